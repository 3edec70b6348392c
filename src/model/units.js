/**
 * The only file that converts between document units and kernel units (metres, radians).
 * @import { AngleUnit, LengthUnit, Units } from './document.js'
 */
const RADIANS_PER_DEGREE = Math.PI / 180;

export const toRadians = (/** @type {number} */ degrees) => degrees * RADIANS_PER_DEGREE;
export const toDegrees = (/** @type {number} */ radians) => radians / RADIANS_PER_DEGREE;

const PER_METRE = { mm: 1000, cm: 100, m: 1 };

/**
 * A document's number of a quantity → metres or radians. Lengths shift their decimal point, so that an arm is the same to
 * the last bit whichever unit its table is written in.
 * @example
 * toKernel('length', 431.8, { length: 'mm', angle: 'deg' }) // → 0.4318
 * toKernel('angle', 90, { length: 'mm', angle: 'deg' }) // → Math.PI / 2
 * @param {'length' | 'angle'} quantity
 * @param {number} value
 * @param {Units} units
 */
export function toKernel(quantity, value, { length, angle }) {
  if (quantity === 'length') return convertLength(value, length, 'm');
  return angle === 'deg' ? toRadians(value) : value;
}

/**
 * Metres or radians → a document's number, for answers of the kernel (a posture that inverse kinematics found, a pose to
 * show). Never used to bring a document's own numbers back: the trip loses digits.
 * @example
 * fromKernel('length', 0.4318, { length: 'mm', angle: 'deg' }) // → 431.8
 * @param {'length' | 'angle'} quantity
 * @param {number} value
 * @param {Units} units
 */
export function fromKernel(quantity, value, { length, angle }) {
  if (quantity === 'length') return value * PER_METRE[length];
  return angle === 'deg' ? toDegrees(value) : value;
}

/** Each unit of length is so many powers of ten of a metre. */
const EXPONENT = { mm: -3, cm: -2, m: 0 };

/**
 * A length in another unit, by shifting its decimal point: nothing is multiplied, so nothing is rounded in any number
 * that a person would type (up to 15 digits), and the way back gives the same number.
 * @example
 * convertLength(431.8, 'mm', 'm') // → 0.4318
 * convertLength(0.1 + 0.2, 'm', 'mm') // → 300.00000000000004
 * @param {number} value
 * @param {LengthUnit} from
 * @param {LengthUnit} to
 */
export function convertLength(value, from, to) {
  const shift = EXPONENT[from] - EXPONENT[to];
  if (value === 0 || shift === 0 || !Number.isFinite(value)) return value;
  const [digits, exponent = '0'] = String(value).split('e');
  return Number(`${digits}e${Number(exponent) + shift}`);
}

/** An inch is 25.4 mm: 254 whole tenths. */
const TENTHS_PER_INCH = 254;

/**
 * A length that was typed in inches. The digits are multiplied as a whole number, so that nothing is rounded but the result.
 * @example
 * fromInches(12, 'mm') // → 304.8
 * @param {number} inches
 * @param {LengthUnit} to
 */
export function fromInches(inches, to) {
  if (inches === 0 || !Number.isFinite(inches)) return inches;
  const [digits, exponent = '0'] = String(inches).split('e');
  const [whole, decimals = ''] = digits.split('.');
  const tenths = BigInt(whole + decimals) * BigInt(TENTHS_PER_INCH);
  return convertLength(Number(`${tenths}e${Number(exponent) - decimals.length - 1}`), 'mm', to);
}

/** The finest step of the angles that are kept exact as fractions of π, and how many of them make π. */
const COMMON_STEP = 7.5;
const STEPS_PER_PI = 24;
const LARGEST_COMMON = 720;

/**
 * A common angle, a multiple of 7.5°, as a fraction of π: as it is written, and its exact value in radians.
 * @example
 * commonAngle(-90) // → { text: '-pi/2', value: -Math.PI / 2 }
 * commonAngle(12.3) // → null
 * @param {number} degrees
 * @returns {{ text: string, value: number } | null}
 */
export function commonAngle(degrees) {
  const steps = Math.abs(degrees) / COMMON_STEP;
  if (steps === 0 || !Number.isInteger(steps) || Math.abs(degrees) > LARGEST_COMMON) return null;
  const common = divisor(steps, STEPS_PER_PI);
  const [over, under] = [steps / common, STEPS_PER_PI / common];
  const text = `${degrees < 0 ? '-' : ''}${over === 1 ? '' : `${over}*`}pi${under === 1 ? '' : `/${under}`}`;
  return { text, value: (Math.sign(degrees) * over * Math.PI) / under };
}

/** @param {number} a @param {number} b @returns {number} the greatest common divisor */
const divisor = (a, b) => (b === 0 ? a : divisor(b, a % b));

/**
 * An angle in another unit: a common one exactly, any other as the shortest decimal that is the same radians to one unit in
 * the last place. The way back gives the same number, if it has at most 12 digits.
 * @example
 * convertAngle(Math.PI / 2, 'rad', 'deg') // → 90
 * convertAngle(0.1, 'rad', 'deg') // → 5.729577951308232
 * @param {number} value
 * @param {AngleUnit} from
 * @param {AngleUnit} to
 */
export function convertAngle(value, from, to) {
  if (value === 0 || from === to) return value;
  if (to === 'deg') return shortest(toDegrees(value), (degrees) => isSame(toRadians(degrees), value));
  const radians = toRadians(value);
  return commonAngle(value)?.value ?? shortest(radians, (shorter) => isSame(shorter, radians));
}

/** Whether two numbers differ by one unit in the last place at most. @param {number} a @param {number} b */
const isSame = (a, b) => Math.abs(a - b) <= ulp(b);

/** @param {number} x  not zero */
const ulp = (x) => Math.max(Number.MIN_VALUE, 2 ** (Math.floor(Math.log2(Math.abs(x))) - 52));

/**
 * The decimal with the fewest digits that will do, near a number that may just not do itself.
 * @param {number} value
 * @param {(candidate: number) => boolean} willDo
 */
function shortest(value, willDo) {
  for (let digits = 1; digits <= 17; digits++) {
    const candidate = Number(value.toPrecision(digits));
    if (willDo(candidate)) return candidate;
  }
  return [value + ulp(value), value - ulp(value)].find(willDo) ?? value;
}

/** Seconds → milliseconds, for the few interfaces of the browser that want them. */
export const toMilliseconds = (/** @type {number} */ seconds) => seconds * 1000;
export const fromMilliseconds = (/** @type {number} */ milliseconds) => milliseconds / 1000;
