import { expect, test } from 'vitest';
import { parseKarel } from '../../../src/karel/parser.js';
import { printKarel } from '../../../src/karel/printer.js';

/** The statements that come of some lines, and what is said. @param {string} lines @param {Record<string, string>} [files] */
function expanded(lines, files) {
  const { tree, diagnostics } = parseKarel(`PROGRAM p\nBEGIN\n${lines}\nEND p\n`, { files });
  const body = /BEGIN\n([^]*)END p\n$/.exec(printKarel(tree))?.[1] ?? '';
  return {
    body: body
      .split('\n')
      .map((line) => line.trim())
      .filter(Boolean),
    told: diagnostics.map(({ message }) => message),
  };
}

test.for(
  /** @type {[string, string, string[]][]} */ ([
    ['a name', '%define N 5\nx = N', ['x = 5']],
    ['names inside names', '%define A B\n%define B 7\nx = A', ['x = 7']],
    ['a name that means itself', '%define A A\nx = A', ['x = A']],
    ['parameters', '%define add(a,b) (a + b)\nx = add(1, f(2, 3))', ['x = 1 + f(2, 3)']],
    ['no name in a string', "%define N 5\nx = 'N' + s -- N", ["x = 'N' + s  -- N"]],
    ['a name taken back', '%define N 5\n%undef N\nx = N', ['x = N']],
    ['what is defined', '%define D\n%ifdef D\nx = 1\n%else\nx = 2\n%endif', ['x = 1']],
    ['what is not defined', '%ifndef D\nx = 1\n%else\nx = 2\n%endif', ['x = 1']],
    ['one inside the other', '%ifdef D\n%ifdef E\nx = 1\n%else\nx = 2\n%endif\n%else\nx = 3\n%endif', ['x = 3']],
    ['a comparison', '%define N 5\n%if N > 4\nx = 1\n%endif\n%if N == 4\nx = 2\n%endif', ['x = 1']],
    ['equal words', '%define T TRUE\n%ifeq T TRUE\nx = 1\n%endif', ['x = 1']],
    ['evaluated at once', '%define A 1\n%defeval B A\n%undef A\nx = B', ['x = 1']],
    ['a body of several lines', '%define two(a) `a = 1\na = 2`\ntwo(x)', ['x = 1', 'x = 2']],
  ]),
)('%s', ([, lines, body]) => expect(expanded(lines)).toEqual({ body, told: [] }));

test('a file is included, its names hold afterwards, and a fault in it is told with its name', () => {
  const files = { 'lib/a.klh': '%define N 3\nx = 1\ny = = 2' };
  const { tree, diagnostics } = parseKarel('PROGRAM p\nBEGIN\n%include a.klh\nz = N\nEND p', { files });
  expect(printKarel(tree)).toContain('x = 1\n  z = 3');
  expect(diagnostics).toMatchObject([{ span: { line: 3, file: 'a.klh' } }]);
});

test('what is not known is refused by name, and left out', () => {
  const { body, told } = expanded("%class c('a.klc')\n%from x.klh %import y\n%include none.klh\nx = 1");
  expect(body).toEqual(['x = 1']);
  expect(told).toHaveLength(3);
  expect(told[0]).toMatch(/%class/);
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
