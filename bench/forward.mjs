/**
 * Forward kinematics and Jacobians, against urdf-loader on three and the package `kinematics`.
 * @import { BenchRow } from './run.mjs'
 */
import kinematicsPackage from 'kinematics';
import { createChain } from '../src/kinematics/chain.js';
import { linkFrames, tcpPose } from '../src/kinematics/forward.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../src/kinematics/jacobian.js';
import { FIVE_ARMS, isThere, judgePose, readArm, somePostures } from './arms.mjs';
import { geometricMean, timeCalls } from './measure.mjs';
import { createUrdfArm } from './urdfLoader.mjs';

const POSTURES = 64;

/** @param {string} name */
function measureArm(name) {
  const arm = readArm(name);
  const chain = createChain(arm);
  const urdfPose = createUrdfArm(arm);
  const postures = somePostures(arm, POSTURES);
  const T = new Float64Array(16);
  const frames = new Float64Array(16 * (chain.dof + 1));
  const J = new Float64Array(6 * chain.dof);
  const out = { out: J };
  const times = timeCalls(postures, {
    pose: (q) => void tcpPose(chain, q, T),
    frames: (q) => void linkFrames(chain, q, frames),
    geometric: (q) => void geometricJacobian(chain, q, J),
    differences: (q) => void finiteDifferenceJacobian(chain, q, out),
    urdf: (q) => void urdfPose(q),
  });
  const right = postures.filter((q) => {
    const goal = judgePose(arm, q);
    return isThere(tcpPose(chain, q), goal) && isThere(urdfPose(q), goal);
  });
  return { name, times, note: `${right.length} of ${POSTURES} poses of both are right` };
}

/** A KUKA KR6 R900, near enough, y up as the package wants it: one closed form for arms of this build, one solution. */
function closedForm() {
  const arm = new kinematicsPackage.default([
    [0.025, 0.4, 0],
    [0, 0.455, 0],
    [0.035, 0.035, 0],
    [0.42, 0, 0],
    [0, -0.08, 0],
  ]);
  const postures = somePostures(readArm('kuka_kr6_r900'), POSTURES).map((q) => Array.from(q, (value) => value / 4));
  const poses = postures.map((q) => arm.forward(...toSix(q))[5]);
  const times = timeCalls(
    postures.map((q, k) => ({ q: toSix(q), pose: toSix(poses[k]) })),
    { forward: ({ q }) => void arm.forward(...q), inverse: ({ pose }) => void arm.inverse(...pose) },
  );
  return times;
}

/** @param {number[]} values @returns {[number, number, number, number, number, number]} */
const toSix = ([a, b, c, d, e, f]) => [a, b, c, d, e, f];

/** @returns {BenchRow[]} */
export function bench() {
  const arms = FIVE_ARMS.map(measureArm);
  const mean = (/** @type {keyof (typeof arms)[0]['times']} */ what) =>
    geometricMean(arms.map(({ times }) => times[what]));
  const package_ = closedForm();
  const unit = 'ns';
  return [
    ...arms.map(({ name, times, note }) => ({
      name: `forward kinematics: ${name}`,
      unit,
      median: times.pose,
      peer: { name: 'urdf-loader on three', median: times.urdf },
      ratio: times.urdf / times.pose,
      note,
    })),
    {
      name: 'forward kinematics: geometric mean',
      unit,
      median: mean('pose'),
      peer: { name: 'urdf-loader on three', median: mean('urdf') },
      ratio: mean('urdf') / mean('pose'),
      target: { of: 'ratio', atLeast: 12 },
    },
    {
      name: 'forward kinematics: KR6 R900',
      unit,
      median: arms[FIVE_ARMS.indexOf('kuka_kr6_r900')].times.pose,
      peer: { name: 'kinematics', median: package_.forward },
      ratio: package_.forward / arms[FIVE_ARMS.indexOf('kuka_kr6_r900')].times.pose,
      note: `a similar arm; its inverse, one solution in closed form, takes ${package_.inverse.toFixed(0)} ns`,
    },
    { name: 'all link frames: geometric mean', unit, median: mean('frames') },
    { name: 'geometric Jacobian with forward kinematics: geometric mean', unit, median: mean('geometric') },
    {
      name: 'forward-difference Jacobian with forward kinematics: geometric mean',
      unit,
      median: mean('differences'),
      ratio: mean('differences') / mean('geometric'),
      target: { of: 'ratio', atMost: 2.5 },
      note: 'ratio: to the geometric one',
    },
  ];
}
