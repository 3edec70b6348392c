/** Tables as people paste them: one robot written in each format, and what must not break the reading. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { MAX_TABLE_TEXT, readTableText } from '../../../src/io/tableText.js';
import { guessColumns } from '../../../src/io/tableTextColumns.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { applyCommand } from '../../../src/model/commands.js';
import { refusal } from '../../../src/model/refusals.js';
import { planPaste } from '../../../src/ui/robot/pasteTablePlan.js';
import { SEED, runs } from '../../helpers/property.js';

/** @typedef {import('../../../src/model/document.js').Units} Units */

const { puma560 } = LIBRARY;
const MM_DEG = /** @type {Units} */ ({ length: 'mm', angle: 'deg' });

const FORMATS = {
  spreadsheet:
    'Joint\tθ (deg)\td (mm)\ta (mm)\tα (deg)\n1\tq1\t300\t0\t90\n2\tq2 + 90\t0\t250,5\t0\n3\t0\td3*\t0\t-90\n',
  'columns in another order':
    'alpha [rad]\ta [mm]\ttheta\td [mm]\nπ/2\t0\tθ1*\t300\n0\t250.5\tθ2* + pi/2\t0\n-pi/2\t0\t0\td3*',
  'CSV with semicolons and decimal commas': 'theta;d;a;alpha\nq1;300;0;90\n90+q2;0;250,5;0\n0;q3;0;-90',
  'CSV with quotes':
    '"theta","d","a","alpha"\r\n"q1","300","0","90"\r\n"q2+90","0","250.5","0"\r\n"0","q3","0","-90"\r\n',
  Markdown:
    '| i | θ | d | a | α |\n|---|:-:|---|--:|---|\n| 1 | **θ1** | 300 | 0 | 90° |\n| 2 | θ2 + 90° | 0 | 250.5 | 0 |\n| 3 | 0 | d3 | 0 | −90° |',
  'LaTeX tabular': String.raw`\begin{table}\centering
    \begin{tabular}{c|cccc} \hline
    $i$ & $\theta_i$ & $d_i$ & $a_i$ & $\alpha_i$ \\ \hline % the head
    1 & $\theta_1^*$ & 300 & 0 & $90^\circ$ \\
    2 & $\theta_2^{*} + \frac{\pi}{2}\,\mathrm{rad}$ & 0 & 250.5 & $0$ \\
    3 & 0 & $d_3^*$ & 0 & $-90^{\circ}$ \\ \hline
    \end{tabular}\end{table}`,
  'LaTeX matrix': String.raw`\begin{bmatrix} q_1 & 300 & 0 & 90^\circ \\ q_2 + 90^\circ & 0 & 250.5 & 0 \\ 0 & q_3 & 0 & -90^\circ \end{bmatrix}`,
  box: '┌──────┬─────┬───────┬─────┐\n│  θⱼ  │ dⱼ  │  aⱼ   │ ⍺ⱼ  │\n├──────┼─────┼───────┼─────┤\n│  q1  │ 300 │ 0     │ 90° │\n│ q2 + 90° │ 0   │ 250.5 │ 0   │\n│ 0    │ q3  │ 0     │ -90° │\n└──────┴─────┴───────┴─────┘',
  blanks: 'q1     300  0      90\nq2+90  0    250.5  0\n0      q3   0      -90',
};

/** @param {string} text @param {import('../../../src/model/document.js').Convention} [convention] @param {number | null} [from] */
function plan(text, convention = 'standard', from = null) {
  const { table, fault } = readTableText(text);
  if (fault !== null) throw new Error(fault);
  const guess = guessColumns(table.rows, convention);
  const rows = guess.hasHead ? table.rows.slice(1) : table.rows;
  const units = { ...MM_DEG, ...guess.units };
  return { guess, ...planPaste(puma560, { rows, roles: guess.roles, units, others: guess.others, convention, from }) };
}

describe('a pasted table', () => {
  test.each(Object.entries(FORMATS))('of %s is read', (_, text) => {
    const { command, faults } = plan(text);
    expect(faults).toEqual([]);
    expect(command.rows.map(({ type }) => type)).toEqual(['revolute', 'revolute', 'prismatic']);
    expect(command.rows.map(({ numbers }) => numbers)).toEqual([
      { theta: 0, d: 300, a: 0, alpha: 90 },
      { theta: 90, d: 0, a: 250.5, alpha: 0 },
      { theta: 0, d: 0, a: 0, alpha: -90 },
    ]);
    const doc = newDocument(puma560);
    expect(refusal(doc, command)).toBeNull();
    const { robot } = applyCommand(doc, command);
    expect(robot.joints.map(({ type }) => type)).toEqual(['revolute', 'revolute', 'prismatic']);
    expect(robot.joints[1].a).toBe(250.5);
    expect(applyCommand(newDocument(robot), command).robot).toEqual(robot);
  });

  test('whose columns are those of Craig is taken as modified; an offset is added to what moves', () => {
    const { guess, command } = plan(
      '$\\alpha_{i-1}$ & $a_{i-1}$ & $d_i$ & $\\theta_i$ & offset \\\\ 0 & 0 & 5 & $\\theta_1$ & 90 \\\\ 90 & 0 & $d_2$ & 0 & 7',
    );
    expect(guess).toMatchObject({ isModified: true, roles: ['alpha', 'a', 'd', 'theta', 'offset'] });
    expect(command.rows[0]).toMatchObject({ type: 'revolute', numbers: { theta: 90, d: 5 } });
    expect(command.rows[1]).toMatchObject({ type: 'prismatic', numbers: { theta: 0, d: 7 } });
  });

  test('without names has the order of the convention, unless the variables are in the other order’s column', () => {
    expect(guessColumns([['0', '1', '2', '3']], 'standard').roles).toEqual(['theta', 'd', 'a', 'alpha']);
    expect(guessColumns([['0', '1', '2', '3']], 'modified').roles).toEqual(['alpha', 'a', 'd', 'theta']);
    expect(guessColumns([['0', '1', '2', 'θ1']], 'standard').roles).toEqual(['alpha', 'a', 'd', 'theta']);
    expect(
      guessColumns(
        [
          ['1', '0', '1', '2', '3'],
          ['2', '5', '5', '5', '5'],
        ],
        'standard',
      ).roles[0],
    ).toBe('none');
  });

  test('says of each cell that it cannot read why, and then does nothing', () => {
    const { faults } = plan('theta\td\ta\talpha\nq1\td1\tL1\t90\nq2\t0\t\t0\nq3 - 1\t0\t1..2\t-q3');
    expect(faults).toEqual([
      'J1, d: “d1” has a symbol without a number.',
      'J1, a: “L1” has a symbol without a number.',
      'J2, a: is empty; a number is needed.',
      expect.stringContaining('J3, a: “1..2”'),
      'J3, α: “-q3” has a symbol without a number.',
    ]);
    expect(plan('1\t2\t3\t4').faults).toEqual(['A robot has two to six joints; this has 1 row.']);
    expect(plan('-q1\t2\t3\t4\nq2\t1\t1\t1').faults[0]).toContain('takes the variable away');
  });

  test('in metres and radians becomes millimetres and degrees, exactly, and keeps expressions with their unit', () => {
    const { command, hasPi } = plan('theta\td (m)\ta (m)\talpha (rad)\nq1\t0.67183\t0.1+0.2\tpi/2\nq2\t0\t12 in\t0');
    expect(command.rows[0]).toEqual({
      ...{ type: 'revolute', numbers: { theta: 0, d: 671.83, a: 300, alpha: 90 } },
      texts: { a: '(0.1+0.2) m', alpha: 'pi/2 rad' },
    });
    expect(command.rows[1]).toMatchObject({ numbers: { a: 304.8 }, texts: { a: '12 in' } });
    expect(hasPi).toBe(false);
  });

  test('in inches, or with another unit in each column, is read as its head says, whatever words stand about the symbol', () => {
    const inches = 'Joint\tLink length a_i [in]\talpha_i in rad\tOffset, d (inch)\tθ_i (joint angle), deg\n';
    const { guess, command, faults } = plan(`${inches}1\t0\tpi/2\t10\tq1 + 45\n2\t3/2\t0\t-2 mm\tq2`);
    expect(faults).toEqual([]);
    expect(guess.roles).toEqual(['none', 'a', 'alpha', 'd', 'theta']);
    expect(guess.units.length).toBe('in');
    const [one, two] = command.rows;
    expect(one.numbers).toEqual({ theta: 45, d: 254, a: 0, alpha: 90 });
    expect(two.numbers).toEqual({ theta: 0, d: -2, a: 38.1, alpha: 0 });
    expect([one.texts?.d, two.texts?.a, two.texts?.d]).toEqual(['10 in', '(3/2) in', '-2 mm']);
    expect(plan('a (m)\td in mm\n1\t2\n3\t4').command.rows[0].numbers).toEqual({ a: 1000, d: 2 });
  });

  test('fills a block from a joint on, and leaves the other numbers as they are', () => {
    const given = {
      rows: [
        ['5', '6'],
        ['7', '8'],
      ],
      units: MM_DEG,
      convention: /** @type {const} */ ('standard'),
    };
    const roles = /** @type {const} */ (['d', 'a']);
    const { command, changes } = planPaste(puma560, { ...given, roles, from: 1 });
    const { joints } = applyCommand(newDocument(puma560), command).robot;
    expect(joints.map(({ d, a }) => [d, a]).slice(0, 4)).toEqual([
      [671.83, 0],
      [5, 6],
      [7, 8],
      [431.8, 0],
    ]);
    expect(joints.map(({ alpha, theta, lower }) => [alpha, theta, lower])).toEqual(
      puma560.joints.map(({ alpha, theta, lower }) => [alpha, theta, lower]),
    );
    expect(changes).toBe(4);
    expect(planPaste(puma560, { ...given, roles, from: 5 }).faults).toEqual([
      'From J6 on there is room for 1 row only.',
    ]);
  });
});

describe('hostile text', () => {
  test('that is too long, too wide or no table is refused', () => {
    expect(readTableText('1\t2\n'.repeat(MAX_TABLE_TEXT)).fault).toBe('too-long');
    expect(readTableText('1\t2\n'.repeat(100)).fault).toBe('too-many');
    expect(readTableText('1\t'.repeat(100)).fault).toBe('too-many');
    for (const text of ['', '   \n', '12', '|---|---|']) expect(readTableText(text).fault).toBe('no-table');
  });

  test('in 500 mutants of every format never makes the reading throw, and every plan without faults can be carried out', () => {
    const texts = Object.values(FORMATS);
    const piece = fc.oneof(
      fc.constantFrom(
        '\\frac{',
        '}',
        '{',
        '\\\\',
        '&',
        '\t',
        ';',
        ',',
        '|',
        '$',
        '^\\circ',
        '\\begin{tabular}{',
        '*',
        '√',
        '"',
        '(',
        'q1',
        '∞',
        '1e999',
      ),
      fc.string({ unit: 'binary', maxLength: 5 }),
    );
    const mutant = fc
      .tuple(
        fc.constantFrom(...texts),
        fc.array(fc.tuple(fc.nat(400), fc.nat(6), piece), { minLength: 1, maxLength: 5 }),
      )
      .map(([text, cuts]) =>
        cuts.reduce((now, [at, gone, put]) => now.slice(0, at) + put + now.slice(at + gone), text),
      );
    let carriedOut = 0;
    const doc = newDocument(puma560);
    fc.assert(
      fc.property(mutant, (text) => {
        if (readTableText(text).fault !== null) return;
        const { faults, command } = plan(text);
        if (faults.length) return;
        carriedOut++;
        expect(refusal(doc, command)).toBeNull();
        for (const { theta, d, a, alpha } of applyCommand(doc, command).robot.joints) {
          expect([theta, d, a, alpha].every(Number.isFinite)).toBe(true);
        }
      }),
      { numRuns: runs(500), seed: SEED },
    );
    expect(carriedOut).toBeGreaterThan(runs(50));
  });

  test('of the longest length is read at once', () => {
    for (const piece of ['\\frac{', '{', '\\begin{tabular}{', '$', '(', '"', '|', '\\\\', 'q', ' ', '[', '1 ']) {
      const text = piece.repeat(Math.floor(MAX_TABLE_TEXT / piece.length));
      expect(() => readTableText(text)).not.toThrow();
    }
  });
});
