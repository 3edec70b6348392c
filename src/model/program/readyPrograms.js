/**
 * Ready programs, made for the arm that is there: somewhere within its reach, as large as it can draw them. Each is to be planned
 * before it is offered, so that what is put into a document can be played; where nothing is found, that is all that is said:
 * other places were not tried.
 *
 * @import { Doc, Ending, PoseTarget, RobotDoc } from '../document.js'
 * @import { NewStep } from './motionCommands.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { PlanQuestion } from '../../motion/planQuestion.js'
 *
 * @typedef {'pick-and-place' | 'weld-seam' | 'circle' | 'lissajous' | 'corners' | 'laws' | 'points'} ReadyId
 * @typedef {{ above: string, grip: string, release: string, arc: string, sharp: string, rounded: string, through: string, past: string,
 *   laws: Record<Law, string> }} ReadyWords  comments of steps
 * @typedef {typeof LAWS[number]} Law
 * @typedef {PlanQuestion} ReadyQuestion
 *
 * @typedef {object} Room   where a program is drawn: in the plane of u and v around a place of the tool, with n pointing away from the work
 * @property {Float64Array} T_world_middle
 * @property {readonly [Axis, Axis, Axis]} axes   u, v, n
 * @property {number} size    m
 * @typedef {readonly [number, number, number]} Axis
 */
import { tcpPose } from '../../kinematics/forward.js';
import { compilePosture, compileRobot } from '../compile.js';
import { homePosture, limitsOf } from '../document.js';
import { atOnce } from '../inSlices.js';
import { applyMotionCommand } from './motionCommands.js';
import { planRequest } from './planRequest.js';
import { poseInUnits } from '../numbers/poseNumbers.js';
import { fromKernel, toKernel } from '../units.js';

/** @type {readonly ReadyId[]} */
export const READY_PROGRAMS = ['pick-and-place', 'weld-seam', 'circle', 'lissajous', 'corners', 'laws', 'points'];

const LAWS = /** @type {const} */ (['trapezoid', 'doubleS', 'cubic', 'quintic', 'timeOptimal']);

/** The first joint of Craig's example 7.3 passes 10, 35, 25 and 10°; in parts of the farthest, seen from the first. */
const CRAIG = [0, 1, 0.6, 0];

/** Laws by which one move leads into the next, through its target or past it. */
const LEADING = ['cubicSpline', 'parabolicBlends'];

/** How far that is: rad, as there, or m; less where the joint has no room for it. */
const SWING = { angle: toKernel('angle', 25, { length: 'm', angle: 'deg' }), length: 0.1 };

/** Of the arm's length, the largest first; and which of them some programs begin with, which would take too long to watch if larger. */
const SIZES = [0.35, 0.25, 0.15, 0.1, 0.06, 0.03];
/** @type {Partial<Record<ReadyId, number>>} */
const LARGEST = { 'weld-seam': 0.15, lissajous: 0.25, corners: 0.25 };

/** m/s */
const QUICK = 0.25;
const SLOW = 0.1;
const SEAM = 0.02;

/** A ten-thousandth of a millimetre, a ten-thousandth of a degree: what nobody types is not written. */
const DIGITS = 7;

/**
 * Asks of one place after the other whether the program can be played there: each question is to be planned by whoever runs this,
 * and answered by whether every move of it can be. Where the arm does not even reach, there is nothing to plan, and it only pauses.
 *
 * @param {Doc} doc
 * @param {ReadyId} id
 * @param {ReadyWords} words
 * @returns {Generator<ReadyQuestion | null, NewStep[] | null, boolean>}  null: not found within the arm's reach
 */
export function* readyProgram(doc, id, words) {
  const chain = compileRobot(doc.robot);
  for (const room of rooms(doc, chain, LARGEST[id] ?? Infinity)) {
    const steps = PROGRAMS[id](drawing(doc, room), words);
    const question = questionOf(doc, chain, steps);
    const canBePlayed = yield question;
    if (question && canBePlayed) return steps;
  }
  return null;
}

/** @param {Doc} doc @param {Chain} chain @param {NewStep[]} steps @returns {PlanQuestion | null} */
function questionOf(doc, chain, steps) {
  const made = applyMotionCommand({ ...doc, motionPrograms: [] }, { type: 'add-motion-program', name: '', steps });
  const [program] = made.motionPrograms;
  const { request, issues } = atOnce(planRequest({ doc: made, program, start: homePosture(doc.robot) }, chain));
  if (issues.length > 0) return null;
  // whether one is refused does not depend on its rounding, which takes the most time
  const sharp = request.moves.map((move) =>
    'law' in move && move.law === 'doubleS' ? { ...move, law: 'trapezoid' } : move,
  );
  return { ...request, moves: /** @type {PlanQuestion['moves']} */ (sharp) };
}

/** @param {Doc} doc @param {Chain} chain @param {number} largest  of SIZES @returns {Generator<Room>} */
function* rooms({ robot, posture }, chain, largest) {
  const middle = robot.joints.map((joint, i) => {
    const { lower, upper } = limitsOf(joint);
    return Number.isFinite(upper - lower) ? (lower + upper) / 2 : (joint.home ?? posture[i]);
  });
  const bent = homePosture(robot).map((value, i) => (value + middle[i]) / 2);
  for (const share of SIZES.filter((one) => one <= largest)) {
    for (const q of [homePosture(robot), posture, bent, middle]) {
      const T = tcpPose(chain, compilePosture(robot, q));
      const size = share * chain.characteristicLength;
      for (const axes of planes(T)) yield { T_world_middle: T, axes, size };
    }
  }
}

/**
 * The floor, the plane that the tool points at, and the planes of an arm that has no third direction.
 * @param {Float64Array} T
 * @returns {(readonly [Axis, Axis, Axis])[]}
 */
function planes(T) {
  const column = (/** @type {number} */ k, /** @type {1 | -1} */ sign) =>
    /** @type {const} */ ([sign * T[4 * k], sign * T[4 * k + 1], sign * T[4 * k + 2]]);
  const [x, y, z] = /** @type {const} */ ([
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ]);
  return [
    [x, y, z],
    [column(0, 1), column(1, 1), column(2, -1)],
    [x, y, y],
    [x, z, z],
  ];
}

/**
 * @param {Doc} doc
 * @param {Room} room
 */
function drawing({ robot }, { T_world_middle, axes: [u, v, n], size }) {
  const { units } = robot;
  const neat = (/** @type {number} */ value) => Number(value.toPrecision(DIGITS));
  /** @param {number} a @param {number} b @param {number} [c] @returns {PoseTarget} */
  function at(a, b, c = 0) {
    const T = T_world_middle.slice();
    for (let k = 0; k < 3; k++) T[12 + k] += size * (a * u[k] + b * v[k] + c * n[k]);
    const { xyz, rpy = [0, 0, 0] } = poseInUnits(T, units);
    return { kind: 'pose', xyz: xyz.map((value) => (Math.abs(value) < 1e-9 ? 0 : neat(value))), rpy: rpy.map(neat) };
  }
  const tool = { speedUnit: /** @type {const} */ ('length/s'), acceleration: 100 };
  const fine = /** @type {const} */ ({ kind: 'fine' });
  const round = (/** @type {number} */ value) => /** @type {const} */ ({ kind: 'percent', value });
  return {
    at,
    fine,
    round,
    size: neat(fromKernel('length', size, units)),
    home: /** @returns {NewStep} */ () => ({
      ...{ kind: 'joint', target: { kind: 'posture', values: homePosture(robot) } },
      ...{ speed: 50, speedUnit: '%', acceleration: 100, ending: fine },
    }),
    /** The first joint away from home, to the side where it has more room. @param {number} share @param {string} law @param {Ending} ending @param {string} [comment] */
    swing: (share, law, ending, comment) =>
      /** @type {NewStep} */ ({
        ...{ kind: 'joint', target: { kind: 'posture', values: swung(robot, share) }, law },
        ...{ speed: 50, speedUnit: '%', acceleration: 100, ending },
        ...(comment !== undefined && { comment }),
      }),
    /** @param {PoseTarget} target @param {string} [comment] @returns {NewStep} */
    joint: (target, comment) => ({
      ...{ kind: 'joint', target, speed: 50, speedUnit: '%', acceleration: 100, ending: fine },
      ...(comment !== undefined && { comment }),
    }),
    /** @param {PoseTarget} target @param {number} speed  m/s @param {Ending} [ending] @param {string} [comment] @returns {NewStep} */
    line: (target, speed, ending = fine, comment = undefined) => ({
      ...{ kind: 'linear', target, speed: fromKernel('length', speed, units), ...tool, ending },
      ...(comment !== undefined && { comment }),
    }),
    /** @param {PoseTarget} via @param {PoseTarget} target @param {number} speed @param {string} [comment] @returns {NewStep} */
    arc: (via, target, speed, comment) => ({
      ...{ kind: 'circular', via, target, speed: fromKernel('length', speed, units), ...tool, ending: fine },
      ...(comment !== undefined && { comment }),
    }),
    /** @param {'on' | 'off'} value @param {string} comment @returns {NewStep[]} */
    output: (value, comment) => [
      { kind: 'set-output', output: 1, value, comment },
      { kind: 'wait', seconds: 0.4 },
    ],
  };
}

/** @param {RobotDoc} robot @param {number} share  of SWING */
function swung(robot, share) {
  const [joint] = robot.joints;
  const [home, ...others] = homePosture(robot);
  const { lower, upper } = limitsOf(joint);
  const isUp = upper - home >= home - lower;
  const quantity = joint.type === 'prismatic' ? 'length' : 'angle';
  const most = Math.min(fromKernel(quantity, SWING[quantity], robot.units), isUp ? upper - home : home - lower);
  return [Number((home + (isUp ? share : -share) * most).toPrecision(DIGITS)), ...others];
}

const POINTS = 24;

/** @type {Record<ReadyId, (draw: ReturnType<typeof drawing>, words: ReadyWords) => NewStep[]>} */
const PROGRAMS = {
  'pick-and-place': ({ at, home, joint, line, output, round }, { above, grip, release }) => [
    home(),
    joint(at(-1, 0, 0.6), above),
    line(at(-1, 0), SLOW),
    ...output('on', grip),
    line(at(-1, 0, 0.6), QUICK, round(50)),
    line(at(1, 0, 0.6), QUICK, round(50), above),
    line(at(1, 0), SLOW),
    ...output('off', release),
    line(at(1, 0, 0.6), QUICK, round(50)),
    home(),
  ],
  'weld-seam': ({ at, home, joint, line, output, round }, { above, arc }) => [
    home(),
    joint(at(-1, -0.4, 0.5), above),
    line(at(-1, -0.4), SLOW),
    ...output('on', arc),
    line(at(0.4, -0.4), SEAM, round(100)),
    line(at(1, 0.4), SEAM),
    { kind: 'set-output', output: 1, value: 'off' },
    line(at(1, 0.4, 0.5), QUICK),
    home(),
  ],
  circle: ({ at, home, joint, arc }) => [
    home(),
    joint(at(1, 0)),
    arc(at(0, 1), at(-1, 0), QUICK),
    arc(at(0, -1), at(1, 0), QUICK),
    home(),
  ],
  lissajous: ({ at, home, joint, line, round }) => {
    const point = (/** @type {number} */ k) => {
      const t = (2 * Math.PI * k) / POINTS;
      return at(Math.sin(3 * t), Math.sin(2 * t));
    };
    const points = Array.from({ length: POINTS }, (_, k) => line(point(k + 1), QUICK, round(50)));
    return [home(), joint(point(0)), ...points, home()];
  },
  corners: ({ at, home, joint, line, fine, size }, { sharp, rounded }) => {
    const square = [at(1, -1), at(1, 1), at(-1, 1), at(-1, -1)];
    const rounding = /** @type {const} */ ({ kind: 'distance', value: Number((size / 2).toPrecision(2)) });
    return [
      home(),
      joint(at(-1, -1)),
      ...square.map((corner, i) => line(corner, QUICK, fine, i === 0 ? sharp : undefined)),
      ...square.map((corner, i) => line(corner, QUICK, i === 3 ? fine : rounding, i === 0 ? rounded : undefined)),
      home(),
    ];
  },
  laws: ({ home, swing, fine }, words) => [
    home(),
    ...LAWS.flatMap((law) => [swing(1, law, fine, words.laws[law]), swing(0, law, fine)]),
  ],
  points: ({ home, swing, fine, round }, { through, past }) => [
    home(),
    ...LEADING.flatMap((law) =>
      CRAIG.slice(1).map((share, i) => {
        const comment = law === 'cubicSpline' ? through : past;
        return swing(share, law, i + 2 < CRAIG.length ? round(100) : fine, i === 0 ? comment : undefined);
      }),
    ),
  ],
};
