/**
 * The volume: all places of the tool point, as a solid or as points in the scene, and what is known of them in numbers.
 *
 * @import { Page } from '../page.js'
 * @import { VolumeMap } from '../../model/workspace/mapped.js'
 * @import { WorkspaceView } from '../../model/workspace/workspaceView.js'
 */
import '../css/robotDetails.css';
import { together } from '../../model/views.js';
import { cubeSize } from '../../model/workspace/mapQuestions.js';
import { COLOURS, DETAILS, OPACITY, STYLES } from '../../model/workspace/workspaceView.js';
import { captionedSelect, select } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { segments } from '../parts/segments.js';
import { WORKSPACE } from '../words/workspace.js';
import { createLegend } from './legend.js';
import { look, viewNow } from './look.js';
import { createMapProgress, headText } from './mapProgress.js';
import { sizeOf, volumeInWords } from './mapText.js';
import { grouped, shortLength } from './measures.js';
import { createSaveButton } from './saveButton.js';
import { createSeedField } from './seedField.js';
import { createToolFields } from './toolFields.js';

const WORDS = WORKSPACE.volume;

/** Places need so many coordinates; an arm with more joints that move the tool point has some to spare. */
const COORDINATES = 3;

/** @param {Page} page @param {HTMLElement} body @param {(summary: string) => void} say @param {(draw: () => void) => void} afterPress  when nothing is pressed */
export function createVolumePanel(page, body, say, afterPress) {
  const { store, addView, derived } = page;
  const style = segments(WORDS.style.label, STYLES, WORDS.style.name, (value) => look(page, { style: value }));
  const shown = h('input', { type: 'checkbox', role: 'switch' });
  shown.addEventListener('change', () => look(page, { hasVolume: shown.checked }));
  const colour = select(WORDS.colourLabel, COLOURS, WORDS.colours, (value) => look(page, { colour: value }));
  const detail = select(WORDS.detailLabel, DETAILS, { coarse: '', usual: '', fine: '' }, (value) =>
    look(page, { detail: value }),
  );
  const opacity = h('input', {
    ...{ type: 'range', min: 100 * OPACITY.least, max: 100 * OPACITY.most, step: 5, 'aria-label': WORDS.opacity },
  });
  const percent = h('output', { class: 'sm' });
  opacity.addEventListener('input', () => look(page, { opacity: Number(opacity.value) / 100 }));
  const opacityRow = h(
    'label',
    { class: 'reach-opacity' },
    h('span', { class: 'soft' }, WORDS.opacity),
    opacity,
    percent,
  );
  const legend = createLegend();
  const progress = createMapProgress(page, 'volume');
  const facts = h('dl', { class: 'facts' });
  const sentence = h('p', { class: 'visually-hidden' });
  const note = h('p', { class: 'sm soft' });
  const save = createSaveButton(page, 'saveVolume');
  fill(
    body,
    h(
      'div',
      { class: 'reach-body' },
      h(
        'div',
        { class: 'row-flex' },
        style.element,
        h('span', { class: 'grow' }),
        h('label', { class: 'switch' }, shown, WORKSPACE.inScene),
      ),
      h(
        'div',
        { class: 'captioned-row is-two' },
        captionedSelect(colour, WORDS.colour),
        captionedSelect(detail, WORDS.detail),
      ),
      opacityRow,
      progress.element,
      legend.element,
      h('div', { class: 'reach-result' }, facts, sentence, note),
      createToolFields(page),
      h('div', { class: 'row-flex' }, createSeedField(page), h('span', { class: 'grow' }), save),
    ),
  );

  let sizes = '';
  addView(
    together(({ doc, session }) => [session.workspace, doc.robot]),
    ([, { units }]) => {
      const view = viewNow(page);
      style.draw(view.style);
      shown.checked = view.hasVolume;
      colour.value = view.colour;
      opacity.value = String(100 * view.opacity);
      percent.textContent = WORDS.opacityValue(fixed(100 * view.opacity, 0));
      opacityRow.hidden = view.style !== 'solid';
      const chain = derived.chain(store.state.doc);
      const names = DETAILS.map((each) => shortLength(cubeSize(chain, each), units));
      if (sizes !== names.join()) {
        sizes = names.join();
        [...detail.options].forEach((option, i) => (option.textContent = names[i]));
      }
      detail.value = view.detail;
    },
  );
  addView(
    together(({ doc, session }) => [session.maps.volume, session.workspace?.colour, session.workspace?.style, doc.robot.units, doc.robot]), // prettier-ignore
    () => afterPress(drawNow),
  );

  const drawNow = () => draw(store.state.session.maps.volume, viewNow(page));

  /** @param {VolumeMap | null} map @param {WorkspaceView} view */
  function draw(map, view) {
    const { units } = store.state.doc.robot;
    progress.draw(map);
    const cubes = map && !map.isStale && !map.why ? map.cubes : null;
    const found = cubes && map ? sizeOf(map) : null;
    const isDone = map?.status === 'done' && !map.isStale;
    say(headText(map, () => found?.text ?? ''));
    legend.element.hidden = !found;
    save.disabled = !cubes || map?.status === 'working';
    facts.hidden = !found;
    note.hidden = !cubes || (!isDone && !found);
    sentence.textContent = isDone && cubes ? volumeInWords(store.state, map) : '';
    if (!map || !cubes) return;
    if (!found) {
      note.hidden = map.status === 'working';
      note.textContent = WORDS.none;
      return;
    }
    const { joints } = cubes;
    legend.draw(map, view.colour, units, { isFlat: found.isFlat, joints });
    const points = map.places.reduce((sum, { length }) => sum + length / COORDINATES, 0);
    const rows = /** @type {[string, string][]} */ ([
      [found.isFlat ? WORDS.result.area : WORDS.result.volume, found.thin ? WORDS.result.none : found.text],
      ...found.axes.map(({ axis, low, high }) => [
        axis,
        WORDS.range(shortLength(low, units), shortLength(high, units)),
      ]),
      [WORDS.result.cubes, WORDS.cubesIn(grouped(found.count), shortLength(cubes.size, units))],
      ...(view.style === 'points' ? [[WORDS.result.points, grouped(points)]] : []),
    ]);
    fill(
      facts,
      rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]),
    );
    note.textContent = [
      found.thin ? WORDS.thin[found.thin] : found.isFlat && WORDS.flat,
      view.tool !== 'any' || found.thin
        ? null
        : cubes.isMiddle
          ? WORDS.proven
          : joints > COORDINATES
            ? WORDS.estimated
            : WORDS.estimatedFew,
    ]
      .filter(Boolean)
      .join(' ');
  }
}
