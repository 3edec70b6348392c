/**
 * A small drawing of the section: its outline, lines and numbered places in it, and where the tool point is. Where it is asked to,
 * a place is picked in it by a click, or by a cross that keys move.
 *
 * @import { Units } from '../../model/document.js'
 * @import { TracedSection } from '../../model/workspace/mapped.js'
 *
 * @typedef {object} FigureDot
 * @property {number} u
 * @property {number} v
 * @property {string} text
 * @property {boolean} isReached
 * @property {(() => void) | null} press
 *
 * @typedef {object} Figure
 * @property {TracedSection} section
 * @property {Units} units
 * @property {readonly { readonly points: readonly number[], readonly kind: 'trace' | 'way' | 'missing' }[]} lines  u, v each
 * @property {readonly FigureDot[]} dots
 * @property {readonly [number, number]} tool
 */
import { isInside, windowAround } from '../../model/workspace/drawingWindow.js';
import { boxOfSection, thinned } from '../../model/workspace/sectionShape.js';
import { fill, h } from '../parts/dom.js';
import { svg } from '../parts/svg.js';
import { SECTION } from '../words/workspaceSection.js';
import { lengthText } from './measures.js';
import { placeOf } from './placeOf.js';

const SIZE = { width: 372, height: 260 };
const ROOM = 14;
const MIDDLE = { x: SIZE.width / 2, y: SIZE.height / 2 };
const INNER = { width: SIZE.width - 2 * ROOM, height: SIZE.height - 2 * ROOM };

/** Pixels that keys move the cross. */
const STEP = { small: 2, large: 20 };
const DOT = 8;

const short = (/** @type {number} */ value) => value.toFixed(1);

/**
 * @param {string} label
 * @param {((u: number, v: number) => void) | null} onPick
 * @param {(words: string) => void} announce
 */
export function createReachFigure(label, onPick, announce) {
  const inside = svg('path', { class: 'section-inside' });
  const boundary = svg('path', { class: 'section-boundary' });
  const lines = svg('g', {});
  const cross = svg('path', { class: 'section-cross' });
  const tool = svg('circle', { class: 'figure-tool', r: 4 });
  const dots = svg('g', {});
  const picture = svg(
    'svg',
    {
      viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
      class: 'error-plot reach-figure',
      role: onPick ? 'application' : 'img',
      tabindex: onPick ? 0 : null,
      'aria-label': label,
    },
    inside,
    boundary,
    lines,
    cross,
    tool,
    dots,
  );
  const reading = h('output', { class: 'section-reading sm' });
  const element = h('figure', { class: 'section-figure' }, /** @type {Node} */ (picture), onPick ? reading : null);
  /** @type {Figure | null} */
  let shown = null;
  let window = { u: 0, v: 0, scale: 1 };
  /** @type {{ u: number, v: number } | null} */
  let at = null;

  const x = (/** @type {number} */ u) => MIDDLE.x + (u - window.u) * window.scale;
  const y = (/** @type {number} */ v) => MIDDLE.y - (v - window.v) * window.scale;

  const placeHere = (/** @type {MouseEvent} */ event) => placeOf(event, picture, SIZE, MIDDLE, window);

  /** @param {readonly number[] | Float64Array} points  u, v each @param {boolean} isClosed */
  function path(points, isClosed) {
    const texts = [];
    for (let k = 0; k + 1 < points.length; k += 2) texts.push(`${short(x(points[k]))} ${short(y(points[k + 1]))}`);
    return texts.length > 0 ? `M${texts.join('L')}${isClosed ? 'Z' : ''}` : '';
  }

  function drawCross() {
    if (!at || !shown) {
      cross.setAttribute('d', '');
      reading.textContent = '';
      return;
    }
    const [px, py] = [short(x(at.u)), short(y(at.v))];
    cross.setAttribute('d', `M${px} 0V${SIZE.height}M0 ${py}H${SIZE.width}`);
    const { section, units } = shown;
    reading.textContent = SECTION.reading(
      lengthText(at.u, units),
      lengthText(at.v, units),
      isInside(section, at.u, at.v),
    );
  }

  if (onPick) {
    picture.addEventListener('pointermove', (event) => {
      if (!(event instanceof PointerEvent)) return;
      at = placeHere(event);
      drawCross();
    });
    picture.addEventListener('pointerleave', () => {
      if (document.activeElement === picture) return;
      at = null;
      drawCross();
    });
    picture.addEventListener('click', (event) => {
      if (!(event instanceof MouseEvent) || !shown) return;
      const { u, v } = placeHere(event);
      onPick(u, v);
    });
    picture.addEventListener('keydown', (event) => {
      if (!(event instanceof KeyboardEvent) || !shown || event.ctrlKey || event.metaKey || event.altKey) return;
      const step = (event.shiftKey ? STEP.large : STEP.small) / window.scale;
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (way) {
        at = { u: (at?.u ?? window.u) + way[0] * step, v: (at?.v ?? window.v) + way[1] * step };
        drawCross();
        announce(reading.textContent ?? '');
      } else if (event.key === 'Enter' && at) onPick(at.u, at.v);
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
  }

  return {
    element,
    /** @param {Figure} figure @param {string} words */
    draw(figure, words) {
      const isOther = shown?.section !== figure.section;
      shown = figure;
      if (isOther) {
        window = windowAround(boxOfSection(figure.section), INNER);
        const d = figure.section.outlines.map(({ places }) => path(thinned(places, 0.4 / window.scale), true)).join('');
        inside.setAttribute('d', d);
        boundary.setAttribute('d', d);
      }
      picture.setAttribute('aria-label', words);
      fill(
        lines,
        figure.lines.map(({ points, kind }) =>
          svg('path', { d: path(points, false), class: `figure-line is-${kind}` }),
        ),
      );
      fill(
        dots,
        figure.dots.map(({ u, v, text, isReached, press }) => {
          const dot = svg(
            'g',
            { class: `figure-dot${isReached ? '' : ' is-out'}${press ? ' is-live' : ''}`, 'aria-hidden': 'true' },
            svg('circle', { cx: short(x(u)), cy: short(y(v)), r: DOT }),
            svg('text', { x: short(x(u)), y: short(y(v) + 3.5), 'text-anchor': 'middle' }, text),
          );
          if (press)
            dot.addEventListener('click', (event) => {
              event.stopPropagation();
              press();
            });
          return dot;
        }),
      );
      tool.setAttribute('cx', short(x(figure.tool[0])));
      tool.setAttribute('cy', short(y(figure.tool[1])));
      drawCross();
    },
  };
}
