/** What a position's decimals cost on the way of a joint move, against postures of poses that are off by as much. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { dexterity } from '../../../src/kinematics/dexterity.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { poseFromRollPitchYaw, rollPitchYawOf } from '../../../src/kinematics/orientation.js';
import { poseDifference } from '../../../src/kinematics/pose.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { roundingAlong } from '../../../src/model/controller/roundingAlong.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { straightPath } from '../../../src/motion/posturePath.js';
import { runs, SEED } from '../../helpers/property.js';

/** @typedef {import('../../../src/model/controller/codeMoves.js').CodeMove} CodeMove */

const HALF = 0.0005; // of the third decimal: mm, degrees
const RADIANS = Math.PI / 180;
const SHARES = [0.25, 0.5, 0.75];
/** A reading of signs: each of the six numbers up or down. */
const CORNERS = Array.from({ length: 64 }, (_, corner) =>
  Array.from({ length: 6 }, (__, k) => (corner & (1 << k) ? HALF : -HALF)),
);

test.each(['abb_irb120', 'kuka_kr6_r900', 'puma560'])('%s: as much as they can cost, and not many times that', (id) => {
  const doc = newDocument(LIBRARY[id]);
  const chain = compileRobot(doc.robot);
  const posture = fc.array(fc.double({ min: 0.2, max: 0.8, noNaN: true }), {
    minLength: 6,
    maxLength: 6,
  });
  const at = (/** @type {readonly number[]} */ shares) =>
    compilePosture(
      doc.robot,
      shares.map((share, i) => {
        const { lower = -180, upper = 180 } = doc.robot.joints[i];
        return lower + share * (upper - lower);
      }),
    );
  fc.assert(
    fc.property(posture, posture, (first, last) => {
      const [from, to] = [at(first), at(last)];
      fc.pre(1 / dexterity(chain, to).conditionNumber > 0.02);
      const move = /** @type {CodeMove} */ (
        /** @type {unknown} */ ({
          ...{ motion: 'joint', isJoint: false },
          followed: { chain, path: straightPath([0, 1], [from, to]), end: to },
        })
      );
      const bound = roundingAlong(doc, null, move);
      const T = tcpPose(chain, to);
      const rpy = rollPitchYawOf(T);
      const worst = { millimetres: 0, degrees: 0 };
      for (const corner of CORNERS) {
        const T_off = poseFromRollPitchYaw(
          [T[12], T[13], T[14]].map((value, k) => value + corner[k] / 1000),
          rpy.map((value, k) => value + corner[3 + k] * RADIANS),
        );
        const found = inverseKinematics(chain, T_off, { seed: to });
        for (const share of SHARES) {
          const between = (/** @type {ArrayLike<number>} */ end) =>
            tcpPose(
              chain,
              from.map((value, i) => value + share * (end[i] - value)),
            );
          const [x, y, z, a, b, c] = poseDifference(between(to), between(found.q));
          worst.millimetres = Math.max(worst.millimetres, 1000 * Math.hypot(x, y, z));
          worst.degrees = Math.max(worst.degrees, Math.hypot(a, b, c) / RADIANS);
        }
      }
      for (const unit of /** @type {const} */ (['millimetres', 'degrees'])) {
        expect(worst[unit]).toBeLessThanOrEqual(bound[unit] * 1.01);
        expect(worst[unit]).toBeGreaterThan(bound[unit] / 10);
      }
    }),
    { seed: SEED, numRuns: runs(3) },
  );
});
