/** Files of controller code go back as they came. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { decodeCode, encodeCode } from '../../../src/io/codeText.js';
import { runs, SEED } from '../../helpers/property.js';

test('a text that nobody altered has the same bytes, whatever they are', () => {
  const anyBytes = fc.oneof(
    fc.uint8Array({ maxLength: 60 }),
    fc.string({ unit: 'binary' }).map((text) => new TextEncoder().encode(text)),
  );
  fc.assert(
    fc.property(anyBytes, (bytes) => {
      const came = decodeCode(bytes);
      expect(came.text).not.toMatch(/\r/);
      expect(encodeCode(came.text.replaceAll('\n', '\r\n'), came)).toEqual(bytes);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('one that was altered keeps its ends of lines, its encoding as far as that goes, and its mark', () => {
  const altered = (/** @type {number[]} */ ...bytes) => {
    const came = decodeCode(Uint8Array.from(bytes));
    return [...encodeCode(`${came.text}!`, came)];
  };
  const [a, bang, cr, lf] = [...'a!\r\n'].map((sign) => sign.charCodeAt(0));
  expect(altered(a, cr, lf)).toEqual([a, cr, lf, bang]);
  expect(altered(a, lf)).toEqual([a, lf, bang]);
  expect(altered(0xfc, cr, lf)).toEqual([0xfc, cr, lf, bang]); // ü of Windows-1252
  expect(altered(0xef, 0xbb, 0xbf, 0xc3, 0xbc, cr, lf)).toEqual([0xef, 0xbb, 0xbf, 0xc3, 0xbc, cr, lf, bang]);
  const old = decodeCode(Uint8Array.of(0xfc));
  expect([...encodeCode('ü€', old)]).toEqual([0xc3, 0xbc, 0xe2, 0x82, 0xac]); // a euro sign is where Latin-1 has none
});
