import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { preprocessCSS, resolveConfig } from 'vite';
import { beforeAll, expect, test } from 'vitest';
import { classesIn } from '../../../scripts/bootstrapParts.mjs';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const FILE = join(ROOT, 'node_modules/bootstrap/dist/css/bootstrap.css');
const WHOLE = readFileSync(FILE, 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');

/** Names that Bootstrap has a class for, and the page another, of its own. @type {readonly string[]} */
const OURS = [];

/** @type {string} */
let parts;
beforeAll(async () => {
  const config = await resolveConfig({ root: ROOT, logLevel: 'silent' }, 'build');
  parts = (await preprocessCSS(WHOLE, FILE, config)).code;
});

/** Every class in a stylesheet's selectors. @param {string} css */
const classesOf = (css) => new Set([...css.matchAll(/([^{};]+)\{/g)].flatMap(([, selector]) => classesIn(selector)));

test('every class of Bootstrap that the page names is among the parts that are kept', () => {
  const whole = classesOf(WHOLE);
  const kept = classesOf(parts);
  const named = readdirSync(join(ROOT, 'src/ui'), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.js'))
    .flatMap((name) => [
      ...readFileSync(join(ROOT, 'src/ui', name), 'utf8').matchAll(
        /class: ['`]([^'`]*)['`]|className: ['`]([^'`]*)['`]/g,
      ),
    ])
    .flatMap(([, one, other]) => (one ?? other).split(/\s+/));
  expect(named).toContain('modal-dialog-scrollable');
  const missing = named.filter((name) => whole.has(name) && !kept.has(name) && !OURS.includes(name));
  expect([...new Set(missing)]).toEqual([]);
});

test('what Bootstrap’s scripts put on an element is kept, and what nobody uses is not', () => {
  expect([...classesOf(parts)]).toEqual(expect.arrayContaining(['show', 'fade', 'modal-backdrop', 'modal-static']));
  for (const name of ['navbar', 'btn-danger', 'row', 'text-center', 'carousel'])
    expect(classesOf(parts)).not.toContain(name);
  expect(parts.length).toBeLessThan(WHOLE.length / 6);
});

test('a custom property that is read is also written, as in the whole stylesheet', () => {
  const read = [...parts.matchAll(/var\((--[\w-]+)\)/g)].map(([, name]) => name);
  const written = (/** @type {string} */ css) =>
    new Set([...css.matchAll(/[{;\s](--[\w-]+)\s*:/g)].map(([, name]) => name));
  const [inParts, inWhole] = [written(parts), written(WHOLE)];
  expect(read.filter((name) => inWhole.has(name) && !inParts.has(name))).toEqual([]);
  expect(inParts.has('--bs-indigo')).toBe(false);
});
