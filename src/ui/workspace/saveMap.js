/**
 * A map as a file, by a dialog as everything is saved by. Large files are written in pieces, one a frame.
 *
 * @import { Page } from '../page.js'
 */
import '../css/saveAs.css';
import {
  cubesCsvParts,
  placesCsvParts,
  plyParts,
  stlParts,
  writeSectionCsv,
  writeSectionSvg,
} from '../../io/workspaceFiles.js';
import { fromKernel } from '../../model/units.js';
import { fileNameOf } from '../files/files.js';
import { DISMISSES, dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { fill, h } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';
import { SAVE_MAP } from '../words/saveMap.js';
import { viewNow } from './look.js';

/**
 * @typedef {object} MapWare
 * @property {keyof typeof SAVE_MAP.formats} id
 * @property {string} end        of its name
 * @property {string} mediaType
 * @property {() => Iterator<BlobPart>} parts
 */

const CSV = 'text/csv';
const PLY = 'model/ply';

/** @param {Page} page */
const unitNow = (page) => {
  const { units } = page.store.state.doc.robot;
  return { unit: units.length, scale: fromKernel('length', 1, units) };
};

/** What fits into one part. @param {() => string} write */
const atOnce = (write) =>
  function* once() {
    yield write();
  };

/** @param {Page} page */
export function saveVolume(page) {
  const { volume } = page.store.state.session.maps;
  if (!volume?.cubes || !volume.surface) return;
  const { cubes, surface, places, status } = volume;
  const { unit, scale } = unitNow(page);
  /** @type {MapWare[]} */
  const wares = [
    { id: 'stl', end: 'workspace.stl', mediaType: 'model/stl', parts: () => stlParts(surface, scale) },
    {
      ...{ id: 'surface', end: 'workspace.ply', mediaType: PLY },
      parts: () => plyParts([surface.corners], scale, surface.triangles),
    },
    { id: 'cubes', end: 'workspace.csv', mediaType: CSV, parts: () => cubesCsvParts(cubes, scale, unit) },
  ];
  if (viewNow(page).style === 'points' && places.length > 0) {
    wares.push(
      { id: 'cloud', end: 'workspace-points.ply', mediaType: PLY, parts: () => plyParts(places, scale) },
      { id: 'places', end: 'workspace-points.csv', mediaType: CSV, parts: () => placesCsvParts(places, scale, unit) },
    );
  }
  const notes = [
    SAVE_MAP.unit(unit),
    !cubes.isMiddle && SAVE_MAP.estimated,
    status === 'cancelled' && SAVE_MAP.partial,
  ];
  openSaveMap(page, SAVE_MAP.volumeTitle, wares, notes);
}

/** @param {Page} page */
export function saveSection(page) {
  const { section } = page.store.state.session.maps.section ?? {};
  if (!section?.extent) return;
  const { outlines, extent, sides } = section;
  const { unit, scale } = unitNow(page);
  // an SVG has no metres
  const drawn = unit === 'm' ? /** @type {const} */ ({ unit: 'cm', scale: 100 }) : { unit, scale };
  openSaveMap(
    page,
    SAVE_MAP.sectionTitle,
    [
      {
        ...{ id: 'svg', end: 'section.svg', mediaType: 'image/svg+xml' },
        parts: atOnce(() => writeSectionSvg(outlines, extent, drawn.scale, drawn.unit)),
      },
      {
        ...{ id: 'outlines', end: 'section.csv', mediaType: CSV },
        parts: atOnce(() => writeSectionCsv(outlines, scale, unit)),
      },
    ],
    [SAVE_MAP.sectionUnit(unit), sides === 'estimated' && SAVE_MAP.estimated],
  );
}

/**
 * @param {Page} page
 * @param {string} title
 * @param {readonly MapWare[]} wares  the first is the usual one
 * @param {readonly (string | false)[]} notes
 */
function openSaveMap(page, title, wares, notes) {
  const { store, announce, clock } = page;
  const robot = fileNameOf(store.state.doc.robot.name);
  let [chosen] = wares;
  const name = h('span', { class: 'b save-file' });
  const save = h('button', { type: 'button', class: 'btn btn-primary' }, icon('download'), SAVE_MAP.save);
  const draw = () => (name.textContent = `${robot}-${chosen.end}`);

  save.addEventListener('click', () => {
    const { parts, mediaType, end } = chosen;
    const file = `${robot}-${end}`;
    const work = parts();
    /** @type {BlobPart[]} */
    const written = [];
    save.disabled = true;
    fill(save, SAVE_MAP.writing);
    const goOn = () => {
      const { done, value } = work.next();
      if (!done) {
        written.push(value);
        clock.onFrame(goOn);
        return;
      }
      download(file, new Blob(written, { type: mediaType }), mediaType, clock);
      announce(TEXT.files.saved(file));
      dialog.hide();
    };
    goOn();
  });

  const choices = wares.map((ware, i) => {
    const words = SAVE_MAP.formats[ware.id];
    const radio = h('input', { type: 'radio', name: 'map-format', value: ware.id, checked: i === 0 });
    radio.addEventListener('change', () => {
      chosen = ware;
      draw();
    });
    return h('label', {}, radio, h('span', {}, words.name, h('small', {}, words.detail)));
  });
  draw();
  const dialog = openDialog({
    name: 'save-as',
    title: 'save-map-title',
    fit: 'modal-dialog-centered modal-fullscreen-sm-down',
    content: [
      dialogHead('save-map-title', title),
      h(
        'div',
        { class: 'save-body' },
        h('div', { class: 'save-formats', role: 'radiogroup', 'aria-label': SAVE_MAP.format }, choices),
        h(
          'div',
          { class: 'save-about soft' },
          notes.filter((note) => note !== false).map((note) => h('p', {}, note)),
        ),
      ),
      dialogFoot(
        h('span', { class: 'save-name grow' }, name),
        h('button', { ...DISMISSES, class: 'btn btn-outline' }, SAVE_MAP.cancel),
        save,
      ),
    ],
    onShown: () => choices[0].querySelector('input')?.focus(),
  });
}
