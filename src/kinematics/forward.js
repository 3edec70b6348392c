/**
 * Forward kinematics: where a posture puts the tool and every link. Allocates nothing when `out` is given.
 * @import { Chain } from './chain.js'
 * @import { Packed } from './packed.js'
 * @import { Pose } from './pose.js'
 */
import { requirePosture, requireRoom } from './checks.js';
import { writeFrames, writeTurns } from './frames.js';
import * as packing from './packed.js';
import { compose } from './pose.js';

// the module's own: see frames.js
const { ROW, LENGTH, COS_TWIST, SIN_TWIST, MOST_JOINTS } = packing;

/** Room for what the joints do, for each number of joints. @type {Float64Array[]} */
const turnsFor = [];

/**
 * T_base_tcp, tool included, seen from the chain's root. The loop of frames.js without the writing down: this is the
 * function that is called most, and it takes half the time.
 * @param {Packed} packed
 * @param {Float64Array} turns  from writeTurns
 * @param {Pose} out
 * @returns {Pose}
 */
function writeTcpPose({ start, rows, lower, tool, hasTool }, turns, out) {
  let x0 = start[0];
  let x1 = start[1];
  let x2 = start[2];
  let y0 = start[4];
  let y1 = start[5];
  let y2 = start[6];
  let z0 = start[8];
  let z1 = start[9];
  let z2 = start[10];
  let p0 = start[12];
  let p1 = start[13];
  let p2 = start[14];
  const n = Math.min(lower.length, MOST_JOINTS);
  for (let i = 0; i < n; i++) {
    const at = ROW * i;
    const t = 3 * i;
    const cos = turns[t];
    const sin = turns[t + 1];
    const d = turns[t + 2];
    // Rz(θ), then the step d along z and a along the new x, then Rx(α)
    const a = rows[at + LENGTH];
    const ca = rows[at + COS_TWIST];
    const sa = rows[at + SIN_TWIST];
    const u0 = cos * x0 + sin * y0;
    const u1 = cos * x1 + sin * y1;
    const u2 = cos * x2 + sin * y2;
    const v0 = cos * y0 - sin * x0;
    const v1 = cos * y1 - sin * x1;
    const v2 = cos * y2 - sin * x2;
    p0 += a * u0 + d * z0;
    p1 += a * u1 + d * z1;
    p2 += a * u2 + d * z2;
    x0 = u0;
    x1 = u1;
    x2 = u2;
    y0 = ca * v0 + sa * z0;
    y1 = ca * v1 + sa * z1;
    y2 = ca * v2 + sa * z2;
    z0 = ca * z0 - sa * v0;
    z1 = ca * z1 - sa * v1;
    z2 = ca * z2 - sa * v2;
  }
  out[0] = x0;
  out[1] = x1;
  out[2] = x2;
  out[3] = 0;
  out[4] = y0;
  out[5] = y1;
  out[6] = y2;
  out[7] = 0;
  out[8] = z0;
  out[9] = z1;
  out[10] = z2;
  out[11] = 0;
  out[12] = p0;
  out[13] = p1;
  out[14] = p2;
  out[15] = 1;
  return hasTool ? compose(out, tool, out) : out;
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q  a value for each joint, radians or metres
 * @param {Pose} [out]
 * @returns {Pose} T_base_tcp: the chain's base and tool are in it
 */
export function tcpPose({ packed }, q, out = new Float64Array(16)) {
  const dof = packed.lower.length; // a chain has getters, and looking anything up in it takes time
  requirePosture(dof, q);
  requireRoom(out, 16);
  const turns = (turnsFor[dof] ??= new Float64Array(3 * dof));
  writeTurns(packed, q, turns);
  return writeTcpPose(packed, turns, out);
}

/**
 * Every link's frame seen from the chain's root, where the book of the chain's convention puts it: a standard frame i at
 * the far end of link i, a modified one on joint i.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {Float64Array} [out]
 * @returns {Float64Array} 16 · (n + 1) numbers: frame 0 (the base), frame 1, … frame n (the flange; no tool)
 */
export function linkFrames({ packed }, q, out = new Float64Array(16 * (packed.lower.length + 1))) {
  const dof = packed.lower.length;
  requirePosture(dof, q);
  requireRoom(out, 16 * (dof + 1));
  const turns = (turnsFor[dof] ??= new Float64Array(3 * dof));
  writeFrames(packed, q, out, { turns, isRelative: false, isAtJoints: packed.isModified });
  if (packed.isModified) out.set(packed.base); // `start` is past the first link
  return out;
}
