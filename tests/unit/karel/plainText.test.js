import fc from 'fast-check';
import { expect, test } from 'vitest';
import { fanucNames } from '../../../src/karel/fanucNames.js';
import { plainText, wrapped } from '../../../src/karel/plainText.js';
import { titleOf } from '../../../src/karel/write/header.js';
import { runs, SEED } from '../../helpers/property.js';

test.for([
  ['Puma 560', 'Puma 560'],
  ['Größe', 'Grosse'],
  ['Škoda – łódź, 90°', 'Skoda - lodz, 90deg'],
  ['x\nABORT', 'x ABORT'],
  ['x\r\n\u2028\u2029\0\tABORT', 'x ABORT'],
  ['ロボット 2', '? 2'],
  ['  a  ', 'a'],
  ['“quoted”', '"quoted"'],
  ['\ud800', ''],
  ['', ''],
])('%j becomes %j', ([text, plain]) => expect(plainText(text)).toBe(plain));

test.for([
  ['Puma 560', 'Größe', 'Puma 560: Grosse'],
  ['ロボット', '移動', 'Robot: program'],
  ['ロボット 2', '', '? 2: program'],
])('robot %j and program %j are %j in a header', ([robotName, name, title]) =>
  expect(titleOf({ robotName, name })).toBe(title),
);

test('any text becomes one line of printable ASCII, no longer than asked', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'binary' }), fc.nat(40), (text, longest) => {
      expect(plainText(text)).toMatch(/^([!-~]|[!-~][ -~]*[!-~])?$/);
      expect(plainText(text, longest).length).toBeLessThanOrEqual(longest);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('wrapping keeps all words in order and no line is too long', () => {
  const words = fc.array(fc.string({ unit: fc.constantFrom('a', 'b', '-'), minLength: 1, maxLength: 12 }));
  fc.assert(
    fc.property(words, fc.integer({ min: 12, max: 40 }), (list, width) => {
      const lines = wrapped(list.join(' '), width);
      expect(lines.join(' ')).toBe(list.join(' '));
      for (const line of lines) expect(line.length).toBeLessThanOrEqual(width);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('a word longer than the line is cut', () => expect(wrapped('a bcdefgh', 3)).toEqual(['a', 'bcd', 'efg', 'h']));

test.for([
  ['Puma 560', 'puma_560', 'PUMA_MV'],
  ['Cobra 600', 'cobra600', 'COBRA_MV'],
  ['Planar 2R', 'planar2r', 'PLANA_MV'],
  ['2 links', 'p2_links', 'P2_LI_MV'],
  ['Bras à 6 axes', 'brasa6ax', 'BRAS_MV'],
  ['ロボット', 'denavit', 'DENAV_MV'],
  ['', 'denavit', 'DENAV_MV'],
  ['end', 'end_p', 'END_MV'],
  ['Position', 'positi_p', 'POSIT_MV'],
  ['pos', 'pos_p', 'POS_MV'],
  ['arm_mv', 'arm_mv', 'ARM_M_MV'],
  ['a_mv', 'a_mv', 'A_MV_MV'],
  ['abcde_mv', 'abcde_mv', 'ABCDE_GO'],
])('%j gives the programs %s and %s', ([wanted, karel, tp]) => expect(fanucNames(wanted)).toEqual({ karel, tp }));

test('any name gives two different legal ones, of at most 8 characters', () => {
  const anyName = fc.oneof(
    fc.string({ unit: 'binary' }),
    fc.string({ unit: fc.constantFrom('a', 'm', 'v', '_', '1', ' ', 'g', 'o'), maxLength: 10 }),
    fc.constantFrom('BEGIN', 'routine', 'jointpos', 'input', 'true', 'fill', 'fill_p', '__', '_mv'),
  );
  fc.assert(
    fc.property(anyName, (wanted) => {
      const { karel, tp } = fanucNames(wanted, ['fill', 'joints']);
      expect(karel).toMatch(/^[a-z][a-z0-9_]{0,7}$/);
      expect(tp).toMatch(/^[A-Z][A-Z0-9_]{0,7}$/);
      expect(tp).not.toBe(karel.toUpperCase());
      expect(['fill', 'joints', 'begin', 'routine', 'jointpos', 'input', 'true']).not.toContain(karel);
      expect(fanucNames(karel, ['fill', 'joints']).karel).toBe(karel);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});
