/**
 * Programs that nobody would write: whatever a text says, it is refused, or runs, or stops with an alarm that has a line and a reason.
 * Nothing else is thrown, and no number in the state is none.
 */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { BUILTINS } from '../../../src/karel/check/builtins.js';
import { checkKarel } from '../../../src/karel/checker.js';
import { createMachine, runMachine } from '../../../src/karel/interpreter.js';
import { parseKarel } from '../../../src/karel/parser.js';
import { runs, SEED } from '../../helpers/property.js';

/** @param {string} text @param {Record<string, string>} [files] @returns {string} how it ended, or what is against it */
function fate(text, files = {}) {
  const { tree, diagnostics, hasGaps } = parseKarel(text, { files });
  const all = [...diagnostics, ...checkKarel(tree, { files, hasGaps })];
  for (const { message, span } of all) expect(`${span.line} ${message}`).not.toMatch(/undefined|NaN|^0/);
  const error = all.find(({ severity }) => severity === 'error');
  const { machine, errors } = createMachine(tree, {
    ...{ steps: 9000, sources: files, input: ['1e999', 'text', '99999999999'], files: { 'A.DT': '12 x' } },
    kinematics: { toPosition: () => [1, 2, 3, 4, 5, 6, 0], toJoints: () => null },
  });
  if (error ?? errors.length) return (error ?? errors[0]).message;
  const run = runMachine(machine);
  let next = run.next();
  for (let i = 0; !next.done && i < 500; i++, next = run.next())
    if (next.value.kind === 'read') machine.state.input.push('5');
  const { globals, registers, positionRegisters, system, time } = machine.state;
  expect(JSON.stringify([globals, registers, positionRegisters, system, time], withoutNone)).not.toContain('no number');
  if (!next.done) return 'goes on';
  const { status, alarm } = next.value;
  if (alarm)
    expect(alarm).toMatchObject({
      reason: expect.stringMatching(/^(?!.*(undefined|NaN)).+/),
      line: expect.any(Number),
    });
  if (alarm) expect(alarm.line).toBeGreaterThan(0);
  return alarm?.reason ?? status;
}

const withoutNone = (/** @type {string} */ _, /** @type {unknown} */ value) =>
  typeof value === 'number' && !Number.isFinite(value) ? 'no number' : value;

const HEAD = `PROGRAM fz
TYPE
  rec = STRUCTURE
    n : INTEGER
    s : STRING[3]
    p : XYZWPR
  ENDSTRUCTURE
VAR
  i, u : INTEGER
  r : REAL
  b : BOOLEAN
  s : STRING[5]
  v : VECTOR
  p : XYZWPR
  jp : JOINTPOS
  c : CONFIG
  f : FILE
  ar : ARRAY[6] OF REAL
  st : rec
  pt : PATH NODEDATA = rec
BEGIN
  i = 3
  r = 3.0E38
  b = TRUE
  s = 'fz'
  p = POS(1, 2, 3, 4, 5, 6, p.config_data)
`;
/** By the letters of parameters. @type {Record<string, string[]>} */
const VALUES = {
  ...{ I: ['i', 'u', '0', '-1', '2147483647', 'st.n'], R: ['r', 'i', '0.0', '-3.0E38', 'ar[2]'], N: ['i', 'r'] },
  ...{
    S: ['s', "''", "'1.5E99'", "'*SYSTEM*'", 'st.s'],
    B: ['b', 'FALSE'],
    P: ['p', 'jp', 'st.p'],
    K: ['p'],
    J: ['jp'],
  },
  ...{
    V: ['v'],
    C: ['c', 'p.config_data'],
    A: ['ar'],
    L: ['ar'],
    H: ['pt'],
    F: ['f'],
    X: ['i', 's', 'p', 'st', 'pt', 'v'],
  },
};

test('built-ins take whatever has the type, set or not, and refuse the rest', () => {
  const oneOf = (/** @type {readonly string[]} */ list) => fc.constantFrom(...list);
  const argument = (/** @type {string} */ type) =>
    fc.oneof(
      { weight: 20, arbitrary: oneOf(VALUES[type]) },
      { weight: 1, arbitrary: oneOf(Object.values(VALUES).flat()) },
    );
  const calls = fc.constantFrom(...BUILTINS.values()).chain(({ name, parameters, gives }) =>
    fc.tuple(...parameters.map(({ type }) => argument(type))).map((args) => {
      const call = args.length ? `${name}(${args.join(', ')})` : name;
      return gives ? `u = ${call}` : call;
    }),
  );
  /** @type {string[]} */
  const fates = [];
  fc.assert(
    fc.property(calls, (call) => void fates.push(fate(`${HEAD}  ${call}\n  WRITE(u, CR)\nEND fz\n`))),
    { seed: SEED, numRuns: runs(60) },
  );
  expect(fates.filter((one) => one === 'ended').length).toBeGreaterThan(fates.length / 50);
  expect(fates.filter((one) => one.startsWith('Expected')).length).toBeGreaterThan(fates.length / 10);
});

/** @param {string} body @param {string} [declarations] */
const program = (body, declarations = '') => `PROGRAM p\n${declarations}\nBEGIN\n${body}\nEND p\n`;
const TWICE = Array.from({ length: 30 }, (_, i) => `t${i + 1} = STRUCTURE\na, b : t${i}\nENDSTRUCTURE`).join('\n');

/** @type {[string, string, string][]} */
const HOSTILE = [
  ['x = y\n'.repeat(300), '', 'not declared'],
  [`i = ${'('.repeat(5000)}`, 'VAR i : INTEGER', '120 levels'],
  [`i = a${'[1]'.repeat(3000)}`, 'VAR i : INTEGER', '50 indices'],
  [`i = ${'9'.repeat(9999)}`, 'VAR i : INTEGER', 'up to 2147483647'],
  ['', `TYPE t0 = STRUCTURE\na : REAL\nENDSTRUCTURE\n${TWICE}\nVAR v : t30`, 'values together'],
  ['i = EXP()', 'VAR i : INTEGER', 'by its name alone'],
  ["WRITE(f('a'), CR)", 'ROUTINE f(s : STRING) : STRING\nBEGIN\nRETURN(f(s + s))\nEND f', 'too deeply'],
  ['i = f', 'VAR i : INTEGER\nROUTINE f : INTEGER\nBEGIN\ni = 1\nEND f', 'without RETURN'],
  ["WRITE('a'::2147483647, CR)", '', 'ended'],
  ['DELAY 3.0E38', '', 'goes on'],
  [
    'i = 1\nREPEAT\ni = i + 1\nCONNECT TIMER TO a[i]\nUNTIL FALSE',
    'VAR i : INTEGER\na : ARRAY[2000] OF INTEGER',
    '1000 timers',
  ],
  ['i = 1\nWHILE TRUE DO\ni = i * 7\nPULSE DOUT[1] FOR i NOWAIT\nENDWHILE', 'VAR i : INTEGER', 'budget'],
  ['READ(i)', 'VAR i : INTEGER', 'fit into an INTEGER'],
  ['PEND_SEMA(1, 2, 1 = 1)', '', 'ended'],
  ['CONDITION[1]:\nWHEN ABORT DO\nABORT\nENDCONDITION\nENABLE CONDITION[1]\nABORT', '', 'aborted'],
  [
    'CONDITION[1]:\nWHEN EVENT[1] DO\nENABLE CONDITION[1]\nSIGNAL EVENT[1]\nENDCONDITION\nENABLE CONDITION[1]\nSIGNAL EVENT[1]',
    '',
    'too deeply',
  ],
];

test.for(HOSTILE.map(([body, declarations, expected]) => /** @type {const} */ ([expected, body, declarations])))(
  '… %s',
  ([expected, body, declarations]) => {
    expect(fate(program(body, declarations))).toContain(expected);
  },
);

test('files that include themselves again and again come to an end', () => {
  expect(fate(program('', '%INCLUDE a'), { 'a.kl': '%INCLUDE a\n'.repeat(3) })).toBe('ended');
  expect(fate(`%include a.klh\n${program('')}`, { 'a.klh': '%include a.klh\n'.repeat(3) })).toContain('400000');
});
