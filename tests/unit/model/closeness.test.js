/** How an arm stands among obstacles, for the eye: the nearest of each, all that touches; and where a new obstacle is put. */
import { expect, test } from 'vitest';
import { applyCommand } from '../../../src/model/commands.js';
import { createDerived } from '../../../src/model/derived.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { newObstacle } from '../../../src/model/workcell/newObstacle.js';
import { OBSTACLE_SIZES } from '../../../src/model/workcell/obstacles.js';
import { createWorkcells, shownObstacles } from '../../../src/model/workcell/workcell.js';
import { marginNow } from '../../../src/model/workcell/workcellView.js';
import { automaticRadii } from '../../../src/render/arm/automaticRadii.js';

/** @import { Doc, ObstacleDoc } from '../../../src/model/document.js' */
/** @import { ObstacleKind } from '../../../src/model/workcell/obstacles.js' */

function start() {
  const derived = createDerived();
  return { derived, cells: createWorkcells(derived, automaticRadii) };
}
const KINDS = /** @type {ObstacleKind[]} */ (Object.keys(OBSTACLE_SIZES));

test.for(Object.keys(LIBRARY))(
  '%s: what is put in is sound, clear of the arm, and not on top of what is there',
  (id) => {
    const { derived, cells } = start();
    let doc = newDocument(LIBRARY[/** @type {keyof typeof LIBRARY} */ (id)]);
    const chain = derived.chain(doc);
    for (const kind of [...KINDS, 'box', 'sphere']) {
      const obstacle = newObstacle(/** @type {ObstacleKind} */ (kind), doc, chain, cells);
      doc = reduce(startState(doc), { type: 'add-obstacle', obstacle }).doc; // throws at what is refused
      expect(cells.closeness(doc).around?.distance).toBeGreaterThan(0);
    }
    const solid = doc.obstacles.filter(({ kind }) => kind !== 'plane');
    for (const [i, one] of solid.entries()) {
      for (const other of solid.slice(0, i)) expect(one.xyz).not.toEqual(other.xyz);
      expect(Math.hypot(...one.xyz)).toBeLessThan(1e6);
    }
    expect(marginNow({ margin: null }, chain)).toBeGreaterThan(0);
    expect(marginNow({ margin: 0 }, chain)).toBe(0);
  },
);

/** @param {readonly ObstacleDoc[]} obstacles @returns {Doc} */
const puma = (obstacles) => ({ ...newDocument(LIBRARY.puma560), obstacles });

test('obstacles and the arm itself are told apart, and everything that touches is named', () => {
  const { derived, cells } = start();
  const alone = puma([]);
  expect(cells.closeness(alone)).toMatchObject({ around: null, touching: [] });
  expect(cells.closeness(alone).itself?.distance).toBeGreaterThan(0);
  const [x, y, z] = derived
    .tcp(alone)
    .subarray(12, 15)
    .map((metre) => 1000 * metre);
  /** @type {ObstacleDoc} */
  const ball = { kind: 'sphere', id: 'ball', xyz: [x, y, z], radius: 60 };
  const doc = puma([ball, { ...ball, id: 'other', xyz: [x, y, z + 10] }, { ...ball, id: 'far', xyz: [9e3, 0, 0] }]);
  const { around, touching } = cells.closeness(doc);
  expect(around?.distance).toBeLessThan(0);
  expect(new Set(touching.map(({ obstacle }) => obstacle))).toEqual(new Set(['ball', 'other']));
  expect(cells.closeness(doc)).toBe(cells.closeness({ ...doc, targets: [] }));
  const moved = applyCommand(doc, { type: 'set-posture', posture: doc.posture.map((value) => value + 1) });
  expect(cells.closeness(moved)).not.toBe(cells.closeness(doc));
});

test('what is drawn has its sizes in metres along its own axes, and a plane none', () => {
  const pose = { xyz: [100, 0, 0], rpy: [0, 0, 90] };
  const shown = shownObstacles(
    puma([
      { kind: 'box', id: 'b', ...pose, width: 10, depth: 20, height: 30 },
      { kind: 'cylinder', id: 'c', ...pose, radius: 10, height: 30 },
      { kind: 'plane', id: 'p', ...pose },
    ]),
  );
  expect(shown.map(({ size }) => size)).toEqual([[0.01, 0.02, 0.03], [0.01, 0.01, 0.03], [1, 1, 1]]); // prettier-ignore
  expect(shown[0].T_world_obstacle[12]).toBeCloseTo(0.1, 12);
});

test('another document has other obstacles: none of them is chosen or hidden', () => {
  let state = startState(puma([]));
  const workcell = { isOpen: true, chosen: 'box_1', hidden: ['box_1'], hasCapsules: true, margin: 0.02 };
  state = reduce(state, { type: 'show', change: { workcell } });
  const next = reduce(state, { type: 'replace-document', doc: newDocument(LIBRARY.ur5) });
  expect(next.session.workcell).toEqual({ ...workcell, chosen: null, hidden: [] });
  const same = reduce(state, { type: 'convert-units', units: { length: 'm', angle: 'rad' } });
  expect(same.session.workcell).toBe(workcell);
});
