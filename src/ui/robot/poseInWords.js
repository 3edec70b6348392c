/**
 * A pose in a few words: "z 160 mm, turned".
 *
 * @import { PoseDoc, Units } from '../../model/document.js'
 * @import { Child } from '../parts/dom.js'
 */
import { isNoPose, isNoTurn } from '../../model/noPose.js';
import { h } from '../parts/dom.js';
import { compact } from '../parts/format.js';
import { TEXT } from '../strings.js';

/** How many characters of a shift a line has room for. */
const WIDEST = 7;

/** @param {PoseDoc} pose @param {Units} units @param {string} none @returns {Child[]} */
export function poseInWords(pose, units, none) {
  if (isNoPose(pose)) return [none];
  const shifts = pose.xyz.flatMap((value, i) =>
    value === 0 ? [] : [[h('span', { class: 'm' }, 'xyz'[i]), ` ${compact(value, WIDEST).text} `]],
  );
  if (shifts.length === 0) return [TEXT.robot.turnedOnly];
  return [...shifts.flat(), units.length, isNoTurn(pose) ? null : `, ${TEXT.robot.turned}`];
}
