import { describe, expect, test } from 'vitest';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { GROUPS, columnsOf, planCsv, unitText } from '../../../src/model/program/planColumns.js';
import { indexAt, sampleSeries, sampleTimes, steppedTimes, valueAt } from '../../../src/model/program/planSeries.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { planMotion } from '../../../src/motion/plan.js';

const { robot } = newDocument(LIBRARY.puma560);
const chain = compileRobot(robot);
const posture = (/** @type {number[]} */ ...degrees) => compilePosture(robot, degrees);
const full = (/** @type {number} */ value) => new Float64Array(6).fill(value);
const limits = { rates: full(1), accelerations: full(4), jerks: full(40) };
const start = posture(0, 40, -150, 0, 30, 0);
const T = tcpPose(chain, start);
const down = Float64Array.from(T);
down[14] -= 0.1;

/** @type {import('../../../src/motion/plan.js').Move[]} */
const MOVES = [
  { kind: 'joint', posture: posture(50, 40, -150, 0, 30, 0), speed: 0.5, acceleration: 1, ending: { kind: 'fine' } },
  { kind: 'wait', seconds: 0.5 },
  { kind: 'joint', posture: start, speed: 1, acceleration: 1, ending: { kind: 'fine' } },
  ...[down, T].map(
    (T_base_tcp) =>
      /** @type {import('../../../src/motion/plan.js').LinearMove} */ ({
        ...{ kind: 'linear', T_base_tcp, speed: 0.1, turnSpeed: 1, acceleration: 1 },
        ending: { kind: 'fine' },
      }),
  ),
];
const plan = planMotion(chain, start, MOVES, limits);

/** @param {Float64Array} times */
function seriesAt(times) {
  const run = sampleSeries(plan, times, () => chain);
  const shares = [];
  for (;;) {
    const { done, value } = run.next();
    if (done) return { series: value, shares };
    shares.push(value);
  }
}
const { series, shares } = seriesAt(sampleTimes(plan, 801));
const most = (/** @type {Float64Array} */ values) => Math.max(...values.map(Math.abs));

/**
 * How far a series is from the integral of its derivative, at most, over so many of the first moves.
 * @param {Float64Array} of @param {Float64Array} derivative @param {number} moves
 */
function gapOfIntegral(of, derivative, moves) {
  const { times } = series;
  let [sum, worst] = [0, 0];
  for (let k = 1; k < times.length && series.moves[k] < moves; k++) {
    sum += ((derivative[k] + derivative[k - 1]) / 2) * (times[k] - times[k - 1]);
    worst = Math.max(worst, Math.abs(of[0] + sum - of[k]));
  }
  return worst;
}

describe('a plan as series', () => {
  test('the plan is one, or all below says nothing', () => {
    expect(plan.refused).toBe(null);
    expect(plan.parts).toHaveLength(5);
  });

  test('begins and ends with the plan, in order, with two samples where moves meet, and tells how far it is', () => {
    const { times, moves } = series;
    expect(times[0]).toBe(0);
    expect(times.at(-1)).toBe(plan.duration);
    expect(times.every((time, k) => k === 0 || time > times[k - 1])).toBe(true);
    for (const { begin, move } of plan.parts.slice(1)) {
      const k = times.indexOf(begin);
      expect([moves[k - 1], moves[k]]).toEqual([move - 1, move]);
    }
    expect(shares.length).toBeGreaterThan(10);
    expect(shares.every((share, i) => share > 0 && share <= 1 && (i === 0 || share > shares[i - 1]))).toBe(true);
  });

  test('rates are the derivatives of values, and in joint moves accelerations of rates', () => {
    const { values, rates, accelerations, jerks } = series;
    for (let i = 0; i < 6; i++) {
      expect(gapOfIntegral(values[i], rates[i], 5)).toBeLessThan(1e-3);
      expect(gapOfIntegral(rates[i], accelerations[i], 3)).toBeLessThan(8e-3);
    }
    expect(most(jerks[0])).toBeGreaterThan(1);
    expect(accelerations[1].every(Number.isFinite)).toBe(true);
  });

  test('the speed of the tool is how fast its place changes', () => {
    const { times, place, speed } = series;
    for (let k = 1; k < times.length - 1; k++) {
      const [x, y, z] = place.map((column) => (column[k + 1] - column[k - 1]) / (times[k + 1] - times[k - 1]));
      // at a mark the two sides differ, and beside it the quotient is over one step and a millionth
      if (times[k + 1] - times[k - 1] > 0.01) expect(Math.abs(Math.hypot(x, y, z) - speed[k])).toBeLessThan(4e-3);
    }
    expect(Math.max(...speed.filter((_, k) => series.moves[k] >= 3))).toBeCloseTo(0.1, 3);
    expect(Math.max(...speed.filter((_, k) => series.moves[k] === 1))).toBe(0);
  });

  test('what turns about the upright axis of the base turns the tool as fast, and changes W or R alone', () => {
    for (const [k, move] of series.moves.entries()) {
      if (move === 0) expect(series.turnSpeed[k]).toBeCloseTo(Math.abs(series.rates[0][k]), 12);
      if (move >= 3) expect(series.turnSpeed[k]).toBeLessThan(1e-4);
    }
    const [w, p, r] = series.orientation;
    const turned = series.times.indexOf(plan.parts[1].begin);
    expect(w[turned]).toBeCloseTo(w[0], 9);
    expect(p[turned]).toBeCloseTo(p[0], 9);
    expect(r[turned] - r[0]).toBeCloseTo((50 / 180) * Math.PI, 9);
  });

  test('angles never jump by a turn', () => {
    for (const column of series.orientation) {
      expect(most(column.map((angle, k) => (k === 0 ? 0 : angle - column[k - 1])))).toBeLessThan(0.2);
    }
  });

  test('a joint that turns the whole arm changes no manipulability', () => {
    const { manipulability, moves } = series;
    const first = manipulability.filter((_, k) => moves[k] === 0);
    expect(Math.max(...first) - Math.min(...first)).toBeLessThan(1e-9);
    expect(first[0]).toBeGreaterThan(1e-3);
  });
});

describe('times', () => {
  test('a step that does not go into the duration has the end besides', () => {
    expect([...steppedTimes(1, 0.25)]).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect([...steppedTimes(0.6, 0.25)]).toEqual([0, 0.25, 0.5, 0.6]);
    expect([...steppedTimes(0.3, 0.1)]).toHaveLength(4);
    expect([...steppedTimes(0, 0.1)]).toEqual([0]);
  });

  test('a value between samples lies straight between them', () => {
    const [times, values] = [Float64Array.of(0, 1, 3), Float64Array.of(10, 20, 0)];
    expect([-1, 0, 0.5, 1, 2, 3, 9].map((time) => valueAt(times, values, time))).toEqual([10, 10, 15, 20, 10, 0, 0]);
    expect([0, 0.9, 1, 2.9, 3, 9].map((time) => indexAt(times, time))).toEqual([0, 0, 1, 1, 2, 2]);
  });
});

describe('columns', () => {
  test('are in document units, with the limits that hold', () => {
    const [first] = columnsOf(robot, series, 'values', limits);
    expect(first).toMatchObject({ name: 'J1', least: -160, most: 160 });
    expect(Math.max(...first.values)).toBeCloseTo(50, 9);
    const [rate] = columnsOf(robot, series, 'rates', limits);
    expect(rate.most).toBeCloseTo(180 / Math.PI, 9);
    expect(rate.least).toBe(-rate.most);
    expect(Math.max(...rate.values)).toBeCloseTo(90 / Math.PI, 3);
    expect(unitText(rate.unit)).toBe('deg/s');
    const [speed] = columnsOf(robot, series, 'speed', limits);
    expect(unitText(speed.unit)).toBe('mm/s');
    expect(Math.max(...speed.values)).toBeGreaterThan(100 - 0.1);
    expect(columnsOf(robot, series, 'place', null).map(({ name }) => name)).toEqual(['X', 'Y', 'Z']);
    expect(columnsOf(robot, series, 'place', null)[2].values[0]).toBeCloseTo(1000 * T[14], 9);
  });

  test('units are written with their powers', () => {
    expect(unitText({ unit: 'mm', power: 3, per: 0 })).toBe('mm³');
    expect(unitText({ unit: '', power: 0, per: 0 })).toBe('');
    expect(unitText({ unit: 'deg', power: 1, per: 3 }, () => '°')).toBe('°/s³');
  });

  test('in a file every row has every column, all of them numbers but the name of the step', () => {
    const { series: few } = seriesAt(steppedTimes(plan.duration, 0.5));
    const text = planCsv(
      robot,
      few,
      (move) => `step "${move}", so`,
      (group, name) => `${group} ${name}`,
    );
    const lines = text.split('\r\n');
    expect(lines.pop()).toBe('');
    expect(lines).toHaveLength(few.times.length + 1);
    const [head, ...rows] = lines.map((line) => line.replaceAll(/"(?:[^"]|"")*"/g, 'step').split(','));
    expect(head[0]).toBe('t [s]');
    expect(head).toContain('jerks J6 [deg/s³]');
    expect(head).toHaveLength(2 + 4 * 6 + 3 + 3 + 3);
    for (const row of rows) {
      expect(row).toHaveLength(head.length);
      expect(row.filter((_, i) => i !== 1).every((cell) => cell !== '' && Number.isFinite(Number(cell)))).toBe(true);
    }
    expect(lines[1].startsWith('0,"step ""0"", so",0,40,')).toBe(true);
    expect(GROUPS).toHaveLength(9);
  });
});
