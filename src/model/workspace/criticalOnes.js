/**
 * The postures that the boundary of a section is made of, one for each stretch of it: where joints are at limits, or those that
 * are free cannot push the tool point any farther.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { CriticalSection, Held } from './asked.js'
 *
 * @typedef {object} CriticalOne
 * @property {number} u   m
 * @property {number} v
 * @property {readonly number[]} q        rad and m, of all joints
 * @property {'limit' | 'singular'} kind
 * @property {readonly Held[]} held
 * @property {readonly number[]} free     joints that are not at a limit and move the tool point in the section
 * @property {'stretched' | 'folded' | 'axis' | null} shape  of the free ones, seen from the first of them; axis: as near to the first
 *   axis as they come
 * @property {number} length              m, of the stretch
 */
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { cross, unit } from '../../kinematics/lines.js';
import { seenInSection, toolPlace } from './sweep.js';

/** A stretch that is a smaller share of its outline is not worth a name. */
const SHORT = 0.01;

/** Nearer to the axis than this (m) is on it: there a half-plane ends, and no posture is critical. */
const ON_AXIS = 1e-4;

/** The cosine of an angle that leaves no doubt. */
const CLEARLY = 0.5;

/** An outline around less of a share of the largest is a speck. */
const SPECK = 1e-4;

/** What is no curve. */
const NONE = -1;

/** A joint is moved by so much, rad, to see whether the tool point comes nearer. */
const NUDGE = 0.02;

/** A joint that moves the tool point by less in all stretches, m/rad, has nothing to do with it. */
const STILL = 1e-7;

/** How far the tool point is from a joint's axis: what the joint does to it. @param {Chain} chain @param {readonly number[]} q @param {number} joint */
function arm(chain, q, joint) {
  const J = geometricJacobian(chain, q);
  return Math.hypot(J[6 * joint], J[6 * joint + 1], J[6 * joint + 2]);
}

/**
 * Whether every free joint, moved either way, brings the tool point away from the axis of a half-plane.
 * @param {Chain} chain
 * @param {CriticalSection} section
 * @param {readonly number[]} q
 * @param {readonly number[]} free
 */
function isNearAxis(chain, section, q, free) {
  if (section.kind !== 'meridian' || !section.isAnyAngle) return false;
  const away = (/** @type {readonly number[]} */ posture) => seenInSection(section, toolPlace(chain, posture))[0];
  const here = away(q);
  return free.every((joint) => [NUDGE, -NUDGE].every((step) => away(q.with(joint, q[joint] + step)) > here));
}

/**
 * Seen from the axis of the first free joint that turns, the way out of the region leads away from it, or towards it.
 * @param {Chain} chain
 * @param {CriticalSection} section
 * @param {readonly number[]} q
 * @param {readonly number[]} free
 * @param {readonly number[]} outwards  along u and v
 * @returns {CriticalOne['shape']}
 */
function shapeOf(chain, section, q, free, outwards) {
  if (isNearAxis(chain, section, q, free)) return 'axis';
  const [first, second] = free.filter((joint) => chain.joints[joint].type === 'revolute');
  if (second === undefined) return null;
  const J = geometricJacobian(chain, q).subarray(6 * first, 6 * first + 6);
  const away = unit(cross(J.subarray(0, 3), J.subarray(3, 6))); // (a × r) × a
  const { u, v } = section.frame;
  const along = [0, 1, 2].reduce((sum, i) => sum + away[i] * (outwards[0] * u[i] + outwards[1] * v[i]), 0);
  return along > CLEARLY ? 'stretched' : along < -CLEARLY ? 'folded' : null;
}

/**
 * @param {Chain} chain
 * @param {CriticalSection} section
 * @returns {CriticalOne[]}  along the outlines, the outer ones first
 */
export function criticalOnes(chain, section) {
  const { kind, isAnyAngle, curves, outlines } = section;
  const turned = kind === 'meridian' ? chain.joints.findIndex(({ type }) => type === 'revolute') : -1;
  const largest = outlines.reduce((most, { area }) => Math.max(most, Math.abs(area)), 0);
  return outlines
    .filter(({ area }) => Math.abs(area) >= SPECK * largest)
    .sort((a, b) => Math.abs(b.area) - Math.abs(a.area))
    .flatMap((outline) => {
      const { places, postures } = outline;
      const count = places.length / 2;
      const lengths = Array.from({ length: count }, (_, k) => {
        const next = (k + 1) % count;
        return Math.hypot(places[2 * next] - places[2 * k], places[2 * next + 1] - places[2 * k + 1]);
      });
      const total = lengths.reduce((sum, length) => sum + length, 0);
      const isOnAxis = (/** @type {number} */ k) =>
        kind === 'meridian' && Math.abs(places[2 * k]) < ON_AXIS && Math.abs(places[2 * ((k + 1) % count)]) < ON_AXIS;
      const keys = lengths.map((_, k) => (isOnAxis(k) ? NONE : outline.curves[k]));
      const outwardsAt = (/** @type {number} */ k) => {
        const next = (k + 1) % count;
        const [du, dv] = [places[2 * next] - places[2 * k], places[2 * next + 1] - places[2 * k + 1]];
        return [dv / lengths[k], -du / lengths[k]]; // the region is on the left
      };
      const found = stretchesOf(keys, lengths, total).map(({ key, at, length }) => {
        const { kind: why, fixed: held } = curves[key];
        const q = Array.from(postures.subarray(chain.dof * at, chain.dof * (at + 1)));
        const isHeld = (/** @type {number} */ joint) => held.some((one) => one.joint === joint);
        const free = Array.from(chain.joints.keys()).filter(
          (joint) => joint !== turned && !isHeld(joint) && arm(chain, q, joint) + arm(chain, nudged(q), joint) > STILL,
        );
        const shape = why === 'singular' ? shapeOf(chain, section, q, free, outwardsAt(at)) : null;
        return { u: places[2 * at], v: places[2 * at + 1], q, kind: why, held, free, shape, length };
      });
      return withoutRepeats(found);
    });

  /** Another posture, in which a joint that the tool point happens to be on the axis of moves it. @param {number[]} q */
  function nudged(q) {
    return q.map((value, i) => (chain.joints[i].type === 'revolute' && isAnyAngle ? value + 0.3 + 0.1 * i : value));
  }
}

/**
 * Neighbours that are there for the same reason are one, as when a curve was traced in parts: the longest stands for all.
 * @param {CriticalOne[]} ones  all the way round an outline
 */
function withoutRepeats(ones) {
  const reason = (/** @type {CriticalOne} */ { kind, held, shape }) => JSON.stringify([kind, held, shape]);
  /** @type {CriticalOne[]} */
  const kept = [];
  const first = Math.max(
    0,
    ones.findIndex((one, k) => reason(one) !== reason(ones[(k + ones.length - 1) % ones.length])),
  );
  for (let i = 0; i < ones.length; i++) {
    const one = ones[(first + i) % ones.length];
    const last = kept[kept.length - 1];
    if (!last || reason(last) !== reason(one)) kept.push(one);
    else if (one.length > last.length) kept[kept.length - 1] = { ...one, length: one.length + last.length };
    else kept[kept.length - 1] = { ...last, length: one.length + last.length };
  }
  return kept;
}

/**
 * Lines one after the other of the same curve, all the way round; what is too short is left out.
 * @param {readonly number[]} keys  NONE for none
 * @param {readonly number[]} lengths
 * @param {number} total
 */
function stretchesOf(keys, lengths, total) {
  const count = keys.length;
  const first = Math.max(
    0,
    keys.findIndex((key, k) => key !== keys[(k + count - 1) % count]),
  );
  /** @type {{ key: number, from: number, to: number, length: number }[]} */
  const runs = [];
  for (let i = 0; i < count; i++) {
    const k = (first + i) % count;
    const last = runs[runs.length - 1];
    if (last?.key === keys[k]) Object.assign(last, { to: i, length: last.length + lengths[k] });
    else runs.push({ key: keys[k], from: i, to: i, length: lengths[k] });
  }
  return runs
    .filter(({ key, length }) => key !== NONE && length >= SHORT * total)
    .map(({ key, from, to, length }) => {
      let [i, done] = [from, 0];
      while (i < to && done < length / 2) done += lengths[(first + i++) % count];
      return { key, at: (first + i) % count, length };
    });
}
