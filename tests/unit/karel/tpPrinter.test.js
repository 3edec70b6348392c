import fc from 'fast-check';
import { expect, test } from 'vitest';
import { printTp } from '../../../src/karel/tpPrinter.js';
import { runs, SEED } from '../../helpers/property.js';
import { wrong } from './wrong.js';

/** @import { TpLine, TpProgram } from '../../../src/karel/tpTree.js' */

const NOON = { year: 2026, month: 7, day: 1, hour: 12, minute: 5, second: 9 };

/** @param {Partial<TpProgram>} parts @returns {TpProgram} */
const program = (parts) => ({
  kind: 'tp-program',
  name: 'DEMO',
  comment: 'for a test',
  created: NOON,
  lines: [],
  ...parts,
});
const lines = (/** @type {TpLine[]} */ ...list) => program({ lines: list });

test('a program with everything in it', () => {
  const text = printTp(
    lines(
      { kind: 'remark', text: 'to the table' },
      { kind: 'user-frame', number: 0 },
      { kind: 'tool-frame', number: 3 },
      { kind: 'joint-move', register: 7, speedPercent: 100, termination: 'FINE' },
      { kind: 'joint-move', register: 8, speedPercent: 1, termination: 50 },
      { kind: 'joint-move', register: 9, speedPercent: 20, termination: 0 },
      { kind: 'call', program: 'OPEN_2' },
    ),
  );
  const tab = '\t';
  expect(text.split('\r\n')).toEqual([
    '/PROG  DEMO',
    '/ATTR',
    `OWNER${tab}${tab}= MNEDITOR;`,
    `COMMENT${tab}${tab}= "for a test";`,
    `PROG_SIZE${tab}= 0;`,
    `CREATE${tab}${tab}= DATE 26-07-01  TIME 12:05:09;`,
    `MODIFIED${tab}= DATE 26-07-01  TIME 12:05:09;`,
    `FILE_NAME${tab}= ;`,
    `VERSION${tab}${tab}= 0;`,
    `LINE_COUNT${tab}= 7;`,
    `MEMORY_SIZE${tab}= 0;`,
    `PROTECT${tab}${tab}= READ_WRITE;`,
    `TCD:  STACK_SIZE${tab}= 0,`,
    `      TASK_PRIORITY${tab}= 50,`,
    `      TIME_SLICE${tab}= 0,`,
    `      BUSY_LAMP_OFF${tab}= 0,`,
    `      ABORT_REQUEST${tab}= 0,`,
    `      PAUSE_REQUEST${tab}= 0;`,
    `DEFAULT_GROUP${tab}= 1,*,*,*,*;`,
    `CONTROL_CODE${tab}= 00000000 00000000;`,
    '/MN',
    '   1:  !to the table ;',
    '   2:  UFRAME_NUM=0 ;',
    '   3:  UTOOL_NUM=3 ;',
    '   4:J PR[7] 100% FINE    ;',
    '   5:J PR[8] 1% CNT50    ;',
    '   6:J PR[9] 20% CNT0    ;',
    '   7:  CALL OPEN_2    ;',
    '/POS',
    '/END',
    '',
  ]);
});

test('a program that moves nothing takes no motion group', () => {
  expect(printTp(lines({ kind: 'call', program: 'A' }))).toContain('DEFAULT_GROUP\t= *,*,*,*,*;');
});

test('lines are counted and numbered in four places', () => {
  const many = Array.from({ length: 1234 }, () => /** @type {const} */ ({ kind: 'remark', text: 'x' }));
  const text = printTp(lines(...many));
  expect(text).toContain('LINE_COUNT\t= 1234;\r\n');
  expect(text).toContain('\r\n   9:  !x ;\r\n  10:  !x ;\r\n');
  expect(text).toContain('\r\n1234:  !x ;\r\n/POS\r\n');
});

test('no text that is put in can begin a line of its own or end an instruction', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'binary', minLength: 1, maxLength: 16 }), (text) => {
      for (const tree of [lines({ kind: 'remark', text }), program({ comment: text }), program({ name: text })]) {
        let printed;
        try {
          printed = printTp(tree);
        } catch (error) {
          expect(error).toBeInstanceOf(RangeError);
          continue;
        }
        expect(printed).toMatch(/^[\t\r\n -~]*$/);
        expect(printed.split(/[\r\n]+/)).toHaveLength(24 + tree.lines.length);
        expect(printed.split(';')).toHaveLength(14 + tree.lines.length);
      }
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

const move = { kind: /** @type {const} */ ('joint-move'), register: 1, speedPercent: 20, termination: 'FINE' };
test.for(
  /** @type {[string, TpProgram][]} */ ([
    ['a remark of 33 characters', lines({ kind: 'remark', text: 'x'.repeat(33) })],
    ['an empty remark', lines({ kind: 'remark', text: '' })],
    ['a remark with a semicolon', lines({ kind: 'remark', text: 'a; b' })],
    ['a remark of two lines', lines({ kind: 'remark', text: 'a\n/END' })],
    ['a remark in other letters', lines({ kind: 'remark', text: 'Größe' })],
    ['a comment of 17 characters', program({ comment: 'x'.repeat(17) })],
    ['a comment with a quote', program({ comment: 'a"' })],
    ['a name in small letters', program({ name: 'demo' })],
    ['a name of 37 characters', program({ name: 'X'.repeat(37) })],
    ['no name', program({ name: '' })],
    ['a name with a line end', program({ name: 'A\n' })],
    ['a call of no name', lines({ kind: 'call', program: 'a b' })],
    ['register 0', lines(wrong({ ...move, register: 0 }))],
    ['register 10001', lines(wrong({ ...move, register: 10001 }))],
    ['register 1.5', lines(wrong({ ...move, register: 1.5 }))],
    ['0 % speed', lines(wrong({ ...move, speedPercent: 0 }))],
    ['101 % speed', lines(wrong({ ...move, speedPercent: 101 }))],
    ['20.5 % speed', lines(wrong({ ...move, speedPercent: 20.5 }))],
    ['CNT101', lines(wrong({ ...move, termination: 101 }))],
    ['CNT-1', lines(wrong({ ...move, termination: -1 }))],
    ['a termination of another kind', lines(wrong({ ...move, termination: 'CNT50 ;\n' }))],
    ['a frame below 0', lines({ kind: 'user-frame', number: -1 })],
    ['a frame that is no number', lines({ kind: 'tool-frame', number: NaN })],
    ['month 13', program({ created: { ...NOON, month: 13 } })],
    ['year 1999', program({ created: { ...NOON, year: 1999 } })],
    ['hour 24', program({ created: { ...NOON, hour: 24 } })],
    [
      '10000 lines',
      lines(...Array.from({ length: 10000 }, () => /** @type {const} */ ({ kind: 'remark', text: 'x' }))),
    ],
  ]),
)('%s has no listing', ([, tree]) => expect(() => printTp(tree)).toThrow(RangeError));

test('an unknown line is a TypeError', () => {
  expect(() => printTp(lines(wrong({ kind: 'jump' })))).toThrow(TypeError);
});
