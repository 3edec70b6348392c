import fc from 'fast-check';
import { expect, test } from 'vitest';
import { decodeText } from '../../../src/io/decodeText.js';
import { hasErrors } from '../../../src/io/fileIssues.js';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { validateDocument } from '../../../src/model/validate.js';
import { runs, SEED } from '../../helpers/property.js';
import { documents } from './documents.js';
import { SAMPLES } from './files.js';
import { schemaErrors } from './xmllint.js';

const good = [
  ...SAMPLES.map(({ text }) => text),
  ...fc.sample(documents, { seed: SEED, numRuns: 12 }).map(writeRobotXml),
];

const TOKENS = [
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

/** Anywhere alike: fc.double prefers the neighbourhood of zero. */
const place = fc.noBias(fc.integer({ min: 0, max: 999_999 })).map((millionths) => millionths / 1_000_000);
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

/** @type {fc.Arbitrary<Mutation>[]} of a whole value, a whole number or a whole line: these get far */
const AIMED = [
  fc.tuple(place, fc.constantFrom(...TOKENS)).map(([where, token]) => (text) => {
    return replaceOne(text, /"[^"<]*"/g, where, () => `"${token.replace(/["<&]/g, '')}"`);
  }),
  fc.tuple(place, fc.constantFrom(...TOKENS, '-7', '12.25', '1e3')).map(([where, token]) => (text) => {
    return replaceOne(text, /(?<=["\s])-?\d[-+.e\d]*(?=["\s])/g, where, () => token.replace(/["<&]/g, ''));
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

const mutants = fc
  .tuple(fc.constantFrom(...good), fc.array(mutation, { minLength: 1, maxLength: 3 }))
  .map(([text, mutations]) => mutations.reduce((mutant, mutate) => mutate(mutant), text));

/** @param {ReturnType<typeof readRobotXml>} answer */
function expectHonest({ doc, issues }) {
  expect(hasErrors(issues)).toBe(doc === null);
  for (const { message } of issues) expect(message).toMatch(/^[^\p{Cc}\p{Cf}\p{Cs}]{20,500}\.$/u);
  if (!doc) return;
  expect(validateDocument(doc)).toEqual([]);
  expect(tcpPose(compileRobot(doc.robot), compilePosture(doc.robot, doc.posture)).every(Number.isFinite)).toBe(true);
  expect(readRobotXml(writeRobotXml(doc)).doc).toStrictEqual(doc);
}

test('a spoilt file is refused, or opened as a sound, finite document; and what is opened is valid under libxml2', async () => {
  /** @type {string[]} */
  const opened = [];
  let refused = 0;
  fc.assert(
    fc.property(mutants, (text) => {
      const answer = readRobotXml(text);
      expectHonest(answer);
      if (answer.doc) opened.push(text);
      else refused++;
    }),
    { seed: SEED, numRuns: runs(400) },
  );
  expect(opened.length).toBeGreaterThan(15);
  expect(refused).toBeGreaterThan(100);
  const undeclared = opened.map((text) => text.replace(/^<\?xml.*?\?>/s, '')); // the encoding is decodeText's affair
  const errors = (await schemaErrors(undeclared)).flat();
  expect(errors.filter((message) => !message.startsWith('namespace warning'))).toEqual([]);
});

test('spoilt bytes never get through as anything else', () => {
  const bytes = fc
    .tuple(
      fc.constantFrom(...good),
      fc.array(fc.tuple(place, fc.integer({ min: 0, max: 255 })), { minLength: 1, maxLength: 6 }),
    )
    .map(([text, changes]) => {
      const encoded = new TextEncoder().encode(text);
      for (const [where, byte] of changes) encoded[Math.floor(where * encoded.length)] = byte;
      return encoded;
    });
  fc.assert(
    fc.property(bytes, (spoilt) => {
      const { text, issues } = decodeText(spoilt);
      if (text === null) expect(hasErrors(issues)).toBe(true);
      else expectHonest(readRobotXml(text));
    }),
    { seed: SEED, numRuns: runs(150) },
  );
});

test('any text at all is answered', () => {
  fc.assert(
    fc.property(
      fc.string({ unit: fc.oneof(fc.constantFrom(...TOKENS), fc.string({ unit: 'binary', maxLength: 1 })) }),
      (text) => {
        expectHonest(readRobotXml(text));
        expectHonest(readRobotXml(`<robotModel xmlns="urn:denavit:robot-model:1" ${text}</robotModel>`));
      },
    ),
    { seed: SEED, numRuns: runs(300) },
  );
});
