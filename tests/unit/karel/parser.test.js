import fc from 'fast-check';
import { expect, test } from 'vitest';
import { parseKarel } from '../../../src/karel/parser.js';
import { printKarel } from '../../../src/karel/printer.js';
import { writePair } from '../../../src/karel/write/pair.js';
import { runs, SEED } from '../../helpers/property.js';
import { wrong } from './wrong.js';
import { anyProgram, anyTokens, withoutSpans } from './anyKarel.js';

/** @import { Program } from '../../../src/karel/tree.js' */

const DEEP = runs(1) > 1;

const parsed = (/** @type {string} */ text) => withoutSpans(parseKarel(text).tree);
/** @param {string} statements */
const bodyOf = (statements) => /** @type {Program} */ (parsed(`PROGRAM p\nBEGIN\n${statements}\nEND p\n`)).body;
/** @param {string} text */
const faults = (text) =>
  parseKarel(text).diagnostics.map(({ message, span }) => `${span.line}:${span.column} ${message}`);
/** @param {string} statements the second line of the text is their first */
const bodyFaults = (statements) => faults(`PROGRAM p BEGIN\n${statements}\nEND p\n`);

test('what is printed is read back as its tree, without a word against it', () => {
  fc.assert(
    fc.property(anyProgram, (tree) => {
      const text = printKarel(tree);
      const { tree: again, diagnostics } = parseKarel(text);
      expect(diagnostics).toEqual([]);
      expect(withoutSpans(again)).toEqual(tree);
    }),
    { seed: SEED, numRuns: runs(20) },
  );
});

test('the parser survives any words and signs, and what it gives can be looked at', () => {
  fc.assert(
    fc.property(anyTokens, fc.boolean(), (tokens, inside) => {
      const text = inside ? `PROGRAM p\nBEGIN\n${tokens}\nEND p` : tokens;
      const { tree, diagnostics } = parseKarel(text);
      expect(['program', 'fragment']).toContain(tree.kind);
      for (const { span, message } of diagnostics) {
        expect(message).not.toBe('');
        expect(span.start).toBeGreaterThanOrEqual(0);
        expect(span.end).toBeLessThanOrEqual(text.length);
        expect(span.line).toBeGreaterThanOrEqual(1);
      }
    }),
    { seed: SEED, numRuns: DEEP ? 10_000 : 100 },
  );
});

test('the parser survives programs with a piece cut out, doubled or moved', () => {
  const change = fc.tuple(fc.nat(), fc.nat(60), fc.nat());
  fc.assert(
    fc.property(anyProgram, fc.array(change, { minLength: 1, maxLength: 4 }), (tree, changes) => {
      let text = printKarel(tree);
      for (const [from, length, to] of changes) {
        const start = from % (text.length + 1);
        const piece = text.slice(start, start + length);
        const rest = text.slice(0, start) + text.slice(start + length);
        const at = to % (rest.length + 1);
        text = rest.slice(0, at) + piece + (to % 3 ? piece : '') + rest.slice(at);
      }
      const { tree: read } = parseKarel(text);
      expect(['program', 'fragment']).toContain(read.kind);
    }),
    { seed: SEED, numRuns: DEEP ? 10_000 : 20 },
  );
});

test('the KAREL half of a FANUC pair is read back as its tree', () => {
  const target = {
    joints: [0, 45, -180, 0.125, 45, 0],
    position: [1, 2, 3, 4, 5, 6],
    fanuc: 'N U T, 0, 0, 0',
    kuka: null,
  };
  const manner = /** @type {const} */ ({ acceleration: 100, ending: { kind: 'fine' }, userFrame: 0, tool: 0, step: 0 });
  const move = /** @type {const} */ ({ kind: 'move', motion: 'joint', speed: { value: 20, unit: '%' }, ...manner });
  const [karel] = writePair({
    ...{
      name: 'pair',
      robotName: 'Arm',
      version: '1',
      generatedAt: '2026-07-01T12:00:00Z',
      convention: [],
      frames: [],
    },
    slides: Array(6).fill(false),
    steps: [
      { ...move, target: { ...target, isJoint: true } },
      { ...move, target: { ...target, isJoint: false } },
    ],
  }).files;
  const { tree, diagnostics } = parseKarel(karel.text);
  expect(diagnostics).toEqual([]);
  expect(printKarel(tree)).toBe(karel.text);
});

test('a deep nest of brackets is refused, not a crash', () => {
  const deep = `x = ${'('.repeat(20_000)}1${')'.repeat(20_000)}`;
  expect(bodyFaults(deep)[0]).toMatch(/levels of nesting/);
  expect(bodyFaults('IF a THEN '.repeat(20_000))[0]).toMatch(/levels of nesting|ENDIF/);
});

test('every node says where it stood', () => {
  const { tree } = parseKarel('PROGRAM p\nBEGIN\n  count = 7 DIV 2\nEND p\n');
  const [assign] = /** @type {Program} */ (tree).body;
  expect(assign.span).toEqual({ start: 18, end: 33, line: 3, column: 3 });
});

test.for([
  ['a comment may stand anywhere', 'f(1, -- why\n 1)', ''],
  ['a line goes on behind &', 'x = 1 + & -- why\n 2', ''],
  ['in brackets lines do not end', 'f(1,\n 2\n)', ''],
  ['behind an operator lines do not end', 'x = 1 +\n 2', ''],
  ['statements may share a line', 'a = 1; b = 2;; c = 3', ''],
  ['a label may have its statement behind it', 'here:: a = 1\nGO TO here', ''],
  ['THEN may stand in the next line', 'IF (a)\nTHEN\nENDIF', ''],
  ['an IF on one line', 'IF a THEN b = 1; ENDIF', ''],
  ['WITH and MOVE on two lines', 'WITH $SPEED = 200\nMOVE TO p', ''],
])('%s', ([, text, fault]) => {
  const found = bodyFaults(text);
  if (!fault) expect(found).toEqual([]);
  else expect(found.join()).toMatch(fault);
});

test.for([
  ['x = 1 = 2', { head: '=', left: 1, right: 2 }],
  ['x = -a * b', { sign: '-', of: '*' }],
  ['x = a - b - c', { head: '-', leftHead: '-' }],
])('%s', ([text, wanted]) => {
  const [statement] = bodyOf(/** @type {string} */ (text));
  const value = wrong(statement).value;
  const seen =
    value.kind === 'unary'
      ? { sign: value.operator, of: value.operand.operator }
      : value.left.kind === 'binary'
        ? { head: value.operator, leftHead: value.left.operator }
        : { head: value.operator, left: value.left.value, right: value.right.value };
  expect(seen).toEqual(wanted);
});

test.for([
  ['x = ', '3:1 Expected a value, got "END".'],
  ['x 1', '2:3 Expected ";" or a new line, got "1".'],
  ['IF a b = 1\nENDIF', '2:6 Expected "THEN", got "b".'],
  ['ENDIF', '2:1 Expected a statement, got "ENDIF", which ends nothing here.'],
  ['x = 1 y = 2', '2:7 Expected ";" or a new line, got "y".'],
  ["x = 'abc", "2:5 Expected ' at the end of the string, got the end of the line."],
  ['x = 2147483648', '2:5 Expected a whole number up to 2147483647, got 2147483648.'],
  ['f(1, 2', '3:1 Expected ")", got "END".'],
  ['a(1) = 2', '2:6 Expected a variable before "="; parentheses are for arguments, brackets for indices, got "=".'],
  ['FOR i = 1 UNTIL 3 DO\nENDFOR', '2:11 Expected TO or DOWNTO, got "UNTIL".'],
  ['then = 1', '2:1 Expected a variable, got "then".'],
  ['x = 1 ? 2', '2:7 Expected KAREL, got the character "?".'],
  ['x = 1 "', String.raw`2:7 Expected KAREL, got the character "\"". A text stands in single quotes: 'text'.`],
  ['x := 1', '2:3 Expected ";" or a new line, got ":". KAREL assigns with "=" alone.'],
  ['IF x == 1 THEN\nENDIF', '2:7 Expected a value, got "=". KAREL compares with one "=".'],
  ['x += 1', '2:3 Expected ";" or a new line, got "+". KAREL has it in full: i = i + 1.'],
  ['x = 1 // one', '2:8 Expected a value, got "/". A remark begins with two hyphens: --.'],
  [
    'IF x THEN\nELSEIF y THEN\nENDIF',
    '3:8 Expected ";" or a new line, got "y". There is no such word: behind ELSE stands an IF of its own, with its own ENDIF.',
  ],
  ['RETURN 1', '2:8 Expected ";" or a new line, got "1". A value stands in parentheses: RETURN(value).'],
  ['x = 7 % 2', '2:7 Expected KAREL, got the character "%". The rest of a division is MOD.'],
  [
    'WAIT FOR DIN[1] AND a = 1 OR b = 2',
    '2:27 Expected AND between all terms of a condition, got OR: AND and OR cannot be mixed.',
  ],
])('%s: %s', ([text, fault]) => expect(bodyFaults(text)).toContain(fault));

test('a fault in one statement leaves the others', () => {
  const { tree, diagnostics } = parseKarel('PROGRAM p\nBEGIN\n a = 1\n b = = 2\n c = 3\nEND p');
  expect(diagnostics).toHaveLength(1);
  expect(/** @type {Program} */ (tree).body).toHaveLength(2);
});

test('END must name what it ends', () => {
  expect(faults('PROGRAM a\nBEGIN\nEND b')).toEqual(['3:5 Expected "a" after END, got "b".']);
  expect(faults('PROGRAM a\nBEGIN\nEND')[0]).toMatch(/Expected "a" after END/);
});

test('the text of an included file is a fragment', () => {
  expect(parsed('CONST a = 1\nROUTINE r FROM other')).toMatchObject({
    kind: 'fragment',
    parts: [{ kind: 'constants' }, { kind: 'routine' }],
  });
  expect(parsed('x, y : INTEGER\nz IN CMOS : REAL')).toMatchObject({ parts: [{ kind: 'variables', bare: true }] });
  expect(parsed('t = STRUCTURE\n a : INTEGER\nENDSTRUCTURE')).toMatchObject({ parts: [{ kind: 'types', bare: true }] });
  expect(parsed('x = 1\nf(x)')).toMatchObject({ parts: [{ kind: 'assign' }, { kind: 'call' }] });
  expect(parsed('')).toEqual({ kind: 'fragment', parts: [] });
});

test('comments keep their place, and one behind a statement stays there', () => {
  const text =
    '-- head\nPROGRAM p\n\n-- of the routine\nROUTINE r FROM q\n\nBEGIN\n  -- first\n  a = 1  -- behind\nEND p\n';
  expect(printKarel(parseKarel(text).tree)).toBe(text);
});
