/** The worker's manners: words and an answer with the question's id, silence about what was given up, faults in words. */
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import { publishedArm } from '../kinematics/publishedArms.js';

/** @import { MapWorkspaceAnswer, MapWorkspaceQuestion } from '../../../src/workers/mapWorkspace.js' */

/** @type {MapWorkspaceAnswer[]} */
let said = [];
/** @type {{ postMessage: (answer: MapWorkspaceAnswer) => void, onmessage: (event: { data: MapWorkspaceQuestion }) => void }} */
const worker = { postMessage: (answer) => void said.push(answer), onmessage: () => {} };

beforeAll(async () => {
  vi.stubGlobal('self', worker);
  await import('../../../src/workers/mapWorkspace.js');
});

afterAll(() => vi.unstubAllGlobals());

const chain = publishedArm('puma560');

/** @param {number} id @param {number} [count] @returns {MapWorkspaceQuestion} */
const cloud = (id, count = 300_000) => ({ id, chain, job: { kind: 'cloud', options: { count } } });

/** @param {MapWorkspaceQuestion} data */
const ask = (data) => worker.onmessage({ data });

const isOver = (/** @type {number} */ id) => () =>
  said.some((answer) => answer.id === id && !('word' in answer)) || Promise.reject(new Error('Not yet.'));

/** @param {() => unknown} condition */
const until = (condition) => vi.waitFor(condition, { timeout: 10_000, interval: 5 });

test('a question is answered with its id; one that is overtaken is not', async () => {
  said = [];
  ask(cloud(1));
  ask(cloud(2, 100_000));
  await until(isOver(2));
  expect(said.filter(({ id }) => id === 1)).toHaveLength(1); // its first word was said before the second question came
  expect(said.at(-1)).toMatchObject({ id: 2, found: { kind: 'cloud' } });
  expect(said.filter((answer) => answer.id === 2 && 'word' in answer)).toHaveLength(2);
});

test('work that is stopped says nothing more', async () => {
  said = [];
  ask(cloud(3));
  ask({ id: 4, stop: true });
  ask(cloud(5, 50_000));
  await until(isOver(5));
  expect(said.filter(({ id }) => id === 3)).toHaveLength(1);
});

test('a question that makes no sense is answered with why', async () => {
  said = [];
  ask({ id: 6, chain, job: { kind: 'cloud', options: { seed: 0.5 } } });
  await until(isOver(6));
  expect(said.at(-1)).toEqual({ id: 6, fault: 'Expected seed to be a whole number, got 0.5.' });
});

/** All that is said of a section of an arm. @param {number} id @param {object} options */
async function saidOf(id, options) {
  said = [];
  ask({ id, chain, job: { kind: 'section', options } });
  await until(isOver(id));
  return said.flatMap((answer) => ('word' in answer && answer.word.first ? [answer.word.first] : []));
}

test('a section begins with pictures that grow finer, in its own plane', async () => {
  const [first, second] = await saidOf(7, { cell: 0.02 });
  expect(first).toMatchObject({ kind: 'meridian', isAnyAngle: true });
  expect(second.cells.size).toBeLessThan(first.cells.size);
  const last = said.at(-1);
  if (!last || !('found' in last) || last.found.kind !== 'section' || !last.found.section)
    throw new Error('No section.');
  const { frame, cells, extent } = last.found.section;
  expect(second.frame).toEqual(frame);
  // where a posture lands is reached: no cell that is seen lies outside of the section, but by its own width
  const { u, v, size, columns, reached } = second.cells;
  reached.forEach((isIn, k) => {
    if (!isIn) return;
    const [left, low] = [u + (k % columns) * size, v + Math.floor(k / columns) * size];
    expect(left + size).toBeGreaterThan((extent?.u[0] ?? 0) - 1e-6);
    expect(low).toBeLessThan((extent?.v[1] ?? 0) + 1e-6);
  });
  expect(cells.size).toBe(0.02);
});

test('a plane that no joint brings places into has a picture of those that pass by at first', async () => {
  const cut = { kind: 'plane', origin: [0, 0, 0.3], u: [1, 0, 0], v: [0, 1, 0] };
  const pictures = await saidOf(8, { cut, cell: 0.02, tolerance: 5e-4 });
  expect(pictures).toHaveLength(1);
  const [{ cells, beside }] = pictures;
  expect(beside).toBeGreaterThan(0); // and no more than a cell
  expect(beside).toBeLessThan(cells.size);
  expect(cells.reached.some(Boolean)).toBe(true);
  // Puma 560 reaches 0.8779 m from the shoulder (0.4318, 0.4323 and 0.15005 m), whose height is 0.67183 m
  const farthest = Math.sqrt((0.4318 + Math.hypot(0.4318, 0.0203)) ** 2 + 0.15005 ** 2 - (0.67183 - 0.3) ** 2);
  expect(cells.u).toBeGreaterThan(-farthest - 2 * cells.size);
  expect(cells.u + cells.columns * cells.size).toBeLessThan(farthest + 2 * cells.size);
  const last = said.at(-1);
  if (!last || !('found' in last) || last.found.kind !== 'section') throw new Error('No section.');
  for (const [at, end] of [-farthest, farthest].entries())
    expect(Math.abs((last.found.section?.extent?.u[at] ?? 0) - end)).toBeLessThan(1e-3);
});
