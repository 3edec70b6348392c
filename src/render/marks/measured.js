/**
 * What the drawing of a dimension is given, be it of a length or of an angle.
 *
 * @import { Vector3 } from 'three'
 * @import { Drafting } from './drafting.js'
 * @import { Eye } from '../eye.js'
 * @import { Label } from '../labels.js'
 * @import { Skin } from '../skins.js'
 *
 * @typedef {{ name: 'x' | 'z', number: string, way: Vector3 }} Axis  `number` is empty where the axis has none yet
 *
 * @typedef {object} Measured
 * @property {Vector3} from
 * @property {Vector3} to
 * @property {Axis & { constant: number }} axis  along or about which it is measured, and what the row alone says
 * @property {[Axis, Axis]} across  from which, to which
 * @property {number} shown   metres or radians
 *
 * @typedef {object} Dimension
 * @property {Label} words
 * @property {(eye: Eye, measured: Measured, middle: Vector3) => void} face  `middle` is the arm's
 * @typedef {{ drafting: Drafting, skin: Skin, size: number, isVariable: boolean }} DimensionOptions
 */
export {};
