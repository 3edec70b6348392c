/**
 * How far the decimals of code may take the tool from a move of the program, on the way and at its end: not a bound of everything
 * that could be, but where the tool is with the worst that rounding could do to the numbers of this move and of the one before.
 * To joint values it is added up by the Jacobian. Of a way of the tool, of which near points, a half turn or a singular posture make
 * much of little, the ends are moved by the worst and the way is gone anew. More than a millimetre or half a degree is never the
 * decimals' due: there the numbers do not tell where the tool goes.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { FollowedMove } from './followMoves.js'
 * @import { RobotDoc } from '../document.js'
 * @import { Deviation } from './moveMargins.js'
 * @import { MadeMove } from './neutralProgram.js'
 *
 * @typedef {object} WrittenAs
 * @property {boolean} isJoint      the target: joint values, not a position
 * @property {boolean} viaIsJoint
 * @property {Float64Array} T_base_user
 *
 * @typedef {object} DecimalsCost
 * @property {Deviation[]} along        at the shares of the way (SHARES)
 * @property {Float64Array[]} loose     changes of the posture at its end, each of which may be so or the other way
 *
 * @typedef {{ point: number, twist: Float64Array }} Loose   of one of the points of a way: 0 where it begins, 1 on it, 2 its end
 */
import { tcpPose } from '../../kinematics/forward.js';
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { poseFromRotationVector } from '../../kinematics/orientations/axisAngle.js';
import { compose, poseDifference } from '../../kinematics/pose.js';
import { createToolSystem } from '../../motion/toolSystem.js';
import { fromKernel } from '../units.js';
import { asTwists, looseJoints, loosePosition, worstSigns } from './decimals.js';
import { isFull, postureAlong, postureOnWay, SHARES, wayOf } from './followMoves.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** What changes in proportion is right to a thousandth, as small as it is. */
const NEARLY = 1.001;

/**
 * But for the joints that decimals of a position leave open: next to a singular posture, as near as positions are written (a fiftieth,
 * neutralTarget.js), they go farther than in proportion by some hundredths: by 3.3 in what was tried.
 */
const OPEN = 1.05;

/** A pose that decimals leave open by more is not the program's, however little the numbers are off. */
const MOST = { millimetres: 1, degrees: 0.5 };

/**
 * @param {RobotDoc} robot
 * @param {MadeMove} made     of the program
 * @param {WrittenAs} written
 * @param {readonly Float64Array[]} before   loose at the end of the move before
 * @returns {DecimalsCost}
 */
export function decimalsCost(robot, made, written, before) {
  const { move, followed } = made;
  const { chain, end } = followed;
  const joints = written.isJoint ? looseJoints(robot, move.target, end) : null;
  const twists = joints ? asTwists(chain, end, joints) : loosePosition(move.target, written.T_base_user);
  if (!followed.way) {
    const own = joints ?? solved(chain, end, twists).map((change) => change.map((value) => value * OPEN));
    return { along: SHARES.map((share) => ofJoints(followed, share, before, own)), loose: own };
  }
  return ofWay(robot, made, written, asTwists(chain, made.from, before), twists);
}

/** @param {FollowedMove} followed @param {number} share @param {readonly Float64Array[]} before @param {readonly Float64Array[]} own @returns {Deviation} */
function ofJoints({ chain, path }, share, before, own) {
  const scaled = (/** @type {readonly Float64Array[]} */ list, /** @type {number} */ by) =>
    list.map((change) => change.map((value) => value * by));
  return atWorst(asTwists(chain, postureAlong(path, share), [...scaled(before, 1 - share), ...scaled(own, share)]));
}

/** Of twists that add up, each so or the other way. @param {readonly Float64Array[]} up @returns {Deviation} */
function atWorst(up) {
  const down = up.map((twist) => twist.map((value) => -value));
  return inUnits(worstSigns(up, down, 0).size, worstSigns(up, down, 3).size);
}

/**
 * @param {RobotDoc} robot
 * @param {MadeMove} made
 * @param {WrittenAs} written
 * @param {readonly Float64Array[]} begin   twists where it begins
 * @param {readonly Float64Array[]} end
 * @returns {DecimalsCost}
 */
function ofWay(robot, { move, kernel, followed, from }, written, begin, end) {
  const { chain } = followed;
  const via = kernel.kind === 'circular' ? kernel.via : null;
  /** @type {Loose[]} */
  const loose = [
    ...begin.map((twist) => ({ point: 0, twist })),
    ...(via && move.via ? looseVia(robot, move.via, followed, written).map((twist) => ({ point: 1, twist })) : []),
    ...end.map((twist) => ({ point: 2, twist })),
  ];
  const points = [tcpPose(chain, from), via, /** @type {{ T_base_tcp: Float64Array }} */ (kernel).T_base_tcp];
  const full = isFull(chain);
  /** Where the way has the tool, and an arm with few joints, with some of it changed; null: nowhere. @param {readonly Loose[]} changes @param {readonly number[]} shares */
  function going(changes, shares) {
    const [first, on, last] = points.map(
      (T, point) =>
        T &&
        moved(
          T,
          changes.filter((one) => one.point === point),
        ),
    );
    const way = wayOf(/** @type {Float64Array} */ (first), on, /** @type {Float64Array} */ (last));
    if (!way) return null;
    const postures = full ? [] : shares.map((share) => postureOnWay({ ...followed, way }, share));
    return {
      tools: full ? shares.map((share) => way.poseAt(share)) : postures.map((q) => tcpPose(chain, q)),
      postures,
    };
  }
  const own = /** @type {NonNullable<ReturnType<typeof going>>} */ (going([], SHARES));
  const other = (/** @type {Loose} */ { point, twist }) => ({ point, twist: twist.map((value) => -value) });
  const [up, down] = [loose, loose.map(other)].map((list) => list.map((one) => going([one], SHARES) ?? own));
  const along = SHARES.map((share, k) => {
    const [ups, downs] = [up, down].map((list) => list.map(({ tools }) => poseDifference(own.tools[k], tools[k])));
    const [metres, radians] = [0, 3].map((part) => {
      const { signs } = worstSigns(ups, downs, part);
      const sizes = [1, -1].map((side) => {
        const gone = going(
          loose.map((one, i) => (signs[i] * side > 0 ? one : other(one))),
          [share],
        );
        return gone ? sizeOf(poseDifference(own.tools[k], gone.tools[0]), part) : 0;
      });
      return Math.max(...sizes, ...[...ups, ...downs].map((twist) => sizeOf(twist, part)));
    });
    return inUnits(metres, radians);
  });
  // joint values are where a controller goes, on the way or beside it
  if (written.isJoint) along[along.length - 1] = mostOf([along[along.length - 1], atWorst(end)]);
  if (full) return { along, loose: solved(chain, followed.end, end) };
  // into a singular posture and out of it are not alike: the farther
  const open = up.map(({ postures }, i) => {
    const [there, back] = [postures, down[i].postures].map((list) => list[SHARES.length - 1]);
    const changes = [there, back].map((q) => q.map((value, k) => value - own.postures[SHARES.length - 1][k]));
    return Math.hypot(...changes[0]) < Math.hypot(...changes[1]) ? changes[1] : changes[0];
  });
  return { along, loose: open };
}

/** Of the point that an arc passes, only the place. @param {RobotDoc} robot @param {NonNullable<MadeMove['move']['via']>} target @param {FollowedMove} followed @param {WrittenAs} written */
function looseVia(robot, target, { chain, path, way }, { viaIsJoint, T_base_user }) {
  if (!viaIsJoint) return loosePosition(target, T_base_user).slice(0, 3);
  const q = postureAlong(path, way?.viaShare ?? 0);
  return asTwists(chain, q, looseJoints(robot, target, q));
}

/** Changes of the posture that do to the tool what twists say. @param {Chain} chain @param {Float64Array} q @param {readonly Float64Array[]} twists */
function solved(chain, q, twists) {
  const system = createToolSystem(chain.dof);
  system.set(geometricJacobian(chain, q), chain.characteristicLength);
  return twists.map((twist) => {
    const change = new Float64Array(chain.dof);
    system.solve(twist, change);
    return change;
  });
}

/** How far a twist goes, or turns (3). @param {Float64Array} twist @param {number} part */
const sizeOf = (twist, part) => Math.hypot(twist[part], twist[part + 1], twist[part + 2]);

/** A pose, moved by all of its changes. @param {Float64Array} T @param {readonly Loose[]} changes */
function moved(T, changes) {
  const sum = [0, 1, 2, 3, 4, 5].map((row) => changes.reduce((all, { twist }) => all + twist[row], 0));
  const there = compose(poseFromRotationVector([0, 0, 0], sum.slice(3)), T);
  for (let k = 0; k < 3; k++) there[12 + k] = T[12 + k] + sum[k];
  return there;
}

/** The most of each. @param {readonly Deviation[]} list @returns {Deviation} */
export const mostOf = (list) => ({
  millimetres: Math.max(...list.map(({ millimetres }) => millimetres)),
  degrees: Math.max(...list.map(({ degrees }) => degrees)),
});

/** @param {number} metres @param {number} radians @returns {Deviation} */
const inUnits = (metres, radians) => ({
  millimetres: Math.min(MOST.millimetres, NEARLY * fromKernel('length', metres, UNITS)),
  degrees: Math.min(MOST.degrees, NEARLY * fromKernel('angle', radians, UNITS)),
});
