/** Poses as other programs write them: what is read from the text, and the target that comes of it. */
import { describe, expect, test } from 'vitest';
import { readPoseText } from '../../../src/io/poseText.js';
import { poseFromXyzwpr } from '../../../src/model/aim/aim.js';
import { copyText } from '../../../src/model/numbers/copyText.js';
import { matrixSheet, poseSheet } from '../../../src/model/numbers/copySheets.js';
import { orientationForm } from '../../../src/model/numbers/orientationForms.js';
import { readAs, readingsOf } from '../../../src/model/numbers/poseReadings.js';
import { firstRobot as robot } from '../../../src/model/shelf.js';

const NOW = [1, 2, 3, 40, 50, 60];

/** The target of a text as it is understood at first. @param {string} text */
function targetOf(text) {
  const { found, fault } = readPoseText(text);
  if (!found) throw new Error(JSON.stringify(fault));
  const [reading] = readingsOf(found.numbers, found.said, 'wpr');
  const read = readAs(reading, found.numbers, { ...robot.units, ...found.units }, robot, NOW);
  if (!read.target) throw new Error(JSON.stringify(read.fault));
  return read.target;
}

// X 450 Y −100.5 Z 900, turned by 90° about z: W 0 P 0 R 90, written out by hand in every language
const WANTED = [450, -100.5, 900, 0, 0, 90];
const H = '0.7071067811865476';

test.each([
  ['CSV', '450, -100.5, 900, 0, 0, 90'],
  ['blanks and a true minus', '450 −100.5 900 0 0 90'],
  ['decimal commas', '450,0; -100,5; 900; 0; 0; 90'],
  ['lines with units', '450 mm\n-100.5 mm\n900 mm\n0°\n0°\n90°'],
  ['a pendant of FANUC', "GP1:\n UF : 0, UT : 1,  CONFIG : 'N U T, 0, 0, 0',\n X = 450.000  mm, Y = -100.500  mm, Z = 900.000 mm,\n W = .000 deg, P = .000 deg, R = 90.000 deg"], // prettier-ignore
  ['KUKA', '{X 450, Y -100.5, Z 900, A 90, B 0, C 0, S 2, T 35}'],
  ['KUKA with its type', 'DECL E6POS XP1={X 450.0,Y -100.5,Z 900.0,A 90.0,B 0.0,C 0.0,S 6,T 27,E1 0.0}'],
  ['a quaternion', `450 -100.5 900 0 0 ${H} ${H}`],
  ['ABB', `CONST robtarget p10:=[[450,-100.5,900],[${H},0,0,${H}],[1,1,0,11],[9E9,9E9,9E9,9E9,9E9,9E9]];`],
  ['ROS', `position:\n  x: 0.45\n  y: -0.1005\n  z: 0.9\norientation:\n  x: 0.0\n  y: 0.0\n  z: ${H}\n  w: ${H}`],
  ['Universal Robots', 'p[0.45, -0.1005, 0.9, 0, 0, 1.5707963267948966]'],
  ['JSON with names', '{"x": 450, "y": -100.5, "z": 900, "a": 90, "b": 0, "c": 0}'],
  ['JSON without', '[450, -100.5, 900, 0, 0, 90]'],
  ['numpy', 'T = np.array([[0., -1., 0., 450.],\n [1., 0., 0., -100.5],\n [0., 0., 1., 900.],\n [0., 0., 0., 1.]])'],
  ['MATLAB', 'T = [0 -1 0 450; 1 0 0 -100.5; 0 0 1 900; 0 0 0 1]; % made by hand'],
  ['CSV matrix', '0,-1,0,450;1,0,0,-100.5;0,0,1,900;0,0,0,1'],
  ['a matrix column by column', '0 1 0 0 -1 0 0 0 0 0 1 0 450 -100.5 900 1'],
  ['three rows', '0 -1 0 450\n1 0 0 -100.5\n0 0 1 900'],
  ['a rotation, then the place', '[0 -1 0; 1 0 0; 0 0 1], [450 -100.5 900]'],
])('%s', (_, text) => {
  targetOf(text).forEach((value, k) => expect(value).toBeCloseTo(WANTED[k], 8));
});

test('twelve numbers column by column are one choice further on, since both orders fit', () => {
  const numbers = [0, 1, 0, -1, 0, 0, 0, 0, 1, 450, -100.5, 900];
  const readings = readingsOf(numbers, null, 'wpr');
  expect(readings.map(({ id }) => id)).toEqual(['rotation-first', 'columns', 'rows']);
  readAs(readings[1], numbers, robot.units, robot, NOW).target?.forEach((value, k) => expect(value).toBeCloseTo(WANTED[k], 9)); // prettier-ignore
});

test('three numbers are the place; the orientation stays', () => {
  expect(targetOf('450; -100.5; 900')).toEqual([450, -100.5, 900, 40, 50, 60]);
  expect(targetOf('X=450 Y=-100.5 Z=900')).toEqual([450, -100.5, 900, 40, 50, 60]);
});

describe.each(/** @type {const} */ (['text', 'python', 'matlab', 'json']))('what is copied as %s', (format) => {
  const asked = [450.25, -100.5, 900.125, 10, 20, 30];
  const T = poseFromXyzwpr(robot, asked);
  test.each([robot.units, /** @type {const} */ ({ length: 'm', angle: 'rad' })])('comes back, in $length', (units) => {
    const place = /** @type {const} */ ({ robot, frame: 'target', from: 'world', T, units });
    for (const id of ['wpr', 'abc', 'xyzw', 'wxyz', 'rotation-vector']) {
      const sheet = poseSheet(place, orientationForm(id));
      targetOf(copyText(sheet, format)).forEach((value, k) => expect(value).toBeCloseTo(asked[k], 9));
    }
    targetOf(copyText(matrixSheet(place), format)).forEach((value, k) => expect(value).toBeCloseTo(asked[k], 9));
  });
});

test.each([
  ['', { kind: 'empty' }],
  ['1 2 3 4 5', { kind: 'count', count: 5 }],
  ['[[1,2],[3,4]]', { kind: 'count', count: 4 }],
  ['450 100 high', { kind: 'word', word: 'high' }],
  ['1 2 nan', { kind: 'word', word: 'nan' }],
  ['1 2 1e999', { kind: 'word', word: '1e999' }],
  ['X 1, Y 2, W 3', { kind: 'missing', names: 'X Y W' }],
  ['1 '.repeat(4000), { kind: 'too-long' }],
  ['no numbers here', { kind: 'word', word: 'no' }],
])('%j is refused', (text, fault) => expect(readPoseText(text).fault).toMatchObject(fault));

test('a quaternion that is not of length 1 makes no target, and is mended only in its own numbers', () => {
  const numbers = [1, 2, 3, 0, 0, 3, 4];
  const [reading] = readingsOf(numbers, null, 'wpr');
  const read = readAs(reading, numbers, robot.units, robot, NOW);
  expect(read.target).toBeNull();
  expect(read.fault).toMatchObject({ of: 'quaternion', length: 5 });
  expect(read.mended).toEqual([1, 2, 3, 0, 0, 0.6, 0.8]);
});

test('a rounded matrix makes no target; mended in the order it came in, it does', () => {
  const c = 0.7071;
  for (const [order, numbers] of Object.entries({
    rows: [c, -c, 0, 450, c, c, 0, 100, 0, 0, 1, 900, 0, 0, 0, 1],
    columns: [c, c, 0, 0, -c, c, 0, 0, 0, 0, 1, 0, 450, 100, 900, 1],
  })) {
    const [reading] = readingsOf(numbers, null, 'wpr');
    expect(reading.id).toBe(order);
    const read = readAs(reading, numbers, robot.units, robot, NOW);
    expect(read.fault).toMatchObject({ kind: 'skew' });
    const mended = read.mended ?? [];
    const again = readAs(reading, mended, robot.units, robot, NOW);
    again.target?.forEach((value, k) => expect(value).toBeCloseTo([450, 100, 900, 0, 0, 45][k], 9));
    expect(again.target).not.toBeNull();
  }
});
