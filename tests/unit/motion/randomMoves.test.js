/**
 * Any moves, one after another, of arms with two to seven joints: they end where they should, hang together, keep the limits
 * and the ways, and are the same again. Ways and places are reckoned here from plain matrices.
 */
import { isDeepStrictEqual } from 'node:util';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { planMotion } from '../../../src/motion/plan.js';
import { planMoment, planMomentAt } from '../../../src/motion/planMoment.js';
import { pathMomentAt } from '../../../src/motion/posturePath.js';
import { SEED, runs } from '../../helpers/property.js';
import {
  angleBetween,
  distanceBetween,
  oracleForward,
  rodrigues,
  rotationOf,
  rowsOf,
  times,
  transpose,
} from '../kinematics/oracle.js';
import { PLAYERS, anyProgram } from './programs.js';

/**
 * @import { MotionPart, MotionPlan } from '../../../src/motion/plan.js'
 * @import { JointLimits, LinearMove, Move } from '../../../src/motion/moves.js'
 * @import { Arm, Program } from './programs.js'
 */

/** The promise of lines and circles: m and rad. */
const [OFF, TURNED] = [1e-5, (0.01 * Math.PI) / 180];

/** Moments between two that are looked at, in each stretch of a law: a hair inside, since accelerations may jump at the ends. */
const INSIDE = [1e-6, 0.35, 0.7, 1 - 1e-6];

/** What a plan passes of its limits at most, by what it says. @param {MotionPlan} plan @param {JointLimits} limits */
function mostUse({ parts, ...plan }, limits) {
  const now = planMoment(plan.start.length);
  let most = 0;
  for (const part of parts) {
    const alone = { ...plan, parts: [part] };
    for (const { start, duration } of part.law.pieces) {
      for (const at of INSIDE) {
        const { rates, accelerations } = planMomentAt(alone, part.begin + start + at * duration, now);
        rates.forEach((rate, i) => (most = Math.max(most, Math.abs(rate) / limits.rates[i])));
        accelerations.forEach((value, i) => (most = Math.max(most, Math.abs(value) / limits.accelerations[i])));
      }
    }
  }
  return most;
}

/** How far what it says it is doing is from what it does: by differences. @param {MotionPlan} plan @param {JointLimits} limits */
function audit(plan, { accelerations }) {
  const count = 400;
  const dof = plan.start.length;
  const [now, before] = [planMoment(dof), planMoment(dof)];
  const found = { gap: 0, jump: 0 };
  const step = plan.duration / count;
  planMomentAt(plan, 0, before);
  for (let k = 1; k <= count; k++) {
    planMomentAt(plan, k * step, now);
    for (let i = 0; i < dof; i++) {
      // by the mean rate it would be here, were its acceleration constant
      const way = now.posture[i] - before.posture[i] - (step * (now.rates[i] + before.rates[i])) / 2;
      found.gap = Math.max(found.gap, Math.max(0, Math.abs(way) - 1e-9) / (step * step * accelerations[i]));
      found.jump = Math.max(
        found.jump,
        Math.max(0, Math.abs(now.rates[i] - before.rates[i]) - 1e-9) / (step * accelerations[i]),
      );
      before.posture[i] = now.posture[i];
      before.rates[i] = now.rates[i];
    }
  }
  return found;
}

/** Positions and rates where parts, pieces of laws and pieces of ways meet. @param {MotionPlan} plan @param {JointLimits} limits */
function mostLeap(plan, { accelerations }) {
  const dof = plan.start.length;
  const [before, after] = [planMoment(dof), planMoment(dof)];
  const hair = 1e-9;
  let most = 0;
  for (const { begin, law } of plan.parts) {
    for (const { start } of law.pieces) {
      const t = begin + start;
      if (t < 2 * hair) continue;
      planMomentAt(plan, t - hair, before);
      planMomentAt(plan, t + hair, after);
      for (let i = 0; i < dof; i++) {
        most = Math.max(most, Math.abs(after.posture[i] - before.posture[i]) - 2.1 * hair * 6);
        most = Math.max(most, Math.abs(after.rates[i] - before.rates[i]) - 2.1 * hair * accelerations[i]);
      }
    }
  }
  return most;
}

/** Where a line has the tool: straight, and turned about one axis at a constant rate. @param {number[][]} from @param {number[][]} to @param {number} share */
function onLine(from, to, share) {
  const D = times(rotationOf(to), transpose(rotationOf(from)));
  const angle = angleBetween(from, to);
  const axis = [D[2][1] - D[1][2], D[0][2] - D[2][0], D[1][0] - D[0][1]];
  const R = angle < 1e-9 ? rotationOf(from) : times(rodrigues(axis, share * angle), rotationOf(from));
  return [...R.map((row, i) => [...row, from[i][3] + share * (to[i][3] - from[i][3])]), [0, 0, 0, 1]];
}

/** How far the tool is off a line at most: ten times between any two of the postures. @param {Arm} description @param {MotionPart} part @param {LinearMove} move */
function mostAstray(description, { path }, move) {
  const { knots } = path;
  const [begin, length] = [knots[0], knots[knots.length - 1] - knots[0]];
  const most = { off: 0, turned: 0 };
  if (length === 0) return most;
  const toolAt = (/** @type {number} */ s) => oracleForward(description, pathMomentAt(path, s).posture).tcp;
  const [from, to] = [toolAt(begin), rowsOf(move.T_base_tcp)];
  for (let k = 0; k < knots.length - 1; k++) {
    for (let part = 0.05; part < 1; part += 0.1) {
      const s = knots[k] + part * (knots[k + 1] - knots[k]);
      const [is, wanted] = [toolAt(s), onLine(from, to, (s - begin) / length)];
      most.off = Math.max(most.off, distanceBetween(is, wanted));
      most.turned = Math.max(most.turned, angleBetween(is, wanted));
    }
  }
  return most;
}

/** When each joint of a joint move has gone nearly all of its way: the latest less the earliest. @param {MotionPart} part @param {MotionPlan} plan */
function apartInTime(part, plan) {
  const alone = { ...plan, parts: [{ ...part }] };
  const [from, to] = [part.begin, part.end].map((t) => planMomentAt(alone, t).posture);
  const times = Array.from(from, (value, i) => {
    if (Math.abs(to[i] - value) < 1e-6) return null;
    let [low, high] = [part.begin, part.end];
    for (let k = 0; k < 60; k++) {
      const middle = (low + high) / 2;
      if (Math.abs(planMomentAt(alone, middle).posture[i] - value) < 0.999 * Math.abs(to[i] - value)) low = middle;
      else high = middle;
    }
    return high;
  }).filter((t) => t !== null);
  return times.length === 0 ? 0 : Math.max(...times) - Math.min(...times);
}

/**
 * Where every move is an S-curve, joints' accelerations hang together, too, from the first to the last, and jerks that are stated are
 * kept; nothing goes anywhere in no time.
 * @param {MotionPlan} plan @param {readonly Move[]} moves @param {JointLimits} limits
 */
function expectRounded(plan, moves, { accelerations, jerks }) {
  const dof = plan.start.length;
  const [before, after] = [planMoment(dof), planMoment(dof)];
  const hair = 1e-9;
  for (const [index, { begin, end, law }] of plan.parts.entries()) {
    const isStill = plan.parts[index].kind === 'wait' || law.to - law.from < 1e-9;
    if (!isStill) expect(end - begin).toBeGreaterThan(0);
  }
  const isRounded = moves.every(
    (move) => move.kind === 'wait' || !('law' in move) || (move.law ?? 'doubleS') === 'doubleS',
  );
  if (!isRounded) return;
  tally.rounded++;
  let [mostJump, mostJerk] = [0, 0];
  for (const { begin, law } of plan.parts) {
    for (const { start, duration } of law.pieces) {
      const t = begin + start;
      if (t < 2 * hair || duration < 1e-6) continue;
      planMomentAt(plan, t - hair, before);
      planMomentAt(plan, t + hair, after);
      for (let i = 0; i < dof; i++) {
        const grows = 2.1 * hair * Math.max(Math.abs(after.jerks[i]), Math.abs(before.jerks[i]));
        const jump = Math.abs(after.accelerations[i] - before.accelerations[i]) - grows;
        mostJump = Math.max(mostJump, jump / accelerations[i]);
        if (jerks) mostJerk = Math.max(mostJerk, Math.abs(after.jerks[i]) / jerks[i]);
      }
    }
  }
  expect(mostJump).toBeLessThan(1e-6);
  expect(mostJerk).toBeLessThan(1.001);
}

const tally = { programs: 0, rounded: 0, moves: 0, planned: 0, lines: 0, refused: 0 };

/** @param {Arm} description @param {Program} program */
function expectSound(description, { start, moves, limits }) {
  const dof = description.joints.length;
  const chain = createChain(description);
  const plan = planMotion(chain, start, moves, limits);
  expect(isDeepStrictEqual(planMotion(chain, start, moves, limits), plan)).toBe(true);
  const count = plan.refused ? plan.refused.move : moves.length;
  expect(plan.parts.map(({ move }) => move)).toEqual(Array.from({ length: count }, (_, i) => i));
  tally.programs++;
  tally.moves += count + (plan.refused ? 1 : 0);
  tally.planned += count;
  if (plan.refused) {
    tally.refused++;
    const { posture, share } = plan.refused;
    expect(share >= 0 && share <= 1).toBe(true);
    description.joints.forEach(({ lower, upper }, i) => {
      expect(posture[i]).toBeGreaterThanOrEqual(lower - 1e-9);
      expect(posture[i]).toBeLessThanOrEqual(upper + 1e-9);
    });
  }
  if (plan.duration === 0) return;
  expect(mostUse(plan, limits)).toBeLessThan(1.001);
  expect(mostLeap(plan, limits)).toBeLessThan(1e-6);
  const { gap, jump } = audit(plan, limits);
  // across a jump of the acceleration from one limit to the other the mean rate is off by a quarter of its step, and no more
  expect(gap).toBeLessThan(0.51);
  expect(jump).toBeLessThan(1.001);
  expectRounded(plan, moves, limits);
  for (const part of plan.parts) {
    for (const { from, to, joint } of part.slowed) {
      expect(from >= 0 && from < to && to <= 1).toBe(true);
      expect(joint === null || (joint >= 0 && joint < dof)).toBe(true);
    }
    const move = moves[part.move];
    if (move.kind === 'wait') continue;
    const stops = (/** @type {number} */ index) => {
      const each = moves[index];
      return index < 0 || each.kind === 'wait' || each.ending.kind === 'fine' || plan.parts[index].notBlended !== null;
    };
    if (!stops(part.move)) continue;
    const { posture } = planMomentAt({ ...plan, parts: plan.parts.slice(0, part.move + 1) }, part.end);
    if (move.kind === 'joint') {
      move.posture.forEach((value, i) => expect(Math.abs(posture[i] - value)).toBeLessThan(1e-9));
      // with blends each joint has its own acceleration, so they are in proportion at both ends only
      const inProportion = move.law !== 'parabolicBlends' && stops(part.move - 1);
      if (inProportion) expect(apartInTime(part, plan)).toBeLessThan(1e-6);
      continue;
    }
    const is = oracleForward(description, posture).tcp;
    expect(distanceBetween(is, rowsOf(move.T_base_tcp))).toBeLessThan(1e-9);
    if (dof >= 6) expect(angleBetween(is, rowsOf(move.T_base_tcp))).toBeLessThan(1e-9);
    if (move.kind === 'linear' && stops(part.move - 1)) {
      tally.lines++;
      const { off, turned } = mostAstray(description, part, move);
      expect(off).toBeLessThan(OFF);
      if (dof >= 6) expect(turned).toBeLessThan(TURNED);
    }
  }
}

describe('any moves', () => {
  test.each(Object.entries(PLAYERS))('of %s are sound', (name, { description, near }) => {
    const before = { ...tally };
    fc.assert(
      fc.property(anyProgram(description, near), (program) => expectSound(description, program)),
      { seed: SEED, numRuns: runs(21) },
    );
    expect(tally.planned - before.planned).toBeGreaterThan(20);
    expect(tally.lines - before.lines).toBeGreaterThan(0);
    if (process.env.DENAVIT_DEEP) console.info(name, tally);
  });
});
