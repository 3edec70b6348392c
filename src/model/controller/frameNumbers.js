/**
 * By which numbers a controller knows the document's user frames and tools. 0 is the controller's own world, and the bare flange.
 * FANUC's world is on axis 1, at the height of axis 2; KUKA's is taken to be the document's.
 *
 * @import { Doc, FrameDoc, MoveStep, PoseDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {'fanuc' | 'kuka'} Brand
 * @typedef {{ kind: 'user' | 'tool', number: number, name: string, pose: PoseDoc }} NumberedFrame
 */
import { linkFrames } from '../../kinematics/forward.js';
import { compose, identity, invert, translation } from '../../kinematics/pose.js';
import { compileRobot } from '../compile.js';
import { identityPose } from '../document.js';
import { fromKernel } from '../units.js';
import { agree, framePose, poseOnly } from '../frames/frames.js';

const MILLIMETRES = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** Sine of the angle between axes that are parallel. */
const PARALLEL = 1e-9;

/**
 * @param {Doc} doc
 * @param {Brand} brand
 * @param {Readonly<Record<string, number>>} [own]  numbers that are to be used instead, by frameKey
 */
export function controllerFrames(doc, brand, own = {}) {
  const { robot, frames, activeTool } = doc;
  /** @type {NumberedFrame[]} */
  const numbered = frames.map((frame) => ({
    ...{ kind: frame.kind, name: frame.id, pose: poseOnly(frame) },
    number: own[frameKey(frame.kind, frame.id)] ?? frame.number ?? freeNumber(frames, frame),
  }));
  const named = (/** @type {'user' | 'tool'} */ kind, /** @type {string | undefined} */ id) =>
    numbered.find((frame) => frame.kind === kind && frame.name === id);
  const isBare = agree(robot.tool, identityPose());
  if (activeTool === undefined && !isBare) {
    const taken = numbered.flatMap(({ kind, number }) => (kind === 'tool' ? [number] : []));
    numbered.push({
      kind: 'tool',
      number: own[frameKey('tool', '')] ?? Math.max(0, ...taken) + 1,
      name: '',
      pose: poseOnly(robot.tool),
    });
  }
  const ownTool = activeTool === undefined ? (isBare ? undefined : named('tool', '')) : named('tool', activeTool);
  const chain = compileRobot(robot);
  const T_world_zero = brand === 'fanuc' ? fanucWorld(chain) : identity();
  /** @type {Map<number, Chain>} */
  const chains = new Map();
  return {
    numbered,
    T_world_zero,
    zero: zeroText(chain),
    /** @param {MoveStep} step */
    toolOf: ({ tool }) => (tool === undefined ? ownTool : named('tool', tool))?.number ?? 0,
    /** @param {string | undefined} id */
    userOf: (id) => named('user', id)?.number ?? 0, // no name, or '': the world
    /** The user frame of a number seen from the world; null where there is none. @param {number} number */
    userPose(number) {
      if (number === 0) return T_world_zero;
      const found = frames.find((frame, i) => frame.kind === 'user' && numbered[i].number === number);
      return found ? framePose(found, robot.units) : null;
    },
    /** The arm with the tool of a number; null where there is none. @param {number} number @returns {Chain | null} */
    chainOf(number) {
      const known = chains.get(number);
      if (known) return known;
      const frame = numbered.find((one) => one.kind === 'tool' && one.number === number);
      if (!frame && number !== 0) return null;
      const chain = compileRobot(
        number === ownTool?.number ? robot : { ...robot, tool: frame?.pose ?? identityPose() },
      );
      chains.set(number, chain);
      return chain;
    },
  };
}

/** @typedef {ReturnType<typeof controllerFrames>} ControllerFrames */

/** Of a frame among others; the tool that has no name is ''. @param {'user' | 'tool'} kind @param {string} name */
export const frameKey = (kind, name) => `${kind} ${name}`;

/** Of the first frame, turned as the base is, where axis 2 has its common normal with axis 1. @param {Chain} chain */
function fanucWorld(chain) {
  const frames = linkFrames(chain, new Float64Array(chain.dof));
  const [T_world_0, T_world_1] = [frames.slice(0, 16), frames.slice(16, 32)];
  if (chain.joints[0].type === 'prismatic') return T_world_0;
  const T_0_1 = compose(invert(T_world_0), T_world_1);
  const [x, y] = chain.convention === 'modified' ? [T_0_1[12], T_0_1[13]] : [0, 0];
  return compose(T_world_0, translation([x, y, T_0_1[14]]));
}

/** What FANUC's world is to an arm, where axis 2 has no height to tell it by. @param {Chain} chain @returns {string | undefined} */
function zeroText(chain) {
  const [{ type }, second] = chain.joints;
  if (type === 'prismatic') return 'taken to be the base of the model';
  const frames = linkFrames(chain, new Float64Array(chain.dof));
  const [z0, z1] = [frames.subarray(8, 11), frames.subarray(24, 27)];
  const isAlong =
    Math.hypot(z0[1] * z1[2] - z0[2] * z1[1], z0[2] * z1[0] - z0[0] * z1[2], z0[0] * z1[1] - z0[1] * z1[0]) < PARALLEL;
  if (!isAlong && second.type !== 'prismatic') return undefined;
  const height = fromKernel('length', compose(invert(frames.slice(0, 16)), fanucWorld(chain))[14], MILLIMETRES);
  return `taken to be on axis 1, ${Number(height.toFixed(3)) + 0} mm from the base of the model`;
}

/** The first number that no frame of its kind has, and no unnumbered one before it gets. @param {readonly FrameDoc[]} frames @param {FrameDoc} frame */
function freeNumber(frames, frame) {
  const alike = frames.filter(({ kind }) => kind === frame.kind);
  const taken = new Set(alike.map(({ number }) => number));
  let count = alike.filter(({ number }) => number === undefined).indexOf(frame);
  let number = 1;
  while (taken.has(number) || count-- > 0) number++;
  return number;
}
