/**
 * What is known of the workspace so far, as the workers say it: plain data with large arrays, which nobody writes to. Lengths are
 * metres, seen from the world.
 *
 * @typedef {object} Cubes   a solid as cubes side by side
 * @property {number} size
 * @property {readonly [number, number, number]} corner  of the first
 * @property {readonly [number, number, number]} counts  along x, y and z; x runs fastest
 * @property {Uint8Array} reached               1 or 0
 * @property {Float32Array} manipulability
 * @property {Float32Array} margin
 * @property {Float32Array} directions
 * @property {Uint8Array | null} postures       null where there are infinitely many
 * @property {number} joints       how many move the tool point
 * @property {number} freedoms     in how many directions they move it in general: 3 makes a volume, 2 a surface, 1 a curve
 * @property {boolean} isMiddle    proven: a cube is reached if its middle is
 * @property {number} volume
 * @property {number} volumeError
 *
 * @typedef {object} CubeScale  of something that is told of each cube
 * @property {number} least
 * @property {number} most
 * @property {boolean} isCount        whole numbers, each a part by itself
 * @property {readonly number[]} shares  of all cubes, in each part of the scale
 *
 * @typedef {object} CubeSummary
 * @property {number} count  of cubes that are reached
 * @property {readonly number[]} low   m, the box of all of them
 * @property {readonly number[]} high
 * @property {{ readonly across: number, readonly area: number, readonly areaError: number } | null} layer  if they are one: the axis square to it
 * @property {Readonly<Record<'height' | 'manipulability' | 'margin' | 'directions', CubeScale> & { postures: CubeScale | null }>} scales
 *
 * @typedef {object} CubeSurface
 * @property {Float32Array} corners    x, y, z each
 * @property {Uint32Array} triangles   three corners each
 * @property {Uint32Array} cubes       the cube that each pair of triangles belongs to
 *
 * @typedef {object} Cells   a region as squares; row by row upwards
 * @property {number} size
 * @property {number} columns
 * @property {number} rows
 * @property {number} u        of the corner of the first
 * @property {number} v
 * @property {Uint8Array} reached
 *
 * @typedef {object} SectionPlane
 * @property {'meridian' | 'plane' | 'flat'} kind   meridian: a half-plane through the axis of the first joint that turns
 * @property {boolean} isAnyAngle
 * @property {{ readonly origin: ArrayLike<number>, readonly u: ArrayLike<number>, readonly v: ArrayLike<number> }} frame
 * @property {Cells} cells
 *
 * @typedef {SectionPlane & {
 *   sides: 'proven' | 'estimated',
 *   outlines: readonly { readonly places: Float64Array, readonly area: number }[],
 *   extent: { readonly u: readonly [number, number], readonly v: readonly [number, number] } | null,
 *   area: number, areaError: number, volume: number | null, volumeError: number | null, gap: number }} TracedSection
 *
 * @typedef {{ readonly code: 'unlimited-slide', readonly joint: number } | { readonly code: 'nothing-moves' }} NotMapped
 *
 * @typedef {object} MapState   how far one question is
 * @property {string} key       of the question
 * @property {boolean} isStale  what is shown is still the answer to the question before
 * @property {'working' | 'done' | 'cancelled' | 'failed'} status  cancelled: what there is stays
 * @property {string} stage
 * @property {number} share     of all work, 0 … 1
 * @property {number | null} secondsLeft  null while nobody can tell
 * @property {NotMapped | null} why  it cannot be mapped
 *
 * @typedef {MapState & { cubes: Cubes | null, surface: CubeSurface | null, summary: CubeSummary | null, hasValues: boolean, places: readonly Float32Array[], placesKey: string | null }} VolumeMap
 *   `summary` is null where nothing is reached; `hasValues`: what the cubes are coloured by is known, not only which are reached
 * @typedef {MapState & { first: (SectionPlane & { beside: number }) | null, section: TracedSection | null, hasNone: boolean }} SectionMap
 *   `first`: until there is a section, with how far from the plane what is drawn of it may be, m; `hasNone`: the arm has no such section, or none that can be told
 *
 * @typedef {{ readonly volume: VolumeMap | null, readonly section: SectionMap | null }} WorkspaceMaps
 */

/** @type {WorkspaceMaps} */
export const NO_MAPS = { volume: null, section: null };
