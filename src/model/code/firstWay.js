/**
 * Where a first program may take the arm: up, where it can go up; an arm that keeps to a plane goes along another axis of frame 0.
 *
 * @import { Doc } from '../document.js'
 *
 * @typedef {'x' | 'y' | 'z'} Axis
 */
import { compilePosture } from '../compile.js';
import { CHOSEN, positionForCode, systemAtFirst } from './codeFrames.js';
import { movesOf } from './codeMoves.js';

/** The first that the arm can go along. @type {readonly [Axis, number][]} */
const AXES = [
  ['z', 2],
  ['y', 1],
  ['x', 0],
];

const LINE = {
  ...{ kind: 'move', to: 'TO', motion: 'L', isJoint: false, userFrame: 0, toolFrame: 0 },
  ...{ speed: { value: 100, unit: 'mm/sec' }, termination: { kind: 'FINE' } },
};

/** @param {Doc} doc @param {number} millimetres @returns {Axis} up, where the arm can go along none */
export function firstWay(doc, millimetres) {
  const system = { ...systemAtFirst(doc), [CHOSEN.user]: 0, [CHOSEN.tool]: 0 };
  const here = positionForCode(doc, system, true);
  const from = compilePosture(doc.robot, doc.posture);
  const found = AXES.find(
    ([, k]) => !('message' in movesOf(doc, from, { ...LINE, position: here.with(k, here[k] + millimetres) }, system)),
  );
  return found?.[0] ?? 'z';
}
