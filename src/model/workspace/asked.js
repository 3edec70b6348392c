/**
 * What the workers say of single points, lines and the boundary, and what of it the scene shows: plain data, metres and radians.
 *
 * @typedef {{ readonly joint: number, readonly bound: 'lower' | 'upper' }} Held  a joint at one of its limits
 *
 * @typedef {{ readonly q: Float64Array, readonly limitMargin: { readonly share: number, readonly joint: number } | null }} AnsweredPosture
 *
 * @typedef {object} PointAnswer
 * @property {boolean} isReached
 * @property {boolean} isProven
 * @property {readonly AnsweredPosture[]} postures
 * @property {boolean} areAll
 * @property {number} distance
 * @property {Float64Array} nearest
 * @property {Float64Array | null} nearestPosture
 *
 * @typedef {object} LineAnswer
 * @property {boolean} isTravelled
 * @property {number} share
 * @property {Float64Array | null} start
 * @property {Float64Array | null} end
 * @property {{ readonly place: Float64Array, readonly isReachedBeyond: boolean, readonly held: readonly Held[] } | null} stop
 *
 * @typedef {{ kind: 'meridian' | 'plane' | 'flat', isAnyAngle: boolean,
 *   frame: { readonly origin: ArrayLike<number>, readonly u: ArrayLike<number>, readonly v: ArrayLike<number> },
 *   curves: readonly { readonly kind: 'limit' | 'singular', readonly fixed: readonly Held[] }[],
 *   outlines: readonly { readonly places: Float64Array, readonly curves: Uint32Array, readonly postures: Float64Array, readonly area: number }[] }} CriticalSection
 *
 * @typedef {object} ReachShown   seen from the world
 * @property {readonly { readonly at: readonly number[], readonly text: string, readonly isReached: boolean }[]} points
 * @property {readonly { readonly points: Float64Array, readonly kind: 'trace' | 'way' | 'missing' }[]} lines  x, y and z each
 *
 * @typedef {{ readonly points: ReachShown | null, readonly teach: ReachShown | null }} Probes  of the folds of those names
 */

/** @type {Probes} */
export const NO_PROBES = { points: null, teach: null };
