/** The colours of controller code: nothing of a line is lost, and written listings have those of the editor. */
import { StringStream } from '@codemirror/language';
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { piecesOf, READERS } from '../../../src/ui/code/codeTokens.js';
import { runs, SEED } from '../../helpers/property.js';

const LANGUAGES = /** @type {const} */ (['karel', 'fanuc-tp', 'krl']);
const words = fc.constantFrom(
  ...['WITH', '$MOTYPE', 'INTEGER', 'SET_POS_REG', 'x_1', '1:', ':', '12.5e3', '3', '/PROG', 'J', 'P', '[', ']', '%'],
  ...[
    "'it''s",
    '"a b',
    '-- why',
    '! why',
    ';fold',
    '&ACCESS',
    'PTP',
    'E6POS',
    ' ',
    '  ',
    '\t',
    '=',
    '<=',
    'ä',
    '%NOPAUSE',
  ],
);
const lines = fc
  .array(fc.oneof({ weight: 4, arbitrary: words }, fc.string({ unit: 'binary', maxLength: 3 })))
  .map((all) => all.join(''));

test.each(LANGUAGES)('%s: the pieces of a line are the line, and those that the editor finds', (language) => {
  fc.assert(
    fc.property(lines, (line) => {
      const pieces = piecesOf(language, line);
      expect(pieces.map(({ text }) => text).join('')).toBe(line);
      expect(pieces.every(({ text }) => text !== '')).toBe(true);
      const stream = new StringStream(line, 4, 2);
      for (const { text, token } of pieces) {
        expect(READERS[language](stream)).toBe(token);
        expect(stream.current()).toBe(text);
        stream.start = stream.pos;
      }
    }),
    { numRuns: runs(300), seed: SEED },
  );
});

test('words, numbers, texts and remarks are what they are in their language', () => {
  const tokens = (/** @type {typeof LANGUAGES[number]} */ language, /** @type {string} */ line) =>
    piecesOf(language, line).flatMap(({ text, token }) =>
      token && token !== 'punctuation' ? [`${text} ${token}`] : [],
    );
  expect(tokens('karel', "  WRITE('x', PATH_LEN(p)) -- 1")).toEqual([
    ...['WRITE keyword', "'x' string", 'PATH_LEN variableName.standard', 'p variableName', '-- 1 comment'],
  ]);
  expect(tokens('fanuc-tp', '  12:J P[3] 50% CNT100 ;')).toEqual([
    ...['12: lineNumber', 'J keyword', 'P variableName.standard', '3 number', '50 number', 'CNT100 keyword'],
  ]);
  expect(tokens('krl', 'PTP {A1 -3.5} C_PTP ;x')).toEqual([
    ...['PTP keyword', 'A1 variableName', '3.5 number', 'C_PTP keyword', ';x comment'],
  ]);
});
