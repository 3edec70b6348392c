/** Programs of any moves, for arms of two to seven joints: what every plan has to keep is asked of these. */
import fc from 'fast-check';
import { arm, columnMajor, oracleForward, rodrigues, rotationOf, times } from '../kinematics/oracle.js';

/**
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { JointRow } from '../../../src/kinematics/joint.js'
 * @import { Ending, JointLimits, Move, PlanLaw, ViaLaw } from '../../../src/motion/moves.js'
 *
 * @typedef {Omit<ChainDescription, 'joints'> & { joints: Required<JointRow>[] }} Arm
 *
 * @typedef {object} Step
 * @property {Move['kind']} kind
 * @property {boolean} isNear     whether it goes where the joints say, or where `by` says, which may be out of reach
 * @property {number[]} wobble    rad, and a third of it in metres: from the posture before to the next
 * @property {number[]} bulge     m, of a circle's point on the way
 * @property {number} share       of speeds and accelerations
 * @property {PlanLaw} law
 * @property {ViaLaw | null} through   of a joint move: by this law instead
 * @property {Ending} ending
 *
 * @typedef {object} Program
 * @property {Float64Array} start
 * @property {Move[]} moves
 * @property {JointLimits} limits
 */

/** Rows of a table of turning joints within ± 3. @param {readonly [a: number, alpha: number, d: number][]} rows @returns {Arm} */
const turning = (rows) => ({
  convention: 'standard',
  joints: rows.map(([a, alpha, d]) => ({
    type: /** @type {const} */ ('revolute'),
    a,
    alpha,
    d,
    theta: 0,
    lower: -3,
    upper: 3,
  })),
});
const QUARTER = Math.PI / 2;

const stanford = turning([
  [0, -QUARTER, 0.4],
  [0, QUARTER, 0.15],
  [0, 0, 0.3],
  [0, -QUARTER, 0],
  [0, QUARTER, 0],
  [0, 0, 0.26],
]);
stanford.joints[2] = { ...stanford.joints[2], type: /** @type {const} */ ('prismatic'), d: 0, lower: 0.3, upper: 1.3 };

/** @type {Record<string, { description: Arm, near: number[] }>}   near: a posture that is no singular one */
export const PLAYERS = {
  'a Puma 560': { description: arm('puma560'), near: [0.3, 0.6, -2.6, 0.4, 0.9, 0.2] },
  'a UR5': { description: arm('ur5'), near: [0.3, -1.2, 1.6, -0.7, 0.9, 0.4] },
  'a Stanford arm': { description: stanford, near: [0.3, 0.9, 0.7, 0.4, 0.8, 0.2] },
  'a SCARA': { description: arm('scara_cobra600'), near: [0.2, 0.7, 0.1, 0.3] },
  'a planar arm of two joints': { description: arm('planar2r'), near: [0.4, 1.1] },
  'an arm of three joints': {
    description: turning([
      [0, QUARTER, 0.3],
      [0.4, 0, 0],
      [0.35, 0, 0],
    ]),
    near: [0.3, 0.5, -1.1],
  },
  'an arm of five joints': {
    description: turning([
      [0, QUARTER, 0.3],
      [0.4, 0, 0],
      [0.35, 0, 0],
      [0, QUARTER, 0],
      [0, 0, 0.1],
    ]),
    near: [0.3, 0.5, -1.1, 0.8, 0.2],
  },
  'an arm of seven joints': {
    description: turning([
      [0, -QUARTER, 0.34],
      [0, QUARTER, 0],
      [0, QUARTER, 0.4],
      [0, -QUARTER, 0],
      [0, -QUARTER, 0.4],
      [0, QUARTER, 0],
      [0, 0, 0.126],
    ]),
    near: [0.3, 0.7, 0.2, -1.1, 0.3, 0.9, 0.2],
  },
};

const number = (/** @type {number} */ min, /** @type {number} */ max) => fc.double({ min, max, noNaN: true });
const list = (/** @type {number} */ length, /** @type {fc.Arbitrary<number>} */ one) =>
  fc.array(one, { minLength: length, maxLength: length });

/** @type {fc.Arbitrary<Ending>} */
const anyEnding = fc.oneof(
  fc.constant(/** @type {const} */ ({ kind: 'fine' })),
  fc.record({ kind: fc.constant(/** @type {const} */ ('share')), share: number(0, 1) }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('distance')), distance: number(0, 0.1) }),
);

/** @param {number} dof @returns {fc.Arbitrary<Step>} */
const anyStep = (dof) =>
  fc.record({
    kind: fc.constantFrom('joint', 'joint', 'linear', 'linear', 'linear', 'circular', 'wait'),
    isNear: fc.constantFrom(true, true, true, true, false),
    wobble: list(dof, number(-0.4, 0.4)),
    bulge: list(3, number(-0.1, 0.1)),
    share: number(0.05, 1),
    law: fc.constantFrom('trapezoid', 'doubleS', 'cubic', 'quintic', 'timeOptimal'),
    through: fc.constantFrom(null, null, 'cubicSpline', 'parabolicBlends'),
    ending: anyEnding,
  });

/** @param {Arm} description @param {readonly number[]} near @returns {fc.Arbitrary<Program>} */
export const anyProgram = (description, near) => {
  const dof = description.joints.length;
  return fc
    .record({
      wobble: list(dof, number(-1, 1)),
      rates: list(dof, number(0.5, 6)),
      accelerations: list(dof, number(2, 40)),
      jerks: fc.option(list(dof, number(10, 400)), { nil: undefined }),
      steps: fc.array(anyStep(dof), { minLength: 2, maxLength: 6 }),
      isRounded: fc.constantFrom(true, false, false),
    })
    .map(({ wobble, rates, accelerations, jerks, steps, isRounded }) => {
      const start = beside(description, near, wobble);
      let posture = start;
      const moves = steps.map((each) => {
        const step = isRounded ? { ...each, law: /** @type {const} */ ('doubleS'), through: null } : each;
        if (step.kind === 'wait') return { kind: step.kind, seconds: step.share };
        const from = posture;
        posture = beside(description, posture, step.wobble);
        return moveOf(description, from, posture, step);
      });
      const limits = {
        rates: Float64Array.from(rates),
        accelerations: Float64Array.from(accelerations),
        ...(jerks && { jerks: Float64Array.from(jerks) }),
      };
      return { start: Float64Array.from(start), moves, limits };
    });
};

/** A posture next to another, within the limits. @param {Arm} description @param {readonly number[]} q @param {readonly number[]} by */
const beside = ({ joints }, q, by) =>
  joints.map(({ type, lower, upper }, i) =>
    Math.min(upper, Math.max(lower, q[i] + (type === 'prismatic' ? by[i] / 3 : by[i]))),
  );

/** @param {Arm} description @param {readonly number[]} from @param {readonly number[]} to @param {Step} step @returns {Move} */
function moveOf(description, from, to, { kind, isNear, bulge, share, law, through, ending }) {
  const joint = { posture: Float64Array.from(to), speed: share, acceleration: share, ending };
  if (kind === 'joint') return through ? { kind, ...joint, law: through } : { kind, ...joint, law };
  const [T, end] = [from, to].map((q) => oracleForward(description, q).tcp);
  // a way off may be out of reach, or so turned as the arm cannot be
  const turned = isNear ? rotationOf(end) : times(rodrigues([1, 2, 3], 10 * bulge[0]), rotationOf(end));
  const place = [0, 1, 2].map((i) => end[i][3] + (isNear ? 0 : 3 * bulge[i]));
  const T_base_tcp = columnMajor([...turned.map((row, i) => [...row, place[i]]), [0, 0, 0, 1]]);
  const base = { T_base_tcp, speed: share, turnSpeed: 3 * share, acceleration: 5 * share, law, ending };
  if (kind === 'linear') return { kind, ...base };
  const via = columnMajor(T);
  bulge.forEach((by, i) => (via[12 + i] = (T[i][3] + place[i]) / 2 + by));
  return { kind: /** @type {const} */ ('circular'), via, ...base };
}
