import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readCsv, writeCsv } from '../../../src/io/csv.js';
import { readPostures, writePostures } from '../../../src/io/postureCsv.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Doc } from '../../../src/model/document.js' */

const scara = newDocument(LIBRARY.scara_cobra600);
const planar = newDocument(LIBRARY.planar2r);
/** @type {Doc} */
const recorded = {
  ...planar,
  posture: [1.5, -90],
  postures: [
    { id: 'home', q: [0, 0.1] },
    { id: 'pick', q: [-1e-7, 123456.789] },
  ],
};

test('a row for each posture, the present one first, under a head with names and units', () => {
  expect(writePostures(recorded)).toBe(
    `name,${planar.robot.joints.map(({ label, id }) => `${label ?? id} (deg)`).join(',')}\r\ncurrent,1.5,-90\r\nhome,0,0.1\r\npick,-1e-7,123456.789\r\n`,
  );
  expect(writePostures(scara).split('\r\n')[0]).toMatch(/\(deg\).*\(mm\)/);
});

test('what was written is read as it was', () => {
  fc.assert(
    fc.property(
      fc.constantFrom(...Object.values(LIBRARY)).map(newDocument),
      fc.array(fc.double({ min: -1e9, max: 1e9, noNaN: true }).map((value) => value + 0), { minLength: 6, maxLength: 6 }), // prettier-ignore
      (doc, numbers) => {
        const q = numbers.slice(0, doc.robot.joints.length);
        const { rows, fault, unused } = readPostures(writePostures({ ...doc, postures: [{ id: 'a', q }] }), doc.robot);
        expect({ rows, fault, unused }).toEqual({
          rows: [
            { line: 2, name: 'current', q: doc.posture.map((value) => value + 0), reason: null },
            { line: 3, name: 'a', q, reason: null },
          ],
          fault: null,
          unused: [],
        });
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('any cells come back, and no text begins as a formula does', () => {
  const cell = fc.oneof(
    fc.string().map((text) => text.replace(/\0/g, '').trim()),
    fc.constantFrom('=1+1', '+x', '-x', '@x', "'=x", "''", '"', 'a"b', 'a,b', 'a;b', '＝x', '=\n1'),
  );
  fc.assert(
    fc.property(fc.array(fc.array(cell, { minLength: 2, maxLength: 4 }), { minLength: 1, maxLength: 4 }), (rows) => {
      const text = writeCsv([rows[0].map(() => 'head,'), ...rows]);
      const written = readCsv(text).rows.slice(1);
      const asWritten = rows.map((row) => row.map((one) => one.trim())).filter((row) => row.some((one) => one !== ''));
      expect(written.map(({ cells }) => cells.map((one) => one.replace(/\r\n?/g, '\n')))).toEqual(
        asWritten.map((row) => row.map((one) => one.replace(/\r\n?/g, '\n'))),
      );
      const starts = text.replace(/"([^"]|"")*"/g, (quoted) => quoted.slice(0, 2)); // what a cell in quotes begins with
      expect(starts).not.toMatch(/(^|,|\n)"?\s*[=+@＝＋－＠]/);
    }),
    { seed: SEED, numRuns: runs(300) },
  );
  expect(writeCsv([['=cmd|1', -5, '-5', 'plain']])).toBe("'=cmd|1,-5,'-5,plain\r\n");
});

test('a hostile label stays one cell in any spreadsheet, and is found again', () => {
  const [first, ...others] = planar.robot.joints;
  const robot = { ...planar.robot, joints: [{ ...first, label: 'a;=cmd|calc,+1"\t@x' }, ...others] };
  const text = writePostures({ ...planar, robot });
  expect(text.split('\r\n')[0]).toBe(`name,a =cmd|calc +1 @x (deg),${others[0].label ?? others[0].id} (deg)`);
  expect(readPostures(text, robot).rows[0].q).toEqual(planar.posture);
});

test('columns are found by their heads, in any order and other units; what is not used is said', () => {
  const { rows, unused, hasHead } = readPostures('remark;q2 [rad];Name;J1 (deg)\nx;1,5707963267948966;pick;-30', planar.robot); // prettier-ignore
  expect([hasHead, unused]).toEqual([true, ['remark']]);
  expect(rows).toEqual([{ line: 2, name: 'pick', q: [-30, 90], reason: null }]);
});

test('without a head the values are in the order and the units of the document, with or without names', () => {
  expect(readPostures('1, 2\n3, 4', planar.robot).rows.map(({ name, q }) => [name, q])).toEqual([
    ['', [1, 2]],
    ['', [3, 4]],
  ]);
  expect(readPostures('a\t1\t−2\nb\t3,5\t4', planar.robot).rows.map(({ name, q }) => [name, q])).toEqual([
    ['a', [1, -2]],
    ['b', [3.5, 4]],
  ]);
});

test.for([
  ['a,1', 'The row has 1 joint values; expected 2, with or without a name before them.'],
  ['a,1,2,3', 'The row has 3 joint values; expected 2, with or without a name before them.'],
  ['a,1,x', 'Joint 2 has "x"; expected a number.'],
  ['a,,2', 'Joint 1 has nothing; expected a number.'],
  ['a,0x10,2', 'Joint 1 has "0x10"; expected a number.'],
  ['a,1e400,2', 'Joint 1 has "1e400"; expected a number up to 1000000000.'],
  ['a,NaN,2', 'Joint 1 has "NaN"; expected a number.'],
  ['b,5,6', 'The name "b" stands in an earlier row already.'],
])('the row %s is refused alone', ([line, reason]) => {
  const { rows, fault } = readPostures(`b,1,2\n${line}\nc,3,4`, planar.robot);
  expect(fault).toBe(null);
  expect(rows.map(({ q }) => q)).toEqual([[1, 2], null, [3, 4]]);
  expect(rows[1].reason).toBe(reason);
});

test.for([
  ['', 'The file is empty; expected a row for each posture.'],
  ['name,J1,J2', 'There is a head but no posture below it; expected a row for each.'],
  ['name,J1\na,1', /^No column is named after joint 2; expected a head such as ".+ \(deg\)"\.$/],
  ['J1,J2 (mm)\n1,2', 'The column "J2 (mm)" is in mm; expected deg or rad, as joint 2 turns.'],
  [Array(1100).fill('1,2').join('\n'), 'The file has 1100 rows; expected at most 1000 postures and a head.'],
])('a table is refused as a whole: case %#', ([text, fault]) => {
  const reading = readPostures(/** @type {string} */ (text), planar.robot);
  expect(reading.rows).toEqual([]);
  expect(reading.fault).toEqual(
    typeof fault === 'string' ? fault : expect.stringMatching(/** @type {RegExp} */ (fault)),
  );
});

test('reading never throws', () => {
  fc.assert(
    fc.property(fc.array(fc.constantFrom('"', ',', ';', '\t', '\n', '\r', "'", '=', '1', 'J1', 'name', '(mm)', '\uD800')), (parts) => {
      readPostures(parts.join(''), planar.robot);
    }), // prettier-ignore
    { seed: SEED, numRuns: runs(500) },
  );
});
