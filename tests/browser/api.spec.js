/** `window.denavit`, as docs/api.md has it, in the built page. */
import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import { open } from './page.js';

/** @param {string} name */
const fixture = (name) =>
  JSON.parse(readFileSync(new URL(`../fixtures/kinematics/${name}`, import.meta.url), 'utf8')).arms;
const DEGREES = 180 / Math.PI;

test('arms stand where the Robotics Toolbox has them, and solve() finds their poses', async ({ page }) => {
  await open(page);
  for (const robot of ['puma560', 'ur5', 'scara_cobra600', 'planar2r']) {
    const { postures, poses } = numbersOf(robot);
    const answers = await page.evaluate(
      async ({ id, values, targets }) => {
        const { denavit } = window;
        await denavit.load(id);
        const stood = values.map((joints) => {
          denavit.setJoints(joints);
          return denavit.pose();
        });
        await denavit.load(id);
        const solved = targets.map((pose) => ({ ...denavit.solve(pose), stands: denavit.pose() }));
        return { stood, solved: solved.map(({ status, stands }) => ({ status, stands })) };
      },
      { id: robot, values: postures, targets: poses },
    );
    answers.stood.forEach((pose, i) => expectSame(pose, poses[i], 1e-11));
    answers.solved.forEach(({ status, stands }, i) => {
      expect([robot, status]).toEqual([robot, 'converged']);
      expectSame(stands, poses[i], 2e-9);
    });
  }
});

test('wrong calls throw in words and change nothing', async ({ page }) => {
  await open(page);
  const said = await page.evaluate(async () => {
    const { denavit } = window;
    /** @type {string[]} */
    const messages = [];
    /** @param {() => unknown} call */
    const attempt = async (call) => {
      try {
        await call();
        messages.push('no error');
      } catch (error) {
        messages.push(/** @type {Error} */ (error).message);
      }
    };
    await attempt(() => denavit.setJoints([1, 2]));
    await attempt(() => denavit.setJoints([1, 2, 3, 4, 5, NaN]));
    await attempt(() => denavit.load('r2d2'));
    await attempt(() => denavit.load('<robotModel/>'));
    await attempt(() => denavit.solve([[1]]));
    await attempt(() => denavit.solve([[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])); // prettier-ignore
    denavit.undo(); // nothing to undo: nothing happens
    return { messages, joints: denavit.joints() };
  });
  expect(said.messages[0]).toBe('Expected 6 joint values, got 2.');
  expect(said.messages[1]).toContain('NaN');
  expect(said.messages[2]).toMatch(/^Expected one of planar2r, .*, ur5, .* or a robot file, got "r2d2"/);
  for (const message of said.messages) expect(message).not.toBe('no error');
  expect(said.joints).toEqual([0, 45, -180, 0, 45, 0]);
});

test('every call is one step that undo takes back', async ({ page }) => {
  await open(page);
  const trace = await page.evaluate(async () => {
    const { denavit } = window;
    const home = denavit.joints();
    const xml = denavit.xml();
    denavit.setJoints([1, 2, 3, 4, 5, 6]);
    await denavit.load('planar2r');
    denavit.undo();
    const afterOne = denavit.joints();
    denavit.undo();
    const same = denavit.xml() === xml;
    denavit.redo();
    return { home, afterOne, same, again: denavit.joints(), name: denavit.model().name };
  });
  expect(trace).toEqual({
    home: [0, 45, -180, 0, 45, 0],
    afterOne: [1, 2, 3, 4, 5, 6],
    same: true,
    again: [1, 2, 3, 4, 5, 6],
    name: 'Puma 560',
  });
});

/**
 * Ten postures in document units (mm, degrees) and their poses as rows, metres.
 * @param {string} robot
 * @returns {{ postures: number[][], poses: number[][][] }}
 */
function numbersOf(robot) {
  /** @type {{ joints: readonly (readonly [string, ...number[]])[] }} */
  const { joints } = fixture('arms.json')[robot];
  /** @type {{ q: number[][], tcp: number[][] }} */
  const { q, tcp } = fixture('forward.json')[robot];
  return {
    postures: q
      .slice(0, 10)
      .map((values) => values.map((value, i) => value * (joints[i][0] === 'prismatic' ? 1000 : DEGREES))),
    poses: tcp.slice(0, 10).map((line) => [line.slice(0, 4), line.slice(4, 8), line.slice(8, 12), [0, 0, 0, 1]]),
  };
}

/** @param {readonly (readonly number[])[]} pose @param {readonly (readonly number[])[]} expected @param {number} tolerance */
function expectSame(pose, expected, tolerance) {
  pose.forEach((row, i) => row.forEach((value, j) => expect(Math.abs(value - expected[i][j])).toBeLessThan(tolerance)));
}
