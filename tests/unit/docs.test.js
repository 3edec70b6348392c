/** Every `expression // → value` in a doc comment of the pure folders is true. */
import { describe, expect, test } from 'vitest';

const FOLDERS = 'kinematics, karel, model, io';
const modules = import.meta.glob('../../src/{kinematics,karel,model,io}/**/*.js', { eager: true });
const sources = import.meta.glob('../../src/{kinematics,karel,model,io}/**/*.js', {
  eager: true,
  query: '?raw',
  import: 'default',
});

/** A line of a block comment that promises a value: code, arrow, value. */
const EXAMPLE = /^ *(?:\/\*)?\* (\S.*?) *\/\/ → (.+?)(?: *\*\/)?$/gm;

/** Numbers within 1e-12 of each other are equal here: examples are for readers. @param {unknown} found @param {unknown} promised */
function expectSame(found, promised) {
  if (typeof promised === 'number' && typeof found === 'number' && Number.isFinite(promised)) {
    expect(Math.abs(found - promised)).toBeLessThan(1e-12 * (1 + Math.abs(promised)));
  } else if (Array.isArray(promised) && Array.isArray(found)) {
    expect(found.length).toBe(promised.length);
    promised.forEach((value, i) => expectSame(found[i], value));
  } else {
    expect(found).toEqual(promised);
  }
}

let count = 0;
for (const [file, source] of Object.entries(sources)) {
  const scope = /** @type {Record<string, unknown>} */ (modules[file]);
  const examples = [...String(source).matchAll(EXAMPLE)];
  count += examples.length;
  if (examples.length === 0) continue;
  const evaluate = (/** @type {string} */ text) =>
    new Function(...Object.keys(scope), `return (${text});`)(...Object.values(scope));
  describe(file.replace('../../', ''), () => {
    for (const [, code, value] of examples)
      test(`${code} → ${value}`, () => expectSame(evaluate(code), evaluate(value)));
  });
}

test(`there are examples in ${FOLDERS} and they are found`, () => {
  expect(count).toBeGreaterThanOrEqual(10);
});
