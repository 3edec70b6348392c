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
 *
 * @typedef {'section' | 'volume' | 'tool'} PickGround  where a point that is picked in the scene lands: on the section's plane, in the
 *   middle of a cube of the volume, or on the plane through the tool point that faces whoever looks
 *
 * @typedef {object} ReachHand   the hand on all that in the scene
 * @property {PickGround | null} pick  a press puts a point there; null: it does not
 * @property {readonly number[] | null} over  where it would put it, m
 * @property {{ readonly at: readonly number[] } | { readonly fold: keyof Probes, readonly index: number } | null} pressed  a place, or a
 *   point that is shown, until the panel has taken it
 */

/** @type {Probes} */
export const NO_PROBES = { points: null, teach: null };

/** @type {ReachHand} */
export const NO_HAND = { pick: null, over: null, pressed: null };
