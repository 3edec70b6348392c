/**
 * All postures that take the tool to a target, as a list to compare: the document's numbers in, the kernel asked, and for each
 * solution what people and controllers call it, how far it is from here, and how much room its joints have.
 *
 * @import { Doc, RobotDoc } from '../document.js'
 * @import { AllSolutions, Solution } from '../../kinematics/allInverse.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { FanucConfiguration, KukaStatusTurn, PostureName } from '../../kinematics/postureNames.js'
 *
 * @typedef {AllSolutions} SolvedAll  as the kernel answers
 * @typedef {Pick<AllSolutions, 'families' | 'complete'> & { solutions: readonly Pick<Solution, 'q' | 'withinLimits' | 'name'>[] }} Listed
 *
 * @typedef {object} JointRoom  of the joint that has the least of it, as a share of its range
 * @property {number} joint   from 0
 * @property {number} room    to the nearer limit, in document units; negative: so far past it
 * @property {number} share   of half the range: 1 in the middle, 0 at a limit
 *
 * @typedef {object} SolutionDoc
 * @property {readonly number[]} posture  in document units
 * @property {boolean} withinLimits
 * @property {JointRoom | null} room      null if no joint has limits
 * @property {PostureName} name
 * @property {FanucConfiguration} fanuc
 * @property {KukaStatusTurn} kuka
 * @property {readonly (readonly [number, number])[]} figure  the arm from the side, as points; metres
 *
 * @typedef {object} FoundSolutions
 * @property {readonly SolutionDoc[]} solutions  those inside the limits first, then the nearest first
 * @property {AllSolutions['families']} families
 * @property {boolean} complete
 */
import { allInverseKinematics } from '../../kinematics/allInverse.js';
import { allPlaces } from '../../kinematics/allPlaces.js';
import { linkFrames, tcpPose } from '../../kinematics/forward.js';
import { fanucConfiguration, kukaStatusTurn, namePosture, prepareNames } from '../../kinematics/postureNames.js';
import { recognise } from '../../kinematics/solvers/solvers.js';
import { compilePosture, postureFromKernel } from '../compile.js';
import { pendantValues } from '../controller/controllerValues.js';
import { isSliding, limitsOf, quantityOf } from '../document.js';
import { toKernel, toRadians } from '../units.js';

/** Where the arms of the list are seen from: the front right, as in the first picture, and from the side. */
const AZIMUTH = -0.55;
const TILT = 0.12;

/** A joint that is nearer than this (radians, arm lengths) to where it was stands there. */
const HERE = 1e-6;

/** Whether all solutions of this arm have to be searched for, which takes a while. @param {Chain} chain */
export const needsSearch = (chain) => recognise(chain).solver === null;

/**
 * @param {Doc} doc      the present posture decides among full turns, and the order
 * @param {Chain} chain  compiled from `doc.robot`
 * @param {Float64Array} T_world_target
 * @returns {AllSolutions}
 */
export const solveAll = ({ robot, posture }, chain, T_world_target) =>
  allInverseKinematics(chain, T_world_target, { seed: compilePosture(robot, posture) });

/**
 * All postures that bring the tool's point to a place, its orientation being none of the arm's choice.
 * @param {Doc} doc
 * @param {Chain} chain
 * @param {Float64Array} T_world_target
 * @returns {Listed | null} null for an arm that has a choice
 */
export function solvePlace({ robot, posture }, chain, T_world_target) {
  const places = allPlaces(chain, T_world_target, compilePosture(robot, posture));
  const names = namesOf(chain);
  return (
    places && {
      solutions: places.map((place) => ({ ...place, name: namePosture(names, place.q) })),
      families: [],
      complete: true,
    }
  );
}

/**
 * The same question as plain numbers, for a worker.
 * @param {Doc} doc
 * @param {Chain} chain
 * @param {Float64Array} T
 */
export const questionFor = ({ robot, posture }, { convention, base, tool, joints }, T) => ({
  chain: { convention, base, tool, joints: joints.map((joint) => ({ ...joint })) },
  T: T.slice(),
  seed: compilePosture(robot, posture),
});

/**
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {readonly number[]} from  the posture that travel is counted from
 * @param {Listed} all
 * @returns {FoundSolutions}
 */
export function describeSolutions(robot, chain, from, { solutions, families, complete }) {
  const described = solutions.map(({ q, withinLimits, name }) => {
    const posture = postureFromKernel(robot, q);
    return {
      posture,
      withinLimits,
      room: roomOf(robot, posture),
      name,
      ...configurationAt(robot, chain, posture),
      figure: figureOf(chain, q),
    };
  });
  const order = described
    .map((solution) => ({ solution, way: travelBetween(robot, chain, from, solution.posture).way }))
    .sort((a, b) => Number(b.solution.withinLimits) - Number(a.solution.withinLimits) || a.way - b.way);
  return { solutions: order.map(({ solution }) => solution), families, complete };
}

/**
 * The joint that has to go farthest.
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {readonly number[]} from
 * @param {readonly number[]} to
 * @returns {{ joint: number, by: number, way: number, isHere: boolean }} `by` in document units; `way` compares turns and slides
 */
export function travelBetween(robot, chain, from, to) {
  let farthest = { joint: 0, by: 0, way: 0 };
  robot.joints.forEach((joint, i) => {
    const by = Math.abs(to[i] - from[i]);
    const kernel = toKernel(quantityOf(joint, 'home'), by, robot.units);
    const way = isSliding(joint) ? kernel / chain.characteristicLength : kernel;
    if (way > farthest.way) farthest = { joint: i, by, way };
  });
  return { ...farthest, isHere: farthest.way < HERE };
}

/** @param {RobotDoc} robot @param {readonly number[]} posture @returns {JointRoom | null} */
function roomOf(robot, posture) {
  /** @type {JointRoom | null} */
  let least = null;
  robot.joints.forEach((each, joint) => {
    const { lower, upper } = limitsOf(each);
    const room = Math.min(posture[joint] - lower, upper - posture[joint]);
    if (!Number.isFinite(room)) return;
    const half = (upper - lower) / 2;
    // with a stop on one side only there is no range to have a share of: it counts once it is passed
    const share = Number.isFinite(half) && half > 0 ? room / half : room < 0 ? room / (1 + Math.abs(room)) : 1;
    if (!least || share < least.share) least = { joint, room, share };
  });
  return least;
}

/** @type {WeakMap<Chain, ReturnType<typeof prepareNames>>} */
const knownNames = new WeakMap();

/** @param {Chain} chain */
function namesOf(chain) {
  let names = knownNames.get(chain);
  if (!names) {
    const { start } = chain.packed;
    names = prepareNames(recognise(chain).screws, [start[2], start[6], start[10]]);
    knownNames.set(chain, names);
  }
  return names;
}

/**
 * What controllers call a posture, by the joint values as the controller counts them.
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {readonly number[]} posture
 */
export function configurationAt(robot, chain, posture) {
  const names = namesOf(chain);
  const q = compilePosture(robot, posture);
  const hasOwnCount = robot.joints.some(
    ({ controller: { sign, offset, coupledTo } }) => sign !== 1 || offset !== 0 || coupledTo !== undefined,
  );
  const options = hasOwnCount && robot.joints.every((joint) => !isSliding(joint)) ? { axisValues: axisValues() } : {};
  function axisValues() {
    return pendantValues(robot, posture).map(toRadians);
  }
  return { fanuc: fanucConfiguration(names, q, options), kuka: kukaStatusTurn(names, q, options) };
}

/** What people call a posture. @param {RobotDoc} robot @param {Chain} chain @param {readonly number[]} posture */
export const nameAt = (robot, chain, posture) => namePosture(namesOf(chain), compilePosture(robot, posture));

/** @param {Chain} chain @param {ArrayLike<number>} q @returns {[number, number][]} */
function figureOf(chain, q) {
  const frames = linkFrames(chain, q);
  const T = tcpPose(chain, q);
  const places = Array.from({ length: chain.dof + 1 }, (_, i) => frames.subarray(16 * i + 12, 16 * i + 15));
  const [cos, sin] = [Math.cos(AZIMUTH), Math.sin(AZIMUTH)];
  const points = [...places, T.subarray(12, 15)].map(([x, y, z]) => {
    const across = x * cos + y * sin;
    const away = y * cos - x * sin;
    return /** @type {[number, number]} */ ([across, z + TILT * away]);
  });
  return points.filter((point, i) => i === 0 || point.some((value, k) => value !== points[i - 1][k]));
}

/**
 * The same solutions in the order of an older list, as far as they were on it, so that no row changes its number while a
 * person reads; what is new comes after.
 * @param {readonly SolutionDoc[]} older
 * @param {readonly SolutionDoc[]} found
 * @param {RobotDoc} robot
 */
export function inOrderOf(older, found, robot) {
  const rest = [...found];
  const kept = older.flatMap((old) => {
    const at = rest.findIndex(({ posture }) => isSamePosture(robot, old.posture, posture));
    return at < 0 ? [] : rest.splice(at, 1);
  });
  return [...kept, ...rest];
}

/**
 * Whether two lists have the same postures, in whatever order.
 * @param {readonly SolutionDoc[]} one
 * @param {readonly SolutionDoc[]} other
 * @param {RobotDoc} robot
 */
export const isOneList = (one, other, robot) =>
  one.length === other.length &&
  one.every(({ posture }) => other.some((each) => isSamePosture(robot, posture, each.posture)));

/** Full turns aside. @param {RobotDoc} robot @param {readonly number[]} a @param {readonly number[]} b */
function isSamePosture({ joints, units }, a, b) {
  return joints.every((joint, i) => {
    const away = toKernel(quantityOf(joint, 'home'), b[i] - a[i], units);
    const rest = isSliding(joint) ? away : away - 2 * Math.PI * Math.round(away / (2 * Math.PI));
    return Math.abs(rest) < HERE;
  });
}
