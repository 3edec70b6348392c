import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { EXPORT_FORMATS } from '../../../src/io/exportFormats.js';
import { readRobotFile } from '../../../src/io/robotFile.js';
import { deepFreeze } from '../../../src/model/freeze.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { SEED, runs } from '../../helpers/property.js';
import { documents } from './documents.js';

/** @import { Doc } from '../../../src/model/document.js' */

/** @param {string} id */
function formatCalled(id) {
  const format = EXPORT_FORMATS.find((each) => each.id === id);
  if (!format) throw new RangeError(`No format ${id}.`);
  return format;
}

const plain = newDocument(LIBRARY.planar2r);
const joint = plain.robot.joints[0];

/** A document with one of everything. @type {Doc} */
const rich = deepFreeze({
  ...plain,
  robot: {
    ...plain.robot,
    name: 'Arm no. 1',
    info: { manufacturer: 'Somebody', author: 'Me', description: 'Two links.' },
    joints: [
      {
        ...joint,
        label: 'Shoulder',
        lower: -90,
        upper: undefined,
        home: 10,
        velocity: 100,
        jerk: 5,
        effort: 7,
        text: { a: '1/2' },
        link: { kind: 'box', width: 0.1, color: '#ff0000' },
        controller: { sign: -1, offset: 0, coupling: 0 },
      },
      plain.robot.joints[1],
    ],
  },
  posture: [1, -2.5],
  postures: [
    { id: 'pick', q: [1, 2] },
    { id: 'place', q: [3, 4] },
  ],
  frames: [
    { kind: 'user', id: 'table', xyz: [1, 0, 0] },
    { kind: 'tool', id: 'pen', xyz: [0, 0, 0.1] },
    { kind: 'tool', id: 'none', ...plain.robot.tool },
  ],
  activeTool: 'none',
  targets: [{ id: 'corner', xyz: [1, 0, 0] }],
  obstacles: [{ kind: 'sphere', id: 'ball', xyz: [1, 1, 0], radius: 0.2 }],
  programs: [{ id: 'main', language: 'karel', text: '' }],
  codeOptions: 'format=krl',
  extensions: ['<x:note xmlns:x="urn:example:x"/>'],
});

/** @param {string} id @param {Doc} doc */
const told = (id, doc) =>
  formatCalled(id)
    .losses(doc)
    .map(({ message }) => message);

test('the list is frozen, the formats are named once, files have an extension and a type', () => {
  expect(Object.isFrozen(EXPORT_FORMATS) && EXPORT_FORMATS.every((format) => Object.isFrozen(format))).toBe(true);
  expect(new Set(EXPORT_FORMATS.map(({ id }) => id)).size).toBe(EXPORT_FORMATS.length);
  for (const { extension, mediaType } of EXPORT_FORMATS) {
    expect(extension).toMatch(/^[a-z]+(\.xml)?$/);
    expect(mediaType).toMatch(/^[a-z]+\/[a-z.+-]+$/);
  }
});

describe('our own file', () => {
  test('loses nothing', () => {
    for (const robot of Object.values(LIBRARY)) expect(told('denavit', newDocument(robot))).toEqual([]);
    expect(told('denavit', rich)).toEqual([]);
  });

  test('tells a character that XML cannot hold', () => {
    const doc = { ...plain, robot: { ...plain.robot, name: 'a\u0000b' } };
    expect(told('denavit', doc)).toEqual([
      'XML has no place for the character U+0000 in robot.name; the replacement character U+FFFD stands for it.',
    ]);
  });
});

describe('a URDF', () => {
  test('of a plain arm lacks the table, and has placeholders', () => {
    expect(told('urdf', plain)).toEqual([
      'URDF has frames in m and rad and no table; the 2 rows (standard, in mm and deg) can be read back only as a table of the same arm, which may be another.',
      'URDF has no place for the posture that the arm stands in, 30, 60.',
      'URDF has no place for what is said of the robot: source.',
      'URDF has no place for the home value of 2 joints (joint_1, joint_2).',
      'URDF has other names: "Planar 2R" as "Planar_2R".',
      'URDF asks for masses and inertias; 1 kg and 0.01 kg m² stand for those of 3 links.',
      'URDF asks for the largest velocity; 1 (rad/s or m/s) stands for that of 2 joints (joint_1, joint_2).',
      'URDF asks for the largest effort; 1000 (N m or N) stands for that of 2 joints (joint_1, joint_2).',
    ]);
  });

  test('of a document with one of everything lacks what is said, by name', () => {
    expect(told('urdf', rich)).toEqual([
      expect.stringContaining('no table'),
      'URDF has no place for the posture that the arm stands in, 1, -2.5.',
      'URDF has no place for 2 recorded postures (pick, place).',
      'URDF has no place for 1 user frame (table).',
      'URDF has no place for 1 tool (pen) that is not active.',
      'URDF has no place for the name of the active tool, none; its pose is kept.',
      'URDF has no place for 1 target (corner).',
      'URDF has no place for 1 obstacle (ball).',
      'URDF has no place for 1 program (main).',
      'URDF has no place for how code is to be written.',
      'URDF has no place for 1 element of other programs.',
      'URDF has no place for what is said of the robot: manufacturer, author, description.',
      'URDF has no place for what was typed for numbers of 1 joint (joint_1).',
      'URDF has no place for the label of 1 joint (joint_1).',
      'URDF has no place for the home value of 2 joints (joint_1, joint_2).',
      'URDF has no place for the largest jerk of 1 joint (joint_1).',
      "URDF has no place for the controller's sign, offset or coupling of 1 joint (joint_1).",
      'URDF has no place for the look of the link of 1 joint (joint_1).',
      'URDF has other names: "Arm no. 1" as "Arm_no__1".',
      'URDF asks for both limits; at least 1000000 (rad or m) stands for what is missing of 1 joint (joint_1).',
      'URDF asks for masses and inertias; 1 kg and 0.01 kg m² stand for those of 3 links.',
      'URDF asks for the largest velocity; 1 (rad/s or m/s) stands for that of 1 joint (joint_2).',
      'URDF asks for the largest effort; 1000 (N m or N) stands for that of 1 joint (joint_2).',
    ]);
  });
});

/** Of lists in a document, where losses must say so. */
const LISTS = /** @type {const} */ (['postures', 'targets', 'programs', 'extensions']);

test.each(EXPORT_FORMATS)(
  '$id: whatever the document, it is written or refused, and what is lost is said',
  (format) => {
    fc.assert(
      fc.property(documents, (doc) => {
        const losses = format.losses(doc);
        for (const { message } of losses) expect(message).toMatch(/^[^\p{Cc}\p{Cf}\p{Cs}]{20,900}\.$/u);
        if (losses.some(({ severity }) => severity === 'error')) {
          expect(() => format.write(doc)).toThrow(RangeError);
          return;
        }
        expect(readRobotFile(format.write(doc)).issues.map(({ code }) => code)).not.toContain('not-xml');
        if (format.id === 'denavit') expect(losses).toEqual([]);
        else {
          const paths = losses.map(({ path }) => path);
          for (const list of LISTS) expect([list, paths.includes(list)]).toEqual([list, doc[list].length > 0]);
          for (const field of /** @type {const} */ (['label', 'home', 'text', 'jerk'])) {
            const isThere = doc.robot.joints.some((each) => each[field] !== undefined);
            const isTold = paths.some((path) => path.endsWith(`.${field}`));
            expect([field, isTold]).toEqual([field, isThere]);
          }
        }
      }),
      { seed: SEED, numRuns: runs(60) },
    );
  },
);
