/**
 * The section as a drawing with axes: it can be zoomed and moved, and a cross reads places, under the pointer or by keys.
 *
 * @import { Units } from '../../model/document.js'
 * @import { SectionPlane, TracedSection } from '../../model/workspace/mapped.js'
 * @import { Window } from '../../model/workspace/drawingWindow.js'
 */
import { roundStep } from '../../model/roundStep.js';
import { fromKernel } from '../../model/units.js';
import { isInside, moveWindow, ticksWithin, windowAround, zoomWindow } from '../../model/workspace/drawingWindow.js';
import { boxOfSection, stripesOf, thinned } from '../../model/workspace/sectionShape.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { svg } from '../parts/svg.js';
import { SECTION } from '../words/workspaceSection.js';
import { lengthSign, lengthText, tickText } from './measures.js';
import { placeOf } from './placeOf.js';

/** Of the drawing, in its own pixels. */
const SIZE = { width: 372, height: 320 };
const ROOM = { left: 46, right: 18, top: 8, bottom: 34 };
const INNER = { width: SIZE.width - ROOM.left - ROOM.right, height: SIZE.height - ROOM.top - ROOM.bottom };
const MIDDLE = { x: ROOM.left + INNER.width / 2, y: ROOM.top + INNER.height / 2 };

const ZOOM = 1.6;
/** A wheel's step, and what counts as one. */
const WHEEL = 1.2;
/** Pixels that keys move the cross. */
const STEP = { small: 2, large: 20 };
/** Lines of the grid are about so many pixels apart. */
const GRID = 60;

/** @typedef {SectionPlane & Partial<TracedSection>} Drawn */

const short = (/** @type {number} */ value) => value.toFixed(1);

/** @param {(words: string) => void} announce */
export function createSectionDrawing(announce) {
  const grid = svg('g', { class: 'plot-grid' });
  const inside = svg('path', { class: 'section-inside' });
  const boundary = svg('path', { class: 'section-boundary' });
  const cross = svg('path', { class: 'section-cross' });
  const clip = svg('clipPath', { id: 'section-clip' }, svg('rect', { x: ROOM.left, y: ROOM.top, ...INNER }));
  const names = [0, 1].map((i) =>
    svg('text', {
      class: 'axis-name',
      ...(i === 0
        ? { x: SIZE.width - ROOM.right, y: SIZE.height - 4, 'text-anchor': 'end' }
        : { transform: `translate(10 ${ROOM.top}) rotate(-90)`, 'text-anchor': 'end' }),
    }),
  );
  const picture = svg(
    'svg',
    {
      viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
      class: 'error-plot section-drawing',
      role: 'application',
      tabindex: 0,
      'aria-roledescription': SECTION.drawing,
      'aria-label': SECTION.drawing,
    },
    clip,
    grid,
    svg('g', { 'clip-path': 'url(#section-clip)' }, inside, boundary, cross),
    ...names,
  );
  const reading = h('span', { class: 'section-reading sm' }, SECTION.pointAt); // announced when keys move the cross
  const [closer, farther, whole] = [
    [SECTION.zoomIn, 'plus'],
    [SECTION.zoomOut, 'dash'],
    [SECTION.all, 'fullscreen'],
  ].map(([label, sign]) =>
    h(
      'button',
      { type: 'button', class: 'btn btn-icon', 'aria-label': label, title: label },
      sign === 'dash' ? '−' : icon(/** @type {'plus' | 'fullscreen'} */ (sign)),
    ),
  );
  const element = h(
    'figure',
    { class: 'section-figure' },
    /** @type {Node} */ (picture),
    h('div', { class: 'row-flex' }, reading, h('span', { class: 'grow' }), farther, closer, whole),
  );

  /** @type {Drawn | null} */
  let shown = null;
  /** @type {Units} */
  let units = { length: 'mm', angle: 'deg' };
  /** @type {Window} */
  let window = { u: 0, v: 0, scale: 1 };
  let isFitted = true;
  /** Where the cross is, m. @type {{ u: number, v: number } | null} */
  let at = null;

  const x = (/** @type {number} */ u) => MIDDLE.x + (u - window.u) * window.scale;
  const y = (/** @type {number} */ v) => MIDDLE.y - (v - window.v) * window.scale;

  const placeHere = (/** @type {MouseEvent} */ event) => placeOf(event, picture, SIZE, MIDDLE, window);

  function drawCross() {
    if (!at || !shown) {
      cross.setAttribute('d', '');
      reading.textContent = SECTION.pointAt;
      return;
    }
    const [px, py] = [short(x(at.u)), short(y(at.v))];
    cross.setAttribute(
      'd',
      `M${px} ${ROOM.top}V${SIZE.height - ROOM.bottom}M${ROOM.left} ${py}H${SIZE.width - ROOM.right}`,
    );
    reading.textContent = SECTION.reading(
      lengthText(at.u, units),
      lengthText(at.v, units),
      isInside(shown, at.u, at.v),
    );
  }

  function draw() {
    picture.classList.toggle('is-zoomed', !isFitted);
    if (!shown) return;
    const { scale } = window;
    const metresPerUnit = 1 / fromKernel('length', 1, units);
    const step = roundStep((GRID / scale) * fromKernel('length', 1, units)).step * metresPerUnit;
    const across = ticksWithin(window.u, INNER.width / scale, step);
    const up = ticksWithin(window.v, INNER.height / scale, step);
    fill(
      grid,
      ...across.flatMap((u) => [
        svg('path', {
          d: `M${short(x(u))} ${ROOM.top}V${SIZE.height - ROOM.bottom}`,
          class: u === 0 ? 'is-zero' : null,
        }),
        svg(
          'text',
          { x: short(x(u)), y: SIZE.height - ROOM.bottom + 14, 'text-anchor': 'middle' },
          tickText(u, step, units),
        ),
      ]),
      ...up.flatMap((v) => [
        svg('path', {
          d: `M${ROOM.left} ${short(y(v))}H${SIZE.width - ROOM.right}`,
          class: v === 0 ? 'is-zero' : null,
        }),
        svg('text', { x: ROOM.left - 5, y: short(y(v) + 3.5), 'text-anchor': 'end' }, tickText(v, step, units)),
      ]),
    );
    const { outlines } = shown;
    if (outlines) {
      const d = outlines
        .map(({ places }) => {
          const points = thinned(places, 0.4 / scale);
          const texts = [];
          for (let k = 0; k < points.length; k += 2)
            texts.push(`${x(points[k]).toFixed(2)} ${y(points[k + 1]).toFixed(2)}`);
          return texts.length > 0 ? `M${texts.join('L')}Z` : '';
        })
        .join('');
      inside.setAttribute('d', d);
      boundary.setAttribute('d', d);
    } else {
      const stripes = stripesOf(shown.cells, INNER.height);
      let d = '';
      for (let k = 0; k < stripes.length; k += 4) {
        const [left, right, low, high] = [x(stripes[k]), x(stripes[k + 1]), y(stripes[k + 2]), y(stripes[k + 3])];
        d += `M${short(left)} ${short(low)}H${short(right)}V${short(high)}H${short(left)}Z`;
      }
      inside.setAttribute('d', d);
      boundary.setAttribute('d', '');
    }
    inside.classList.toggle('is-coarse', !outlines);
    drawCross();
  }

  function fit() {
    isFitted = true;
    if (shown) window = windowAround(boxOfSection(shown), INNER);
    draw();
  }

  /** @param {number} factor @param {{ u: number, v: number }} [about] */
  function zoom(factor, about = at ?? window) {
    isFitted = false;
    window = zoomWindow(window, factor, about);
    draw();
  }

  closer.addEventListener('click', () => zoom(ZOOM, window));
  farther.addEventListener('click', () => zoom(1 / ZOOM, window));
  whole.addEventListener('click', fit);
  picture.addEventListener(
    'wheel',
    (event) => {
      // else whoever scrolls the panel would get stuck in it
      const isMeant = event instanceof WheelEvent && (event.ctrlKey || document.activeElement === picture);
      if (!isMeant || !shown) return;
      event.preventDefault();
      zoom(event.deltaY < 0 ? WHEEL : 1 / WHEEL, placeHere(event));
    },
    { passive: false },
  );
  /** What is dragged, seen from where it was taken. @type {{ u: number, v: number } | null} */
  let held = null;
  picture.addEventListener('pointerdown', (event) => {
    if (!(event instanceof PointerEvent) || event.button !== 0) return;
    held = placeHere(event);
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener('pointermove', (event) => {
    if (!(event instanceof PointerEvent) || !shown) return;
    const here = placeHere(event);
    if (held && event.buttons > 0) {
      isFitted = false;
      window = moveWindow(window, held, here);
      draw();
    }
    at = placeHere(event);
    drawCross();
  });
  for (const end of ['pointerup', 'pointercancel']) picture.addEventListener(end, () => void (held = null));
  picture.addEventListener('pointerleave', () => {
    if (document.activeElement === picture) return;
    at = null;
    drawCross();
  });
  picture.addEventListener('keydown', (event) => {
    if (!(event instanceof KeyboardEvent) || !shown || event.ctrlKey || event.metaKey || event.altKey) return;
    const { key, shiftKey } = event;
    const step = (shiftKey ? STEP.large : STEP.small) / window.scale;
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[key];
    if (way) {
      at = { u: (at?.u ?? window.u) + way[0] * step, v: (at?.v ?? window.v) + way[1] * step };
      drawCross();
      announce(SECTION.readingInWords(lengthText(at.u, units), lengthText(at.v, units), isInside(shown, at.u, at.v)));
    } else if (key === '+' || key === '=') zoom(ZOOM);
    else if (key === '-') zoom(1 / ZOOM);
    else if (key === '0') fit();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  return {
    element,
    picture,
    size: SIZE,
    /** @param {Drawn} section @param {Units} now @param {string} words  all of it, for those who do not see it */
    draw(section, now, words) {
      const isOther = shown === null || section.kind !== shown.kind;
      shown = section;
      units = now;
      const [across, up] = SECTION.axes[section.kind];
      names[0].textContent = SECTION.axisUnit(across, lengthSign(units));
      names[1].textContent = SECTION.axisUnit(up, lengthSign(units));
      picture.setAttribute('aria-label', `${words} ${SECTION.drawingHelp}`);
      if (isFitted || isOther) fit();
      else draw();
    },
  };
}
