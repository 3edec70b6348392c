/**
 * What can be copied, gathered as numbers with their names: a pose, its matrix, the links' transforms, the joint values; in
 * the document's units or in metres and radians.
 *
 * @import { Doc, RobotDoc, Units } from '../document.js'
 * @import { CopySheet } from './copyText.js'
 * @import { FrameId } from './frameNumbers.js'
 * @import { OrientationForm } from './orientationNumbers.js'
 */
import { isSliding } from '../document.js';
import { rowsOf } from './poseRows.js';
import { convertAngle, convertLength } from '../units.js';
import { compilePosture } from '../compile.js';

/** @type {Units} */
export const KERNEL_UNITS = { length: 'm', angle: 'rad' };

/**
 * Lengths shift their decimal point and angles keep their last digit but one: see units.js.
 * @param {'length' | 'angle' | 'none'} quantity
 * @param {number} value  metres, radians
 * @param {Units} units
 */
function inUnits(quantity, value, units) {
  if (quantity === 'length') return convertLength(value, 'm', units.length);
  return quantity === 'angle' ? convertAngle(value, 'rad', units.angle) : value;
}

/** @param {Float64Array} T @param {Units} units */
const rowsIn = (T, units) =>
  rowsOf(T).map((row, i) => row.map((value, j) => (j === 3 && i < 3 ? inUnits('length', value, units) : value)));

/** @typedef {FrameId | 'target'} CopiedFrame */

/** In words: "the tool", "frame 3". @param {CopiedFrame} frame */
export function frameName(frame) {
  if (typeof frame === 'number') return frame === 0 ? 'base' : `frame ${frame}`;
  return frame;
}

/** @param {CopiedFrame} frame */
const idOf = (frame) => (typeof frame === 'number' ? (frame === 0 ? 'base' : `f${frame}`) : frame);
/** @param {CopiedFrame} frame */
const texOf = (frame) => (typeof frame === 'number' && frame > 0 ? String(frame) : `\\mathrm{${idOf(frame)}}`);

/** @typedef {{ robot: RobotDoc, frame: CopiedFrame, from: FrameId, T: Float64Array, units: Units }} PosePlace */

/** @param {PosePlace} place */
const factsOf = ({ robot, frame, from, units }) => ({
  robot: robot.name,
  frame: frameName(frame),
  seenFrom: frameName(from),
  units,
});

/** @param {PosePlace} place */
const titleOf = ({ robot, frame, from }) =>
  `${robot.name || 'Robot'}: pose of ${frameName(frame)} in ${frameName(from)}`;

/**
 * Position and orientation.
 * @param {PosePlace} place
 * @param {OrientationForm} form
 * @returns {CopySheet}
 */
export function poseSheet(place, form) {
  const { frame, from, T, units } = place;
  const { values } = form.read(T, KERNEL_UNITS);
  const product = form.product ? `, R = ${form.product}` : '';
  const hasAngles = form.quantities.includes('angle');
  const subscript = `${texOf(frame)}`;
  return {
    title: titleOf(place),
    facts: { ...factsOf(place), convention: form.name, ...(form.product && { product: form.product }) },
    items: [
      {
        name: 'position',
        latex: `{}^{${texOf(from)}}p_{${subscript}}`,
        about: `position X, Y, Z in ${units.length}`,
        labels: ['X', 'Y', 'Z'],
        values: [T[12], T[13], T[14]].map((value) => inUnits('length', value, units)),
      },
      {
        name: 'orientation',
        latex: `{}^{${texOf(from)}}o_{${subscript}}`,
        about: `orientation ${form.name}: ${form.labels.join(', ')}${hasAngles ? ` in ${units.angle}` : ''}${product}`,
        labels: form.labels,
        values: values.map((value, k) => inUnits(form.quantities[k], value, units)),
      },
    ],
  };
}

/** @param {PosePlace} place @returns {CopySheet} */
export function matrixSheet(place) {
  const { frame, from, T, units } = place;
  const name = `T_${idOf(from)}_${idOf(frame)}`;
  return {
    title: titleOf(place),
    facts: factsOf(place),
    items: [
      {
        name,
        latex: `{}^{${texOf(from)}}T_{${texOf(frame)}}`,
        about: `${name}, lengths in ${units.length}`,
        rows: rowsIn(T, units),
      },
    ],
  };
}

/**
 * @param {RobotDoc} robot
 * @param {readonly { index: number, A: Float64Array }[]} links  index 0 is the first
 * @param {Units} units
 * @returns {CopySheet}
 */
export const linksSheet = (robot, links, units) => ({
  title: `${robot.name || 'Robot'}: link transforms, ${robot.convention} DH`,
  facts: { robot: robot.name, convention: `${robot.convention} DH`, units },
  items: links.map(({ index, A }) => ({
    name: `A${index + 1}`,
    latex: `A_{${index + 1}}`,
    about: `A${index + 1}: frame ${index + 1} in ${index === 0 ? 'base' : `frame ${index}`}, lengths in ${units.length}`,
    rows: rowsIn(A, units),
  })),
});

/**
 * Joint values: those of the document as they stand there, or in metres and radians.
 * @param {Doc} doc
 * @param {Units} units  the document's own, or the kernel's
 * @returns {CopySheet}
 */
export function jointsSheet({ robot, posture }, units) {
  const isOwn = units.length === robot.units.length && units.angle === robot.units.angle;
  const own = robot.joints.map((joint) => units[isSliding(joint) ? 'length' : 'angle']);
  const names = robot.joints.map((_, i) => `J${i + 1}`);
  const isSame = own.every((unit) => unit === own[0]);
  return {
    title: `${robot.name || 'Robot'}: joint values`,
    facts: { robot: robot.name, units, jointUnits: own },
    items: [
      {
        name: 'q',
        latex: 'q',
        about: isSame ? `${names.join(', ')} in ${own[0]}` : names.map((name, i) => `${name} in ${own[i]}`).join(', '),
        labels: names,
        values: isOwn ? posture : Array.from(compilePosture(robot, posture)),
      },
    ],
  };
}
