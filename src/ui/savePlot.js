/**
 * A plot as a file that looks elsewhere as it does here: the styles that the page gives it are written into it.
 *
 * @import { Page } from './page.js'
 */
import { download } from './download.js';
import { h } from './dom.js';
import { icon } from './icons.js';
import { svg } from './svg.js';
import { PLOT } from './words/plot.js';

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

const paper = () => getComputedStyle(document.body).getPropertyValue('--panel').trim();

/** @param {SVGElement} picture @param {{ width: number, height: number }} size  of its view box */
function svgText(picture, { width, height }) {
  const copy = /** @type {SVGElement} */ (picture.cloneNode(true));
  const copies = [copy, ...copy.querySelectorAll('*')];
  for (const [i, element] of [picture, ...picture.querySelectorAll('*')].entries()) {
    const look = getComputedStyle(element);
    for (const name of STYLES) copies[i].setAttribute(name, look.getPropertyValue(name));
    copies[i].removeAttribute('class');
  }
  for (const [name, value] of Object.entries({ width, height })) copy.setAttribute(name, String(value));
  copy.prepend(svg('rect', { width, height, fill: paper() }));
  return new XMLSerializer().serializeToString(copy);
}

/**
 * Pictures one below the other, on paper.
 * @param {readonly { image: CanvasImageSource, width: number, height: number }[]} images
 * @returns {Promise<Blob>}
 */
function pngOf(images) {
  const width = Math.max(...images.map((each) => each.width));
  const height = images.reduce((sum, each) => sum + each.height, 0);
  const canvas = h('canvas', { width, height });
  const brush = canvas.getContext('2d');
  if (!brush) throw new Error('This browser draws no pictures.');
  brush.fillStyle = paper();
  brush.fillRect(0, 0, width, height);
  let top = 0;
  for (const each of images) {
    brush.drawImage(each.image, 0, top, each.width, each.height);
    top += each.height;
  }
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture is too large.'))), 'image/png'),
  );
}

/** @param {string} text @param {{ width: number, height: number }} size */
async function pngOfSvg(text, { width, height }) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  return pngOf([{ image, width: SCALE * width, height: SCALE * height }]);
}

/**
 * Buttons that save a drawing as SVG and as PNG.
 * @param {Page} page
 * @param {string} name  of the files, without its end
 * @param {SVGElement} picture
 * @param {{ width: number, height: number }} size  of its view box
 */
export function createPlotSaver(page, name, picture, size) {
  return h(
    'div',
    { class: 'row-flex plot-saver' },
    saveButton(page, `${name}.svg`, () => svgText(picture, size)),
    saveButton(page, `${name}.png`, () => pngOfSvg(svgText(picture, size), size)),
  );
}

/**
 * A button that saves what canvases show.
 * @param {Page} page
 * @param {string} name
 * @param {() => readonly HTMLCanvasElement[]} canvasesNow  one or more
 */
export const createCanvasSaver = (page, name, canvasesNow) =>
  saveButton(page, `${name}.png`, () =>
    pngOf(canvasesNow().map((image) => ({ image, width: image.width, height: image.height }))),
  );

/**
 * @param {Page} page
 * @param {string} file
 * @param {() => string | Promise<Blob>} make
 */
function saveButton({ announce, clock, messages }, file, make) {
  const [, kind] = file.split('.');
  const label = PLOT.save(kind.toUpperCase());
  const button = h(
    'button',
    { type: 'button', class: 'btn quiet', title: PLOT.saveTitle(file) },
    icon('download'),
    label,
  );
  button.addEventListener('click', async () => {
    try {
      download(file, await make(), kind === 'svg' ? 'image/svg+xml' : 'image/png', clock);
      announce(PLOT.saved(file));
    } catch (error) {
      messages.fault(error);
    }
  });
  return button;
}
