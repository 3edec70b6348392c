/**
 * Values of a running KAREL program as text, as they stand in code: a minus is a minus sign of code.
 *
 * @import { Type } from '../../karel/check/types.js'
 */
import { isPosition } from '../../karel/check/types.js';
import { configText, isJoints } from '../../karel/run/positions.js';

/** Elements of an array, characters of a text: more is cut. */
const MOST_ELEMENTS = 8;
const MOST_CHARACTERS = 200;

/** What a variable that nothing was put into holds. */
export const UNSET = 'uninitialised';

/** A REAL has about seven digits. @param {number} value */
const real = (value) => {
  const text = String(Number(value.toPrecision(7)));
  return /^-?\d+$/.test(text) ? `${text}.0` : text;
};

/** @param {unknown} value @param {Type} type @returns {string} */
export function valueText(value, type) {
  if (value === undefined) return UNSET;
  if (type.kind === 'FILE') return 'FILE';
  if (typeof value === 'boolean') return value ? 'TRUE' : 'FALSE';
  if (type.kind === 'CONFIG' && typeof value === 'number') return configText(value);
  if (typeof value === 'number') return type.kind === 'REAL' ? real(value) : String(value);
  if (typeof value === 'string') return cut(`'${value}'`);
  if (type.kind === 'PATH') return `${nodesOf(value).length} nodes`;
  if (Array.isArray(value)) return arrayText(value, type);
  return Object.entries(/** @type {object} */ (value))
    .slice(0, MOST_ELEMENTS)
    .map(([name, inner]) => `${name.toLowerCase()} ${valueText(inner, fieldType(type, name))}`)
    .join(', ');
}

/** @param {readonly unknown[]} values @param {Type} type */
function arrayText(values, type) {
  if (type.kind === 'VECTOR') return numbersText(values);
  if (isPosition(type)) return positionText(values);
  const shown = values.slice(0, MOST_ELEMENTS).map((one) => valueText(one, type.of ?? NOTHING_KNOWN));
  return cut(`[${shown.join(', ')}${values.length > MOST_ELEMENTS ? `, … ${values.length} in all` : ''}]`);
}

/** Of joints, or x y z | w p r | the configuration. @param {readonly unknown[]} values */
export function positionText(values) {
  if (isJoints(values)) return numbersText(values);
  const config = typeof values[6] === 'number' ? ` | ${configText(values[6])}` : '';
  return `${numbersText(values.slice(0, 3))} | ${numbersText(values.slice(3, 6))}${config}`;
}

/** @type {Type} */
const NOTHING_KNOWN = { kind: 'UNKNOWN' };

/** @param {readonly unknown[]} values */
const numbersText = (values) => values.map((one) => (typeof one === 'number' ? real(one) : '–')).join(' ');

/** @param {Type} type @param {string} name */
const fieldType = (type, name) => type.fields?.get(name) ?? NOTHING_KNOWN;

/** @param {unknown} value @returns {readonly unknown[]} */
const nodesOf = (value) => /** @type {{ nodes: unknown[] }} */ (value).nodes;

/** @param {string} text */
const cut = (text) => (text.length > MOST_CHARACTERS ? `${text.slice(0, MOST_CHARACTERS)}…` : text);
