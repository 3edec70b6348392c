/**
 * A plot as a file that looks elsewhere as it does here.
 *
 * @import { Page } from '../page.js'
 */
import { download } from '../parts/download.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { svg } from '../parts/svg.js';
import { PLOT } from '../words/plot.js';

/** What the page's style sheets say of a drawing. */
const STYLES = [
  'fill',
  'stroke',
  'stroke-width',
  'stroke-dasharray',
  'stroke-linejoin',
  'paint-order',
  'font-family',
  'font-size',
  'font-weight',
  'text-anchor',
];

/** Pixels of a picture for each of the drawing's own: sharp in print. */
const SCALE = 3;

/**
 * A copy of a drawing of the page with its styles written into it, on paper.
 * @param {SVGElement} picture
 * @param {{ width: number, height: number }} size  of its view box
 */
export function standalone(picture, { width, height }) {
  const copy = /** @type {SVGElement} */ (picture.cloneNode(true));
  const copies = [copy, ...copy.querySelectorAll('*')];
  for (const [i, element] of [picture, ...picture.querySelectorAll('*')].entries()) {
    const look = getComputedStyle(element);
    for (const name of STYLES) copies[i].setAttribute(name, look.getPropertyValue(name));
    copies[i].removeAttribute('class');
  }
  for (const [name, value] of Object.entries({ width, height })) copy.setAttribute(name, String(value));
  copy.prepend(
    svg('rect', { width, height, fill: getComputedStyle(document.body).getPropertyValue('--panel').trim() }),
  );
  return copy;
}

const textOf = (/** @type {SVGElement} */ drawing) => new XMLSerializer().serializeToString(drawing);

/** @param {SVGElement} drawing @returns {Promise<Blob>} */
async function pngOf(drawing) {
  const [width, height] = ['width', 'height'].map((name) => SCALE * Number(drawing.getAttribute(name)));
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(textOf(drawing))}`;
  await image.decode();
  const canvas = h('canvas', { width, height });
  const brush = canvas.getContext('2d');
  if (!brush) throw new Error('This browser draws no pictures.');
  brush.drawImage(image, 0, 0, width, height);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture is too large.'))), 'image/png'),
  );
}

/**
 * Buttons that save a drawing as SVG and as PNG.
 * @param {Page} page
 * @param {string} name  of the files, without its end
 * @param {() => SVGElement} draw  what stands by itself, as it is now
 */
export const plotSavers = (page, name, draw) => [
  saveButton(page, `${name}.svg`, draw),
  saveButton(page, `${name}.png`, draw),
];

/**
 * A drawing that stands by itself, as a file.
 * @param {Page} page
 * @param {string} file  ends in .svg or .png
 * @param {() => SVGElement} draw
 */
export const savePlot = (page, file, draw) =>
  save(page, file, () => (file.endsWith('.svg') ? textOf(draw()) : pngOf(draw())));

/**
 * @param {Page} page
 * @param {string} file
 * @param {() => string | Promise<Blob>} make
 */
async function save({ announce, clock, messages }, file, make) {
  try {
    download(file, await make(), file.endsWith('.svg') ? 'image/svg+xml' : 'image/png', clock);
    announce(PLOT.saved(file));
  } catch (error) {
    messages.fault(error);
  }
}

/**
 * @param {Page} page
 * @param {string} file
 * @param {() => SVGElement} draw
 */
function saveButton(page, file, draw) {
  const label = PLOT.save(file.slice(-3).toUpperCase());
  const button = h(
    'button',
    { type: 'button', class: 'btn quiet', title: PLOT.saveTitle(file) },
    icon('download'),
    label,
  );
  button.addEventListener('click', () => savePlot(page, file, draw));
  return button;
}
