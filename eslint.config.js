/**
 * What may not be written where. Each entry of the lists is [selector, what to do instead]; tests/unit/tooling plants a
 * violation of every one.
 */
import js from '@eslint/js';
import globals from 'globals';
import { noAny, typesByImportTag } from './scripts/jsdocTypes.mjs';

/** @typedef {readonly (readonly [selector: string, message: string])[]} Restrictions */

const CLOCK = 'Take the Clock as a parameter.';
const TIMERS = '/^(requestAnimationFrame|setTimeout|setInterval|requestIdleCallback)$/';
/** @type {Restrictions} */
const TIME_AND_CHANCE = [
  ['MemberExpression[object.name="Math"][property.name="random"]', 'Take a generator from createRandom(seed).'],
  ['MemberExpression[property.name=/^(getRandomValues|randomUUID)$/]', 'Take a generator from createRandom(seed).'],
  ['MemberExpression[object.name=/^(Date|performance)$/][property.name="now"]', CLOCK],
  [`CallExpression[callee.name=${TIMERS}]`, CLOCK],
  [`CallExpression[callee.property.name=${TIMERS}]`, CLOCK],
  [':matches(NewExpression, CallExpression)[callee.name="Date"]', CLOCK],
];

const UNITS_FILE = 'Convert units in src/model/units.js only.';
/** @type {Restrictions} */
const UNITS = [
  [
    ':matches(BinaryExpression[operator=/^[*\\u002f]$/], AssignmentExpression[operator=/^[*\\u002f]=$/]) > :matches(Literal[value=180], Literal[value=1000])',
    UNITS_FILE,
  ],
  ['MemberExpression[property.name=/^(degToRad|radToDeg|DEG2RAD|RAD2DEG)$/]', UNITS_FILE],
];

const ELEMENTS = 'Build elements with ui/parts/dom.js; text stays text.';
const INSERTING =
  '/^(append|prepend|before|after|replaceWith|appendTo|prependTo|insertBefore|insertAfter|wrap|wrapAll|wrapInner)$/';
const MARKUP =
  ':matches(Literal[value=/</], TemplateLiteral:has(TemplateElement[value.raw=/</]), BinaryExpression:has(Literal[value=/</]))';
/** @type {Restrictions} */
const HTML_FROM_TEXT = [
  ['AssignmentExpression > MemberExpression.left[property.name=/^(innerHTML|outerHTML|srcdoc)$/]', ELEMENTS],
  ['AssignmentExpression > MemberExpression.left[property.value=/^(innerHTML|outerHTML|srcdoc)$/]', ELEMENTS],
  ['Property[key.name=/^(innerHTML|outerHTML|srcdoc)$/]', ELEMENTS],
  [
    'CallExpression[callee.property.name=/^(insertAdjacentHTML|html|parseHTML|setHTMLUnsafe|createContextualFragment)$/]',
    ELEMENTS,
  ],
  ['CallExpression[callee.object.name="document"][callee.property.name=/^write(ln)?$/]', ELEMENTS],
  [`CallExpression[callee.name=/^(\\$|jQuery)$/] > ${MARKUP}.arguments`, ELEMENTS],
  [`CallExpression[callee.property.name=${INSERTING}] > ${MARKUP}.arguments`, ELEMENTS],
  ['Property[key.name="html"][value.value=true]', 'A popover or tooltip shows text.'],
  ['Property[key.name="sanitize"][value.value=false]', 'A popover or tooltip shows text.'],
];

/** @type {Restrictions} */
const EXPORTS = [
  [':matches(ExportDefaultDeclaration, ExportSpecifier[exported.name="default"])', 'Named exports only.'],
  ['ExportAllDeclaration', 'No barrels.'],
];

/** @type {Restrictions} */
const GLOBAL_OBJECT = [
  ['Identifier[name="globalThis"]', 'This folder runs without a browser: take what you need as a parameter.'],
];

/** @param {Restrictions[]} lists */
const restrict = (...lists) => ['error', ...lists.flat().map(([selector, message]) => ({ selector, message }))];

const noBrowserGlobals = Object.fromEntries(Object.keys(globals.browser).map((name) => [name, 'off']));
/** These run unchanged in Node, in a worker and in the page. */
const ANYWHERE = [
  'src/kinematics/**/*.js',
  'src/motion/**/*.js',
  'src/karel/**/*.js',
  'src/model/**/*.js',
  'src/io/**/*.js',
];

export default [
  { ignores: ['dist/', '.cache/', 'coverage/', 'test-results/', 'playwright-report/'] },
  js.configs.recommended,
  {
    plugins: { denavit: { rules: { 'no-any': noAny, 'types-by-import-tag': typesByImportTag } } },
    rules: {
      eqeqeq: 'error',
      'prefer-const': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'denavit/no-any': 'error',
    },
  },
  {
    files: ['src/**/*.js'],
    languageOptions: { globals: globals.browser },
    rules: {
      'no-restricted-syntax': restrict(TIME_AND_CHANCE, UNITS, HTML_FROM_TEXT, EXPORTS),
      'denavit/types-by-import-tag': 'error',
      'no-console': 'error',
      'no-alert': 'error',
      'max-lines': ['error', { max: 300, skipBlankLines: true, skipComments: true }],
    },
  },
  {
    files: ANYWHERE,
    languageOptions: {
      globals: { ...noBrowserGlobals, URLSearchParams: 'readonly', TextDecoder: 'readonly', TextEncoder: 'readonly' },
    },
    rules: { 'no-restricted-syntax': restrict(TIME_AND_CHANCE, UNITS, HTML_FROM_TEXT, EXPORTS, GLOBAL_OBJECT) },
  },
  {
    // The clock is where time, and its milliseconds, come in.
    files: ['src/ui/browserClock.js'],
    rules: { 'no-restricted-syntax': restrict(HTML_FROM_TEXT, EXPORTS) },
  },
  {
    // The composition root is where chance and the date come in.
    files: ['src/main.js'],
    rules: { 'no-restricted-syntax': restrict(UNITS, HTML_FROM_TEXT, EXPORTS) },
  },
  {
    files: ['src/model/units.js'],
    rules: { 'no-restricted-syntax': restrict(TIME_AND_CHANCE, HTML_FROM_TEXT, EXPORTS, GLOBAL_OBJECT) },
  },
  { files: ['src/ui/messages.js'], rules: { 'no-console': 'off', 'no-alert': 'off' } },
  {
    files: ['tests/**/*.js', 'scripts/**/*.mjs', 'bench/**/*.mjs', '*.config.js', '.dependency-cruiser.cjs'],
    languageOptions: { globals: { ...globals.node, ...globals.browser } },
  },
];
