/** Points as text, however they are written; and texts that are none. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { MAX_POINTS, MAX_POINTS_TEXT, readPoints } from '../../../src/io/pointsText.js';
import { runs, SEED } from '../../helpers/property.js';

const FAR = 1e7;
const at = (/** @type {string} */ text) => readPoints(text, FAR).points?.map((point) => [point.name, ...point.at]);

describe('points are read', () => {
  test.each([
    ['1 2 3', [['', 1, 2, 3]]],
    ['  1.5\t-2e2\t.5  ', [['', 1.5, -200, 0.5]]],
    ['[1, 2, 3]'.replace(/[[\]]/g, ''), [['', 1, 2, 3]]],
    ['A 1 2 3\nB 4 5 6', [['A', 1, 2, 3], ['B', 4, 5, 6]]], // prettier-ignore
    ['1;2,5;3;end', [['end', 1, 2.5, 3]]],
    ['point,x,y,z\r\nP1,1,2,3\r\n\r\n# a note\r\n"P2",4,5,6\r\n', [['P1', 1, 2, 3], ['P2', 4, 5, 6]]], // prettier-ignore
    ['7 1 2 3', [['7', 1, 2, 3]]],
    ['−1 2 3', [['', -1, 2, 3]]],
    ['name,x,y,z\n"A, left",1,2,3', [['A, left', 1, 2, 3]]],
    ['point;x_mm;y_mm;z_mm;reached;margin\n7;1,5;2;3;yes;\n;4;5;6;no;0,2', [['7', 1.5, 2, 3], ['', 4, 5, 6]]], // prettier-ignore
    ['x,y,z,w,p,r\n1,2,3,0,90,0', [['', 1, 2, 3]]],
    ['name,x,y,z\nA,1,2,3\n4 5 6', [['A', 1, 2, 3], ['', 4, 5, 6]]], // prettier-ignore
    ['\uFEFFx y z\n1 2 3', [['', 1, 2, 3]]],
  ])('%j', (text, points) => expect(at(text)).toEqual(points));

  test.each([
    ['', { code: 'none' }],
    ['x y z', { code: 'none' }],
    ['x,y,z\n1,,3', { code: 'not-three', line: 2 }],
    ['1 2', { code: 'not-three', line: 1 }],
    ['1 2 3\n1 2 three', { code: 'not-three', line: 2 }],
    ['1 2 3\na b c', { code: 'not-three', line: 2 }],
    ['A B 1 2 3', { code: 'not-three', line: 1 }],
    ['1 2 1e9', { code: 'too-far', line: 1 }],
    ['1 2 1e999', { code: 'too-far', line: 1 }],
    ['1 2 0x10', { code: 'not-three', line: 1 }],
    ['1 2 3\n'.repeat(MAX_POINTS + 1), { code: 'too-many' }],
    ['1'.repeat(MAX_POINTS_TEXT + 1), { code: 'too-long' }],
  ])('but not %j', (text, fault) => expect(readPoints(text, FAR)).toEqual({ points: null, fault }));

  test('whatever the text, without throwing, and never a number that is none', () => {
    fc.assert(
      fc.property(fc.oneof(fc.string({ maxLength: 200 }), fc.stringMatching(/^[-0-9.,;\te \n"#]{0,80}$/)), (text) => {
        const { points, fault } = readPoints(text, FAR);
        expect((points === null) !== (fault === null)).toBe(true);
        for (const point of points ?? []) expect(point.at.every((value) => Math.abs(value) <= FAR)).toBe(true);
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });

  test('what is written is read again', () => {
    const place = fc.tuple(...[0, 1, 2].map(() => fc.double({ min: -1e6, max: 1e6, noNaN: true })));
    fc.assert(
      fc.property(
        fc.array(place, { minLength: 1, maxLength: 20 }),
        fc.constantFrom(' ', '\t', ';', ','),
        (list, sign) => {
          const text = list.map((each) => each.map((value) => String(value)).join(sign)).join('\n');
          expect(at(text)).toEqual(list.map((each) => ['', ...each.map((value) => Number(String(value)))]));
        },
      ),
      { seed: SEED, numRuns: runs(100) },
    );
  });
});
