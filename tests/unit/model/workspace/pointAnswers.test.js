/** Answers of the kernel in the document's units, and the reasons why a line stops. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../../src/kinematics/chain.js';
import { compileRobot } from '../../../../src/model/compile.js';
import { lineRow, pointCells, pointRow } from '../../../../src/model/workspace/pointAnswers.js';
import { LIBRARY } from '../../../../src/model/library.js';
import { createPointFinder } from '../../../../src/workspace/points.js';

const robot = LIBRARY.puma560;
const finder = createPointFinder(createChain(compileRobot(robot)));

describe('a point', () => {
  test('that is reached has postures in degrees, and margins', () => {
    const row = pointRow(robot, { name: 'A', at: [300, 200, 400] }, finder.ask([0.3, 0.2, 0.4]));
    expect(row).toMatchObject({ verdict: 'reached', distance: 0, areAll: true });
    for (const { posture, margin } of row.postures) {
      expect(Math.max(...posture.map(Math.abs))).toBeGreaterThan(10);
      expect(margin?.share).toBeGreaterThan(0);
    }
  });

  test('that is not says how far it is, in millimetres, and where the nearest is', () => {
    const row = pointRow(robot, { name: '', at: [3000, 0, 0] }, finder.ask([3, 0, 0]));
    expect(row.verdict).toBe('unreachable');
    expect(Math.hypot(...row.nearest.map((value, i) => value - [3000, 0, 0][i]))).toBeCloseTo(row.distance, 6);
    const [, cells] = pointCells([row], ['head'], { verdict: () => 'no', postures: () => '0' });
    expect(cells.slice(0, 6)).toEqual(['1', 3000, 0, 0, 'no', '0']);
    expect(cells[7]).toBe(row.distance);
  });
});

describe('a line', () => {
  const end = Float64Array.of(0, 0, 0, 0, 0, 0);
  const stopped = { isTravelled: false, share: 0.5, start: end, end };
  const at = Float64Array.of(0.1, 0.2, 0.3);
  const held = [{ joint: 2, bound: /** @type {const} */ ('upper') }];
  test.each([
    ['limit', { place: at, isReachedBeyond: false, held }],
    ['limit-other', { place: at, isReachedBeyond: true, held }],
    ['boundary', { place: at, isReachedBeyond: false, held: [] }],
    ['turn', { place: at, isReachedBeyond: true, held: [] }],
  ])('stops: %s', (why, stop) => {
    const row = lineRow(robot, { ...stopped, stop });
    expect(row.why).toBe(why);
    expect(row.stopsAt).toEqual([100, 200, 300]);
  });

  test('that is travelled has no reason, and one that cannot begin has no place', () => {
    expect(lineRow(robot, { isTravelled: true, share: 1, start: end, end, stop: null }).why).toBeNull();
    const none = lineRow(robot, { isTravelled: false, share: 0, start: null, end: null, stop: null });
    expect(none).toMatchObject({ why: 'no-start', stopsAt: null, start: null });
  });
});
