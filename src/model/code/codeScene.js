/**
 * What the scene shows of the code that is open, and what a person asks of it there.
 *
 * @typedef {object} CodePath    of the tool
 * @property {object} shown      as ToolPathShown; the "steps" of its ends are lines, from 0
 * @property {{ readonly times: Float64Array, readonly place: readonly Float64Array[], readonly speed: Float64Array }} shown.series
 * @property {number} shown.most
 * @property {number} shown.dotEvery
 * @property {readonly { time: number, step: number }[]} shown.ends
 * @property {readonly { readonly at: readonly number[], readonly line: number }[]} points   where motions end
 *
 * @typedef {object} CodeScene
 * @property {CodePath | null} path
 * @property {{ readonly line: number } | null} asked   a point of the path was pressed; each time another object
 */

/** @type {CodeScene} */
export const NO_CODE = { path: null, asked: null };
