/**
 * Icons as inline SVG: Bootstrap Icons by name, and the few that robotics needs and the set lacks.
 * The markup is our own and fixed at build time; it is parsed as SVG, not as HTML.
 */
import box from 'bootstrap-icons/icons/box.svg?raw';
import circleHalf from 'bootstrap-icons/icons/circle-half.svg?raw';
import codeSlash from 'bootstrap-icons/icons/code-slash.svg?raw';
import copy from 'bootstrap-icons/icons/copy.svg?raw';
import crosshair from 'bootstrap-icons/icons/crosshair.svg?raw';
import download from 'bootstrap-icons/icons/download.svg?raw';
import exclamation from 'bootstrap-icons/icons/exclamation-triangle-fill.svg?raw';
import check from 'bootstrap-icons/icons/check2.svg?raw';
import dots from 'bootstrap-icons/icons/three-dots-vertical.svg?raw';
import pause from 'bootstrap-icons/icons/pause-fill.svg?raw';
import play from 'bootstrap-icons/icons/play-fill.svg?raw';
import skipBack from 'bootstrap-icons/icons/skip-start-fill.svg?raw';
import skipForward from 'bootstrap-icons/icons/skip-end-fill.svg?raw';
import plus from 'bootstrap-icons/icons/plus-lg.svg?raw';
import checkCircle from 'bootstrap-icons/icons/check-circle-fill.svg?raw';
import fileX from 'bootstrap-icons/icons/file-earmark-x.svg?raw';
import folder from 'bootstrap-icons/icons/folder2-open.svg?raw';
import fullscreen from 'bootstrap-icons/icons/arrows-fullscreen.svg?raw';
import home from 'bootstrap-icons/icons/house.svg?raw';
import list from 'bootstrap-icons/icons/list-ul.svg?raw';
import octagon from 'bootstrap-icons/icons/x-octagon-fill.svg?raw';
import question from 'bootstrap-icons/icons/question-circle.svg?raw';
import record from 'bootstrap-icons/icons/record-circle.svg?raw';
import redo from 'bootstrap-icons/icons/arrow-clockwise.svg?raw';
import slash from 'bootstrap-icons/icons/slash-circle.svg?raw';
import sliders from 'bootstrap-icons/icons/sliders.svg?raw';
import table from 'bootstrap-icons/icons/table.svg?raw';
import target from 'bootstrap-icons/icons/bullseye.svg?raw';
import trash from 'bootstrap-icons/icons/trash.svg?raw';
import undo from 'bootstrap-icons/icons/arrow-counterclockwise.svg?raw';
import close from 'bootstrap-icons/icons/x-lg.svg?raw';

/** @param {string} content @param {string} [box] */
const own = (content, box = '0 0 16 16') => `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${box}">${content}</svg>`;

const DRAWINGS = {
  ...{
    circleHalf,
    codeSlash,
    copy,
    crosshair,
    download,
    exclamation,
    checkCircle,
    fileX,
    folder,
    fullscreen,
    home,
    list,
  },
  ...{ box, check, dots, pause, play, plus, skipBack, skipForward },
  ...{ octagon, question, record, redo, slash, sliders, table, target, trash, undo, close },
  revolute: own(
    '<path d="M8 1.5a6.5 6.5 0 1 1-6.1 4.2" fill="none" stroke="currentColor" stroke-width="1.4" stroke-linecap="round"/><path d="M.6 6.9 2 3.6l2.9 2.1z"/><circle cx="8" cy="8" r="2"/>',
  ),
  frames: own(
    '<g fill="none" stroke="currentColor" stroke-width="1.3"><path d="M6 10V2.5M6 10h7M6 10l-3.6 3.6"/></g><path d="M6 0 4.2 3.4h3.6zM16 10l-3.4-1.8v3.6zM.9 15.1l1.2-3.7 2.5 2.5z"/>',
  ),
  handle: own(
    '<g fill="none" stroke="currentColor" stroke-width="1.3"><path d="M5 11V3M5 11h8"/><path d="M8.5 3.6a6 6 0 0 1 4 4"/></g><path d="M5 0 3.2 3.4h3.6zM16 11l-3.4-1.8v3.6z"/><circle cx="5" cy="11" r="2.4"/>',
  ),
  prismatic: own(
    '<path d="M3.2 5h9.6v6H3.2z" fill="none" stroke="currentColor" stroke-width="1.4"/><path d="M.2 8 2.6 6v4zM15.8 8l-2.4-2v4z"/>',
  ),
  // what an arm sweeps: two arcs about a point
  reach: own(
    '<g fill="none" stroke="currentColor" stroke-width="1.3"><path d="M1.5 13.5a12 12 0 0 1 12-12v0M6.5 13.5a7 7 0 0 1 7-7M1.5 13.5h5M13.5 1.5v5"/></g><circle cx="13.2" cy="13.2" r="1.5"/>',
  ),
  matrix: own(
    '<g fill="none" stroke="currentColor" stroke-width="1.4"><path d="M4.5 1.5h-3v13h3M11.5 1.5h3v13h-3"/></g><g><circle cx="6" cy="5" r="1.2"/><circle cx="10" cy="5" r="1.2"/><circle cx="6" cy="11" r="1.2"/><circle cx="10" cy="11" r="1.2"/></g>',
  ),
  caret: own('<path d="M1.5 3.5 5 7l3.5-3.5" fill="none" stroke="currentColor" stroke-width="1.6"/>', '0 0 10 10'),
  // The two joint axes and their common normal: the figure every DH table starts from.
  brand: own(
    '<g fill="none" stroke-linecap="round"><path d="M5 20V2M13 20 19 2" stroke="currentColor" stroke-width="2"/><path d="M5 11h11" stroke="var(--accent)" stroke-width="2.6"/></g><circle cx="5" cy="11" r="2.3" fill="var(--accent)"/><circle cx="16" cy="11" r="2.3" fill="var(--accent)"/>',
    '0 0 22 22',
  ),
};

/** @typedef {keyof typeof DRAWINGS} IconName */

/** @param {IconName} name @param {string} [className] */
export const icon = (name, className) => iconOf(DRAWINGS[name], className);

/**
 * @param {string} drawing  of the set, for a part of the page that is fetched with icons of its own
 * @param {string} [className]
 * @returns {SVGElement} hidden from assistive technology: the control beside it has the name
 */
export function iconOf(drawing, className = '') {
  const svg = new DOMParser().parseFromString(drawing, 'image/svg+xml').documentElement;
  for (const attribute of ['width', 'height', 'fill', 'class']) svg.removeAttribute(attribute);
  svg.setAttribute('class', `i ${className}`.trim());
  svg.setAttribute('aria-hidden', 'true');
  return /** @type {SVGElement} */ (/** @type {unknown} */ (document.importNode(svg, true)));
}
