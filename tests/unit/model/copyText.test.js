/** What is copied is read again, by readers written here, and is the very same numbers. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { linkFrames, tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import {
  jointsSheet,
  KERNEL_UNITS,
  linksSheet,
  matrixSheet,
  poseSheet,
} from '../../../src/model/numbers/copySheets.js';
import { COPY_FORMATS, copyText } from '../../../src/model/numbers/copyText.js';
import { frameSeenFrom } from '../../../src/model/numbers/frameNumbers.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { linkRows, linkTransform } from '../../../src/model/robot/linkTransforms.js';
import { orientationForm } from '../../../src/model/numbers/orientationForms.js';
import { rowsOf } from '../../../src/model/numbers/poseRows.js';
import { SEED, runs } from '../../helpers/property.js';

/** @template T @param {import('fast-check').Arbitrary<T>} any @param {(value: T) => void} holds */
const property = (any, holds) => fc.assert(fc.property(any, holds), { seed: SEED, numRuns: runs(100) });

/** @typedef {import('../../../src/model/numbers/copyText.js').CopyFormat} CopyFormat */

/** Each value by its name, as rows of numbers. @type {Record<CopyFormat, (text: string) => number[][][]>} */
const READ = {
  text: (text) => {
    const lines = text.trimEnd().split('\n');
    const rows = lines.map((line) => line.split('\t').map(Number));
    /** @type {number[][][]} */
    const blocks = [];
    rows.forEach((row, i) => {
      if (row.some(Number.isNaN)) return;
      if (i > 0 && rows[i - 1].some(Number.isNaN)) blocks.push([]);
      blocks.at(-1)?.push(row);
    });
    return blocks;
  },
  python: (text) =>
    [...text.replace(/#.*/g, '').matchAll(/= np\.array\(([^)]*)\)/g)].map(([, value]) => {
      const array = JSON.parse(value.replace(/,\s*\]/g, ']'));
      return Array.isArray(array[0]) ? array : [array];
    }),
  matlab: (text) =>
    [...text.replace(/%.*/g, '').matchAll(/= \[([^\]]*)\];/g)].map(([, value]) =>
      value
        .trim()
        .split('\n')
        .map((row) => row.trim().split(/\s+/).map(Number)),
    ),
  latex: (text) =>
    [...text.replace(/^%.*/gm, '').matchAll(/\\begin\{pmatrix\}([\s\S]*?)\\end/g)].map(([, value]) =>
      value
        .split('\\\\')
        .map((row) => row.split('&').map((cell) => Number(cell.trim().replace(/ \\cdot 10\^\{(.+)\}/, 'e$1')))),
    ),
  json: (text) =>
    Object.values(JSON.parse(text))
      .map((value) => (Array.isArray(value) ? value : value?.values))
      .filter((value) => Array.isArray(value) && typeof value.flat()[0] === 'number')
      .map((value) => (Array.isArray(value[0]) ? value : [value])),
};

/** A column in LaTeX is a row everywhere else. @param {number[][]} block */
const asRows = (block) => (block.every((row) => row.length === 1) ? [block.flat()] : block);

const anyNumber = fc.double({ noNaN: true, noDefaultInfinity: true });
const anyItem = fc.oneof(
  fc
    .array(anyNumber, { minLength: 2, maxLength: 7 })
    .map((values) => ({ values, labels: values.map((_, k) => `v${k}`) })),
  fc
    .array(fc.tuple(anyNumber, anyNumber, anyNumber, anyNumber), { minLength: 2, maxLength: 4 })
    .map((rows) => ({ rows })),
);

describe.each(COPY_FORMATS)('%s', (format) => {
  test('gives every number back to the last bit', () =>
    property(fc.array(anyItem, { minLength: 1, maxLength: 3 }), (items) => {
      const sheet = {
        title: 'any numbers',
        facts: {},
        items: items.map((item, k) => ({ ...item, name: `A${k}`, latex: `A_${k}`, about: `numbers no. ${k}` })),
      };
      const expected = items.map((item) =>
        ('rows' in item ? item.rows : [item.values]).map((row) => row.map((v) => v + 0)),
      );
      expect(READ[format](copyText(sheet, format)).map(asRows)).toEqual(expected);
    }));

  test('a name with line breaks stays in its line', () => {
    const sheet = {
      title: 'evil\nimport os\r\n\u2028]',
      facts: {},
      items: [{ name: 'q', latex: 'q', about: 'x\ny', values: [1, 2] }],
    };
    const text = copyText(sheet, format);
    expect(READ[format](text).map(asRows)).toEqual([[[1, 2]]]);
    expect(text).not.toMatch(/^import os/m);
  });
});

const doc = newDocument(LIBRARY.puma560);
const { robot } = doc;
const chain = compileRobot(robot);
const q = compilePosture(robot, [10, 20, 30, 40, 50, 60]);
const T = tcpPose(chain, q);
const place = {
  robot,
  frame: /** @type {const} */ ('tool'),
  from: /** @type {const} */ ('world'),
  T,
  units: robot.units,
};

test('a pose says frame, convention and units', () => {
  const text = copyText(poseSheet(place, orientationForm('wpr')), 'python');
  expect(text).toMatch(/^import numpy as np\n\n# Puma 560.*: pose of tool in world\n/);
  expect(text).toContain('# position X, Y, Z in mm\nposition = np.array([');
  expect(text).toContain('# orientation FANUC WPR: W, P, R in deg, R = Rz(R) · Ry(P) · Rx(W)\n');
  const json = JSON.parse(copyText(poseSheet({ ...place, units: KERNEL_UNITS }, orientationForm('wxyz')), 'json'));
  expect(json).toMatchObject({ frame: 'tool', seenFrom: 'world', units: KERNEL_UNITS, convention: 'Quaternion wxyz' });
  expect(json.orientation.names).toEqual(['w', 'x', 'y', 'z']);
  expect(json.position.values).toEqual([T[12], T[13], T[14]]);
  expect(copyText(poseSheet(place, orientationForm('xyzw')), 'matlab')).toContain(
    '% orientation Quaternion xyzw: x, y, z, w\n',
  );
});

test('the matrix in metres is the pose itself, in millimetres only its lengths differ', () => {
  expect(READ.matlab(copyText(matrixSheet({ ...place, units: KERNEL_UNITS }), 'matlab'))).toEqual([rowsOf(T)]);
  const [rows] = READ.python(copyText(matrixSheet(place), 'python'));
  rows.forEach((row, i) =>
    row.forEach((value, j) =>
      j === 3 && i < 3 ? expect(value / 1e3).toBeCloseTo(T[12 + i], 15) : expect(value).toBe(T[4 * j + i]),
    ),
  );
  const name = matrixSheet({ ...place, frame: 3, from: 0, T: frameSeenFrom(3, 0, linkFrames(chain, q), T) }).items[0]
    .name;
  expect(name).toBe('T_base_f3');
});

test('the links multiply to the flange', () => {
  const links = linkRows(chain, q).map((row, index) => ({ index, A: linkTransform(robot.convention, row) }));
  const read = READ.latex(copyText(linksSheet(robot, links, KERNEL_UNITS), 'latex'));
  const product = read.reduce((A, B) =>
    A.map((row) => B[0].map((_, j) => row.reduce((sum, v, k) => sum + v * B[k][j], 0))),
  );
  rowsOf(linkFrames(chain, q).slice(-16)).forEach((row, i) =>
    row.forEach((value, j) => expect(product[i][j]).toBeCloseTo(value, 13)),
  );
});

test('joint values are those of the document, or radians; a slide is a length', () => {
  expect(READ.text(copyText(jointsSheet(doc, robot.units), 'text'))).toEqual([[[...doc.posture]]]);
  expect(READ.text(copyText(jointsSheet(doc, KERNEL_UNITS), 'text'))).toEqual([
    [Array.from(compilePosture(robot, doc.posture))],
  ]);
  const scara = newDocument(LIBRARY.scara_cobra600);
  expect(copyText(jointsSheet(scara, scara.robot.units), 'python')).toContain(
    '# J1 in deg, J2 in deg, J3 in mm, J4 in deg\n',
  );
});
