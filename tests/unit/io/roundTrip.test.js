import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { identityPose } from '../../../src/model/document.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { validateDocument } from '../../../src/model/validate.js';
import { runs, SEED } from '../../helpers/property.js';
import { documents } from './documents.js';
import { SAMPLES } from './files.js';
import { DRAFT_SCHEMA, PUBLISHED_SCHEMA, schemaErrors } from './xmllint.js';

const library = Object.values(LIBRARY).map(newDocument);

test('a saved document opens as the same document, and saves as the same bytes', () => {
  fc.assert(
    fc.property(documents, (doc) => {
      const saved = writeRobotXml(doc);
      const { doc: opened, issues } = readRobotXml(saved);
      expect(issues.filter(({ severity }) => severity === 'error')).toEqual([]);
      expect(opened).toStrictEqual(doc);
      expect(opened && writeRobotXml(opened)).toBe(saved);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('what is generated here is sound', () => {
  fc.assert(
    fc.property(documents, (doc) => {
      expect(validateDocument(doc)).toEqual([]);
    }),
    { seed: SEED, numRuns: runs(50) },
  );
});

test.for([
  { name: 'the published schema', schema: PUBLISHED_SCHEMA, lacks: {} },
  {
    name: 'the first draft of it, which knew no targets, no obstacles, no motion programs, no active frames and no options of code',
    schema: DRAFT_SCHEMA,
    lacks: {
      targets: [],
      obstacles: [],
      motionPrograms: [],
      activeTool: undefined,
      activeUser: undefined,
      codeOptions: undefined,
    },
  },
])('libxml2 finds every saved document valid under $name', async ({ schema, lacks }) => {
  const generated = fc.sample(documents, { seed: SEED, numRuns: runs(25) }); // 500 in test:deep
  const saved = [...library, ...generated].map((doc) => writeRobotXml({ ...doc, ...lacks }));
  const errors = await schemaErrors(saved, schema);
  expect(errors.flat()).toEqual([]);
});

test('the robots of the library open as they were, without a remark', () => {
  for (const doc of library) expect(readRobotXml(writeRobotXml(doc))).toStrictEqual({ doc, issues: [] });
});

test.for(SAMPLES)('$name opens without a remark, and saves as the same bytes ever after', ({ text }) => {
  const { doc, issues } = readRobotXml(text);
  expect(issues).toEqual([]);
  const saved = writeRobotXml(/** @type {NonNullable<typeof doc>} */ (doc));
  expect(writeRobotXml(/** @type {NonNullable<typeof doc>} */ (readRobotXml(saved).doc))).toBe(saved);
});

test('numbers come back as typed, a negative zero too', () => {
  const doc = newDocument(LIBRARY.planar2r);
  const posture = [-0, 0.1 + 0.2];
  const saved = writeRobotXml({ ...doc, posture });
  expect(saved).toContain('<posture id="current" q="-0 0.30000000000000004"/>');
  expect(readRobotXml(saved).doc?.posture).toStrictEqual(posture);
});

test('a name keeps its blanks, even through a program that lays XML out afresh', () => {
  const name = ' two  blanks,\ttab,\nline\r';
  const doc = newDocument({ ...LIBRARY.planar2r, name });
  const saved = writeRobotXml(doc);
  expect(saved).toContain('<name> two  blanks,&#9;tab,&#10;line&#13;</name>');
  expect(readRobotXml(saved).doc?.robot.name).toBe(name);
});

test('a program keeps its lines readable in the file', () => {
  const text = 'PROGRAM a\nBEGIN\n  IF i < 3 THEN\nEND a\n';
  const saved = writeRobotXml({ ...newDocument(LIBRARY.planar2r), programs: [{ id: 'a', language: 'karel', text }] });
  expect(saved).toContain(
    '    <program id="a" language="karel">PROGRAM a\nBEGIN\n  IF i &lt; 3 THEN\nEND a\n</program>\n',
  );
});

test('characters that XML forbids become U+FFFD, and the file stays valid', async () => {
  const forbidden = ['\0', '\u0001', '\uD800', '\uFFFE', '\uFFFF'];
  const damaged = fc.string({ unit: fc.constantFrom('a', '😀', ...forbidden), maxLength: 60 });
  const files = fc.sample(damaged, { seed: SEED, numRuns: runs(20) }).map((name) => {
    const saved = writeRobotXml(newDocument({ ...LIBRARY.planar2r, name }));
    const expected = Array.from(name, (character) => (forbidden.includes(character) ? '\uFFFD' : character)).join('');
    expect(readRobotXml(saved).doc?.robot.name).toBe(expected);
    return saved;
  });
  expect((await schemaErrors(files)).flat()).toEqual([]);
});

test('what has its default value is not written', () => {
  const saved = writeRobotXml(newDocument(LIBRARY.planar2r));
  for (const name of ['base', 'tool', 'link', 'controller', 'frames', 'programs', 'extensions', 'label']) {
    expect(saved).not.toMatch(new RegExp(`<${name}|${name}=`));
  }
});

test('a base without an orientation and one with none turned are kept apart', () => {
  for (const base of [identityPose(), { xyz: [0, 0, 0] }, { xyz: [0, 0, -0], rpy: [0, 0, 0] }]) {
    const doc = newDocument({ ...LIBRARY.planar2r, base });
    expect(readRobotXml(writeRobotXml(doc)).doc?.robot.base).toStrictEqual(base);
  }
});

test('a file that we write looks like this', () => {
  const doc = {
    ...newDocument({
      ...LIBRARY.planar2r,
      name: 'Arm & Co',
      info: { author: 'N. N.' },
      base: { xyz: [0, 0, 100], quaternion: [0, 0, 0, 1] },
      joints: LIBRARY.planar2r.joints.map((joint, i) => ({
        ...joint,
        link: { kind: /** @type {const} */ ('box'), width: 40 },
        controller: {
          sign: /** @type {const} */ (-1),
          offset: 90,
          ...(i > 0 && { coupledTo: 'joint_1' }),
          coupling: i,
        },
      })),
    }),
    postures: [{ id: 'p1', q: [1, 2] }],
    frames: [
      { kind: /** @type {const} */ ('tool'), id: 'gripper', number: 1, xyz: [0, 0, 50] },
      { kind: /** @type {const} */ ('user'), id: 'table', xyz: [1, 2, 3], rpy: [0, 0, 90] },
    ],
    programs: [{ id: 'empty', language: /** @type {const} */ ('krl'), text: '' }],
    extensions: ['<x:note xmlns:x="urn:example:x">kept</x:note>'],
  };
  expect(writeRobotXml(doc)).toMatchInlineSnapshot(`
    "<?xml version="1.0" encoding="UTF-8"?>
    <robotModel xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="mm" angleUnit="deg" convention="standard" generator="Denavit 0.1.0">
      <info>
        <name>Arm &amp; Co</name>
        <author>N. N.</author>
      </info>
      <base xyz="0 0 100" quat_xyzw="0 0 0 1"/>
      <chain>
        <joint id="joint_1" type="revolute">
          <dh theta="0" d="0" a="1000" alpha="0"/>
          <limits lower="-180" upper="180" home="30"/>
          <link kind="box" width="40"/>
          <controller sign="-1" offset="90"/>
        </joint>
        <joint id="joint_2" type="revolute">
          <dh theta="0" d="0" a="1000" alpha="0"/>
          <limits lower="-180" upper="180" home="60"/>
          <link kind="box" width="40"/>
          <controller sign="-1" offset="90" coupledTo="joint_1" coupling="1"/>
        </joint>
      </chain>
      <frames>
        <toolFrame id="gripper" number="1" xyz="0 0 50"/>
        <userFrame id="table" xyz="1 2 3" rpy="0 0 90"/>
      </frames>
      <postures>
        <posture id="current" q="30 60"/>
        <posture id="p1" q="1 2"/>
      </postures>
      <programs>
        <program id="empty" language="krl"></program>
      </programs>
      <extensions>
        <x:note xmlns:x="urn:example:x">kept</x:note>
      </extensions>
    </robotModel>
    "
  `);
});
