import { expect, test } from 'vitest';
import { checkKarel } from '../../../src/karel/checker.js';
import { runKarel } from '../../../src/karel/interpreter.js';
import { parseKarel } from '../../../src/karel/parser.js';
import { printKarel } from '../../../src/karel/printer.js';

/** The statements that come of some lines, and what is said. @param {string} lines @param {Record<string, string>} [files] */
function expanded(lines, files) {
  const { tree, diagnostics, hasGaps } = parseKarel(`PROGRAM p\nBEGIN\n${lines}\nEND p\n`, { files });
  const body = /BEGIN\n([^]*)END p\n$/.exec(printKarel(tree))?.[1] ?? '';
  return {
    body: body
      .split('\n')
      .map((line) => line.trim())
      .filter(Boolean),
    told: diagnostics.map(({ message }) => message),
    hasGaps,
  };
}

test.for(
  /** @type {[string, string, string[]][]} */ ([
    ['a name', '%define N 5\nx = N', ['x = 5']],
    ['names inside names', '%define A B\n%define B 7\nx = A', ['x = 7']],
    ['a name that means itself', '%define A A\nx = A', ['x = A']],
    ['parameters', '%define add(a,b) (a + b)\nx = add(1, f(2, 3))', ['x = 1 + f(2, 3)']],
    ['in strings and comments too', "%define N 5\nx = 'N' + s -- N", ["x = '5' + s  -- 5"]],
    ['no part of a name', '%define N 5\nx = Nn + n + N_1', ['x = Nn + n + N_1']],
    ['arguments by number', '%define both #1 + #2\nx = both(1, 2)', ['x = 1 + 2']],
    [
      'a name for a routine hands its arguments on',
      '%define long__name brief\nlong__name(1, f(2))',
      ['brief(1, f(2))'],
    ],
    ['pasting by a macro that gives its argument', '%define IS(a) a\n%define N A\nIS(N)_b = 1', ['A_b = 1']],
    ['a name without its parentheses', '%define f(a) a\nx = f 1', ['x = 1']],
    ['a calculation', '%define N 3\n%define M %eval N*(2+4)\nx = M', ['x = 18']],
    [
      'one of several conditions',
      '%define N 2\n%if N == 1\nx = 1\n%elif N == 2\nx = 2\n%else\nx = 3\n%endif',
      ['x = 2'],
    ],
    ['whether a name is defined', '%define D 0\n%if defined(D) && !defined(E)\nx = 1\n%endif', ['x = 1']],
    ['different words', '%define T FALSE\n%ifneq (T) (TRUE)\nx = 1\n%endif', ['x = 1']],
    ['a comment behind %endif', '%ifndef D\nx = 1\n%endif -- D', ['x = 1']],
    ['what is skipped defines nothing', '%ifdef D\n%define N 1\n%endif\nx = N', ['x = N']],
    [
      'a condition that a macro writes',
      '%mode quote "$"\n%defeval begin $%ifdef N$ \n%mode quote\nbegin\nx = 1\n%endif',
      [],
    ],
    ['quoted for now', '%mode quote "$"\n%define A 1\n%defeval B $A + A\n%undef A\n%mode quote\nx = B', ['x = A + 1']],
    ['modes end with their stack', '%mode push\n%mode string QQQ "`" "`"\n%mode pop\n%define a `1\nx = a', ['x = 1']],
    ['directives that macros write', '%define w(a) `%define a 7`\nw(N)\nx = N', ['x = 7']],
    [
      'a body in the mode of its definition',
      '%mode push\n%mode quote "$"\n%define A 1\n%define B $A\n%mode pop\nx = B + A',
      ['x = A + 1'],
    ],
    ['a name taken back', '%define N 5\n%undef N\nx = N', ['x = N']],
    ['what is defined', '%define D\n%ifdef D\nx = 1\n%else\nx = 2\n%endif', ['x = 1']],
    ['what is not defined', '%ifndef D\nx = 1\n%else\nx = 2\n%endif', ['x = 1']],
    ['one inside the other', '%ifdef D\n%ifdef E\nx = 1\n%else\nx = 2\n%endif\n%else\nx = 3\n%endif', ['x = 3']],
    ['a comparison', '%define N 5\n%if N > 4\nx = 1\n%endif\n%if N == 4\nx = 2\n%endif', ['x = 1']],
    ['equal words', '%define T TRUE\n%ifeq T TRUE\nx = 1\n%endif', ['x = 1']],
    ['evaluated at once', '%define A 1\n%defeval B A\n%undef A\nx = B', ['x = 1']],
    ['a body of several lines', '%mode string QQQ "`" "`"\n%define two(a) `a = 1\na = 2`\ntwo(x)', ['x = 1', 'x = 2']],
  ]),
)('%s', ([, lines, body]) => expect(expanded(lines)).toEqual({ body, told: [], hasGaps: false }));

test('a file is included, its names hold afterwards, and a fault in it is told with its name', () => {
  const files = { 'lib/a.klh': '%define N 3\nx = 1\ny = = 2' };
  const { tree, diagnostics } = parseKarel('PROGRAM p\nBEGIN\n%include a.klh\nz = N\nEND p', { files });
  expect(printKarel(tree)).toContain('x = 1\n  z = 3');
  expect(diagnostics).toMatchObject([{ span: { line: 3, file: 'a.klh' } }]);
});

test.for(['inc/a.h', String.raw`inc\a.h`, 'INC/A.H', 'a.h', 'inc/a.h.kl'])(
  'of "%s" the end .kl may be left out',
  (name) => {
    const text = `PROGRAM p\n%INCLUDE ${name}\nBEGIN\nWRITE(n, CR)\nEND p`;
    const told = (/** @type {Record<string, string>} */ files) => {
      const { tree, diagnostics, hasGaps } = parseKarel(text, { files });
      return [...diagnostics, ...checkKarel(tree, { files, hasGaps })].map(({ code }) => code);
    };
    expect(told({ 'src/inc/a.h.kl': 'CONST n = 1' })).toEqual([]);
    expect(told({ 'src/ba.h.kl': 'CONST n = 1' })).not.toEqual([]);
  },
);

test.for(
  /** @type {[string, RegExp][]} */ ([
    ["%class c('a.klc','a.klh')", /%class c of "a.klc"/],
    ['%class c', /Expected %class name/],
    ['%from x.klh %import y', /%from "x.klh"/],
    ['%include none.klh', /%include of "none.klh"/],
    ['%exec ls', /%exec of the preprocessor is not expanded/],
    ['%mode meta user', /%mode meta of/],
    ['%mode string sss "a" "b"', /%mode string sss/],
  ]),
)('%s is refused by name, and left out; something is missing', ([line, message]) => {
  const { body, told, hasGaps } = expanded(`${line}\nx = 1`);
  expect(body).toEqual(['x = 1']);
  expect(told).toEqual([expect.stringMatching(message)]);
  expect(hasGaps).toBe(true);
});

test('%error is an error at its place, %warning a warning, and what is skipped says nothing', () => {
  const { diagnostics } = parseKarel(
    'PROGRAM p\n%ifdef D\n%error no\n%endif\n%error this\n%warning that\nBEGIN\nEND p',
  );
  expect(diagnostics).toMatchObject([
    { severity: 'error', message: '%error: this', span: { line: 5, column: 1 } },
    { severity: 'warning', message: '%warning: that', span: { line: 6 } },
  ]);
});

test('of a header only what is wanted is taken, with its further lines', () => {
  const files = {
    'namespace.m': '%define declare(a,b) `%define a b`\n',
    'lib/tools.klh': [
      'declare(tools__close_to, close_to)',
      'ROUTINE tools__close_to(a : REAL; &',
      '  b : REAL) : BOOLEAN FROM tools',
      'ROUTINE tools__apart(a : REAL) : BOOLEAN FROM tools',
    ].join('\n'),
  };
  const text = 'PROGRAM p\n%from tools.klh %import close_to\nVAR y : BOOLEAN\nBEGIN\ny = tools__close_to(1, 2)\nEND p';
  const { tree, diagnostics } = parseKarel(text, { files });
  expect(diagnostics).toEqual([]);
  expect(printKarel(tree)).toContain('ROUTINE close_to(a : REAL; b : REAL) : BOOLEAN FROM tools');
  expect(printKarel(tree)).toContain('y = close_to(1, 2)');
  expect(printKarel(tree)).not.toContain('apart');
});

/** A template of programs, its header, and what it is filled with. */
const STACK = {
  'stack.klc': [
    '%ifndef depth',
    '%define depth 2',
    '%endif',
    'PROGRAM class_name',
    'VAR held : ARRAY[depth] OF kept',
    '%include stack.klh',
    'ROUTINE class_name_put',
    'BEGIN',
    '  held[1] = value',
    '  held[2] = = value',
    'END class_name_put',
    'BEGIN',
    'END class_name',
  ].join('\n'),
  'stack.klh': '%define put class_name_put\nROUTINE put(value : kept) FROM class_name',
  'reals.klt': '%define kept REAL\n%define depth 3',
};

test('%class makes a program of a template, and tells the others what they need to know', () => {
  const files = { ...STACK, 'stack.klc': STACK['stack.klc'].replace('= = value', '= value') };
  const text = "PROGRAM p\n%class reals('stack.klc','stack.klh','reals.klt')\nBEGIN\nput(1.5)\nEND p";
  const { tree, programs, diagnostics, hasGaps } = parseKarel(text, { files });
  expect([diagnostics, hasGaps]).toEqual([[], false]);
  expect(programs.map(({ name }) => name)).toEqual(['reals']);
  expect(printKarel(programs[0])).toContain('held : ARRAY[3] OF REAL');
  for (const program of [tree, ...programs]) expect(checkKarel(program)).toEqual([]);
  const run = runKarel(tree, { programs: { reals: programs[0] } });
  const outcome = /** @type {{ value: { status: string, state: { globals: unknown[][] } } }} */ (run.next()).value;
  expect(outcome.status).toBe('ended');
  expect(outcome.state.globals.flat(2)).toContain(1.5);
});

test('a fault in a template is shown in its file, however often it is used', () => {
  const text =
    "PROGRAM p\n%class a('stack.klc','stack.klh','reals.klt')\n%class b('stack.klc','stack.klh','reals.klt')\nBEGIN\nEND p";
  const { programs, diagnostics } = parseKarel(text, { files: STACK });
  expect(programs.map(({ name }) => name)).toEqual(['a', 'b']);
  const at = { file: 'stack.klc', line: 10, column: 13 };
  expect(diagnostics.map(({ span }) => span)).toEqual([expect.objectContaining(at), expect.objectContaining(at)]);
});

test('a template may use another, which is made once', () => {
  const files = {
    ...STACK,
    'stack.klc': STACK['stack.klc'].replace('= = value', '= value'),
    'pair.klc': "PROGRAM class_name\n%class inner('stack.klc','stack.klh','reals.klt')\nBEGIN\nput(1)\nEND class_name",
    'pair.klh': '',
  };
  const text = "PROGRAM p\n%class one('pair.klc','pair.klh')\n%class two('pair.klc','pair.klh')\nBEGIN\nEND p";
  const { programs, diagnostics } = parseKarel(text, { files });
  expect(diagnostics).toEqual([]);
  expect(programs.map(({ name }) => name).sort()).toEqual(['inner', 'one', 'two']);
});

test('line ends of every kind leave the places right', () => {
  const text = 'PROGRAM p\r\n%define N 1\r\nBEGIN\r\nx = N\r\ny = = 2\r\nEND p\r\n';
  const { diagnostics } = parseKarel(text);
  expect(diagnostics).toMatchObject([{ span: { line: 5, column: 5 } }]);
  expect(text.slice(diagnostics[0].span.start, diagnostics[0].span.end)).toBe('=');
});

test('an argument of a macro keeps its own place', () => {
  const { diagnostics } = parseKarel('PROGRAM p\n%define twice(a) 2 * a\nBEGIN\nx = twice(3 + = 4)\nEND p');
  expect(diagnostics[0].span).toMatchObject({ line: 4, column: 15 });
});

test('an unknown macro among declarations is a warning, and what follows is read', () => {
  const { diagnostics, tree } = parseKarel('PROGRAM p\n%define A 1\ndeclare(a,b)\nVAR x : INTEGER\nBEGIN\nEND p');
  expect(diagnostics).toMatchObject([{ severity: 'warning', code: 'unknown-macro', span: { line: 3, column: 1 } }]);
  expect(printKarel(tree)).toContain('x : INTEGER');
});

test('a fault behind a macro is shown in the text that was typed', () => {
  const { diagnostics } = parseKarel('PROGRAM p\n%define LONG 1 + 2 + 3\nBEGIN\nx = LONG ) \nEND p');
  expect(diagnostics[0].span).toMatchObject({ line: 4, column: 10 });
});

test('macros that call each other end', () => {
  const lines = Array.from({ length: 20 }, (_, i) => `%define m${i} m${i + 1} + m${i + 1}`).join('\n');
  expect(expanded(`${lines}\nx = m0`).body.length).toBeLessThan(100);
});
