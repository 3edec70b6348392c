/** Documents as cells of capsules and obstacles: in which units, seen from where, how thick, and what is remembered. */
import { expect, test } from 'vitest';
import { createDerived } from '../../../src/model/derived.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { applyCommand } from '../../../src/model/commands.js';
import { createWorkcells, linkRadii } from '../../../src/model/workcell/workcell.js';

/** @import { Doc, ObstacleDoc } from '../../../src/model/document.js' */

const THICK = 0.03; // m
const cells = () => createWorkcells(createDerived(), (chain) => Array(chain.dof).fill(THICK));

/** An arm of two links of 1 m in the plane z = 0, stretched along x from where its base is, in mm. */
const planar = (/** @type {readonly ObstacleDoc[]} */ obstacles, base = [0, 0, 0]) => {
  const doc = newDocument(LIBRARY.planar2r);
  const joints = doc.robot.joints.map((joint) => ({ ...joint, theta: 0, d: 0, a: 1000, alpha: 0 }));
  const pose = { xyz: base, rpy: [0, 0, 0] };
  /** @type {Doc} */
  const made = {
    ...{ ...doc, posture: [0, 0], obstacles },
    robot: { ...doc.robot, units: { length: 'mm', angle: 'deg' }, base: pose, joints, tool: { xyz: [0, 0, 0] } },
  };
  return made;
};

/** By hand, from the arm's line along x at y = z = 0, 30 mm thick. @type {[ObstacleDoc, number, number][]} */
const PLACES = [
  [{ kind: 'sphere', id: 'o', xyz: [1500, 200, 0], radius: 50 }, 120, 1],
  [{ kind: 'sphere', id: 'o', xyz: [400, 0, -60], radius: 50 }, -20, 0],
  [{ kind: 'box', id: 'o', xyz: [2300, 0, 0], rpy: [0, 0, 90], width: 100, depth: 200, height: 10 }, 170, 1],
  [{ kind: 'box', id: 'o', xyz: [500, 0, 100], rpy: [90, 0, 0], width: 10, depth: 80, height: 20 }, 30, 0],
  [{ kind: 'cylinder', id: 'o', xyz: [1600, 0, 160], radius: 5, height: 200 }, 30, 1],
  [{ kind: 'cylinder', id: 'o', xyz: [1600, 0, 160], rpy: [90, 0, 0], radius: 50, height: 10 }, 80, 1],
];

test.for(PLACES)('the nearest is told by name, in document units: %o', ([obstacle, distance, link]) => {
  const near = cells().clearance(planar([obstacle]));
  expect(near).toEqual({ distance: expect.closeTo(distance, 6), link, obstacle: 'o', other: null });
  const inMetres = applyCommand(planar([obstacle]), { type: 'convert-units', units: { length: 'm', angle: 'rad' } });
  expect(cells().clearance(inMetres)?.distance).toBeCloseTo(distance / 1000, 9);
  const elsewhere = planar(
    [{ ...obstacle, xyz: obstacle.xyz.map((value, i) => value + [100, -200, 300][i]) }],
    [100, -200, 300],
  );
  expect(cells().clearance(elsewhere)?.distance).toBeCloseTo(distance, 6);
});

test('a plane is its own xy, and what is below it is filled', () => {
  /** @param {number[]} xyz @param {number[]} [rpy] */
  const far = (xyz, rpy) =>
    cells().clearance(planar([{ kind: 'plane', id: 'floor', xyz, ...(rpy && { rpy }) }]))?.distance;
  expect(far([7, 8, -100])).toBeCloseTo(70, 6);
  expect(far([0, 0, 100])).toBeCloseTo(-30, 6); // overlaps are not told deeper than the capsule is thick
  expect(far([0, 0, 100], [180, 0, 0])).toBeCloseTo(70, 6);
  expect(far([2500, 0, 0], [0, -90, 0])).toBeCloseTo(470, 6);
});

test('nothing around is nothing near', () => {
  expect(cells().clearance(planar([]))).toBeNull();
});

test('a capsule is as thick as its link is drawn, and covers a box', () => {
  const { robot } = planar([]);
  const joints = [
    { ...robot.joints[0], link: { kind: /** @type {const} */ ('cylinder'), radius: 45 } },
    { ...robot.joints[1], link: { kind: /** @type {const} */ ('box'), width: 60, height: 80 } },
  ];
  expect(linkRadii({ ...robot, joints }, [1, 2])).toEqual([0.045, 0.05]);
  expect(linkRadii(robot, [0.1, 0.2])).toEqual([0.1, 0.2]);
});

test('a cell is remembered while the arm jogs, and made anew for other obstacles, units or links', () => {
  const all = cells();
  const doc = planar([PLACES[0][0]]);
  const cell = all.cell(doc);
  const bent = applyCommand(doc, { type: 'set-posture', posture: [90, 0] });
  expect(all.cell(bent)).toBe(cell);
  expect(all.clearance(bent)?.distance).not.toBeCloseTo(120, 0);
  expect(all.cell(applyCommand(bent, { type: 'remove-obstacle', index: 0 }))).not.toBe(cell);
});
