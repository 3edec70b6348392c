import { expect, test } from 'vitest';
import { runSteps } from '../../../scripts/steps.mjs';

const says = (/** @type {string} */ text, status = 0) => [
  '-e',
  `console.log(${JSON.stringify(text)}); process.exit(${status})`,
];

/** @param {Parameters<typeof runSteps>[0]} steps */
async function run(steps) {
  let text = '';
  const results = await runSteps(steps, process.cwd(), (part) => (text += part));
  return { text, results: results.map(({ name, outcome, note }) => ({ name, outcome, note })) };
}

test('a failing step shows all it said, and the steps after it still run', async () => {
  const { text, results } = await run([
    { name: 'first', command: says('one\ntwo', 3) },
    { name: 'second', command: says('quiet') },
  ]);
  expect(results).toEqual([
    { name: 'first', outcome: 'failed', note: '' },
    { name: 'second', outcome: 'ok', note: '' },
  ]);
  expect(text).toContain('one\ntwo');
  expect(text).not.toContain('quiet');
});

test('a step that needs a failed one, or one that never ran, is not run', async () => {
  const { results } = await run([
    { name: 'build', command: says('', 1) },
    { name: 'size', command: says(''), needs: 'build' },
    { name: 'browser', command: says(''), needs: 'size' },
  ]);
  expect(results.map(({ outcome }) => outcome)).toEqual(['failed', 'not run', 'not run']);
});

test('a step with a problem fails with that problem as its note', async () => {
  const { results } = await run([{ name: 'browser', command: says(''), problem: 'No browser.' }]);
  expect(results).toEqual([{ name: 'browser', outcome: 'failed', note: 'No browser.' }]);
});

test('a step killed by a signal has failed', async () => {
  const { results } = await run([{ name: 'a', command: ['-e', "process.kill(process.pid, 'SIGKILL')"] }]);
  expect(results[0].outcome).toBe('failed');
});

test('the summary of a step is the line it asked for, without colours', async () => {
  const { results } = await run([
    { name: 'unit', command: says('\u001b[32m Tests  5 passed\u001b[0m\nmore'), summary: /Tests\s+(.*)$/m },
  ]);
  expect(results[0].note).toBe('5 passed');
});

test('lanes run side by side, each in its order, and results keep the order of the list', async () => {
  const waits = (/** @type {number} */ ms) => ['-e', `setTimeout(() => console.log('waited'), ${ms})`];
  const { text, results } = await run([
    { name: 'long', lane: 'one', command: waits(1500) },
    { name: 'behind', lane: 'one', command: says(''), needs: 'long' },
    { name: 'short', lane: 'other', command: says('', 1) },
    { name: 'after', command: says('') },
  ]);
  expect(results.map(({ name, outcome }) => [name, outcome])).toEqual([
    ['long', 'ok'],
    ['behind', 'ok'],
    ['short', 'failed'],
    ['after', 'ok'],
  ]);
  const told = ['short', 'long', 'behind', 'after'].map((name) => text.indexOf(`${name} …`));
  expect(told).toEqual([...told].sort((a, b) => a - b));
});
