/** Each lint rule still bites, and lets pass what it should: source text is planted and linted as if it were in src. */
import { ESLint } from 'eslint';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';

const eslint = new ESLint({ cwd: fileURLToPath(new URL('../../../', import.meta.url)) });

/**
 * @param {string} filePath
 * @param {string} text
 */
async function complaints(filePath, text) {
  const [{ messages }] = await eslint.lintText(text, { filePath });
  return messages.map(({ ruleId, message }) => `${ruleId}: ${message}`);
}

const lines = (/** @type {number} */ count) => 'export let a = 0;\n' + 'a++;\n'.repeat(count - 1);

/** @type {[what: string, file: string, text: string, complaint: RegExp][]} */
const REFUSED = [
  ['unseeded chance', 'src/ui/x.js', 'export const a = Math.random();', /createRandom/],
  ['chance passed on', 'src/model/x.js', 'export const a = [Math.random];', /createRandom/],
  ['chance by crypto', 'src/ui/x.js', 'export const a = crypto.randomUUID();', /createRandom/],
  ['the date', 'src/render/x.js', 'export const a = Date.now();', /Clock/],
  ['a new date', 'src/ui/x.js', 'export const a = new Date();', /Clock/],
  ['the date as text', 'src/ui/x.js', 'export const a = Date();', /Clock/],
  ['the stopwatch', 'src/render/x.js', 'export const a = performance.now();', /Clock/],
  ['a timer', 'src/ui/x.js', 'setTimeout(() => {}, 5);', /Clock/],
  ['a timer of window', 'src/ui/x.js', 'window.setTimeout(() => {}, 5);', /Clock/],
  ['an animation loop', 'src/render/x.js', 'requestAnimationFrame(() => {});', /Clock/],

  ['degrees by hand', 'src/render/x.js', 'export const f = (a) => (a * Math.PI) / 180;', /units\.js/],
  ['degrees by hand, the other way', 'src/ui/x.js', 'export const f = (a) => 180 * a;', /units\.js/],
  ['degrees in place', 'src/ui/x.js', 'export const f = (a) => { a *= 180; return a; };', /units\.js/],
  ['millimetres by hand', 'src/io/x.js', 'export const f = (a) => a / 1000;', /units\.js/],
  ['millimetres, written 1e3', 'src/io/x.js', 'export const f = (a) => a / 1e3;', /units\.js/],
  ['degrees by Three.js', 'src/render/x.js', 'export const f = (m, a) => m.degToRad(a);', /units\.js/],

  ['markup set', 'src/ui/x.js', 'export const f = (e, s) => { e.innerHTML = s; };', /dom\.js/],
  [
    'markup set where there is no page',
    'src/model/x.js',
    'export const f = (e, s) => { e.innerHTML = s; };',
    /dom\.js/,
  ],
  ['markup added', 'src/ui/x.js', 'export const f = (e, s) => { e.outerHTML += s; };', /dom\.js/],
  ['markup set by key', 'src/ui/x.js', "export const f = (e, s) => { e['innerHTML'] = s; };", /dom\.js/],
  [
    'markup among properties',
    'src/ui/x.js',
    'export const f = (e, s) => Object.assign(e, { innerHTML: s });',
    /dom\.js/,
  ],
  ['markup inserted', 'src/ui/x.js', "export const f = (e, s) => e.insertAdjacentHTML('beforeend', s);", /dom\.js/],
  ['markup by jQuery', 'src/ui/x.js', 'export const f = (e, s) => e.html(s);', /dom\.js/],
  ['an element from text', 'src/ui/x.js', "export const f = ($) => $('<b>');", /dom\.js/],
  ['an element from a template', 'src/ui/x.js', 'export const f = ($, s) => $(`<b>${s}</b>`);', /dom\.js/],
  ['an element from a sum', 'src/ui/x.js', "export const f = ($, s) => $('<b>' + s);", /dom\.js/],
  ['markup appended', 'src/ui/x.js', 'export const f = (e, s) => e.append(`<b>${s}</b>`);', /dom\.js/],
  ['markup written', 'src/ui/x.js', 'document.write(location.hash);', /dom\.js/],
  ['markup in a tooltip', 'src/ui/x.js', 'export const a = { html: true };', /shows text/],
  ['a tooltip without its filter', 'src/ui/x.js', 'export const a = { sanitize: false };', /shows text/],

  ['a default export', 'src/model/x.js', 'export default function f() {}', /Named exports/],
  ['a default export by name', 'src/model/x.js', 'const a = 1; export { a as default };', /Named exports/],
  ['a barrel', 'src/model/x.js', "export * from './document.js';", /barrels/],

  ['the console', 'src/ui/x.js', 'console.log(1);', /no-console/],
  ['an alert', 'src/ui/x.js', "alert('x');", /no-alert/],
  ['301 lines', 'src/model/x.js', lines(301), /max-lines/],

  ...['kinematics', 'karel', 'model', 'io'].flatMap((folder) =>
    ['window', 'document', 'localStorage', 'console', 'structuredClone', 'self', 'fetch', 'process'].map(
      (name) =>
        /** @type {[string, string, string, RegExp]} */ ([
          `${name} in ${folder}`,
          `src/${folder}/x.js`,
          `export const a = ${name};`,
          /no-undef/,
        ]),
    ),
  ),
  ['the page by way of globalThis', 'src/model/x.js', 'export const a = globalThis.document;', /parameter/],

  ['a type by bracket import', 'src/model/x.js', "/** @type {import('./a.js').A} */ export let a;", /@import/],
  [
    'a type by bracket import in a callback',
    'src/model/x.js',
    "/** @callback F\n * @param {import('./a.js').A} a\n */\nexport let a;",
    /@import/,
  ],
  ['any in a test', 'tests/unit/x.test.js', '/** @param {any} a */ export const f = (a) => a;', /no type is any/],
  ['any', 'src/model/x.js', '/** @type {Map<string, any>} */ export let a;', /no type is any/],
  ['any, written *', 'src/model/x.js', '/** @param {*} a */ export const f = (a) => a;', /no type is any/],
  ['any function', 'src/model/x.js', '/** @param {Function} a */ export const f = (a) => a;', /no type is any/],
  ['an unchecked line', 'src/model/x.js', '// @ts-ignore\nexport let a;', /ts-expect-error/],
  ['a loose comparison', 'src/model/x.js', 'export const f = (a) => a == 1;', /eqeqeq/],
];

/** @type {[what: string, file: string, text: string][]} */
const ALLOWED = [
  ['units.js converts', 'src/model/units.js', 'export const f = (a) => (a * 180) / 1000;'],
  ['180 in a sum', 'src/model/x.js', 'export const f = (a) => a + 180;'],
  ['the page’s clock tells the time', 'src/ui/browserClock.js', 'export const f = () => performance.now() / 1000;'],
  ['the composition root hands in the date', 'src/main.js', 'export const today = () => new Date();'],
  ['messages.js speaks', 'src/ui/messages.js', "console.error('x');"],
  ['a generator of chance', 'src/model/x.js', 'export const f = (generator) => generator.random();'],
  ['text content', 'src/ui/x.js', "export const f = (e, s) => { e.textContent = s; e.append(s, '1 < 2'.length); };"],
  ['300 lines', 'src/model/x.js', lines(300)],
  ['long comments', 'src/model/x.js', `${'// why\n'.repeat(200)}${lines(200)}`],
  ['the type of a module', 'src/ui/x.js', "/** @type {typeof import('./a.js') | null} */ export let a;"],
  ['prose about any type', 'src/model/x.js', '/** Any {type} of any kind, import (duty) too: 2 * 3. */ export let a;'],
  ['window in the panels', 'src/ui/x.js', 'export const a = window;'],
];

describe('lint refuses', () => {
  test.each(REFUSED)('%s', async (_what, file, text, complaint) => {
    expect(await complaints(file, text)).toContainEqual(expect.stringMatching(complaint));
  });
});

describe('lint allows', () => {
  test.each(ALLOWED)('%s', async (_what, file, text) => {
    expect(await complaints(file, text)).toEqual([]);
  });
});
