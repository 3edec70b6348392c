import { expect, test } from 'vitest';
import { checkKarel } from '../../../src/karel/checker.js';
import { parseKarel } from '../../../src/karel/parser.js';

/** What is said of a routine's variables, as `name line`. @param {string} body @param {string} [directive] */
function told(body, directive = '') {
  const text = `PROGRAM p
${directive}
VAR g : INTEGER
ROUTINE give(n : INTEGER)
BEGIN
  n = 1
END give
ROUTINE r(p : INTEGER) : INTEGER
VAR a, b, c : INTEGER; v : VECTOR; t : ARRAY[3] OF REAL; f : FILE; way : PATH
BEGIN
${body}
  RETURN(p + g)
END r
BEGIN
END p`;
  const { tree, diagnostics } = parseKarel(text);
  expect(diagnostics).toEqual([]);
  return checkKarel(tree).flatMap(({ code, severity, message, span }) => {
    if (code !== 'uninitialised' || !message.includes('before')) return [];
    expect(severity).toBe('warning');
    return [`${/"(\w+)"/.exec(message)?.[1]} ${span.line - 10}`];
  });
}

test.for(
  /** @type {[string, string, string[]][]} */ ([
    ['before it is set', 'b = a\na = 1', ['a 1']],
    ['in its own assignment', 'a = a + 1', ['a 1']],
    ['kept by the controller', "CALL_PROG('q', a)", []],
    ['told once', 'b = a\nc = a\na = 1', ['a 1']],
    ['set on one way', 'IF p > 1 THEN\na = 1\nENDIF\nb = a', []],
    ['set on the other way', 'IF p > 1 THEN\nb = a\nELSE\na = 1\nENDIF', ['a 2']],
    ['set on the way that returns', 'IF p > 1 THEN\na = 1\nRETURN(1)\nENDIF\nb = a', ['a 5']],
    ['set in one case', 'SELECT p OF\nCASE(1):\na = 1\nELSE:\nENDSELECT\nb = a', []],
    ['asked for before the loop that sets it', 'WHILE a < 3 DO\na = 5\nENDWHILE', ['a 1']],
    ['set in an earlier round', 'WHILE p < 3 DO\nIF p = 2 THEN\nb = a\nENDIF\na = 1\nENDWHILE', []],
    ['set in an earlier round of FOR', 'FOR b = 1 TO 3 DO\nIF b = 2 THEN\nc = a\nENDIF\na = 1\nENDFOR', []],
    ['set in the loop that asks behind', 'REPEAT\na = 1\nUNTIL a > 0', []],
    ['set in a loop', 'FOR b = 1 TO 3 DO\na = b\nENDFOR\nc = a', []],
    ['a bound of its own loop', 'FOR a = 1 TO a DO\nENDFOR', ['a 1']],
    [
      'set before a jump back',
      'IF p = 1 THEN\nGOTO ahead\nENDIF\nb = 1\nback::\nc = a\nahead::\na = 1\nIF p > 2 THEN\nGOTO back\nENDIF',
      [],
    ],
    ['behind a jump', 'GOTO on\nb = a\non::\na = 1', []],
    ['given to a routine', 'give(a)\nb = a', []],
    ['given as a copy', 'give((a))\na = 1', ['a 1']],
    ['set by a built-in', "CNV_STR_INT('1', a)\nb = a", []],
    ['given to a built-in', 'b = ABS(a)\na = 1', ['a 1']],
    ['asked whether it is set', 'IF UNINIT(a) THEN\na = 1\nENDIF\nb = a', []],
    ['read from a file', 'READ (a)\nb = a', []],
    ['written', 'WRITE (a)\na = 1', ['a 1']],
    ['a part set, another read', 'v.x = 1\nv.y = v.z', []],
    ['a part read', 'v.x = v.y', ['v 1']],
    ['an element read', 't[1] = t[2]', ['t 1']],
    ['an index', 't[a] = 1\na = 1', ['a 1']],
    ['the length of an array', 'a = ARRAY_LEN(t)\nt[1] = a', []],
    ['a path and a file', "a = PATH_LEN(way)\nOPEN FILE f ('RW', 'a')\nb = IO_STATUS(f)", []],
    ['a parameter and a global', 'a = p + g\ng = 1\np = 1', []],
    ['set by an action', 'CONDITION[1]: WHEN DIN[1] DO a = 1\nENDCONDITION\nb = a', []],
    ['a timer', 'CONNECT TIMER TO a\nb = a', []],
  ]),
)('%s', ([, body, expected]) => expect(told(body)).toEqual(expected));

test('%UNINITVARS says that variables may be so', () => {
  expect(told('b = a\na = 1', '%UNINITVARS')).toEqual([]);
});
