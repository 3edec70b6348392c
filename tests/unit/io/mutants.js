/**
 * Files spoilt at random: tokens put in, stretches cut out or copied elsewhere, whole values, numbers and lines replaced.
 */
import fc from 'fast-check';

export const TOKENS = [
  ...[
    '<',
    '>',
    '/>',
    '</',
    '"',
    "'",
    '&',
    '&lt;',
    '&#0;',
    ']]>',
    '<![CDATA[',
    '<!--',
    '-->',
    '<?',
    '<!DOCTYPE a>',
    '=',
    ' ',
  ],
  ...[
    '\0',
    '\uD800',
    '\uFFFE',
    '\u202E',
    '\u00A0',
    '\r',
    '\n',
    '😀',
    'xmlns=""',
    'xmlns:x="urn:x"',
    ' x:y="1"',
    '<x:y/>',
  ],
  ...[
    '',
    '0',
    '-0',
    '1',
    '.5',
    '5.',
    '1e9',
    '1e10',
    '1e-400',
    '1e999',
    'NaN',
    'INF',
    '0x10',
    '1,5',
    '1e',
    '+',
    'current',
  ],
  ...[
    'joint_1',
    'revolute',
    'prismatic',
    'continuous',
    'modified',
    'mm',
    'rad',
    '<dh theta="0" d="0" a="0" alpha="0"/>',
  ],
  ...[
    '<base/>',
    '<tool quat_xyzw="0 0 0 1"/>',
    '<limits lower="1" upper="0"/>',
    '<controller coupledTo="joint_1"/>',
    '<info/>',
  ],
];

/** @typedef {(text: string) => string} Mutation */

/** Anywhere in a text alike: fc.double prefers the neighbourhood of zero. */
export const place = fc.noBias(fc.integer({ min: 0, max: 999_999 })).map((millionths) => millionths / 1_000_000);
const at = (/** @type {string} */ text, /** @type {number} */ where) => Math.floor(where * (text.length + 1));

/** @type {fc.Arbitrary<Mutation>[]} anywhere in the text */
const BLIND = [
  fc.tuple(place, fc.constantFrom(...TOKENS)).map(([where, token]) => (text) => {
    return text.slice(0, at(text, where)) + token + text.slice(at(text, where));
  }),
  fc.tuple(place, fc.integer({ min: 1, max: 40 })).map(([where, length]) => (text) => {
    return text.slice(0, at(text, where)) + text.slice(at(text, where) + length);
  }),
  fc.tuple(place, place, fc.integer({ min: 1, max: 200 })).map(([from, to, length]) => (text) => {
    return text.slice(0, at(text, to)) + text.slice(at(text, from), at(text, from) + length) + text.slice(at(text, to));
  }),
];

/** In attributes and in text. */
const NUMBERS = /(?<=["\s>])-?\d[-+.e\d]*(?=["\s<])/g;

/** @type {fc.Arbitrary<Mutation>[]} of a whole value, a whole number or a whole line: these get far */
const AIMED = [
  fc.tuple(place, fc.constantFrom(...TOKENS)).map(([where, token]) => (text) => {
    return replaceOne(text, /"[^"<]*"/g, where, () => `"${token.replace(/["<&]/g, '')}"`);
  }),
  fc.tuple(place, fc.constantFrom(...TOKENS, '-7', '12.25', '1e3')).map(([where, token]) => (text) => {
    return replaceOne(text, NUMBERS, where, () => token.replace(/["<&]/g, ''));
  }),
  fc.tuple(place, fc.constantFrom('-7', '12.25', '1e3', '0', '-90', '0.0001')).map(([where, number]) => (text) => {
    return replaceOne(text, NUMBERS, where, () => number);
  }),
  fc.tuple(place, fc.constantFrom(0, 2)).map(([where, times]) => (text) => {
    return replaceOne(text, /^ *<.*\/>\n/gm, where, (line) => line.repeat(times));
  }),
];

const mutation = fc.oneof(...BLIND, ...AIMED.map((arbitrary) => ({ weight: 3, arbitrary })));

/** @param {string} text @param {RegExp} pattern @param {number} where @param {(found: string) => string} change */
function replaceOne(text, pattern, where, change) {
  const all = [...text.matchAll(pattern)];
  if (all.length === 0) return text;
  const { index, 0: found } = all[Math.floor(where * all.length)];
  return text.slice(0, index) + change(found) + text.slice(index + found.length);
}

/**
 * @param {readonly string[]} texts  good ones
 * @returns {fc.Arbitrary<string>}
 */
export const mutantsOf = (texts) =>
  fc
    .tuple(fc.constantFrom(...texts), fc.array(mutation, { minLength: 1, maxLength: 3 }))
    .map(([text, mutations]) => mutations.reduce((mutant, mutate) => mutate(mutant), text));
