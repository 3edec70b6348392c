/**
 * The workspace as cubes (voxels), with how well the arm works in each. A cube is reached if its middle is, where three joints
 * move the TCP and there is a closed form; for other arms if a posture was seen to land in it, so that those at the edge are
 * reached in part, and one may be missing. What is told of a cube is the best of the postures that landed in it, or all of
 * them together, and so an estimate that grows better with their number:
 *
 * - `manipulability`: the largest √det(J Jᵀ) of the place, m³ (its rows in the plane only, for a planar arm: m²)
 * - `margin`: the largest share of room to the nearest limit, 1 in the middle of all ranges
 * - `directions`: which of 54 directions, evenly about a sphere's cube, the tool's z axis was seen to have, as a share
 *
 * The number of postures is exact where three joints move the TCP, or two in a plane: that of the cube's middle, or of its foot there. For a fixed orientation or
 * a cone of them, inverse kinematics is asked at the middles of the cubes that are reached at all; of a cone, some orientations.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { PlaceSolver } from './exactPlaces.js'
 * @import { Wanted } from './orientationsWanted.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { Ranges } from './placement.js'
 * @import { Voxels } from './voxels.js'
 *
 * @typedef {object} VolumeOptions
 * @property {boolean} [withLimits]  of turning joints (true)
 * @property {number} [cell]         m; missing: a hundredth of the arm's reach
 * @property {Wanted} [wanted]
 * @property {number} [seed]
 * @property {number} [looks]        for each cube of the box, postures of which all is looked at (2); directions need many
 *
 * @typedef {{ stage: 'places' | 'attributes' | 'orientations' | 'middles', share: number, voxels?: Voxels }} VolumeProgress
 */
import { allInverseKinematics } from '../kinematics/allInverse.js';
import { along, dot, minus } from '../kinematics/lines.js';
import { freedomsOf } from '../kinematics/measures/homogeneous.js';
import { createRandom } from '../kinematics/random.js';
import { createPlaceSolver } from './exactPlaces.js';
import { FACINGS, facingOf, shareOfFacings } from './facings.js';
import { orientationsWanted } from './orientationsWanted.js';
import { createPlacement, writePlacement } from './placement.js';
import { flatNormal } from './cut.js';
import { createSampler } from './sampler.js';
import { atOnce, saying } from './steps.js';
import { AT_ONCE, copyOf, cubeAt, emptyVoxels, extentOf, measuring, middleOf } from './voxels.js';

/** Postures for each cube: those of which only the place is looked at, and those of which all is. */
const PLACES_EACH = 12;
const LOOKS_EACH = 2;
const MOST_LOOKS = 6e6;

const SLICE = 1e5;
const LOOK_SLICE = 4e3;

/** The first picture: cubes so many times as large, but not so many along its longest side that postures would miss some. */
const COARSE = 4;
const FIRST_ACROSS = 24;
const FIRST_PLACES = 5e4;

/** Orientations are asked for so many cubes between two words. */
const ASKED = 15;

/** Middles are asked of so many, or passed over. */
const MIDDLES = { asked: 300, passed: 40_000 };

/**
 * @param {Chain} chain
 * @param {VolumeOptions} [options]
 * @returns {Generator<VolumeProgress, Voxels>}
 */
export function* mapVolume(chain, options = {}) {
  const { withLimits = true, seed = 1, wanted = { kind: 'any' }, looks = LOOKS_EACH } = options;
  const sampler = createSampler(chain, { withLimits, seed });
  const arm = { joints: sampler.ranges.joints.length, freedoms: freedomsOf(chain).linear };
  const first = new Float32Array(3 * FIRST_PLACES);
  sampler.fill(0, first);
  const extent = extentOf(first);
  const longest = Math.max(...extent.high.map((value, i) => value - extent.low[i]), 1e-6);
  const size = options.cell ?? longest / 100;

  const coarse = emptyVoxels(extent, Math.max(COARSE * size, longest / FIRST_ACROSS), arm);
  markPlaces(coarse, first);
  yield { stage: 'places', share: 0, voxels: atOnce(measuring(coarse)) };

  const voxels = emptyVoxels(extent, size, arm);
  const places = new Float32Array(3 * SLICE);
  const many = Math.max(FIRST_PLACES, PLACES_EACH * voxels.reached.length);
  for (let done = 0; done < many; done += SLICE) {
    sampler.fill(done, places);
    markPlaces(voxels, places);
    yield { stage: 'places', share: Math.min(1, (done + SLICE) / many) };
  }
  const begun = /** @type {const} */ ({ stage: 'attributes', share: 0 });
  yield { ...begun, voxels: copyOf(yield* saying(begun, measuring(voxels))) };

  yield* lookAt(chain, voxels, withLimits, seed, looks);
  if (wanted.kind !== 'any') yield* keepOriented(chain, voxels, wanted, withLimits);
  const solve = createPlaceSolver(chain, withLimits);
  // a planar arm never leaves its plane, so it is asked where the middles' feet are
  const placement = createPlacement(chain, withLimits);
  const flat = flatNormal(placement);
  if (solve && arm.joints === (flat ? 2 : 3)) {
    const { place } = placement;
    /** @param {Vector} middle */
    const asked = (middle) => (flat ? along(middle, -dot(minus(middle, place), flat), flat) : middle);
    yield* askMiddles(voxels, (middle) => solve(asked(middle)), wanted.kind === 'any');
  }
  return yield* saying({ stage: /** @type {const} */ ('middles'), share: 1 }, measuring(voxels));
}

/**
 * How many postures there are for the middle of each cube that is, or may be, reached.
 * @param {Voxels} voxels
 * @param {(middle: Vector) => ReturnType<PlaceSolver>} solve
 * @param {boolean} isAll  whether that decides what is reached
 * @returns {Generator<VolumeProgress>}
 */
function* askMiddles(voxels, solve, isAll) {
  const { reached, counts } = voxels;
  const landed = reached.slice();
  const postures = new Uint8Array(reached.length);
  let [asked, passed] = [0, 0];
  const steps = [1, counts[0], counts[0] * counts[1]];
  for (let k = 0; k < reached.length; k++) {
    if (++passed >= MIDDLES.passed || asked >= MIDDLES.asked) {
      yield { stage: 'middles', share: k / reached.length };
      asked = passed = 0;
    }
    if (!landed[k] && !steps.some((step) => landed[k + step] || landed[k - step])) continue;
    asked++;
    postures[k] = solve(middleOf(voxels, k)).filter(({ isInside }) => isInside).length;
    if (isAll) reached[k] = Number(postures[k] > 0);
  }
  if (isAll && !reached.includes(1)) {
    reached.set(landed); // a curve or a surface goes through no middle
    return;
  }
  voxels.postures = postures;
  voxels.isMiddle = isAll;
}

/** @param {Voxels} voxels @param {Float32Array} places */
function markPlaces(voxels, places) {
  for (let k = 0; k < places.length; k += 3) {
    const cube = cubeAt(voxels, places[k], places[k + 1], places[k + 2]);
    if (cube >= 0) voxels.reached[cube] = 1;
  }
}

/**
 * Looks at whole postures: how well the arm works where they land.
 * @param {Chain} chain
 * @param {Voxels} voxels
 * @param {boolean} withLimits
 * @param {number} seed
 * @param {number} each
 * @returns {Generator<VolumeProgress>}
 */
function* lookAt(chain, voxels, withLimits, seed, each) {
  const placement = createPlacement(chain, withLimits);
  const { ranges, place, frames, J, q } = placement;
  const { packed } = chain;
  const sampler = createSampler(chain, { withLimits, seed });
  const random = createRandom(seed);
  const isStill = chain.joints.map((_, i) => !ranges.joints.includes(i));
  const facings = new Uint32Array(FACINGS * voxels.reached.length);
  const x = new Float64Array(ranges.joints.length);
  const tool = packed.tool;
  const axis = new Float64Array(3);
  const end = frames.length - 16;
  const looks = Math.min(MOST_LOOKS, each * voxels.reached.length);
  for (let index = 0; index < looks; index++) {
    if (index % LOOK_SLICE === 0) yield { stage: 'attributes', share: index / looks };
    sampler.postureAt(index, q);
    // joints that do not move the TCP turn the tool
    for (let i = 0; i < q.length; i++) {
      if (!isStill[i]) continue;
      const [low, high] = [Math.max(packed.lower[i], -Math.PI), Math.min(packed.upper[i], Math.PI)];
      q[i] = low + random() * (high - low);
    }
    for (let k = 0; k < x.length; k++) x[k] = q[ranges.joints[k]];
    writePlacement(placement, x);
    const cube = cubeAt(voxels, place[0], place[1], place[2]);
    if (cube < 0) continue;
    voxels.reached[cube] = 1;
    voxels.manipulability[cube] = Math.max(voxels.manipulability[cube], manipulabilityOf(J));
    voxels.margin[cube] = Math.max(voxels.margin[cube], marginOf(ranges, x));
    for (let row = 0; row < 3; row++) {
      axis[row] = frames[end + row] * tool[8] + frames[end + 4 + row] * tool[9] + frames[end + 8 + row] * tool[10];
    }
    const facing = facingOf(axis);
    facings[FACINGS * cube + (facing >> 5)] |= 1 << (facing & 31);
  }
  for (let cube = 0; cube < voxels.reached.length; cube++) {
    if (cube % AT_ONCE === AT_ONCE - 1) yield { stage: 'attributes', share: 1 };
    voxels.directions[cube] = shareOfFacings(facings, cube);
  }
}

/**
 * √ of the sum of squares of all determinants of the largest size that do not vanish: the volume, or the area, that unit rates
 * of the joints sweep.
 * @param {Float64Array} J  3 · m
 */
function manipulabilityOf(J) {
  let [a, b, c, d, e, f] = [0, 0, 0, 0, 0, 0];
  for (let k = 0; k < J.length; k += 3) {
    a += J[k] * J[k];
    b += J[k] * J[k + 1];
    c += J[k] * J[k + 2];
    d += J[k + 1] * J[k + 1];
    e += J[k + 1] * J[k + 2];
    f += J[k + 2] * J[k + 2];
  }
  const whole = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d);
  const flat = a * d - b * b + a * f - c * c + d * f - e * e;
  return Math.sqrt(Math.max(0, whole > 1e-9 * flat * Math.sqrt(Math.max(0, flat)) ? whole : flat));
}

/** @param {Ranges} ranges @param {Float64Array} x */
function marginOf({ lower, upper, isClosed }, x) {
  let least = 1;
  for (let k = 0; k < x.length; k++) {
    if (isClosed[k] || upper[k] === lower[k]) continue;
    least = Math.min(least, (2 * Math.min(x[k] - lower[k], upper[k] - x[k])) / (upper[k] - lower[k]));
  }
  return least;
}

/**
 * Leaves those cubes where the tool can be turned as wanted, at the middle.
 * @param {Chain} chain
 * @param {Voxels} voxels
 * @param {Exclude<Wanted, { kind: 'any' }>} wanted
 * @param {boolean} withLimits
 * @returns {Generator<VolumeProgress>}
 */
function* keepOriented(chain, voxels, wanted, withLimits) {
  const cubes = Array.from(voxels.reached.keys()).filter((cube) => voxels.reached[cube]);
  const poses = orientationsWanted(wanted);
  for (const [done, cube] of cubes.entries()) {
    const middle = middleOf(voxels, cube);
    const isThere = poses.some((T) => {
      T.set(middle, 12);
      const { solutions, families } = allInverseKinematics(chain, T, { onlyWithinLimits: withLimits });
      return solutions.length > 0 || families.some(({ withinLimits }) => withinLimits || !withLimits);
    });
    if (!isThere) voxels.reached[cube] = 0;
    if (done % ASKED === ASKED - 1) yield { stage: 'orientations', share: done / cubes.length };
  }
}
