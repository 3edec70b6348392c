/**
 * The section: the places of the tool point in a plane, drawn, traced and measured.
 *
 * @import { Page } from '../page.js'
 * @import { Units } from '../../model/document.js'
 * @import { SectionMap, TracedSection } from '../../model/workspace/mapped.js'
 */
import '../css/robotDetails.css';
import '../css/jacobian.css';
import { isSliding } from '../../model/document.js';
import { together } from '../../model/views.js';
import { holesOf } from '../../model/workspace/sectionShape.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, withUnit } from '../parts/format.js';
import { TEXT } from '../strings.js';
import { WORKSPACE } from '../words/workspace.js';
import { SECTION } from '../words/workspaceSection.js';
import { look, viewNow } from './look.js';
import { createMapProgress, headText } from './mapProgress.js';
import { onlyFirst, sectionInWords } from './mapText.js';
import { grouped, lengthText, measureText, shortLength } from './measures.js';
import { createSaveButton } from './saveButton.js';
import { createSectionDrawing } from './sectionDrawing.js';
import { createSectionFields } from './sectionFields.js';

/** What a boundary that is traced is known to, m. */
const TRACED = { precise: 5e-5, quick: 5e-4 };

/** A gap that is shorter (m) is less than what the boundary is known to. */
const NO_GAP = 5e-5;

const FULL_TURN = 2 * Math.PI;
const NEARLY = 1e-9;

/** @param {Page} page @param {HTMLElement} body @param {(summary: string) => void} say @param {(draw: () => void) => void} afterPress  when nothing is pressed */
export function createSectionPanel(page, body, say, afterPress) {
  const { store, addView, derived, announce } = page;
  const shown = h('input', { type: 'checkbox', role: 'switch' });
  shown.addEventListener('change', () => look(page, { hasSection: shown.checked }));
  const about = h('p', { class: 'sm soft' });
  const progress = createMapProgress(page, 'section');
  const drawing = createSectionDrawing(announce);
  const coarse = h('p', { class: 'sm soft' }, SECTION.coarse);
  const facts = h('dl', { class: 'facts' });
  const holes = h('ul', { class: 'section-holes' });
  const holesPart = h('details', { class: 'plot-table' }, h('summary', {}, SECTION.holesList), holes);
  const sentence = h('p', { class: 'visually-hidden' });
  const note = h('p', { class: 'sm soft' });
  const save = createSaveButton(page, 'saveSection');
  fill(
    body,
    h(
      'div',
      { class: 'reach-body' },
      createSectionFields(page),
      about,
      progress.element,
      drawing.element,
      coarse,
      h('div', { class: 'reach-result' }, facts, holesPart, sentence, note),
      h(
        'div',
        { class: 'row-flex' },
        h('label', { class: 'switch' }, shown, WORKSPACE.inScene),
        h('span', { class: 'grow' }),
        save,
      ),
    ),
  );

  addView(
    ({ session }) => session.workspace?.hasSection,
    (isShown) => void (shown.checked = isShown ?? true),
  );
  addView(
    together(({ doc, session }) => [session.maps.section, doc.robot, session.workspace]),
    () => afterPress(drawNow),
  );

  const drawNow = () => draw(store.state.session.maps.section, store.state.doc.robot.units);

  /** What turns the section into all that is reached. */
  function sweep() {
    const { robot } = store.state.doc;
    const chain = derived.chain(store.state.doc);
    const index = robot.joints.findIndex((joint) => !isSliding(joint));
    const { lower, upper } = chain.joints[index];
    if (!viewNow(page).withLimits || !(upper - lower < FULL_TURN - NEARLY)) return SECTION.whole;
    const [from, to] = [robot.joints[index].lower ?? 0, robot.joints[index].upper ?? 0].map((value) =>
      withUnit(jointNumber(value, robot.units.angle), robot.units.angle),
    );
    return SECTION.swept(TEXT.robot.joint(index + 1), from, to);
  }

  /** @param {SectionMap | null} map @param {Units} units */
  function draw(map, units) {
    progress.draw(map);
    const isFresh = map !== null && !map.isStale && !map.why;
    const section = isFresh ? map.section : null;
    const drawn = map?.section ?? map?.first ?? null;
    // of some planes there is a first picture, and nothing else
    const hasNone = isFresh && map.hasNone && !map.first;
    const onlyPicture = isFresh && map.hasNone ? map.first : null;
    say(headText(map, () => (section?.extent ? measureText('area', section.area, section.areaError) : '')));
    const isNothing = drawn === null || drawn.cells.columns === 0 || (section !== null && !section.extent);
    drawing.element.hidden = isNothing || hasNone || Boolean(map?.why);
    coarse.hidden = drawing.element.hidden || section !== null || onlyPicture !== null;
    facts.hidden = !section?.extent;
    holesPart.hidden = true;
    save.disabled = !section?.extent;
    const words = map && section ? sectionInWords(store.state, map) : '';
    sentence.textContent = words;
    if (drawn && !hasNone) drawing.draw(drawn, units, words || SECTION.coarse);
    about.textContent = drawn && !hasNone && !onlyPicture ? aboutCut(drawn) : '';
    about.hidden = about.textContent === '';
    const missing = viewNow(page).cut === 'own' ? SECTION.noneOwn : SECTION.none;
    note.textContent = onlyPicture ? onlyFirst(onlyPicture, units) : hasNone ? missing : noteOf(section, units);
    note.hidden = note.textContent === '';
    if (section?.extent) write(section, units);
  }

  /** @param {TracedSection | NonNullable<SectionMap['first']>} cut */
  function aboutCut({ kind, isAnyAngle }) {
    if (kind !== 'meridian') return SECTION.about[kind];
    if (!isAnyAngle) return [SECTION.about[kind], SECTION.oneAngle].join(' ');
    return [SECTION.about[kind], SECTION.anyAngle, sweep()].join(' ');
  }

  /** @param {TracedSection | null} section @param {Units} units */
  function noteOf(section, units) {
    if (!section) return '';
    if (!section.extent) return SECTION.empty;
    const { gap, sides } = section;
    return [SECTION[sides], gap > NO_GAP && SECTION.gap(lengthText(gap, units))].filter(Boolean).join(' ');
  }

  /** @param {TracedSection} section @param {Units} units */
  function write(section, units) {
    const { extent, area, areaError, volume, volumeError, outlines, cells, kind } = section;
    if (!extent) return;
    const found = holesOf(section);
    const range = (/** @type {readonly [number, number]} */ [low, high]) =>
      SECTION.result.range(lengthText(low, units), lengthText(high, units));
    const points = outlines.reduce((sum, { places }) => sum + places.length / 2, 0);
    const { isPrecise } = viewNow(page);
    const rows = /** @type {[string, string][]} */ ([
      [SECTION.result.area, measureText('area', area, areaError)],
      ...(kind === 'meridian'
        ? [
            [
              SECTION.result.volume,
              volume === null ? SECTION.noVolume : measureText('volume', volume, volumeError ?? 0),
            ],
          ]
        : []),
      [SECTION.result.across, range(extent.u)],
      [SECTION.result.up, range(extent.v)],
      [SECTION.result.holes, found.length === 0 ? SECTION.result.noHoles : grouped(found.length)],
      [
        SECTION.result.boundary,
        SECTION.result.traced(grouped(points), shortLength(TRACED[isPrecise ? 'precise' : 'quick'], units)),
      ],
      [
        SECTION.result.cells,
        SECTION.result.cellsValue(grouped(cells.columns), grouped(cells.rows), shortLength(cells.size, units)),
      ],
    ]);
    fill(
      facts,
      rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]),
    );
    holesPart.hidden = found.length === 0;
    fill(
      holes,
      found.map((hole) =>
        h('li', {}, SECTION.hole(measureText('area', hole.area, areaError), range(hole.u), range(hole.v))),
      ),
    );
  }
}
