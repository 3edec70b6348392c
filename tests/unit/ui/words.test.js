/**
 * What a person reads or hears stands in src/ui/words and strings.js, so that it can be translated: no other module of the
 * page holds a sentence, or a word where one would be seen.
 */
import { readFileSync, readdirSync } from 'node:fs';
import { parseAst } from 'vite';
import { expect, test } from 'vitest';

/** @typedef {{ type: string, [key: string]: unknown }} Node */

/** Words with a blank between them, or one with a capital; classes, selectors and paths look otherwise. */
const SENTENCE = /^(?=.*[a-z]{2})[“"(]?[A-Z]?[a-zé’']+([,;:]? [A-Za-zé’'(“”)]+)+[.:!?…]?$/;
const WORD = /^[A-Z][a-z]+[.:!?…]?$/;

/** For the browser, or for who writes scripts, though they look like words. */
const NOT_READ = [
  ...['stop lower', 'stop upper', 'noopener noreferrer', 'canvas, button', '(pointer: coarse)', '(hover: none)'],
  'Files', // a drag has some
  'Another document was opened in the meantime.', // window.denavit says it
];

/** Names of keys, as the browser has them. */
const KEYS = /^(Enter|Escape|Tab|Home|End|Delete|Backspace|Shift|Control|Alt|Meta)$/;

/** Attributes whose values are lists of names, or say nothing to anybody. */
const SILENT = ['class', 'className', 'style', 'd', 'viewBox', 'transform', 'font', 'type', 'key'];

/** @param {unknown} value @returns {value is Node} */
const isNode = (value) => typeof value === 'object' && value !== null && 'type' in value;

/**
 * The texts in a module that somebody would read.
 * @param {string} source
 */
export function wordsIn(source) {
  /** @type {string[]} */
  const found = [];
  /** @param {Node} node */
  function visit(node) {
    if (node.type.startsWith('Import') && 'source' in node) return;
    if (node.type === 'ThrowStatement') return; // for who writes the code
    if (node.type === 'NewExpression' && /Error$/.test(String(isNode(node.callee) && node.callee.name))) return;
    if (node.type === 'CallExpression' && isNode(node.callee) && isNode(node.callee.property)) {
      if (
        /^(add|remove|toggle|contains|matches|closest|querySelector(All)?|replace|on)$/.test(
          String(node.callee.property.name),
        )
      ) {
        for (const argument of /** @type {Node[]} */ (node.arguments))
          if (!/^(Literal|TemplateLiteral)$/.test(argument.type)) visit(argument);
        visit(/** @type {Node} */ (node.callee));
        return;
      }
    }
    if (node.type === 'Property' && isNode(node.key) && SILENT.includes(String(node.key.name ?? node.key.value)))
      return;
    const text =
      node.type === 'Literal'
        ? node.value
        : node.type === 'TemplateElement'
          ? /** @type {{ cooked: string }} */ (node.value).cooked
          : null;
    if (
      typeof text === 'string' &&
      !KEYS.test(text) &&
      !NOT_READ.includes(text) &&
      (SENTENCE.test(text.trim()) || WORD.test(text.trim()))
    )
      found.push(text);
    for (const value of Object.values(node)) {
      for (const child of Array.isArray(value) ? value : [value]) if (isNode(child)) visit(child);
    }
  }
  visit(/** @type {Node} */ (/** @type {unknown} */ (parseAst(source))));
  return found;
}

test('no word that is read stands outside the files of words', () => {
  const modules = ['src/ui', 'src/render'].flatMap((folder) =>
    readdirSync(folder, { recursive: true, encoding: 'utf8' }).map((name) => `${folder}/${name}`),
  );
  const files = ['src/main.js', ...modules].filter(
    (path) => path.endsWith('.js') && !/ui\/(words\/|strings\.js)/.test(path),
  );
  expect(files.length).toBeGreaterThan(100);
  const found = files.flatMap((path) => wordsIn(readFileSync(path, 'utf8')).map((text) => `${path}: ${text}`));
  expect(found).toEqual([]);
});

test('words are found where they would be seen', () => {
  expect(wordsIn("h('button', { class: 'btn btn-small', title: 'Go to home' }, 'Zero', `Joint ${1} moved`)")).toEqual([
    'Go to home',
    'Zero',
    'Joint ',
  ]);
  expect(wordsIn("announce('the arm is home'); element.matches('tr td'); throw new Error('Not here at all');")).toEqual(
    ['the arm is home'],
  );
});
