/** What decimals cost: as much as the worst of them, tried one by one, and no more; never so much that another orientation would pass for it. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { dexterity } from '../../../src/kinematics/dexterity.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { identity, poseDifference } from '../../../src/kinematics/pose.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { controllerPose } from '../../../src/model/controller/codeMoves.js';
import { pendantValues } from '../../../src/model/controller/controllerValues.js';
import { decimalsCost } from '../../../src/model/controller/decimalsCost.js';
import { postureAlong, wayOf } from '../../../src/model/controller/followMoves.js';
import { controllerPosition } from '../../../src/model/controller/neutralTarget.js';
import { postureFromPendant } from '../../../src/model/controller/pendantNumbers.js';
import { limitsOf } from '../../../src/model/document.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { straightPath } from '../../../src/motion/posturePath.js';
import { toKernel } from '../../../src/model/units.js';
import { runs, SEED } from '../../helpers/property.js';

/** @import { RobotDoc } from '../../../src/model/document.js' */
/** @import { MadeMove } from '../../../src/model/controller/neutralProgram.js' */

const ARMS = Object.keys(LIBRARY);
const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const share = fc.double({ min: 0.1, max: 0.9, noNaN: true });
const postureOf = (/** @type {RobotDoc} */ { joints }, /** @type {readonly number[]} */ shares) =>
  joints.map((joint, i) => {
    const { lower, upper } = limitsOf(joint);
    const [least, most] = [Math.max(lower, -170), Math.min(upper, 1700)];
    return least + shares[i] * (most - least);
  });

/** A move as a program has it. @param {RobotDoc} robot @param {readonly number[]} to @param {{ kind: 'joint' | 'linear' | 'circular', from: readonly number[], T?: Float64Array, via?: Float64Array }} how */
function madeMove(robot, to, { kind, from, T, via }) {
  const chain = compileRobot(robot);
  const [begin, end] = [from, to].map((posture) => compilePosture(robot, posture));
  const T_base_tcp = T ?? tcpPose(chain, end);
  const way = kind === 'joint' ? null : wayOf(tcpPose(chain, begin), via ?? null, T_base_tcp);
  const target = { joints: pendantValues(robot, to), position: controllerPosition(T_base_tcp) };
  const followed = { chain, end, way, path: straightPath([0, 1], [begin, end]) };
  const move = { target, ...(via && { via: { position: controllerPosition(via) } }) };
  return /** @type {MadeMove} */ (
    /** @type {unknown} */ ({ move, kernel: { kind, T_base_tcp, via }, followed, from: begin })
  );
}
const asPosition = { isJoint: false, viaIsJoint: false, T_base_user: identity() };

/** All that n numbers can be, half a thousandth away and what 24 bits are short of. @param {readonly number[]} numbers */
const corners = (numbers) =>
  Array.from({ length: 2 ** numbers.length }, (_, bits) =>
    numbers.map((value, i) => value + ((bits >> i) & 1 ? 1 : -1) * (0.0005 + Math.abs(value) * 2 ** -24)),
  );

/** mm and degrees. @param {Float64Array} T @param {readonly Float64Array[]} others */
const farthest = (T, others) => {
  const off = others.map((other) => poseDifference(T, other));
  return {
    millimetres: Math.max(...off.map(([x, y, z]) => Math.hypot(x, y, z))) / toKernel('length', 1, UNITS),
    degrees: Math.max(...off.map(([, , , x, y, z]) => Math.hypot(x, y, z))) / toKernel('angle', 1, UNITS),
  };
};
const expectAlike = (/** @type {number} */ cost, /** @type {number} */ worst, most = 1.02) => {
  expect(cost).toBeGreaterThanOrEqual(Math.min(0.5, 0.99 * worst));
  expect(cost).toBeLessThan(most * worst + 1e-9);
  expect(cost).toBeLessThanOrEqual(1);
};

test('of joint values, at the end: the worst of all that they can be, coupled joints with them', () => {
  fc.assert(
    fc.property(fc.constantFrom(...ARMS), fc.array(share, { minLength: 6, maxLength: 6 }), (arm, shares) => {
      const { robot } = newDocument(LIBRARY[arm]);
      const to = postureOf(robot, shares);
      const move = madeMove(robot, to, { kind: 'joint', from: to });
      const { along } = decimalsCost(robot, move, { ...asPosition, isJoint: true }, []);
      const { chain } = move.followed;
      const tools = corners(pendantValues(robot, to)).map((values) =>
        tcpPose(chain, compilePosture(robot, postureFromPendant(robot, values))),
      );
      const worst = farthest(tcpPose(chain, compilePosture(robot, to)), tools);
      expectAlike(along[3].millimetres, worst.millimetres);
      expectAlike(along[3].degrees, worst.degrees);
    }),
    { seed: SEED, numRuns: runs(30) },
  );
});

test('of positions and of arcs, whose points may lie near each other: the worst of all, on the way and at the end', () => {
  const { robot } = newDocument(LIBRARY.abb_irb120);
  const way = fc.record({
    turn: fc.double({ min: 0.6, max: 5.6, noNaN: true }),
    at: fc.double({ min: 0.1, max: 0.9, noNaN: true }),
    size: fc.constantFrom(1e-3, 1e-2, 0.1),
    shares: fc.array(share, { minLength: 6, maxLength: 6 }),
  });
  fc.assert(
    fc.property(way, ({ turn, at, size, shares }) => {
      const from = postureOf(robot, shares);
      const T_from = tcpPose(compileRobot(robot), compilePosture(robot, from));
      const on = (/** @type {number} */ angle) => {
        const T = T_from.slice();
        T[12] += size * Math.sin(angle);
        T[14] += size * (1 - Math.cos(angle));
        return T;
      };
      const [via, T] = [on(turn * at), on(turn)];
      const { along } = decimalsCost(robot, madeMove(robot, from, { kind: 'circular', from, T, via }), asPosition, []);
      const arcs = corners(controllerPosition(via).slice(0, 3)).flatMap((place) =>
        corners(controllerPosition(T)).map((to) => {
          const arc = wayOf(T_from, controllerPose([...place, 0, 0, 0]), controllerPose(to));
          if (!arc) throw new Error('Expected an arc.');
          return arc;
        }),
      );
      const own = wayOf(T_from, via, T);
      for (const [k, part] of [0.25, 0.5, 0.75, 1].entries()) {
        const worst = farthest(
          /** @type {NonNullable<typeof own>} */ (own).poseAt(part),
          arcs.map((arc) => arc.poseAt(part)),
        );
        expectAlike(along[k].millimetres, worst.millimetres);
        expectAlike(along[k].degrees, worst.degrees);
      }
    }),
    { seed: SEED, numRuns: runs(3) },
  );
});

/** Shares of the ranges. */
const middle = fc.array(fc.double({ min: 0.2, max: 0.8, noNaN: true }), { minLength: 6, maxLength: 6 });

test.each(['abb_irb120', 'kuka_kr6_r900', 'puma560'])(
  '%s: of a joint move to a position, on the way, where joints that make up for each other at its end do not',
  (id) => {
    const { robot } = newDocument(LIBRARY[id]);
    fc.assert(
      fc.property(middle, middle, (first, last) => {
        const [from, to] = [first, last].map((shares) => postureOf(robot, shares));
        const move = madeMove(robot, to, { kind: 'joint', from });
        const { chain, path, end } = move.followed;
        fc.pre(1 / dexterity(chain, end).conditionNumber > 0.02);
        const { along } = decimalsCost(robot, move, asPosition, []);
        const ends = corners(move.move.target.position.slice(0, 6)).map(
          (position) => inverseKinematics(chain, controllerPose(position), { seed: end }).q,
        );
        const between = (/** @type {ArrayLike<number>} */ q, /** @type {number} */ part) =>
          tcpPose(
            chain,
            move.from.map((value, i) => value + part * (q[i] - value)),
          );
        for (const [k, part] of [0.25, 0.5, 0.75, 1].entries()) {
          const worst = farthest(
            tcpPose(chain, postureAlong(path, part)),
            ends.map((q) => between(q, part)),
          );
          expectAlike(along[k].millimetres, worst.millimetres, 1.07);
          expectAlike(along[k].degrees, worst.degrees, 1.07);
        }
      }),
      { seed: SEED, numRuns: runs(3) },
    );
  },
);

const FEW = ARMS.filter((id) => LIBRARY[id].joints.length < 6);

test.each(FEW)('%s: less than a degree, in singular postures and next to them, too', (id) => {
  const { robot, posture: home } = newDocument(LIBRARY[id]);
  const folded = robot.joints.map(() => 0);
  const postures = [home, folded, folded.map((_, i) => (i === 1 ? 1e-6 : 0)), folded.map(() => 1e-3)];
  for (const to of postures) {
    const move = madeMove(robot, to, { kind: 'linear', from: to.map((value, i) => value + 3 + i) });
    const { millimetres, degrees } = decimalsCost(robot, move, asPosition, []).along[3];
    expect(millimetres).toBeLessThan(0.01);
    expect(degrees).toBeLessThan(1);
  }
});
