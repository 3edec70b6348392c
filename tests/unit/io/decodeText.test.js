import { expect, test } from 'vitest';
import { decodeText } from '../../../src/io/decodeText.js';

const utf8 = (/** @type {string} */ text) => new TextEncoder().encode(text);
/** @param {string} text @param {boolean} littleEndian @param {boolean} withMark */
function utf16(text, littleEndian, withMark) {
  const marked = withMark ? `\uFEFF${text}` : text;
  const view = new DataView(new ArrayBuffer(2 * marked.length));
  for (let i = 0; i < marked.length; i++) view.setUint16(2 * i, marked.charCodeAt(i), littleEndian);
  return new Uint8Array(view.buffer);
}
const codes = (/** @type {{ issues: { code: string }[] }} */ { issues }) => issues.map(({ code }) => code);

test('UTF-8 is read, with a byte order mark or without', () => {
  expect(decodeText(utf8('<a>é😀</a>'))).toEqual({ text: '<a>é😀</a>', issues: [] });
  expect(decodeText(utf8('\uFEFF<a/>'))).toEqual({ text: '<a/>', issues: [] });
  expect(decodeText(utf8(''))).toEqual({ text: '', issues: [] });
});

test('UTF-16 is read in both byte orders, with a byte order mark or without, and said to be so', () => {
  for (const littleEndian of [true, false]) {
    for (const withMark of [true, false]) {
      const answer = decodeText(utf16('<a>é😀</a>', littleEndian, withMark));
      expect(answer.text).toBe('<a>é😀</a>');
      expect(codes(answer)).toEqual(['utf16']);
    }
  }
});

test('a declaration that says otherwise than the bytes is a warning', () => {
  for (const name of ['UTF-8', 'utf-8', 'utf8', 'US-ASCII']) {
    expect(decodeText(utf8(`<?xml version="1.0" encoding="${name}"?><a/>`)).issues).toEqual([]);
  }
  expect(decodeText(utf8("<?xml version='1.0' encoding = 'ISO-8859-1'?><a/>")).issues).toEqual([
    {
      severity: 'warning',
      code: 'encoding',
      path: '',
      line: 1,
      message: 'Line 1: the file says encoding="ISO-8859-1" but is UTF-8, as which it was read.',
    },
  ]);
  expect(codes(decodeText(utf16('<?xml version="1.0" encoding="UTF-16"?><a/>', true, true)))).toEqual(['utf16']);
  expect(codes(decodeText(utf16('<?xml version="1.0" encoding="UTF-8"?><a/>', true, true)))).toEqual([
    'utf16',
    'encoding',
  ]);
});

test('an encoding that only stands in a text is none', () => {
  expect(decodeText(utf8('<a encoding="latin1"/>')).issues).toEqual([]);
  expect(decodeText(utf8('<?xml version="1.0"?><a encoding="latin1"/>')).issues).toEqual([]);
});

test('bytes that are not UTF-8 are refused with their line', () => {
  const latin1 = Uint8Array.from(Array.from('<a>\n\n<b>é</b>\n</a>', (character) => character.charCodeAt(0)));
  expect(decodeText(latin1)).toEqual({
    text: null,
    issues: [
      {
        severity: 'error',
        code: 'not-text',
        path: '',
        line: 3,
        message: 'Line 3: the file has bytes here that are not UTF-8; expected it to be saved as UTF-8.',
      },
    ],
  });
});

test.for([
  [[0x89, 0x50, 0x4e, 0x47, 0x00], 'a picture'],
  [[0xff, 0xfe, 0x00], 'half a character of UTF-16'],
  [[0xff, 0xfe, 0x00, 0xd8, 0x41, 0x00], 'half a pair in UTF-16'],
  [[0xed, 0xa0, 0x80], 'half a pair in UTF-8'],
  [[0xc0, 0xaf], 'a character spelt too long in UTF-8'],
])('%s, %s, is refused', ([bytes]) => {
  const { text, issues } = decodeText(Uint8Array.from(/** @type {number[]} */ (bytes)));
  expect(text).toBeNull();
  expect(issues.map(({ severity, code }) => [severity, code])).toEqual([['error', 'not-text']]);
});

test('a file that cannot be short enough is not decoded at all', () => {
  expect(codes(decodeText(new Uint8Array(4 * 1024 * 1024 + 1)))).toEqual(['too-large']);
});
