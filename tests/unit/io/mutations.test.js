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
import { mutantsOf, place, TOKENS } from './mutants.js';
import { schemaErrors } from './xmllint.js';

const good = [
  ...SAMPLES.map(({ text }) => text),
  ...fc.sample(documents, { seed: SEED, numRuns: 12 }).map(writeRobotXml),
];

const mutants = mutantsOf(good);

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
    { seed: SEED, numRuns: runs(200) },
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
