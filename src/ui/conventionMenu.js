/**
 * Which convention the table follows, and the two ways to the other one: convert it, or read the same numbers by it.
 *
 * @import { Page } from './page.js'
 * @import { Convention, Doc } from '../model/document.js'
 */
import { applyCommand } from '../model/commands.js';
import { createDerived } from '../model/derived.js';
import { refusal } from '../model/refusals.js';
import { fromKernel } from '../model/units.js';
import { refill, withChoices } from './choices.js';
import { fill, h, spoken } from './dom.js';
import { poseNumber, withUnit } from './format.js';
import { icon } from './icons.js';
import { attempt } from './page.js';
import { TEXT } from './strings.js';

/** @param {Convention} convention @returns {Convention} */
const otherThan = (convention) => (convention === 'standard' ? 'modified' : 'standard');

/**
 * @param {Page} page
 * @param {(text: string) => void} say
 */
export function createConventionMenu(page, say) {
  const { store, addView } = page;
  const derived = createDerived(); // of its own: what the page has derived stays remembered
  const button = h('button', { type: 'button', class: 'btn btn-outline' });
  /** @type {typeof import('./conventionPreview.js') | null} */
  let previews = null;
  // Without them the menu says what matters in words: a failure to fetch is no fault of it.
  let isAsked = false;
  async function fetchPreviews() {
    if (isAsked) return;
    isAsked = true;
    try {
      previews = await import('./conventionPreview.js');
      refill(button);
    } catch {
      isAsked = false;
    }
  }
  button.addEventListener('pointerenter', fetchPreviews, { once: true });
  button.addEventListener('focus', fetchPreviews, { once: true });

  /** How far the tool is from one document to the other, in words. @param {Doc} before @param {Doc} after */
  function distance(before, after) {
    const { units } = before.robot;
    const [p, q] = [before, after].map((doc) => derived.tcp(doc).slice(12, 15));
    const metres = Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    return withUnit(poseNumber(fromKernel('length', metres, units), units.length), units.length);
  }

  addView(
    ({ doc }) => doc.robot.convention,
    (convention) =>
      fill(
        button,
        spoken(TEXT.structure.convention),
        ' ',
        TEXT.table.conventionName[convention],
        icon('caret', 'caret'),
      ),
  );
  return withChoices(
    button,
    () => {
      fetchPreviews();
      const { doc } = store.state;
      const { convention: now } = doc.robot;
      const convention = otherThan(now);
      const name = TEXT.structure.conventionName[convention];
      const convert = /** @type {const} */ ({ type: 'convert-convention', convention });
      const reread = /** @type {const} */ ({ type: 'reinterpret-convention', convention });
      const against = refusal(doc, convert);
      const moved = distance(doc, applyCommand(doc, reread));
      return {
        groups: [
          [{ title: TEXT.table.conventionName[now], detail: TEXT.structure.conventionDetail[now], isChosen: true }],
          [
            {
              title: TEXT.structure.convert(name),
              detail: TEXT.structure.convertDetail,
              against: against?.message ?? null,
              preview: against ? null : (previews?.previewConversion(doc, convention) ?? null),
              run() {
                if (attempt(page, convert) !== null) return;
                const { base, tool } = store.state.doc.robot;
                const changed = [
                  base !== doc.robot.base && TEXT.structure.baseChanged,
                  tool !== doc.robot.tool && TEXT.structure.toolChanged,
                ];
                say([TEXT.structure.convertedTo(name), ...changed].filter(Boolean).join(' '));
              },
            },
            {
              title: TEXT.structure.reread(name),
              detail: previews ? TEXT.structure.rereadPlain : TEXT.structure.rereadDetail(moved),
              preview: previews?.previewReading(doc, convention) ?? null,
              run() {
                if (attempt(page, reread) === null) say(TEXT.structure.rereadAs(name, convention, moved));
              },
            },
          ],
        ],
      };
    },
    { className: 'is-wide' },
  );
}
