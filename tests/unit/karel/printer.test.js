import fc from 'fast-check';
import { expect, test } from 'vitest';
import { printKarel } from '../../../src/karel/printer.js';
import { binary, call, integer, name, real, string, unary } from '../../../src/karel/tree.js';
import { runs, SEED } from '../../helpers/property.js';
import { wrong } from './wrong.js';

/** @import { Declaration, Program, Statement } from '../../../src/karel/tree.js' */

/** @param {Partial<Program>} parts @returns {Program} */
const program = (parts) => ({ kind: 'program', comments: [], name: 'demo', declarations: [], body: [], ...parts });
const body = (/** @type {Statement[]} */ ...statements) => program({ body: statements });
const declarations = (/** @type {Declaration[]} */ ...list) => program({ declarations: list });
const type = (/** @type {string} */ word) => ({ kind: /** @type {const} */ ('type'), name: word });
const INTEGER = type('INTEGER');

/** What stands between BEGIN and END. @param {Statement[]} statements */
const bodyText = (...statements) => /BEGIN\n([^]*)END demo\n$/.exec(printKarel(body(...statements)))?.[1];

test('a program with everything in it', () => {
  const text = printKarel(
    program({
      comments: [
        { kind: 'comment', text: 'What it does' },
        { kind: 'comment', text: '' },
      ],
      declarations: [
        { kind: 'directive', name: 'COMMENT', value: string("it's") },
        { kind: 'directive', name: 'STACKSIZE', value: { kind: 'integer', value: 1000 } },
        { kind: 'directive', name: 'NOPAUSE', value: { kind: 'words', words: ['ERROR', 'COMMAND'] } },
        { kind: 'directive', name: 'ENVIRONMENT', word: 'REGOPE' },
        { kind: 'directive', name: 'NOLOCKGROUP' },
        {
          kind: 'constants',
          entries: [
            { name: 'lowest', value: integer(-5) },
            { name: 'half', value: real(0.5) },
          ],
        },
        {
          kind: 'variables',
          entries: [
            { names: ['i', 'j'], type: INTEGER },
            { names: ['line'], type: { kind: 'string-type', length: 254 } },
            { names: ['grid'], type: { kind: 'array-type', sizes: [2, 3], of: type('REAL') } },
          ],
        },
        { kind: 'comment', text: 'elsewhere' },
        { kind: 'routine', name: 'mv', parameters: [], from: 'mv_prog' },
        {
          kind: 'routine',
          name: 'twice',
          parameters: [
            { names: ['x', 'y'], type: INTEGER },
            { names: ['s'], type: { kind: 'string-type' } },
          ],
          returns: INTEGER,
          declarations: [{ kind: 'variables', entries: [{ names: ['z'], type: INTEGER }] }],
          body: [{ kind: 'return', value: binary(name('x'), '*', integer(2)) }],
        },
      ],
      body: [
        { kind: 'comment', text: 'begin' },
        { kind: 'assign', target: name('i'), value: integer(7) },
        {
          kind: 'assign',
          target: { kind: 'index', target: name('grid'), indices: [integer(1), name('i')] },
          value: real(-1.5, 3),
        },
        {
          kind: 'if',
          condition: unary('NOT', binary(name('i'), '=', integer(1))),
          then: [
            { kind: 'if', condition: name('ok'), then: [{ kind: 'abort' }] },
            { kind: 'write', items: [string('i = '), name('i'), { kind: 'new-line' }] },
          ],
          else: [{ kind: 'write', file: 'TPERROR', items: [{ kind: 'new-line' }] }],
        },
        call('mv'),
        call('twice', [name('i')]),
        { kind: 'return' },
      ],
    }),
  );
  expect(text).toBe(`-- What it does
--
PROGRAM demo
%COMMENT = 'it''s'
%STACKSIZE = 1000
%NOPAUSE = ERROR + COMMAND
%ENVIRONMENT REGOPE
%NOLOCKGROUP

CONST
  lowest = -5
  half = 0.5

VAR
  i, j : INTEGER
  line : STRING[254]
  grid : ARRAY[2, 3] OF REAL

-- elsewhere
ROUTINE mv FROM mv_prog

ROUTINE twice(x, y : INTEGER; s : STRING) : INTEGER
VAR
  z : INTEGER
BEGIN
  RETURN(x * 2)
END twice

BEGIN
  -- begin
  i = 7
  grid[1, i] = -1.500
  IF NOT (i = 1) THEN
    IF ok THEN
      ABORT
    ENDIF
    WRITE('i = ', i, CR)
  ELSE
    WRITE TPERROR (CR)
  ENDIF
  mv
  twice(i)
  RETURN
END demo
`);
});

test('a line is broken with & only beyond 96 characters, between its parts', () => {
  const items = (/** @type {number} */ count) => Array.from({ length: count }, (_, i) => string(`part ${i}`));
  expect(bodyText(call('f', items(8)))?.split('\n')).toHaveLength(2);
  expect(bodyText(call('f', items(30)))).toBe(
    [
      "  f('part 0', 'part 1', 'part 2', 'part 3', 'part 4', 'part 5', 'part 6', 'part 7', 'part 8', &",
      "      'part 9', 'part 10', 'part 11', 'part 12', 'part 13', 'part 14', 'part 15', 'part 16', &",
      "      'part 17', 'part 18', 'part 19', 'part 20', 'part 21', 'part 22', 'part 23', 'part 24', &",
      "      'part 25', 'part 26', 'part 27', 'part 28', 'part 29')",
      '',
    ].join('\n'),
  );
});

test('a string that is longer than a line stays whole', () => {
  const long = 'x'.repeat(254);
  expect(bodyText({ kind: 'assign', target: name('s'), value: string(long) })).toBe(`  s = &\n      '${long}'\n`);
});

test('joining broken lines gives the line that was broken', () => {
  const anyText = fc.string({ unit: 'grapheme-ascii', maxLength: 60 });
  fc.assert(
    fc.property(fc.array(anyText, { minLength: 1, maxLength: 20 }), (texts) => {
      const joined = bodyText(call('f', texts.map(string)))?.replace(/ &\n {6}/g, ' ');
      expect(joined).toBe(`  f(${texts.map((text) => `'${text.replaceAll("'", "''")}'`).join(', ')})\n`);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('no text that is put in can begin a line of its own', () => {
  const anyText = fc.string({ unit: 'binary', maxLength: 20 });
  fc.assert(
    fc.property(anyText, (text) => {
      for (const tree of [
        body({ kind: 'comment', text }),
        body({ kind: 'assign', target: name('s'), value: string(text) }),
        declarations({ kind: 'directive', name: 'COMMENT', value: string(text) }),
      ]) {
        let printed;
        try {
          printed = printKarel(tree);
        } catch (error) {
          expect(error).toBeInstanceOf(RangeError);
          expect(text).toMatch(/[^\P{C}\t]|[\u2028\u2029]/u);
          continue;
        }
        // A carriage return, a vertical tab or a line separator would be a line end to somebody.
        expect(printed.split(/[\n\v\f\r\x85\u2028\u2029]/)).toHaveLength(6);
      }
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test.for(
  /** @type {[string, Program][]} */ ([
    ['a program named by a reserved word', program({ name: 'END' })],
    ['a program name with a line end', program({ name: 'a\nb' })],
    ['a comment of two lines', body({ kind: 'comment', text: 'x\nABORT' })],
    ['a comment with a carriage return', body({ kind: 'comment', text: 'x\rABORT' })],
    ['a comment with a line separator', body({ kind: 'comment', text: 'x\u2028ABORT' })],
    ['VAR without a variable', declarations({ kind: 'variables', entries: [] })],
    ['CONST without a constant', declarations({ kind: 'constants', entries: [] })],
    ['a type without a name', declarations({ kind: 'variables', entries: [{ names: [], type: INTEGER }] })],
    [
      'a variable named by a reserved word',
      declarations({ kind: 'variables', entries: [{ names: ['Then'], type: INTEGER }] }),
    ],
    [
      'a type named by a reserved word',
      declarations({ kind: 'variables', entries: [{ names: ['a'], type: type('THEN') }] }),
    ],
    [
      'a string of 255',
      declarations({ kind: 'variables', entries: [{ names: ['a'], type: { kind: 'string-type', length: 255 } }] }),
    ],
    [
      'a string of 0',
      declarations({ kind: 'variables', entries: [{ names: ['a'], type: { kind: 'string-type', length: 0 } }] }),
    ],
    [
      'an array of 0',
      declarations({
        kind: 'variables',
        entries: [{ names: ['a'], type: { kind: 'array-type', sizes: [0], of: INTEGER } }],
      }),
    ],
    [
      'an array of 2.5',
      declarations({
        kind: 'variables',
        entries: [{ names: ['a'], type: { kind: 'array-type', sizes: [2.5], of: INTEGER } }],
      }),
    ],
    [
      'an array of four dimensions',
      declarations({
        kind: 'variables',
        entries: [{ names: ['a'], type: { kind: 'array-type', sizes: [1, 1, 1, 1], of: INTEGER } }],
      }),
    ],
    ['a directive with two words', declarations({ kind: 'directive', name: 'ENVIRONMENT', word: 'a b' })],
    ['a directive with a line end', declarations({ kind: 'directive', name: 'A\nB' })],
    ['a routine with neither body nor program', declarations({ kind: 'routine', name: 'r', parameters: [] })],
    ['a routine with both', declarations({ kind: 'routine', name: 'r', parameters: [], from: 'p', body: [] })],
    ['WRITE of nothing', body({ kind: 'write', items: [] })],
    ['WRITE to a reserved word', body({ kind: 'write', file: 'BEGIN', items: [{ kind: 'new-line' }] })],
    ['assigning to a reserved word', body({ kind: 'assign', target: name('IF'), value: integer(1) })],
    ['calling a reserved word', body(call('STOP'))],
  ]),
)('%s has no text', ([, tree]) => expect(() => printKarel(tree)).toThrow(RangeError));

test.for(
  /** @type {[string, Program][]} */ ([
    ['statement', body(wrong({ kind: 'loop' }))],
    ['declaration', declarations(wrong({ kind: 'loop' }))],
    ['type', declarations({ kind: 'variables', entries: [{ names: ['a'], type: wrong({ kind: 'loop' }) }] })],
  ]),
)('an unknown %s is a TypeError', ([, tree]) => expect(() => printKarel(tree)).toThrow(TypeError));
