/** Frames seen from frames, and the links' own transforms: both ways to the same tool. */
import { expect, test } from 'vitest';
import { linkFrames, tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { frameSeenFrom, framesOf } from '../../../src/model/numbers/frameNumbers.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { LINK_MOTIONS, LINK_SYMBOLS, linkRows, linkTransform } from '../../../src/model/robot/linkTransforms.js';
import { FIRST_NUMBERS, fitNumbers } from '../../../src/model/numbers/numbersView.js';
import { rowsOf } from '../../../src/model/numbers/poseRows.js';
import { reduce, startState } from '../../../src/model/session.js';

/** @param {number[][]} A @param {number[][]} B */
const times = (A, B) => A.map((row) => B[0].map((_, j) => row.reduce((sum, value, k) => sum + value * B[k][j], 0)));

/** @param {number[][]} A @param {number[][]} B */
const apart = (A, B) => Math.max(...A.flatMap((row, i) => row.map((value, j) => Math.abs(value - B[i][j]))));

/** @param {string} id @param {'standard' | 'modified'} [convention] */
function stand(id, convention) {
  const robot = { ...LIBRARY[id], ...(convention && { convention }) };
  const chain = compileRobot(robot);
  const q = compilePosture(
    robot,
    robot.joints.map((_, i) => 17 * (i + 1)),
  );
  return { robot, chain, q, frames: linkFrames(chain, q), tcp: tcpPose(chain, q) };
}

const ARMS = ['puma560', 'scara_cobra600', 'ur5', 'planar2r'];

test.each(ARMS)('%s: the way from frame to frame ends at the tool', (id) => {
  const { robot, chain, frames, tcp } = stand(id);
  const way = [...robot.joints.map((_, i) => rowsOf(frameSeenFrom(i + 1, i, frames, tcp)))];
  const base = rowsOf(frameSeenFrom(0, 'world', frames, tcp));
  const tool = rowsOf(frameSeenFrom('tool', 'flange', frames, tcp));
  expect(apart(tool, rowsOf(chain.tool))).toBeLessThan(1e-14);
  expect(apart([base, ...way, tool].reduce(times), rowsOf(tcp))).toBeLessThan(1e-14);
});

for (const convention of /** @type {const} */ (['standard', 'modified'])) {
  test.each(ARMS)(`%s, ${convention}: A_i is frame i seen from frame i − 1`, (id) => {
    const { robot, chain, q, frames, tcp } = stand(id, convention);
    linkRows(chain, q).forEach((row, i) => {
      const A = rowsOf(linkTransform(convention, row));
      expect(apart(A, rowsOf(frameSeenFrom(i + 1, i, frames, tcp)))).toBeLessThan(1e-14);
      expect(A.flat().some((value) => Object.is(value, -0))).toBe(false);
    });
    expect(robot.joints.length).toBe(linkRows(chain, q).length);
  });

  test(`${convention}: the symbols say what the numbers are, and so does the product`, () => {
    const row = { theta: 0.3, d: 0.5, a: 0.7, alpha: 1.1 };
    /** @type {Record<string, number>} */
    const values = {
      ...{ cθ: Math.cos(0.3), sθ: Math.sin(0.3), cα: Math.cos(1.1), sα: Math.sin(1.1), d: 0.5, a: 0.7 },
      ...{ 0: 0, 1: 1 },
    };
    const said = LINK_SYMBOLS[convention].map((line) =>
      line.map((entry) => {
        const sign = entry.startsWith('−') ? -1 : 1;
        return entry
          .replace('−', '')
          .split(' ')
          .reduce((product, factor) => product * values[factor], sign);
      }),
    );
    const A = rowsOf(linkTransform(convention, row));
    expect(apart(A, said)).toBeLessThan(1e-15);
    /** @type {Record<string, (v: number) => number[][]>} */
    const motions = {
      Rz: (v) => [
        [Math.cos(v), -Math.sin(v), 0, 0],
        [Math.sin(v), Math.cos(v), 0, 0],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
      ],
      Rx: (v) => [
        [1, 0, 0, 0],
        [0, Math.cos(v), -Math.sin(v), 0],
        [0, Math.sin(v), Math.cos(v), 0],
        [0, 0, 0, 1],
      ],
      Tz: (v) => [
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, v],
        [0, 0, 0, 1],
      ],
      Tx: (v) => [
        [1, 0, 0, v],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
      ],
    };
    const product = LINK_MOTIONS[convention].map(([field, motion]) => motions[motion](row[field])).reduce(times);
    expect(apart(A, product)).toBeLessThan(1e-15);
  });
}

test('a right angle in a row leaves no dirt in its matrix', () => {
  const A = linkTransform('standard', { theta: Math.PI / 2, d: 0, a: 0.4, alpha: -Math.PI / 2 });
  expect(rowsOf(A)).toEqual([
    [0, 0, -1, 0],
    [1, 0, 0, 0.4],
    [0, -1, 0, 0],
    [0, 0, 0, 1],
  ]);
});

test('a choice of frames is kept as long as the robot has them', () => {
  const { robot } = stand('planar2r');
  expect(framesOf(robot, false)).toEqual(['tool', 'flange', 1, 2, 0, 'world']);
  expect(framesOf(robot, true)).toEqual(['tool', 'flange', 1, 2, 0, 'user', 'world']);
  for (const frame of framesOf(robot, true)) {
    const numbers = { ...FIRST_NUMBERS, frame, from: frame };
    expect(fitNumbers(numbers, robot)).toBe(numbers);
  }
  const far = { ...FIRST_NUMBERS, frame: 3, from: 6, form: 'abc' };
  expect(fitNumbers(far, robot)).toEqual({ ...far, frame: 'flange', from: 'flange' });
});

test('how numbers are shown stays when another robot is opened', () => {
  const state = startState(newDocument(LIBRARY.puma560));
  const shown = reduce(state, { type: 'show', change: { numbers: { ...FIRST_NUMBERS, frame: 5, form: 'abc' } } });
  const opened = reduce(shown, { type: 'replace-document', doc: newDocument(LIBRARY.planar2r) });
  expect(opened.session.numbers).toEqual({ ...FIRST_NUMBERS, frame: 'flange', form: 'abc' });
});
