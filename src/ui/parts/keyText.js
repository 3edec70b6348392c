/**
 * What a key above the keyboard makes of a text and what is chosen of it.
 *
 * @typedef {'minus' | 'pi' | 'root' | 'brackets' | 'divide' | 'mm' | 'inch' | 'deg' | 'rad'} KeyName
 *
 * @typedef {object} Edit
 * @property {string} text   that takes the place …
 * @property {number} start  … of what stands from here
 * @property {number} end    … to here; the cursor is then behind it
 */

/** @type {Record<Exclude<KeyName, 'brackets'>, string>} */
const TYPED = { minus: '−', pi: 'π', root: '√', divide: '/', mm: ' mm', inch: ' in', deg: '°', rad: ' rad' };

/** These go on with a number; a field that is come to has all of its text chosen, and the number is not meant to go. */
const AFTER = ['divide', 'mm', 'inch', 'deg', 'rad'];

/**
 * @param {KeyName} key
 * @param {string} value
 * @param {number} start  of what is chosen
 * @param {number} end
 * @returns {Edit}
 */
export function keyText(key, value, start, end) {
  if (key !== 'brackets') {
    return { text: TYPED[key], start: AFTER.includes(key) ? end : start, end };
  }
  if (start !== end) return { text: `(${value.slice(start, end)})`, start, end };
  const before = value.slice(0, start);
  const open = before.split('(').length - before.split(')').length;
  return { text: open > 0 && !/[(/*+−√-]\s*$/.test(before) ? ')' : '(', start, end };
}
