import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { mjcfNames, writeMjcf } from '../../../src/io/mjcf/mjcfWriter.js';
import { sdfNames, writeSdf } from '../../../src/io/sdf/sdfWriter.js';
import { EXPORT_FORMATS } from '../../../src/io/exportFormats.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compileRobot } from '../../../src/model/compile.js';
import { convertConvention } from '../../../src/model/robot/convertConvention.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { SEED, runs } from '../../helpers/property.js';
import { documents } from './documents.js';
import { mjcfPose, sdfPose } from './framesPose.js';

/** @import { Doc, JointDoc } from '../../../src/model/document.js' */

/** @type {{ id: 'sdf' | 'mjcf', write: (doc: Doc) => string, read: typeof sdfPose, namesOf: (robot: Doc['robot']) => string[] }[]} */
const FORMATS = [
  { id: 'sdf', write: writeSdf, read: sdfPose, namesOf: (robot) => sdfNames(robot).joints },
  { id: 'mjcf', write: writeMjcf, read: mjcfPose, namesOf: mjcfNames },
];

/** The largest difference between a pose (column-major) and rows. @param {ArrayLike<number>} T @param {number[][]} rows */
const apart = (T, rows) =>
  Math.max(...rows.slice(0, 3).flatMap((row, i) => row.map((value, j) => Math.abs(T[4 * j + i] - value))));

/** How far the written arm is from the document's, at some postures. @param {Doc} doc @param {typeof FORMATS[number]} format */
function error(doc, { write, read, namesOf }) {
  const { robot } = doc;
  const [chain, pose, names] = [compileRobot(robot), read(write(doc), 'tool0'), namesOf(robot)];
  const errors = [0, 0.3, -1.1, 2.2].map((start) => {
    const q = Float64Array.from(robot.joints, (_, i) => start + 0.7 * i);
    return apart(tcpPose(chain, q), pose(Object.fromEntries(names.map((name, i) => [name, q[i]]))));
  });
  return Math.max(...errors);
}

const plain = newDocument(LIBRARY.planar2r);
/** @param {Partial<JointDoc>} first @param {string} [name] @returns {Doc} planar 2R with something else about its first joint */
const arm = (first, name = 'Arm') => ({
  ...plain,
  robot: {
    ...plain.robot,
    name,
    joints: plain.robot.joints.map((joint, i) => (i === 0 ? { ...joint, ...first } : joint)),
  },
});

describe.each(FORMATS)('$id', (format) => {
  test('every arm of the library, in both conventions, is the same arm to another reader, to 1e-12', () => {
    for (const robot of Object.values(LIBRARY)) {
      const doc = newDocument(robot);
      const other = convertConvention(doc, robot.convention === 'standard' ? 'modified' : 'standard');
      for (const each of [doc, other])
        expect([robot.name, error(each, format)]).toEqual([robot.name, expect.toSatisfy((off) => off < 1e-12)]);
    }
  });

  test('any arm is, to 1e-12 of its size', () => {
    fc.assert(
      fc.property(documents, (doc) => {
        const q = new Float64Array(doc.robot.joints.length);
        const { joints, base, tool } = doc.robot;
        const lengths = [...joints.flatMap(({ a, d }) => [a, d]), ...base.xyz, ...tool.xyz].map(Math.abs);
        const scale = 10 + lengths.reduce((sum, length) => sum + length, 0); // in any unit: at least metres
        expect(tcpPose(compileRobot(doc.robot), q).every(Number.isFinite)).toBe(true);
        expect(error(doc, format) / scale).toBeLessThan(1e-12);
      }),
      { seed: SEED, numRuns: runs(60) },
    );
  });

  test('names that are taken or kept for the format are others', () => {
    const names = (/** @type {string} */ id) => format.namesOf(arm({ id }).robot);
    expect(names('elbow')).toEqual(['elbow', 'joint_2']);
    const isSdf = format.id === 'sdf';
    for (const id of ['link_1', 'tool0', 'world', '__model__', 'world_joint'])
      expect([id, names(id)[0] !== id]).toEqual([id, isSdf]);
    expect(error(arm({ id: '__model__' }, '__root__'), format)).toBeLessThan(1e-12);
  });
});

const losses = (/** @type {string} */ id, /** @type {Doc} */ doc) =>
  (EXPORT_FORMATS.find((format) => format.id === id)?.losses(doc) ?? []).map(({ message }) => message);

describe('limits', () => {
  test('SDFormat has the ones that are there', () => {
    expect(writeSdf(arm({ lower: -90, upper: undefined, velocity: 180, effort: 5 }))).toContain(
      `<limit><lower>${-Math.PI / 2}</lower><effort>5</effort><velocity>${Math.PI}</velocity></limit>`,
    );
    expect(writeSdf(arm({ type: 'continuous', lower: undefined, upper: undefined })).match(/<limit>/g)).toHaveLength(1);
    expect(losses('sdf', arm({ type: 'continuous', lower: -90, upper: 90 }))).toContain(
      'SDFormat has no place for the unused limits of 1 joint (joint_1).',
    );
  });

  test('MJCF has both or none, the upper one higher, and says what it stands for', () => {
    const range = (/** @type {Partial<JointDoc>} */ first) =>
      /name="joint_1"[^/]*axis="0 0 1" ([^/]*)\/>/.exec(writeMjcf(arm(first)))?.[1];
    expect(range({ lower: -90, upper: 180 })).toBe(`limited="true" range="${-Math.PI / 2} ${Math.PI}"`);
    expect(range({ lower: undefined, upper: undefined })).toBe('limited="false"');
    expect(range({ lower: undefined, upper: 90, effort: 5 })).toBe(
      `limited="true" range="-1000000 ${Math.PI / 2}" actuatorfrclimited="true" actuatorfrcrange="-5 5"`,
    );
    expect(range({ lower: 0, upper: 0 })).toBe('limited="true" range="0 0.000001"');
    expect(losses('mjcf', arm({ lower: undefined, upper: 90 }))).toContain(
      'MJCF asks for both limits; at least 1000000 (rad or m) stands for what is missing of 1 joint (joint_1).',
    );
    expect(losses('mjcf', arm({ lower: 0, upper: 0, velocity: 3 }))).toEqual(
      expect.arrayContaining([
        'MJCF wants an upper limit above the lower; 0.000001 (rad or m) is added for 1 joint (joint_1).',
        'MJCF has no place for the largest velocity of 1 joint (joint_1).',
      ]),
    );
  });
});

test('a slide goes along its axis in metres', () => {
  const doc = arm({ type: 'prismatic', lower: 0, upper: 500 });
  expect(writeMjcf(doc)).toContain('type="slide" pos="0 0 0" axis="0 0 1" limited="true" range="0 0.5"');
  expect(writeSdf(doc)).toContain('<upper>0.5</upper>');
  for (const format of FORMATS) expect(error(doc, format)).toBeLessThan(1e-12);
});
