/**
 * The rows of the list of solutions: number, figure, posture in words, travel, and the room to the limits; for the eye, and as
 * one sentence for the ear.
 *
 * @import { RobotDoc } from '../../model/document.js'
 * @import { SolutionDoc } from '../../model/aim/solutions.js'
 * @import { travelBetween } from '../../model/aim/solutions.js'
 */
import { h } from '../parts/dom.js';
import { fixed, jointNumber, unitOf, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { SOLUTIONS } from '../words/solutions.js';

const FIGURE = { width: 36, height: 26, margin: 3 };
const NAMESPACE = 'http://www.w3.org/2000/svg';

/** "front, up, flip". @param {SolutionDoc['name']} name */
export function nameInWords({ shoulder, elbow, wrist }) {
  const words = [shoulder, elbow, wrist].flatMap((word) => (word ? [SOLUTIONS.word[word]] : []));
  return words.join(', ') || SOLUTIONS.unnamed;
}

/** A joint's way without decimals, where it is in degrees. @param {RobotDoc} robot @param {number} joint @param {number} value */
function amount({ joints, units }, joint, value) {
  const unit = unitOf(joints[joint], units);
  return withUnit(unit === 'deg' || unit === 'mm' ? fixed(value, 0) : jointNumber(value, unit), unit);
}

/**
 * All figures of a list in one scale, so that they can be compared.
 * @param {readonly SolutionDoc[]} solutions
 */
export function figureScale(solutions) {
  const points = solutions.flatMap(({ figure }) => figure);
  const [xs, ys] = [0, 1].map((k) => points.map((point) => point[k]));
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const { width, height, margin } = FIGURE;
  const scale = Math.min(
    (width - 2 * margin) / Math.max(right - left, 1e-9),
    (height - 2 * margin) / Math.max(high - low, 1e-9),
  );
  const [x0, y0] = [width / 2 - (scale * (left + right)) / 2, height / 2 + (scale * (low + high)) / 2];
  return (/** @type {readonly [number, number]} */ [x, y]) => [x0 + scale * x, y0 - scale * y];
}

/** @param {SolutionDoc['figure']} figure @param {ReturnType<typeof figureScale>} place */
function stick(figure, place) {
  const svg = document.createElementNS(NAMESPACE, 'svg');
  svg.setAttribute('class', 'stick');
  svg.setAttribute('viewBox', `0 0 ${FIGURE.width} ${FIGURE.height}`);
  svg.setAttribute('aria-hidden', 'true');
  const points = figure.map(place);
  /** @param {string} d @param {string} [className] */
  const path = (d, className) => {
    const element = document.createElementNS(NAMESPACE, 'path');
    element.setAttribute('d', d);
    if (className) element.setAttribute('class', className);
    svg.append(element);
  };
  const [foot] = points;
  const end = points[points.length - 1];
  path(`M${(foot[0] - 4).toFixed(1)} ${foot[1].toFixed(1)}h8`, 'foot');
  path(points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`).join(''));
  const tip = document.createElementNS(NAMESPACE, 'circle');
  tip.setAttribute('cx', end[0].toFixed(1));
  tip.setAttribute('cy', end[1].toFixed(1));
  tip.setAttribute('r', '2.1');
  svg.append(tip);
  return svg;
}

/**
 * @param {object} given
 * @param {RobotDoc} given.robot
 * @param {SolutionDoc} given.solution
 * @param {number} given.number   from 1
 * @param {boolean} given.isNearest
 * @param {ReturnType<typeof travelBetween>} given.travel
 * @param {ReturnType<typeof figureScale>} given.place
 */
export function solutionRow({ robot, solution, number, isNearest, travel, place }) {
  const { room, withinLimits, name, figure } = solution;
  const words = nameInWords(name);
  const way = amount(robot, travel.joint, travel.by);
  const margin = room ? amount(robot, room.joint, Math.abs(room.room)) : '';
  const joint = (/** @type {number} */ i) => `J${i + 1}`;
  const marginSpoken = !room
    ? SOLUTIONS.unlimited
    : SOLUTIONS[withinLimits ? 'roomSpoken' : 'pastSpoken'](joint(room.joint), margin);
  const travelSpoken = travel.isHere ? SOLUTIONS.hereSpoken : SOLUTIONS.travelSpoken(joint(travel.joint), way);
  const spokenTravel = isNearest ? `${travelSpoken}, ${SOLUTIONS.nearest}` : travelSpoken;
  return h(
    'div',
    {
      role: 'option',
      tabindex: -1,
      class: withinLimits ? '' : 'is-outside',
      'aria-selected': String(travel.isHere),
      'data-index': number - 1,
      'data-action': 'solution',
      'aria-label': SOLUTIONS.row(number, words, spokenTravel, marginSpoken),
    },
    h('span', { class: 'number' }, String(number)),
    stick(figure, place),
    h('span', { class: 'name' }, words),
    h(
      'span',
      { class: 'travel', title: isNearest ? SOLUTIONS.nearest : null },
      travel.isHere ? h('span', { class: 'here' }, SOLUTIONS.here) : isNearest ? h('b', {}, way) : way,
    ),
    h(
      'span',
      { class: 'margin' },
      !room
        ? SOLUTIONS.unlimited
        : withinLimits
          ? [bar(room.share), h('span', {}, margin)]
          : h('span', { class: 'past' }, icon('slash'), SOLUTIONS.outside(joint(room.joint), margin)),
    ),
  );
}

/** @param {number} share */
function bar(share) {
  const filled = h('i', {});
  filled.style.width = `${Math.round(100 * Math.max(0, Math.min(1, share)))}%`;
  return h('span', { class: 'bar' }, filled);
}
