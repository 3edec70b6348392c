/**
 * What a person has chosen in the Jacobian panel; it stays when another document is opened.
 *
 * @import { Part } from '../../kinematics/measures/homogeneous.js'
 *
 * @typedef {'world' | 'base' | 'user' | 'tool'} JacobianFrame  whose axes the rows are along; the point is the TCP in all of them
 * @typedef {'forward' | 'central'} DifferenceMethod
 * @typedef {'poses' | 'kernel'} Quotient  poses: forward kinematics twice, subtracted and divided, as in a book; kernel: as the
 *   page's own kernel does it, which subtracts nothing that is nearly equal
 *
 * @typedef {object} JacobianView
 * @property {JacobianFrame} frame
 * @property {DifferenceMethod} method
 * @property {Quotient} quotient
 * @property {number | null} step    radians; null: the kernel's default for the method
 * @property {Part | null} part      whose singular values; null: what the arm is there for
 * @property {'velocity' | 'force' | null} ellipsoid  drawn in the scene
 * @property {readonly number[]} wrench  Fx Fy Fz in N, Mx My Mz in N·m, that the tool presses with, along the axes of `frame`
 */
/** @type {JacobianView} */
export const FIRST_JACOBIAN = {
  frame: 'base',
  method: 'forward',
  quotient: 'poses',
  step: null,
  part: null,
  ellipsoid: null,
  wrench: [0, 0, -10, 0, 0, 0],
};
