import fc from 'fast-check';
import { expect, test } from 'vitest';
import { expressionText, BREAK } from '../../../src/karel/expressionPrinter.js';
import { binary, call, integer, name, real, string, unary } from '../../../src/karel/tree.js';
import { runs, SEED } from '../../helpers/property.js';
import { wrong } from './wrong.js';
import { readExpression, shapeOf } from './expressionReader.js';

/** @import { LetrecLooselyTypedTie } from 'fast-check' */
/** @import { BinaryOperator, Expression } from '../../../src/karel/tree.js' */

const print = (/** @type {Expression} */ expression) => expressionText(expression).replaceAll(BREAK, '');
const [a, b, c] = ['a', 'b', 'c'].map(name);

/** @type {BinaryOperator[]} */
const OPERATORS = [
  ':',
  '@',
  '#',
  '*',
  '/',
  'AND',
  'DIV',
  'MOD',
  '+',
  '-',
  'OR',
  '<',
  '>',
  '=',
  '<>',
  '<=',
  '>=',
  '>=<',
];

const anyName = fc.constantFrom('a', 'B2', 'flag', 'joint_val', 'x');
const anyReal = fc.oneof(
  fc.double({ min: 1.2e-38, max: 3.4e38, noNaN: true }),
  fc.integer({ min: 0, max: 10 ** 9 }).map((thousandths) => thousandths / 1000),
);
const { expression: anyExpression } = fc.letrec((/** @type {LetrecLooselyTypedTie} */ tie) => ({
  expression: fc.oneof(
    { depthSize: 'medium', withCrossShrink: true },
    tie('leaf'),
    tie('unary'),
    tie('binary'),
    tie('call'),
  ),
  leaf: fc.oneof(
    anyName.map(name),
    fc.integer({ min: -(2 ** 31), max: 2 ** 31 - 1 }).map(integer),
    anyReal.map((value) => real(value)),
    fc
      .string({ unit: 'grapheme', maxLength: 20 })
      .filter((text) => !/\p{C}|[\u2028\u2029]/u.test(text))
      .map(string),
  ),
  unary: fc
    .tuple(fc.constantFrom('NOT', '-', '+'), tie('expression'))
    .map(([operator, operand]) =>
      unary(/** @type {'NOT' | '-' | '+'} */ (operator), /** @type {Expression} */ (operand)),
    ),
  binary: fc
    .tuple(tie('expression'), fc.constantFrom(...OPERATORS), tie('expression'))
    .map(([left, operator, right]) =>
      binary(/** @type {Expression} */ (left), operator, /** @type {Expression} */ (right)),
    ),
  call: fc
    .tuple(anyName, fc.array(tie('expression'), { minLength: 1, maxLength: 3 }), fc.boolean())
    .map(([callee, args, isIndex]) => {
      const list = /** @type {Expression[]} */ (args);
      return isIndex ? { kind: 'index', target: name(callee), indices: list } : call(callee, list);
    }),
}));

test.for(/** @type {const} */ (['of the first term', 'of the operand']))(
  'a printed expression is read back as its tree, taking a sign as that %s',
  (signs) => {
    fc.assert(
      fc.property(anyExpression, (drawn) => {
        const tree = /** @type {Expression} */ (drawn);
        expect(readExpression(print(tree), signs)).toEqual(shapeOf(tree));
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  },
);

test('any two operators, nested either way, are read back as nested', () => {
  const signs = /** @type {const} */ (['NOT', '-', '+']);
  const trees = OPERATORS.flatMap((outer) => [
    ...OPERATORS.flatMap((inner) => [binary(binary(a, inner, b), outer, c), binary(a, outer, binary(b, inner, c))]),
    ...signs.flatMap((sign) => [
      binary(unary(sign, a), outer, b),
      binary(a, outer, unary(sign, b)),
      unary(sign, binary(a, outer, b)),
    ]),
  ]);
  for (const tree of [...trees, ...signs.flatMap((one) => signs.map((two) => unary(one, unary(two, a))))]) {
    expect(readExpression(print(tree), 'of the first term')).toEqual(shapeOf(tree));
    expect(readExpression(print(tree), 'of the operand')).toEqual(shapeOf(tree));
  }
});

test('two minus signs never meet, since they would begin a comment', () => {
  fc.assert(
    fc.property(anyExpression, (tree) => {
      expect(print(/** @type {Expression} */ (tree)).replace(/'([^']|'')*'/g, '')).not.toContain('--');
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});

test.for(
  /** @type {[string, Expression][]} */ ([
    ['(a = b) AND (b < c)', binary(binary(a, '=', b), 'AND', binary(b, '<', c))],
    ['a AND b = c', binary(binary(a, 'AND', b), '=', c)],
    ['a OR b AND c', binary(a, 'OR', binary(b, 'AND', c))],
    ['(a OR b) AND c', binary(binary(a, 'OR', b), 'AND', c)],
    ['NOT a AND b', binary(unary('NOT', a), 'AND', b)],
    ['NOT (a AND b)', unary('NOT', binary(a, 'AND', b))],
    ['NOT (a = b)', unary('NOT', binary(a, '=', b))],
    ['a - b - c', binary(binary(a, '-', b), '-', c)],
    ['a - (b - c)', binary(a, '-', binary(b, '-', c))],
    ['a / (b * c)', binary(a, '/', binary(b, '*', c))],
    ['(a < b) = c', binary(binary(a, '<', b), '=', c)],
    ['a : b * c', binary(binary(a, ':', b), '*', c)],
    ['a : (b * c)', binary(a, ':', binary(b, '*', c))],
    ['-a + b', binary(unary('-', a), '+', b)],
    ['a - (-b)', binary(a, '-', unary('-', b))],
    ['(-a) * b', binary(unary('-', a), '*', b)],
    ['-(a * b)', unary('-', binary(a, '*', b))],
    ['-(-1)', unary('-', integer(-1))],
    ['a < -1', binary(a, '<', integer(-1))],
    ['grid[1, a + 1]', { kind: 'index', target: name('grid'), indices: [integer(1), binary(a, '+', integer(1))] }],
    ['f((a = b) AND c)', call('f', [binary(binary(a, '=', b), 'AND', c)])],
  ]),
)('%s', ([text, tree]) => expect(print(tree)).toBe(text));

test.for([
  [0, '0'],
  [-0, '0'],
  [-1, '-1'],
  [2147483647, '2147483647'],
  [-2147483647, '-2147483647'],
  [-2147483648, '-2147483647 - 1'],
])('the integer %d is written %s', ([value, text]) => expect(print(integer(Number(value)))).toBe(text));

test('the smallest integer keeps its value inside a product', () => {
  expect(print(binary(name('a'), '*', integer(-2147483648)))).toBe('a * (-2147483647 - 1)');
});

test.for([
  [0, undefined, '0.0'],
  [-0, undefined, '0.0'],
  [90, undefined, '90.0'],
  [90, 3, '90.000'],
  [-12.3456, 3, '-12.3456'],
  [0.1, undefined, '0.1'],
  [1e-7, undefined, '1.0E-7'],
  [1e-7, 3, '1.0E-7'],
  [1.5e20, undefined, '1.5E20'],
  [-2.5e-10, undefined, '-2.5E-10'],
  [3.4028235e38, undefined, '3.4028235E38'],
  [999999999, undefined, '999999999.0'],
  [0.0001, undefined, '0.0001'],
])('the real %d with at least %s decimals is written %s', ([value, decimals, text]) => {
  expect(print(real(Number(value), decimals === undefined ? undefined : Number(decimals)))).toBe(text);
});

test('a real is written with all the digits that it has', () => {
  fc.assert(
    fc.property(anyReal, fc.integer({ min: 1, max: 6 }), (value, decimals) => {
      const text = print(real(value, decimals));
      expect(text).toMatch(/^\d+\.\d+(E-?\d+)?$/);
      expect(Number(text)).toBe(value);
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});

test('a quote in a string is doubled', () => expect(print(string("it's"))).toBe("'it''s'"));

test.for(
  /** @type {[string, unknown][]} */ ([
    ['an integer beyond 32 bits', integer(2 ** 31)],
    ['an integer beyond 32 bits below zero', integer(-(2 ** 31) - 1)],
    ['an integer that is none', integer(1.5)],
    ['a negative literal', { kind: 'integer', value: -1 }],
    ['a literal minus zero', { kind: 'real', value: -0 }],
    ['a negative real literal', { kind: 'real', value: -1 }],
    ['a real that is no number', real(NaN)],
    ['a real beyond 32 bits', real(4e38)],
    ['a real too small for 32 bits', real(1e-40)],
    ['no decimals', { kind: 'real', value: 1, decimals: 0 }],
    ['a string of 255 characters', string('x'.repeat(255))],
    ['a string of two lines', string('a\nb')],
    ['a string with a null', string('a\0b')],
    ['half a surrogate pair', string('\ud800')],
    ['a name that begins with a digit', name('1a')],
    ['a name with a line end', name('a\nABORT')],
    ['a reserved word as a name', name('Begin')],
    ['an element of a reserved word', { kind: 'index', target: name('BEGIN'), indices: [a] }],
    ['no indices', { kind: 'index', target: a, indices: [] }],
    ['four indices', { kind: 'index', target: a, indices: [a, a, a, a] }],
    ['a function call without arguments', call('f')],
    ['an operator of another language', { kind: 'binary', operator: '==', left: a, right: b }],
    ['an operator that every object has', { kind: 'binary', operator: 'constructor', left: a, right: b }],
    ['a sign of another language', { kind: 'unary', operator: '!', operand: a }],
  ]),
)('%s has no text', ([, tree]) => {
  expect(() => print(wrong(tree))).toThrow(RangeError);
});

test('a node of an unknown kind is a TypeError', () => {
  expect(() => print(wrong({ kind: 'lambda' }))).toThrow(TypeError);
});
