/**
 * How far a posture is from a singular one, and what is lost there.
 *
 * Two measures that answer different questions. The smallest singular value in homogeneous scale says how badly the arm moves
 * *here*: the twist in the worst direction that joint rates of norm 1 make. The joint-space distance says how far the joints
 * have to go until it does not move in some direction at all. Neither bounds the other for long, since the arm bends.
 *
 * @import { Chain } from './chain.js'
 * @import { Part, PartOptions } from './measures/homogeneous.js'
 * @import { Ground } from './measures/singularPostures.js'
 * @import { SingularityKind } from './measures/singularityKinds.js'
 *
 * @typedef {PartOptions & { withinLimits?: boolean, samples?: number, searches?: number, randomSeed?: number }} SearchOptions
 *   withinLimits: only singular postures inside the joint limits (true). samples: postures looked at on one turn of each
 *   joint (24). searches: walks from postures taken at random (32), with `randomSeed` (1)
 *
 * @typedef {object} SingularityDistance
 * @property {Part} part
 * @property {number} lengthScale     metres
 * @property {number} smallest        singular value r at q, r the freedoms of the arm; homogeneous, so without unit: the
 *   least twist, with metres over L, that joint rates of norm 1 make in a direction the arm has in general
 * @property {boolean} isFound        whether any singular posture was found; false proves nothing
 * @property {number} distance        from q to the nearest singular posture found: the norm of the joint displacements,
 *   radians, slides over L; Infinity if none was found. There may be a nearer one; there is none farther away to worry about
 * @property {Float64Array | null} q  that posture; 0 within rounding there, and never a full turn off
 * @property {number | null} joint    index, from 0, of the joint that moves most on the way, slides over L; null if none moves
 * @property {SingularityKind | null} kind  of that posture: the first of `kinds`
 * @property {SingularityKind[]} kinds      all its names
 *
 * @typedef {object} LostMotion
 * @property {Part} part
 * @property {number} lengthScale     metres
 * @property {[number, number, number]} linear   m/s, base axes; what is lost, or costs most, as a twist at the TCP that is of
 *   length 1 with `linear` over L; its largest entry is positive
 * @property {[number, number, number]} angular  rad/s
 * @property {Float64Array} rates     n: the joint rates, of norm 1 with slides over L, that make `singularValue` times this
 *   twist: at a singularity, the motion of the joints that moves nothing
 * @property {number} singularValue   homogeneous
 * @property {number} gain            joint rates of this norm are the price of the twist; Infinity if it cannot be made
 * @property {number} lostFreedoms    how many independent motions are lost; 0 where the arm is not singular
 */
import { requirePosture } from './checks.js';
import { checkedScale, ownPart, rankOf } from './measures/homogeneous.js';
import { isSlide } from './limits.js';
import { createRandom } from './random.js';
import { singularityKinds } from './measures/singularityKinds.js';
import {
  approach,
  createGround,
  descend,
  distance,
  isNought,
  smallestAt,
  writeGradient,
} from './measures/singularPostures.js';
import { createSvd, decompose } from './measures/singularValues.js';

/** One turn of a joint is looked at in this many places; singular values have two or four minima in a turn. */
const SAMPLES = 24;
const SEARCHES = 32;

/** A rough walk that ends this much farther away than the best is not worth finishing: what is left to gain is a few hundredths. */
const HOPELESS = 1.1;

/** Below this a left singular vector, which is what little there is divided by its length, has fewer than half its digits. */
const VAGUE = 1e-8;

/** @param {Chain} chain @param {ArrayLike<number>} q @param {number} L */
const homogeneousPosture = ({ packed }, q, L) =>
  Float64Array.from(q, (value, i) => (isSlide(packed, i) ? value / L : value));

/** @param {number} count @param {string} what */
function requireCount(count, what) {
  if (!(Number.isInteger(count) && count >= 0)) throw new RangeError(`Expected a number of ${what}, got ${count}.`);
}

/**
 * The nearest singular posture that a search finds. It walks from q itself; from every dent of the singular value on one
 * turn of each joint; and from postures taken at random, nearer than the best so far; each walk ends on a singular posture
 * with none nearer in its neighbourhood. Budgets are counts, so the answer is always the same.
 *
 * Nearest *found*: nothing proves that there is none nearer. Measured by searching three times as hard from random postures:
 * none nearer for five arms of six joints (200 postures), whose singular postures are surfaces; for 5 of 80 of two arms of
 * five joints, some of whose singular postures meet two conditions. It takes about 1,000 decompositions for a 6R arm with a
 * wrist (10 to 20 ms on a weak machine) and three times that for one without: too much for every frame of a drag.
 * `searches: 0` takes half, and found the same for those arms of six joints.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {SearchOptions} [options]
 * @returns {SingularityDistance}
 */
export function distanceToSingularity(chain, q, options = {}) {
  const {
    part = ownPart(chain),
    withinLimits = true,
    samples = SAMPLES,
    searches = SEARCHES,
    randomSeed = 1,
  } = options;
  requirePosture(chain.dof, q);
  requireCount(samples, 'samples');
  requireCount(searches, 'searches');
  const L = checkedScale(chain, options.lengthScale);
  const ground = createGround(chain, part, L, withinLimits);
  const home = homogeneousPosture(chain, q, L);
  if (ground.freedoms === 0) return answer(ground, part, q, home, 0, null);
  // from outside the limits the way in is part of the way
  for (let i = 0; i < home.length; i++) {
    ground.lower[i] = Math.min(ground.lower[i], home[i]);
    ground.upper[i] = Math.max(ground.upper[i], home[i]);
  }
  const smallest = smallestAt(ground, home);
  if (isNought(ground, smallest)) return answer(ground, part, q, home, smallest, home);

  /** @type {Float64Array | null} */
  let best = null;
  let nearest = Infinity;
  const search = (/** @type {Float64Array} */ x) => {
    if (!descend(ground, x)) return;
    if (approach(ground, x, home, true) > HOPELESS * nearest) return;
    const apart = approach(ground, x, home, false);
    if (apart < nearest) [best, nearest] = [x, apart];
  };
  search(home.slice());
  for (const x of dentsAround(ground, home, samples)) search(x);
  const random = createRandom(randomSeed);
  for (let i = 0; i < searches; i++) search(randomNear(ground, home, Math.min(nearest, Math.PI), random));
  return answer(ground, part, q, home, smallest, best);
}

/**
 * Where the singular value is least as one joint makes a turn, half a turn either way, the others standing still.
 * @param {Ground} ground
 * @param {Float64Array} home
 * @param {number} samples  of a turn
 * @returns {Float64Array[]} the nearest first
 */
function dentsAround(ground, home, samples) {
  const { lower, upper } = ground;
  const half = Math.floor(samples / 2);
  const dents = [];
  for (let k = 0; k < home.length; k++) {
    const x = home.slice();
    const places = Array.from({ length: 2 * half + 1 }, (_, i) =>
      Math.min(upper[k], Math.max(lower[k], home[k] + ((i - half) * Math.PI) / half)),
    );
    const heights = places.map((place) => {
      x[k] = place;
      return smallestAt(ground, x);
    });
    for (let i = 0; i <= 2 * half; i++) {
      if (i === half || heights[i] > (heights[i - 1] ?? Infinity) || heights[i] >= (heights[i + 1] ?? Infinity))
        continue;
      x[k] = places[i];
      dents.push(x.slice());
    }
  }
  return dents.sort((a, b) => distance(a, home) - distance(b, home));
}

/**
 * A posture inside the limits, no farther from home than the radius in any joint.
 * @param {Ground} ground
 * @param {Float64Array} home
 * @param {number} radius
 * @param {() => number} random
 */
const randomNear = ({ lower, upper }, home, radius, random) =>
  home.map((value, i) => Math.min(upper[i], Math.max(lower[i], value + (2 * random() - 1) * radius)));

/**
 * @param {Ground} ground
 * @param {Part} part
 * @param {ArrayLike<number>} q
 * @param {Float64Array} home  q in homogeneous scale
 * @param {number} smallest
 * @param {Float64Array | null} best
 * @returns {SingularityDistance}
 */
function answer({ chain, L, lower, upper }, part, q, home, smallest, best) {
  const found = { part, lengthScale: L, smallest, isFound: best !== null };
  if (!best) return { ...found, distance: Infinity, q: null, joint: null, kind: null, kinds: [] };
  const moves = home.map((value, i) => Math.abs(best[i] - value));
  const most = Math.max(...moves);
  const { packed } = chain;
  const singular = best.map((value, i) => {
    // what was not moved, or stands at a limit, is copied: L taken out again would leave a rounding
    if (value === home[i]) return q[i];
    if (value === lower[i]) return packed.lower[i];
    if (value === upper[i]) return packed.upper[i];
    return isSlide(packed, i) ? value * L : value;
  });
  const kinds = singularityKinds(chain, singular);
  const joint = most > 0 ? moves.indexOf(most) : null;
  return { ...found, distance: distance(best, home), q: singular, joint, kind: kinds[0], kinds };
}

/**
 * The twist that cannot be made here, or costs most joint motion, among those that the arm can make in general. Where more
 * than one is lost, it is one of them.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {PartOptions} [options]
 * @returns {LostMotion}
 */
export function lostMotion(chain, q, { part = ownPart(chain), lengthScale } = {}) {
  requirePosture(chain.dof, q);
  const L = checkedScale(chain, lengthScale);
  const ground = createGround(chain, part, L, false);
  const { freedoms, svd, first, u } = ground;
  if (freedoms === 0) throw new RangeError(`Expected an arm that can move in the ${part} part, got one that cannot.`);
  const singularValue = smallestAt(ground, homogeneousPosture(chain, q, L));
  const direction = directionLost(ground, singularValue);
  u.fill(0);
  u.set(direction, first);
  const sizes = u.map(Math.abs);
  const sign = u[sizes.indexOf(Math.max(...sizes))] < 0 ? -1 : 1;
  const rates = svd.V.slice((freedoms - 1) * chain.dof, freedoms * chain.dof);
  for (let i = 0; i < rates.length; i++) rates[i] *= sign * (isSlide(chain.packed, i) ? L : 1);
  const [x, y, z, rx, ry, rz] = u.map((value) => sign * value || 0);
  return {
    part,
    lengthScale: L,
    linear: [x * L, y * L, z * L],
    angular: [rx, ry, rz],
    rates,
    singularValue,
    gain: isNought(ground, singularValue) ? Infinity : 1 / singularValue,
    lostFreedoms: freedoms - Math.min(freedoms, rankOf(svd.values)),
  };
}

/**
 * The direction of singular value r. At a singularity of an arm that cannot make every twist anyway, it is not to be told
 * from those that it never makes, but by moving off: the direction that comes back is the one that was lost. So there it is
 * the largest of what the posture's change makes of the joint motion that moves nothing here, ∂(J v)/∂q.
 * @param {Ground} ground  at the posture
 * @param {number} singularValue
 * @returns {Float64Array} as long as the part has rows
 */
function directionLost(ground, singularValue) {
  const { svd, freedoms, gradient } = ground;
  const { rows, U } = svd;
  const n = gradient.length;
  const last = freedoms - 1;
  if (rows === freedoms || singularValue > VAGUE) return U.slice(last * rows, freedoms * rows);
  const open = rows - last;
  const C = new Float64Array(open * n);
  for (let a = 0; a < open; a++) {
    writeGradient(ground, last + a, last, gradient);
    for (let k = 0; k < n; k++) C[open * k + a] = gradient[k];
  }
  const returning = decompose(C, createSvd(open, n)).U;
  const direction = new Float64Array(rows);
  for (let a = 0; a < open; a++) {
    for (let i = 0; i < rows; i++) direction[i] += returning[a] * U[(last + a) * rows + i];
  }
  return direction;
}
