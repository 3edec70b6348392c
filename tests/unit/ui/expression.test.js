/** Expressions in cells, against trees that were computed before they were written down. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { DH_FIELDS, quantityOf } from '../../../src/model/document.js';
import { convertUnits } from '../../../src/model/robot/convertUnits.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { evaluate } from '../../../src/ui/parts/expression.js';
import { fetchExpressions, readTyped } from '../../../src/ui/parts/typedNumber.js';
import { answerExpression } from '../../../src/ui/parts/expressionAnswer.js';
import { SEED, runs } from '../../helpers/property.js';

/** @typedef {import('../../../src/model/document.js').Units} Units */

const MM_DEG = /** @type {Units} */ ({ length: 'mm', angle: 'deg' });
const M_RAD = /** @type {Units} */ ({ length: 'm', angle: 'rad' });
const length = (/** @type {string} */ text, units = MM_DEG) => evaluate(text, 'length', units).found?.value;
const angle = (/** @type {string} */ text, units = MM_DEG) => evaluate(text, 'angle', units).found?.value;
const lengthReason = (/** @type {string} */ text, units = MM_DEG) => evaluate(text, 'length', units).reason;
const angleReason = (/** @type {string} */ text, units = MM_DEG) => evaluate(text, 'angle', units).reason;

describe('an expression', () => {
  test.each([
    ['17 in', 431.8],
    ['12 in', 304.8],
    ['1.1 in', 27.94],
    ['0.4 m', 400],
    ['0.67183 m', 671.83],
    ['40cm', 400],
    ['12"', 304.8],
    ['400 mm + 0.5 in', 412.7],
    ['1/2 in', 12.7],
    ['2*3 cm', 60],
    ['6 m/2', 3000],
    ['sqrt(2)*100', Math.SQRT2 * 100],
    ['100√2', Math.SQRT2 * 100],
    ['√(3^2 + 4²)', 5],
    ['sqrt((30 mm)^2 + (4 cm)^2)', 50],
    ['0.1 + 0.2', 0.3],
    ['3 × 0.1', 0.3],
    ['200 mm * cos(60 deg)', 100],
    ['200*sin(30)', 100],
    ['100 tan(45°)', 100],
    ['-2^2', -4],
    ['2^3^2', 512],
    ['2^-1', 0.5],
    ['−(5 − 7)·4', 8],
    ['1e2*2', 200],
    ['pi*100', Math.PI * 100],
    ['2(3+4)', 14],
  ])('%s is a length of %d mm', (text, value) => expect(length(text)).toBe(value));

  test.each([
    ['90 deg', 90],
    ['90°', 90],
    ['pi/2 rad', 90],
    ['-π/4 rad', -45],
    ['(pi/2 + pi/4) rad', 135],
    ['asin(0.5)', 30],
    ['atan(1) + 15 deg', 60],
    ['acos(-1/2)', 120],
    ['180/4', 45],
    ['atan(30 mm/(3 cm))', 45],
  ])('%s is an angle of %d°', (text, value) => expect(angle(text)).toBe(value));

  test.each([
    ['pi/2', Math.PI / 2],
    ['-π/4', -Math.PI / 4],
    ['2pi', 2 * Math.PI],
    ['3π/4', (3 * Math.PI) / 4],
    ['90 deg', Math.PI / 2],
    ['-67.5°', -3 * (Math.PI / 8)],
    ['PI', Math.PI],
  ])('%s is an angle of %d rad', (text, value) => expect(angle(text, M_RAD)).toBe(value));

  test('takes the sine of what has no unit in the unit of the document, and says so', () => {
    expect(evaluate('sin(30)', 'length', MM_DEG).found).toMatchObject({ value: 0.5, hasBareTurns: true });
    expect(evaluate('sin(pi/6)', 'length', M_RAD).found).toMatchObject({ value: 0.5, hasBareTurns: true });
    expect(evaluate('sin(30 deg)', 'length', M_RAD).found).toMatchObject({ value: 0.5, hasBareTurns: false });
    expect(lengthReason('sin(pi/6)')).toContain('Degrees or radians?');
  });

  test.each([
    ['2 m', 'This is a length'],
    ['30 deg + 2 m', 'Only lengths and lengths'],
    ['30 deg + 2', 'One part has a unit'],
    ['2 m*3 rad', 'belongs to the whole product'],
    ['(2 m)*(3 rad)', 'The units of this make no angle'],
    ['rad', 'stands behind a number'],
    ['2*rad*rad', 'belongs to the whole product'],
    ['2 deg^2', 'A power of “deg”'],
    ['sin(2 mm)', 'not of a length'],
    ['asin(2)', 'asin(2) is no real number'],
    ['asin(30 deg)', 'without a unit'],
    ['tan(90)', 'tan(90°) is no real number'],
    ['sqrt(-1)', 'no real number'],
    ['(-8)^(1/3)', 'no real number'],
    ['1/0', 'divides by zero'],
    ['0^-1', 'divides by zero'],
    ['2^(3 deg)', 'exponent'],
    ['9^9^9', 'too large'],
    ['1e9*2', 'too large'],
    ['1/2pi', 'two ways'],
    ['1/(2) (3)', 'two ways'],
    ['2 3', 'a sign is missing'],
    ['12 in 3', 'a sign is missing'],
    ['2 mm cm', 'two units'],
    ['sin 30', 'needs brackets'],
    ['√', 'After √'],
    ['√-2', 'After √'],
    ['2 +', 'Something is missing'],
    ['()', 'Something is missing'],
    ['(2', 'bracket'],
    ['2)', 'bracket'],
    ['1,5*2', 'with a point: 1.5*2'],
    ['1.000,5', 'A comma means nothing here'],
    ['1,234,567', 'A comma means nothing here'],
    ['atan2(1,1)', 'A comma means nothing here'],
    ['e', '“e” is not known'],
    ['0x10', '“x” is not known'],
    ['1'.repeat(200), 'longer than'],
    ['('.repeat(30) + '1' + ')'.repeat(30), 'too deep'],
  ])('%s is no angle, and the reason is told', (text, reason) => expect(angleReason(text)).toContain(reason));

  test('of an angle is no length', () => {
    expect(lengthReason('90 deg')).toBe('This is an angle; a length is needed, in mm, cm, m or in.');
    expect(lengthReason('2 m * 3 m')).toContain('belongs to the whole product');
    expect(lengthReason('(2 m)*(3 m)')).toContain('make no length');
  });
});

describe('the answer of a field', () => {
  const measure = { quantity: /** @type {const} */ ('angle'), units: MM_DEG };

  test('to π among degrees is a question with two ways out, each of which is an answer', () => {
    const asked = answerExpression('-pi/2', measure);
    expect(asked).toMatchObject({ value: null, isQuestion: true });
    const { ways = [] } = /** @type {import('../../../src/ui/parts/numberText.js').Refused} */ (asked);
    expect(ways.map(({ label }) => label)).toEqual(['-π/2 rad = −90°', '−1.5708°']);
    expect(answerExpression(ways[0].text, measure)).toEqual({ value: -90, reason: null, text: '-pi/2 rad' });
    expect(answerExpression(ways[1].text, measure)).toMatchObject({ value: -Math.PI / 2, text: '-pi/2 deg' });
    const sum = answerExpression('pi/2 + pi/4', measure);
    const { ways: waysOfSum = [] } = /** @type {import('../../../src/ui/parts/numberText.js').Refused} */ (sum);
    expect(answerExpression(waysOfSum[0].text, measure)).toMatchObject({ value: 135, text: '(pi/2 + pi/4) rad' });
  });

  test('to a letter that looks like a digit, or to a decimal comma, is the number that may be meant', () => {
    const ways = (/** @type {string} */ text) =>
      /** @type {{ ways?: unknown }} */ (answerExpression(text, measure)).ways;
    expect(ways('43l.8')).toEqual([{ label: 'Use 431.8', text: '431.8' }]);
    expect(ways('1O0')).toEqual([{ label: 'Use 100', text: '100' }]);
    expect(ways('12,5')).toEqual([{ label: 'Use 12.5', text: '12.5' }]);
    expect(ways('hello')).toEqual([]);
  });

  test('to a number too small to be kept is no zero, nor is one too large called none', async () => {
    await fetchExpressions();
    expect(readTyped('1e-400', measure).reason).toContain('smaller than any number');
    expect(readTyped('1e10', measure).reason).toBe('The number is too large; at most 1e9.');
    expect(readTyped('1e-5*2', measure).value).toBe(2e-5);
  });
});

test('a text that a change of units keeps comes to the changed number', () => {
  const typed = { a: '12 in', d: '(3 + 4)*1.1 cm', alpha: 'pi/2 rad', theta: '90°' };
  const others = { a: '12"', d: 'sqrt(2)*100 mm', alpha: '(pi/2 - pi/8) rad', theta: '-45 deg + 5°' };
  for (const text of [typed, others]) {
    const { joints } = LIBRARY.planar2r;
    const numbers = { a: length(text.a), d: length(text.d), alpha: angle(text.alpha), theta: angle(text.theta) };
    const first = /** @type {import('../../../src/model/document.js').JointDoc} */ ({ ...joints[0], ...numbers, text });
    const doc = newDocument({ ...LIBRARY.planar2r, units: MM_DEG, joints: [first, ...joints.slice(1)] });
    const [row] = convertUnits(doc, M_RAD).robot.joints;
    expect(row.text).toEqual(text);
    for (const field of DH_FIELDS) {
      const { found } = evaluate(text[field], quantityOf(row, field), M_RAD);
      expect(Math.abs((found?.value ?? NaN) / row[field] - 1)).toBeLessThan(1e-15);
    }
  }
  const sine = { a: 'sin(30)*2 m' };
  const doc = newDocument({
    ...LIBRARY.planar2r,
    joints: LIBRARY.planar2r.joints.map((joint) => ({ ...joint, text: sine })),
  });
  expect(convertUnits(doc, M_RAD).robot.joints[0].text).toBeUndefined();
});

/** @typedef {{ value: number, text: string, rank: number }} Printed  rank: 0 sum, 1 product, 2 sign, 3 power, 4 alone */

const wrap = (/** @type {Printed} */ { text, rank }, /** @type {number} */ least) =>
  rank < least ? `(${text})` : text;

/** What has no value has none to the power of nothing either; JavaScript makes it 1. @param {number} x @param {number} y */
const power = (x, y) => (Number.isNaN(x) ? NaN : x ** y);

/** @type {(operator: string, x: Printed, y: Printed) => Printed} */
function join(operator, x, y) {
  switch (operator) {
    case '+':
      return { value: x.value + y.value, text: `${wrap(x, 0)} + ${wrap(y, 1)}`, rank: 0 };
    case '-':
      return { value: x.value - y.value, text: `${wrap(x, 0)}-${wrap(y, 1)}`, rank: 0 };
    case '*':
      return { value: x.value * y.value, text: `${wrap(x, 1)}*${wrap(y, 2)}`, rank: 1 };
    case '/':
      return { value: x.value / y.value, text: `${wrap(x, 1)} / ${wrap(y, 2)}`, rank: 1 };
    default:
      return { value: power(x.value, y.value), text: `${wrap(x, 4)}^${wrap(y, 3)}`, rank: 3 };
  }
}

const leaf = fc.oneof(
  fc.integer({ min: 0, max: 99 }).map((value) => ({ value, text: String(value), rank: 4 })),
  fc.constantFrom(0.5, 2.25, 1e-3).map((value) => ({ value, text: String(value), rank: 4 })),
  fc.constantFrom('pi', 'π').map((text) => ({ value: Math.PI, text, rank: 4 })),
);
const { tree } = fc.letrec((/** @type {(name: string) => fc.Arbitrary<unknown>} */ tie) => ({
  tree: fc.oneof(
    { depthSize: 'small', withCrossShrink: true },
    leaf,
    fc
      .tuple(fc.constantFrom('+', '-', '*', '/', '^'), tie('tree'), tie('tree'))
      .map(([operator, x, y]) => join(operator, /** @type {Printed} */ (x), /** @type {Printed} */ (y))),
    tie('tree').map((/** @type {unknown} */ given) => {
      const x = /** @type {Printed} */ (given);
      return { value: -x.value, text: `-${wrap(x, 3)}`, rank: 2 };
    }),
    tie('tree').map((/** @type {unknown} */ given) => {
      const { value, text } = /** @type {Printed} */ (given);
      return value < 0
        ? { value: Math.abs(value), text: `abs(${text})`, rank: 4 }
        : { value: Math.sqrt(value), text: `√(${text})`, rank: 4 };
    }),
  ),
}));

describe('any', () => {
  test('arithmetic that is written down comes to its value, or is refused where it has none', () => {
    let evaluated = 0;
    fc.assert(
      fc.property(tree, (given) => {
        const { value, text } = /** @type {Printed} */ (given);
        const { found } = evaluate(text, 'length', MM_DEG);
        if (!Number.isFinite(value) || Math.abs(value) > 1e9) expect(found).toBeNull();
        else if (found) {
          evaluated++;
          expect(Math.abs(found.value - value)).toBeLessThanOrEqual(1e-15 * Math.abs(value));
        } else expect(evaluate(text, 'length', MM_DEG).reason).toMatch(/longer|deep|zero|large/);
      }),
      { numRuns: runs(1000), seed: SEED },
    );
    expect(evaluated).toBeGreaterThan(runs(1000) / 2);
  });

  test('text at all comes to a finite number or to a reason', () => {
    const word = fc.constantFrom(...'sin( cos( sqrt( ( ) + - * / ^ √ π pi 2 0.5 1e3 mm in deg ° rad , . '.split(' '));
    const anyText = fc.oneof(
      fc.string(),
      fc.string({ unit: 'binary' }),
      fc.array(word).map((words) => words.join('')),
    );
    fc.assert(
      fc.property(anyText, fc.constantFrom('length', 'angle'), (text, quantity) => {
        const { found, reason } = evaluate(text, /** @type {'length' | 'angle'} */ (quantity), MM_DEG);
        if (found) expect(Math.abs(found.value)).toBeLessThanOrEqual(1e9);
        else expect(reason).not.toBe('');
      }),
      { numRuns: runs(1000), seed: SEED },
    );
  });

  test('word or sign that is not on the list is refused, wherever it stands', () => {
    const outside = fc.constantFrom(
      ...[
        'import("x")',
        'a=1',
        'f(x)=x',
        '1;2',
        '[1,2]',
        '{a:1}',
        '"s"',
        "'s'",
        '1:3',
        'true',
        'null',
        'i',
        'Infinity',
        'NaN',
      ],
      ...[
        'cos.constructor',
        'sqrt.call',
        'constructor',
        '__proto__',
        'evaluate("1")',
        'parse("1")',
        'log(2)',
        'exp(1)',
      ],
      ...[
        '5!',
        '5%',
        '1==1',
        '1<2',
        '1?2:3',
        '2 and 3',
        '~2',
        '2|3',
        '2&3',
        '1 to 2',
        '0b1',
        'x',
        '#',
        '$',
        '@',
        '\\',
        '`1`',
      ],
      ...[
        'hypot(3;4)',
        'random()',
        'unit("1 m")',
        'km',
        'inch',
        'degree',
        'end',
        'ans',
        'phi',
        'tau',
        'sinh(1)',
        'ſin(1)',
      ],
    );
    const inside = fc.constantFrom('', '2*', '1 +', 'sqrt(', '(', '-', '2^');
    fc.assert(
      fc.property(inside, outside, fc.constantFrom('', ')', ' mm', '+1'), (before, text, after) => {
        expect(evaluate(before + text + after, 'length', MM_DEG).found).toBeNull();
      }),
      { numRuns: runs(2000), seed: SEED },
    );
  });
});
