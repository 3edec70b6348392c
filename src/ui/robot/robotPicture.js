/**
 * The small picture of an arm: links as lines; a joint as a ring where its axis is seen end-on, as a barrel along the axis
 * where it is seen from the side, and as a box where it slides. The colours are the stylesheet's.
 *
 * @import { RobotDoc } from '../../model/document.js'
 * @import { Point, Sketch } from '../../model/robot/robotSketch.js'
 */
import { toDegrees } from '../../model/units.js';

const SIZE = 64;
const MARGIN = 9;

/** @param {Point} point → the picture, y down */
const place = ([x, y]) => [MARGIN + x * (SIZE - 2 * MARGIN), MARGIN + (1 - y) * (SIZE - 2 * MARGIN)];
const short = (/** @type {number} */ value) => value.toFixed(1);

/**
 * @param {Sketch} sketch
 * @returns {SVGElement} hidden from assistive technology: its option says what it is
 */
export function robotPicture({ line, joints, ground }) {
  const [tool] = line.slice(-1).map(place);
  const [base] = line.map(place);
  const points = line.map((point) => place(point).map(short).join(' ')).join(' ');
  return svg(
    'svg',
    { viewBox: `0 0 ${SIZE} ${SIZE}`, class: 'robot-picture', 'aria-hidden': 'true' },
    ground === null
      ? svg('rect', { class: 'foot', x: base[0] - 6, y: base[1] - 6, width: 12, height: 12, rx: 2 })
      : svg('path', { class: 'foot', d: `M${short(base[0] - 9)} ${short(place([0, ground])[1] + 2)}h18v3.5h-18z` }),
    svg('polyline', { class: 'links', points }),
    ...[...joints].sort((a, b) => Number(a.axis === null) - Number(b.axis === null)).map(jointMark),
    svg('circle', { class: 'tool', cx: short(tool[0]), cy: short(tool[1]), r: 2.4 }),
  );
}

/** @param {Sketch['joints'][number]} joint */
function jointMark({ at, isSliding, axis }) {
  const [x, y] = place(at);
  if (axis === null && !isSliding) return svg('circle', { class: 'joint', cx: short(x), cy: short(y), r: 4 });
  const [length, width] = isSliding ? [axis === null ? 8 : 12, 8] : [9, 5];
  return svg('rect', {
    class: 'joint',
    ...{ x: -length / 2, y: -width / 2, width: length, height: width, rx: isSliding ? 0 : 2 },
    transform: `translate(${short(x)} ${short(y)}) rotate(${short(-toDegrees(axis ?? 0))})`,
  });
}

/**
 * @param {string} tag
 * @param {Record<string, string | number>} attributes
 * @param {...SVGElement} children
 */
function svg(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}
