/**
 * User frames and tools of running code. The controller's system variables hold them: at first those of the document, by their
 * numbers, seen from FANUC's world; a program may set them. KAREL takes $UFRAME and $UTOOL, TP the numbers that are chosen.
 *
 * @import { Doc } from '../document.js'
 * @import { ControllerFrames } from '../controller/frameNumbers.js'
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {Readonly<Record<string, unknown>>} SystemValues
 * @typedef {ControllerFrames & { missing: string[] }} CodeFrames  missing: numbers that the code
 *   chose, and nobody has set: taken as frames that change nothing
 */
import { compose, invert } from '../../kinematics/pose.js';
import { tcpPose } from '../../kinematics/forward.js';
import { configOf } from '../../karel/run/positions.js';
import { firstSystem } from '../../karel/run/systemVariables.js';
import { configurationAt } from '../aim/solutions.js';
import { compilePose, compilePosture, compileRobot } from '../compile.js';
import { controllerPose } from '../controller/codeMoves.js';
import { controllerFrames } from '../controller/frameNumbers.js';
import { PENDANT_UNITS, postureFromPendant } from '../controller/pendantNumbers.js';
import { memo } from '../memo.js';
import { poseInUnits } from '../numbers/poseNumbers.js';

/** Instead of a frame's number: what $UFRAME and $UTOOL say. */
export const OWN_FRAME = -1;
const OWN = /** @type {const} */ ({ user: 'GROUP[1].UFRAME', tool: 'GROUP[1].UTOOL' });
const NUMBERED = /** @type {const} */ ({ user: 'MNUFRAME[1]', tool: 'MNUTOOL[1]' });
export const CHOSEN = /** @type {const} */ ({ user: 'MNUFRAMENUM[1]', tool: 'MNUTOOLNUM[1]' });

/** The document's frames as controllers number them, while robot and frames are the same. */
const framesOf = memo(
  /** @param {Doc['robot']} robot @param {Doc['frames']} frames @param {Doc['activeTool']} activeTool */
  (robot, frames, activeTool) =>
    controllerFrames(/** @type {Doc} */ ({ robot, frames, ...(activeTool !== undefined && { activeTool }) }), 'fanuc'),
);

/** What the system variables hold before a program runs. @param {Doc} doc @param {ControllerFrames} [frames]  where others than the document's numbers hold */
export function systemAtFirst(doc, frames = framesOf(doc.robot, doc.frames, doc.activeTool)) {
  const toZero = invert(frames.T_world_zero);
  const system = firstSystem();
  const chosen = { user: frames.userOf(doc.activeUser), tool: frames.toolOf(/** @type {never} */ ({})) };
  for (const { kind, number, pose } of frames.numbered) {
    const seen =
      kind === 'tool'
        ? compilePose(pose, doc.robot.units)
        : compose(toZero, /** @type {Float64Array} */ (frames.userPose(number)));
    system[`${NUMBERED[kind]}[${number}]`] = positionOf(seen);
    if (number === chosen[kind]) system[OWN[kind]] = positionOf(seen);
  }
  system[CHOSEN.user] = chosen.user;
  system[CHOSEN.tool] = chosen.tool;
  return system;
}

/** A position with ten numbers, as the interpreters have it. @param {Float64Array} T */
function positionOf(T) {
  const { xyz, rpy = [0, 0, 0] } = poseInUnits(T, PENDANT_UNITS);
  return [...xyz, ...rpy, 0, 0, 0, 0];
}

const chainWith = memo(
  /** @param {Doc['robot']} robot @param {string} numbers */
  (robot, numbers) => compileRobot({ ...robot, tool: poseInUnits(controllerPose(JSON.parse(numbers)), robot.units) }),
);

/** @param {Doc} doc @param {SystemValues} system @returns {CodeFrames} */
export function codeFrames(doc, system) {
  const own = framesOf(doc.robot, doc.frames, doc.activeTool);
  /** @type {string[]} */
  const missing = [];
  /** The numbers of a frame; null for none, which changes nothing. @param {'user' | 'tool'} kind @param {number} number */
  function numbers(kind, number) {
    const found = system[number === OWN_FRAME ? OWN[kind] : `${NUMBERED[kind]}[${number}]`];
    const values = Array.isArray(found) ? /** @type {number[]} */ (found.slice(0, 6).map(Number)) : null;
    const isNothing = !values || values.every((value) => value === 0);
    if (isNothing && number > 0 && !own.numbered.some((one) => one.kind === kind && one.number === number))
      missing.push(`${kind === 'user' ? 'UFRAME' : 'UTOOL'} ${number}`);
    return isNothing ? null : values;
  }
  return {
    ...own,
    missing,
    userPose(number) {
      const values = number === 0 ? null : numbers('user', number);
      return values ? compose(own.T_world_zero, controllerPose(values)) : own.T_world_zero;
    },
    /** @returns {Chain} */
    chainOf: (number) =>
      chainWith(
        doc.robot,
        JSON.stringify((number > 0 || number === OWN_FRAME ? numbers('tool', number) : null) ?? [0, 0, 0, 0, 0, 0]),
      ),
  };
}

/**
 * Where the tool is, as code is told: x y z w p r in the chosen frame, and the word of the configuration.
 * @param {Doc} doc
 * @param {SystemValues} system
 * @param {boolean} isTp  which counts by the numbers that are chosen
 * @returns {number[]}
 */
export function positionForCode(doc, system, isTp) {
  const frames = codeFrames(doc, system);
  const of = (/** @type {'user' | 'tool'} */ kind) => (isTp ? Number(system[CHOSEN[kind]] ?? 0) : OWN_FRAME);
  const chain = /** @type {Chain} */ (frames.chainOf(of('tool')));
  const T_world_user = /** @type {Float64Array} */ (frames.userPose(of('user')));
  const T = compose(invert(T_world_user), tcpPose(chain, compilePosture(doc.robot, doc.posture)));
  const word = configOf(configurationAt(doc.robot, chain, doc.posture).fanuc.text ?? '') ?? 0;
  return [...positionOf(T).slice(0, 6), word];
}

/**
 * What joint values, as a pendant counts them, are as a position in the frame and with the tool that are chosen.
 * @param {Doc} doc
 * @param {SystemValues} system
 * @param {readonly number[]} joints
 */
export const positionOfJoints = (doc, system, joints) =>
  positionForCode(
    { ...doc, posture: postureFromPendant(doc.robot, joints.slice(0, doc.robot.joints.length)) },
    system,
    false,
  );
