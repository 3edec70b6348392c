import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { createDerived } from '../../../src/model/derived.js';
import { reduce, startState } from '../../../src/model/session.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { startDocument } from '../../../src/model/startDocument.js';
import { createStore } from '../../../src/model/store.js';
import { createTrace, isSameShape, traceOf } from '../../../src/model/jog/trace.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Trace } from '../../../src/model/jog/trace.js' */

/** Two links of 1 m in a plane. */
const planar = createChain({
  convention: 'standard',
  joints: [1, 1].map((a) => ({ type: 'revolute', theta: 0, d: 0, a, alpha: 0 })),
});
/** @param {...number} q */
const at = (...q) => Float64Array.from(q);
/** By the definition of the arm. @param {ArrayLike<number>} q */
const toolAt = (q) => [Math.cos(q[0]) + Math.cos(q[0] + q[1]), Math.sin(q[0]) + Math.sin(q[0] + q[1])];

/** @param {Trace} trace @returns {number[][][]} the points of each stroke, x and y */
function strokesOf({ count, points, isStart }) {
  /** @type {number[][][]} */
  const strokes = [];
  for (let i = 0; i < count; i++) {
    if (isStart(i)) strokes.push([]);
    strokes[strokes.length - 1].push([points[3 * i], points[3 * i + 1]]);
  }
  return strokes;
}
/** @param {readonly number[]} p @param {readonly number[]} q */
const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

describe('a trace', () => {
  test('of one joint is the arc that it turns, however it was hurried', () => {
    const trace = createTrace(planar, at(0, 0));
    trace.go(at(0, 0), at(Math.PI / 2, 0), true);
    const [stroke, ...more] = strokesOf(trace);
    expect(more).toEqual([]);
    expect(stroke.length).toBeGreaterThan(40);
    for (const [x, y] of stroke) expect(Math.hypot(x, y)).toBeCloseTo(2, 6);
    expect(trace.length).toBeCloseTo(Math.PI, 3);
    expect(apart(stroke[stroke.length - 1], [0, 2])).toBeLessThan(1e-6);
  });

  test('has a gap where the arm was put elsewhere, and where it only stood there is nothing', () => {
    const trace = createTrace(planar, at(0, 0));
    trace.go(at(0, 0), at(0.1, 0), true);
    trace.go(at(0.1, 0), at(1, 1), false);
    trace.go(at(1, 1), at(2, 1), false);
    expect(trace.strokes).toBe(1);
    const { length } = trace;
    trace.go(at(2, 1), at(2, 1.5), true);
    expect(trace.strokes).toBe(2);
    const [, second] = strokesOf(trace);
    expect(apart(second[0], toolAt([2, 1]))).toBeLessThan(1e-6);
    expect(trace.length - length).toBeCloseTo(0.5, 4);
  });

  test('property: any motion stays within its memory, its strokes lie on the way, and it ends at the tool', () => {
    const step = fc.record({
      to: fc.tuple(fc.double({ min: -3, max: 3, noNaN: true }), fc.double({ min: -3, max: 3, noNaN: true })),
      isMotion: fc.oneof({ weight: 6, arbitrary: fc.constant(true) }, fc.constant(false)),
    });
    fc.assert(
      fc.property(fc.array(step, { maxLength: 60 }), fc.integer({ min: 8, max: 200 }), (steps, most) => {
        let q = at(0, 0);
        const trace = createTrace(planar, q, most);
        let length = 0;
        for (const { to, isMotion } of steps) {
          // one joint and then the other, so that every way is an arc
          for (const next of [at(to[0], q[1]), at(...to)]) {
            trace.go(q, next, isMotion);
            const turned = Math.abs(next[0] - q[0]);
            const bent = Math.abs(next[1] - q[1]);
            if (isMotion) length += turned * Math.hypot(...toolAt([0, q[1]])) + bent;
            q = next;
            expect(trace.count).toBeGreaterThan(0);
            expect(trace.count).toBeLessThanOrEqual(most);
          }
        }
        const strokes = strokesOf(trace);
        expect(trace.isStart(0)).toBe(true);
        const last = strokes[strokes.length - 1];
        expect(apart(last[last.length - 1], toolAt(q))).toBeLessThan(1e-5);
        for (const [x, y] of strokes.flat()) expect(Math.hypot(x, y)).toBeLessThan(2 + 1e-5);
        // chords of arcs, a little short of them
        const slack = 1.001e-9 * (1 + steps.length); // a way or a gap within a nanometre is none
        expect(trace.length).toBeLessThanOrEqual(length + slack);
        expect(trace.length).toBeGreaterThan(0.999 * length - slack);
      }),
      { seed: SEED, numRuns: runs(60) },
    );
  });

  test('keeps its ends and its shape when it is thinned', () => {
    const trace = createTrace(planar, at(0, 0), 64);
    let q = 0;
    for (let i = 1; i <= 600; i++) {
      trace.go(at(q, 0), at(i / 100, 0), true);
      q = i / 100;
    }
    const [stroke] = strokesOf(trace);
    expect(trace.edition).toBeGreaterThan(0);
    expect(apart(stroke[0], [2, 0])).toBeLessThan(1e-6);
    expect(stroke.length).toBeGreaterThan(24);
    expect(trace.length).toBeCloseTo(12, 2);
    for (const [x, y] of stroke) expect(Math.hypot(x, y)).toBeCloseTo(2, 5);
  });
});

describe('the recorder', () => {
  const page = () => ({
    store: createStore(startState(startDocument(firstRobot, { units: null, q: null, isOther: false }).doc), reduce),
    derived: createDerived(),
  });
  /** @param {ReturnType<typeof page>} given @param {number} value @param {string} [gesture] */
  function turn({ store }, value, gesture) {
    const { posture } = store.state.doc;
    store.dispatch({ type: 'set-posture', posture: [value, ...posture.slice(1)], gesture });
  }

  test('keeps nothing until it is asked to, then what a hand moves, and forgets it when it is told to', () => {
    const given = page();
    const { store } = given;
    const recorder = traceOf(given);
    expect(traceOf(given)).toBe(recorder);
    turn(given, 5, 'a');
    expect(recorder.trace).toBe(null);
    store.dispatch({ type: 'show', change: { trace: 0 } });
    expect(recorder.trace?.length).toBe(0);
    turn(given, 25, 'b');
    store.dispatch({ type: 'end-gesture' });
    const first = recorder.trace;
    expect(first?.length).toBeGreaterThan(0.1);
    store.dispatch({ type: 'undo' });
    expect(recorder.trace).toBe(first);
    expect(first?.strokes).toBe(1); // nothing was drawn from where undo put the arm
    turn(given, -20, 'c');
    expect(first?.strokes).toBe(2);
    store.dispatch({ type: 'show', change: { trace: 1 } });
    expect(recorder.trace).not.toBe(first);
    expect(recorder.trace?.length).toBe(0);
    store.dispatch({ type: 'show', change: { trace: null } });
    expect(recorder.trace).toBe(null);
  });

  test('begins anew with another shape, not with another name, colour or unit', () => {
    const given = page();
    const { store } = given;
    const recorder = traceOf(given);
    store.dispatch({ type: 'show', change: { trace: 0 } });
    turn(given, 30, 'a');
    const { trace } = recorder;
    store.dispatch({ type: 'rename-robot', name: 'Another name' });
    store.dispatch({ type: 'convert-units', units: { length: 'm', angle: 'rad' } });
    expect(recorder.trace).toBe(trace);
    store.dispatch({ type: 'set-joint-field', joint: 1, field: 'a', value: 0.5 });
    expect(recorder.trace).not.toBe(trace);
    expect(recorder.trace?.length).toBe(0);
  });

  test('a shape is the rows, the base and the tool', () => {
    const other = createChain({ ...planar, joints: planar.joints, tool: planar.tool });
    expect(isSameShape(planar, other)).toBe(true);
    const longer = createChain({ convention: 'standard', joints: planar.joints.map((joint) => ({ ...joint, a: 2 })) });
    expect(isSameShape(planar, longer)).toBe(false);
    const tool = planar.tool;
    tool[14] = 0.1;
    expect(isSameShape(planar, createChain({ convention: 'standard', joints: planar.joints, tool }))).toBe(false);
    expect(isSameShape(planar, createChain({ convention: 'modified', joints: planar.joints }))).toBe(false);
  });
});
