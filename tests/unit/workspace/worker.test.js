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
