/**
 * What a change of convention would do to the numbers of this robot, row by row, and to its tool. Fetched when the menu is
 * about to open.
 *
 * @import { Doc, PoseDoc, Units } from '../../model/document.js'
 */
import { quantityOf } from '../../model/document.js';
import { applyCommand } from '../../model/commands.js';
import { gapBetween } from '../../model/aim/aim.js';
import { createDerived } from '../../model/derived.js';
import { isNoPose } from '../../model/noPose.js';
import { fromKernel } from '../../model/units.js';
import '../css/conventionPreview.css';
import { h, spoken, symbol } from '../parts/dom.js';
import { compact, poseNumber, unitSign, withUnit } from '../parts/format.js';
import { PREVIEW } from '../words/conventionPreview.js';

const FIELDS = /** @type {const} */ ([
  ['a', 'a'],
  ['alpha', 'α'],
]);
const WIDEST = 8;

/** Bounds of what counts as the same pose, in metres and radians, and how they are written. */
const BOUNDS = /** @type {const} */ ([
  [1e-12, '1e−12'],
  [1e-9, '1e−9'],
  [1e-6, '1e−6'],
]);

/** @param {Doc} before @param {'standard' | 'modified'} convention */
export function previewConversion(before, convention) {
  const after = applyCommand(before, { type: 'convert-convention', convention });
  const { units, joints } = before.robot;
  const rows = joints.flatMap((joint, i) => {
    const changes = FIELDS.flatMap(([field, letter]) => {
      const [old, now] = [joint[field], after.robot.joints[i][field]];
      if (old === now) return [];
      const sign = quantityOf(joint, field) === 'angle' && units.angle === 'deg' ? '°' : '';
      const number = (/** @type {number} */ value) => `${compact(value, WIDEST).text}${sign}`;
      return [h('span', { class: 'change' }, symbol(letter), ' ', ...fromTo(number(old), number(now)))];
    });
    return changes.length > 0 ? [line(PREVIEW.row(i + 1), changes)] : [];
  });
  const poses = /** @type {const} */ (['base', 'tool']).flatMap((which) => {
    const [old, now] = [before.robot[which], after.robot[which]];
    return old === now ? [] : [line(PREVIEW[which], fromTo(inWords(old, units), inWords(now, units)))];
  });
  const { metres, radians } = toolGap(before, after);
  const bound = BOUNDS.find(([most]) => metres <= most && radians <= most);
  const same = bound ? PREVIEW.same(bound[1]) : jumpInWords(metres, radians, units);
  return preview(
    rows.length > 0 ? rows : [line(PREVIEW.allRows, [PREVIEW.noRow])],
    poses,
    line(PREVIEW.toolPose, [same]),
  );
}

/** @param {Doc} before @param {'standard' | 'modified'} convention */
export function previewReading(before, convention) {
  const after = applyCommand(before, { type: 'reinterpret-convention', convention });
  const { metres, radians } = toolGap(before, after);
  return preview(
    line(PREVIEW.allRows, [PREVIEW.kept]),
    line(PREVIEW.toolPose, [jumpInWords(metres, radians, before.robot.units)]),
  );
}

/** @param {Doc} before @param {Doc} after */
function toolGap(before, after) {
  const derived = createDerived(); // of its own: what the page has derived stays remembered
  const T = derived.tcp(before).slice();
  return gapBetween(T, derived.tcp(after));
}

/** @param {number} metres @param {number} radians @param {Units} units */
const jumpInWords = (metres, radians, units) =>
  PREVIEW.jump(
    withUnit(poseNumber(fromKernel('length', metres, units), units.length), units.length),
    withUnit(poseNumber(fromKernel('angle', radians, units), units.angle), units.angle),
  );

/** "x 20.3, turned". @param {PoseDoc} pose @param {Units} units */
function inWords(pose, { length, angle }) {
  if (isNoPose(pose)) return PREVIEW.none;
  const shifts = pose.xyz.flatMap((value, i) => (value === 0 ? [] : [`${'xyz'[i]} ${compact(value, WIDEST).text}`]));
  const turns = (pose.rpy ?? []).flatMap((value, i) =>
    value === 0 ? [] : [withUnit(`${PREVIEW.angles[i]} ${compact(value, WIDEST).text}`, angle)],
  );
  const quaternion = pose.quaternion ? [PREVIEW.quaternion] : [];
  return [...(shifts.length > 0 ? [`${shifts.join(' ')} ${unitSign(length)}`] : []), ...turns, ...quaternion].join(
    ', ',
  );
}

/** @param {string} old @param {string} now */
const fromTo = (old, now) => [
  h('span', { class: 'old' }, old),
  h('span', { class: 'arrow', 'aria-hidden': 'true' }, PREVIEW.to),
  spoken(PREVIEW.spokenTo),
  h('span', {}, now),
];

/** @param {string} name @param {readonly (Node | string)[]} content */
const line = (name, content) => [h('dt', {}, name), h('dd', {}, ...content)];

/** @param {...unknown[]} lines */
const preview = (...lines) => h('dl', { class: 'preview' }, .../** @type {Node[]} */ (lines.flat(2)));
