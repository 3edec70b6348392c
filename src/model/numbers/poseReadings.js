/**
 * What the numbers of a pasted pose may mean, and the target that each meaning makes of them.
 *
 * @import { RobotDoc, Units } from '../document.js'
 * @import { LengthFault, OrientationForm } from './orientationNumbers.js'
 * @import { MatrixFault } from '../aim/targetMatrix.js'
 *
 * @typedef {{ id: string, kind: 'place' }
 *   | { id: string, kind: 'form', form: OrientationForm }
 *   | { id: string, kind: 'matrix' }} Reading
 *
 * @typedef {object} Read
 * @property {readonly number[] | null} target  X Y Z W P R in document units
 * @property {LengthFault | MatrixFault | null} fault
 * @property {readonly number[] | null} mended  the same numbers, mended, in the units they came in
 */
import { ORIENTATION_FORMS } from './orientationForms.js';
import { targetFrom } from '../aim/targetForm.js';
import { targetFromMatrix } from '../aim/targetMatrix.js';
import { convertAngle, convertLength } from '../units.js';

const PLACE = 3;

/**
 * The meanings that so many numbers can have; the likeliest first.
 * @param {readonly number[]} numbers
 * @param {string | null} said    what the text says, the id of a form, or "place"
 * @param {string} present        the form in which the target is written now
 * @returns {Reading[]}
 */
export function readingsOf(numbers, said, present) {
  const { length } = numbers;
  if (length === PLACE) return [{ id: 'place', kind: 'place' }];
  if (length >= 12) {
    const orders = length === 16 ? ['rows', 'columns'] : ['rows', 'rotation-first', 'columns']; // the last two always fit together
    const isPlausible = (/** @type {string} */ id) => isRotation(rowsIn(id, numbers));
    return orders
      .toSorted((a, b) => Number(isPlausible(b)) - Number(isPlausible(a)))
      .map((id) => ({ id, kind: 'matrix' }));
  }
  const forms = ORIENTATION_FORMS.filter(({ labels }) => labels.length === length - PLACE);
  const first = forms.find(({ id }) => id === said) ?? forms.find(({ id }) => id === present) ?? forms[0];
  return [first, ...forms.filter((form) => form !== first)].map((form) => ({ id: form.id, kind: 'form', form }));
}

/**
 * @param {Reading} reading
 * @param {readonly number[]} numbers
 * @param {Units} units       those of the numbers
 * @param {RobotDoc} robot
 * @param {readonly number[]} now  the target as it is, for what the numbers do not say
 * @returns {Read}
 */
export function readAs(reading, numbers, units, robot, now) {
  const length = (/** @type {number} */ value) => convertLength(value, units.length, robot.units.length);
  const angle = (/** @type {number} */ value) => convertAngle(value, units.angle, robot.units.angle);
  const place = numbers.slice(0, PLACE).map(length);
  switch (reading.kind) {
    case 'place':
      return { target: [...place, ...now.slice(PLACE)], fault: null, mended: null };
    case 'form': {
      const { form } = reading;
      const turn = (/** @type {(value: number) => number} */ convert) =>
        numbers.slice(PLACE).map((value, k) => (form.quantities[k] === 'angle' ? convert(value) : value));
      const { target, fault } = targetFrom(form, robot, [...place, ...turn(angle)]);
      if (!fault) return { target, fault, mended: null };
      const own = fault.mended?.map((value, k) => (form.quantities[k] === 'angle' ? numbers[PLACE + k] : value));
      return { target, fault, mended: own ? [...numbers.slice(0, PLACE), ...own] : null };
    }
    case 'matrix': {
      const rows = rowsIn(reading.id, numbers);
      const own = rows.map((value, k) => (k < 12 && k % 4 === 3 ? length(value) : value));
      const { target, fault } = targetFromMatrix(robot, own);
      const mended = fault?.mended?.map((value, k) => (k < 12 && k % 4 === 3 ? rows[k] : value)) ?? null;
      return { target, fault, mended: mended && inOrder(reading.id, mended, numbers.length) };
    }
    default: {
      /** @type {never} */
      const unknown = reading;
      throw new TypeError(`Unknown reading: ${JSON.stringify(unknown)}`);
    }
  }
}

/** Row, column of each of the numbers as they came. @param {string} id @param {number} count @returns {number[]} places in 4 × 4 */
function placesOf(id, count) {
  const rows = count === 16 ? 4 : 3;
  return Array.from({ length: count }, (_, k) => {
    if (id === 'rotation-first') return k < 9 ? 4 * Math.floor(k / 3) + (k % 3) : 4 * (k - 9) + 3;
    return id === 'columns' ? 4 * (k % rows) + Math.floor(k / rows) : k;
  });
}

/** @param {string} id @param {readonly number[]} numbers @returns {number[]} 16, row by row */
function rowsIn(id, numbers) {
  const rows = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];
  placesOf(id, numbers.length).forEach((place, k) => (rows[place] = numbers[k]));
  return rows;
}

/** @param {string} id @param {readonly number[]} rows @param {number} count */
const inOrder = (id, rows, count) => placesOf(id, count).map((place) => rows[place]);

/** Near enough to tell one order from another. */
const ROUGH = 0.05;

/** @param {readonly number[]} rows */
function isRotation(rows) {
  if (rows.slice(12).join() !== '0,0,0,1') return false;
  return [0, 1, 2].every((i) =>
    [0, 1, 2].every((j) => {
      const product = [0, 1, 2].reduce((sum, k) => sum + rows[4 * i + k] * rows[4 * j + k], 0);
      return Math.abs(product - (i === j ? 1 : 0)) < ROUGH;
    }),
  );
}
