import js from '@eslint/js';
import globals from 'globals';

/** [selector, what to do instead] */
const TIME_AND_CHANCE = [
  [
    'CallExpression[callee.object.name="Math"][callee.property.name="random"]',
    'Take a generator from createRandom(seed).',
  ],
  [
    'CallExpression[callee.object.name=/^(Date|performance)$/][callee.property.name="now"]',
    'Take the Clock as a parameter.',
  ],
  [
    'CallExpression[callee.name=/^(requestAnimationFrame|setTimeout|setInterval|requestIdleCallback)$/]',
    'Take the Clock as a parameter.',
  ],
  ['NewExpression[callee.name="Date"]', 'Take the Clock as a parameter.'],
];
const UNITS = ['*', '/'].map((operator) => [
  `BinaryExpression[operator="${operator}"] > Literal[raw=/^(180|1000)$/]`,
  'Convert units in src/model/units.js only.',
]);
const HTML_FROM_TEXT = [
  [
    'AssignmentExpression[left.property.name=/^(innerHTML|outerHTML)$/]',
    'Build elements with ui/dom.js; text stays text.',
  ],
  [
    'CallExpression[callee.property.name=/^(insertAdjacentHTML|html|parseHTML)$/]',
    'Build elements with ui/dom.js; text stays text.',
  ],
  ['CallExpression[callee.name="$"] > Literal.arguments[value=/</]', 'Build elements with ui/dom.js; text stays text.'],
];
const EXPORTS = [
  ['ExportDefaultDeclaration', 'Named exports only.'],
  ['ExportAllDeclaration', 'No barrels.'],
];
const restrict = (...lists) => ['error', ...lists.flat().map(([selector, message]) => ({ selector, message }))];

const noBrowserGlobals = Object.fromEntries(Object.keys(globals.browser).map((name) => [name, 'off']));

export default [
  { ignores: ['dist/', '.cache/', 'coverage/', 'test-results/', 'playwright-report/'] },
  js.configs.recommended,
  {
    files: ['src/**/*.js'],
    languageOptions: { globals: globals.browser },
    rules: {
      'no-restricted-syntax': restrict(TIME_AND_CHANCE, UNITS, HTML_FROM_TEXT, EXPORTS),
      'no-console': 'error',
      'no-alert': 'error',
      'max-lines': ['error', { max: 300, skipBlankLines: true, skipComments: true }],
    },
  },
  { rules: { eqeqeq: 'error', 'prefer-const': 'error', 'no-var': 'error', 'object-shorthand': 'error' } },
  {
    // These run unchanged in Node, in a worker and in the page.
    files: ['src/kinematics/**/*.js', 'src/karel/**/*.js', 'src/model/**/*.js', 'src/io/**/*.js'],
    languageOptions: { globals: { ...noBrowserGlobals, URLSearchParams: 'readonly', TextDecoder: 'readonly' } },
  },
  {
    // The clock is where time, and its milliseconds, come in.
    files: ['src/ui/browserClock.js'],
    rules: { 'no-restricted-syntax': restrict(HTML_FROM_TEXT, EXPORTS) },
  },
  {
    files: ['src/model/units.js'],
    rules: { 'no-restricted-syntax': restrict(TIME_AND_CHANCE, HTML_FROM_TEXT, EXPORTS) },
  },
  { files: ['src/ui/messages.js'], rules: { 'no-console': 'off', 'no-alert': 'off' } },
  {
    files: ['tests/**/*.js', 'scripts/**/*.mjs', 'bench/**/*.mjs', '*.config.js', '.dependency-cruiser.cjs'],
    languageOptions: { globals: { ...globals.node, ...globals.browser } },
  },
];
