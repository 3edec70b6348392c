/**
 * The choices of the menu of conventions: to convert the table, or to read the same numbers by the other convention, each with
 * what it would do. Fetched when the menu is about to open.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { Convention, Doc } from '../../model/document.js'
 */
import { applyCommand } from '../../model/commands.js';
import { createDerived } from '../../model/derived.js';
import { refusal } from '../../model/refusals.js';
import { fromKernel } from '../../model/units.js';
import { previewConversion, previewReading } from './conventionPreview.js';
import { poseNumber, withUnit } from '../parts/format.js';
import { attempt } from '../page.js';
import { TEXT } from '../strings.js';
import { CONVENTION } from '../words/convention.js';

/** @param {Convention} convention @returns {Convention} */
const otherThan = (convention) => (convention === 'standard' ? 'modified' : 'standard');

/** How far the tool is from one document to the other, in words. @param {Doc} before @param {Doc} after */
function distance(before, after) {
  const derived = createDerived(); // of its own: what the page has derived stays remembered
  const { units } = before.robot;
  const [p, q] = [before, after].map((doc) => derived.tcp(doc).slice(12, 15));
  const metres = Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  return withUnit(poseNumber(fromKernel('length', metres, units), units.length), units.length);
}

/**
 * @param {Page} page
 * @param {(text: string) => void} say
 * @returns {readonly (readonly Choice[])[]}
 */
export function conventionChoices(page, say) {
  const { store } = page;
  const { doc } = store.state;
  const { convention: now } = doc.robot;
  const convention = otherThan(now);
  const name = CONVENTION.name[convention];
  const convert = /** @type {const} */ ({ type: 'convert-convention', convention });
  const reread = /** @type {const} */ ({ type: 'reinterpret-convention', convention });
  const against = refusal(doc, convert);
  return [
    [{ title: TEXT.table.conventionName[now], detail: CONVENTION.detail[now], isChosen: true }],
    [
      {
        title: CONVENTION.convert(name),
        detail: CONVENTION.convertDetail,
        against: against?.message ?? null,
        preview: against ? null : previewConversion(doc, convention),
        run() {
          if (attempt(page, convert) !== null) return;
          const { base, tool } = store.state.doc.robot;
          const changed = [
            base !== doc.robot.base && CONVENTION.baseChanged,
            tool !== doc.robot.tool && CONVENTION.toolChanged,
          ];
          say([CONVENTION.convertedTo(name), ...changed].filter(Boolean).join(' '));
        },
      },
      {
        title: CONVENTION.reread(name),
        detail: CONVENTION.rereadDetail,
        preview: previewReading(doc, convention),
        run() {
          const moved = distance(doc, applyCommand(doc, reread));
          if (attempt(page, reread) === null) say(CONVENTION.rereadAs(name, convention, moved));
        },
      },
    ],
  ];
}
