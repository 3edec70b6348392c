/**
 * The list of solutions, and families as lines, judged by forward kinematics that shares no code with the kernel; and a pair of
 * pose and pendant numbers that was published.
 */
import { describe, expect, test } from 'vitest';
import { createRandom } from '../../../src/kinematics/random.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { pendantValues } from '../../../src/model/controller/controllerValues.js';
import { poseFromXyzwpr, xyzwprOf } from '../../../src/model/aim/aim.js';
import { familyLine } from '../../../src/model/aim/families.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import {
  configurationAt,
  describeSolutions,
  inOrderOf,
  isOneList,
  solveAll,
  solvePlace,
  travelBetween,
} from '../../../src/model/aim/solutions.js';
import { oracleForward } from '../kinematics/oracle.js';

/** @typedef {import('../../../src/model/document.js').RobotDoc} RobotDoc */

/** @param {RobotDoc} robot @param {readonly number[]} posture */
const tcp = (robot, posture) => oracleForward(compileRobot(robot), compilePosture(robot, posture)).tcp;

/** @param {number[][]} A @param {number[][]} B */
const apart = (A, B) => Math.max(...A.flatMap((row, i) => row.map((value, j) => Math.abs(value - B[i][j]))));

/** @param {RobotDoc} robot @param {readonly number[]} posture */
function solved(robot, posture) {
  const chain = compileRobot(robot);
  const T = Float64Array.from({ length: 16 }, (_, k) => tcp(robot, posture)[k % 4][k >> 2]);
  const doc = { ...newDocument(robot), posture };
  return {
    chain,
    T,
    all: solveAll(doc, chain, T),
    found: describeSolutions(robot, chain, posture, solveAll(doc, chain, T)),
  };
}

const HERE = [-32, 58, -168, 24, 52, -18];

describe('an arm with too few joints to turn its tool', () => {
  // textbook counts: an elbow either way, and a shoulder in front or behind
  const COUNTS = {
    planar2r: 2,
    planar_rp: 2,
    planar_pr: 2,
    cyl_rpp: 2,
    cart_ppp: 1,
    anthropomorphic_3r: 4,
    polar_rrp: 4,
  };

  test.each(Object.entries(COUNTS))('%s has %i postures for a place', (id, count) => {
    const robot = LIBRARY[id];
    const chain = compileRobot(robot);
    const random = createRandom(12);
    for (let tries = 0; tries < 10; tries++) {
      const posture = robot.joints.map(
        ({ lower = -180, upper = 180 }) => lower + (upper - lower) * (0.05 + 0.9 * random()),
      );
      const wanted = tcp(robot, posture);
      // turned as it never is: only the place counts
      const T = Float64Array.from([0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, wanted[0][3], wanted[1][3], wanted[2][3], 1]);
      const doc = { ...newDocument(robot), posture };
      const listed = solvePlace(doc, chain, T);
      if (!listed) throw new Error('There is no list.');
      const { solutions } = describeSolutions(robot, chain, posture, listed);
      expect(solutions).toHaveLength(count);
      for (const { posture: q } of solutions) {
        const { tcp: now } = oracleForward(chain, compilePosture(robot, q));
        for (const k of [0, 1, 2]) expect(now[k][3]).toBeCloseTo(wanted[k][3], 8);
      }
      posture.forEach((value, i) => expect(solutions[0].posture[i]).toBeCloseTo(value, 5));
      expect(isOneList(solutions, [...solutions].reverse(), robot)).toBe(true);
      if (count > 1) expect(isOneList(solutions, [...solutions.slice(1), solutions[1]], robot)).toBe(false);
    }
  });

  test('has none beyond its reach; and an arm that can turn its tool has no such list', () => {
    const far = Float64Array.from([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]);
    const listOf = (/** @type {string} */ id) => solvePlace(newDocument(LIBRARY[id]), compileRobot(LIBRARY[id]), far);
    expect(listOf('planar2r')?.solutions).toEqual([]);
    for (const id of ['planar3r', 'scara_cobra600', 'puma560']) expect(listOf(id)).toBeNull();
  });
});

describe('solutions of the Puma 560', () => {
  const { found } = solved(LIBRARY.puma560, HERE);

  test('are eight, and each takes the tool to the same place', () => {
    expect(found.solutions).toHaveLength(8);
    expect(found.complete).toBe(true);
    const wanted = tcp(LIBRARY.puma560, HERE);
    for (const { posture } of found.solutions) expect(apart(tcp(LIBRARY.puma560, posture), wanted)).toBeLessThan(1e-8);
  });

  test('begin where the arm stands; those inside the limits come first, the nearest of them first', () => {
    const [first] = found.solutions;
    first.posture.forEach((value, i) => expect(value).toBeCloseTo(HERE[i], 6));
    const inside = found.solutions.map(({ withinLimits }) => withinLimits);
    expect(inside).toEqual([...inside].sort((a, b) => Number(b) - Number(a)));
    const ways = found.solutions
      .filter(({ withinLimits }) => withinLimits)
      .map(({ posture }) => Math.max(...posture.map((value, i) => Math.abs(value - HERE[i]))));
    expect(ways).toEqual([...ways].sort((a, b) => a - b));
  });

  test('say how much room the joint with the least of it has, or by how much it is past its limit', () => {
    for (const { posture, room, withinLimits } of found.solutions) {
      const shares = LIBRARY.puma560.joints.map(({ lower = NaN, upper = NaN }, i) => {
        const toNearer = Math.min(posture[i] - lower, upper - posture[i]);
        return { joint: i, room: toNearer, share: (2 * toNearer) / (upper - lower) };
      });
      const [least] = shares.sort((a, b) => a.share - b.share);
      expect(room?.joint).toBe(least.joint);
      expect(room?.room).toBeCloseTo(least.room, 9);
      expect(Number(room?.room) >= 0).toBe(withinLimits);
    }
  });

  test('keep their places in the list while the arm moves among them', () => {
    const robot = LIBRARY.puma560;
    const third = found.solutions[2].posture;
    const again = solved(robot, third).found.solutions;
    expect(again[0].posture[0]).toBeCloseTo(third[0], 6);
    const kept = inOrderOf(found.solutions, again, robot);
    expect(kept).toHaveLength(8);
    kept.forEach(({ name }, i) => expect(name).toEqual(found.solutions[i].name));
    kept[2].posture.forEach((value, i) => expect(value).toBeCloseTo(third[i], 6));
  });
});

test('travel is that of the joint which goes farthest, and nothing where the arm stands', () => {
  const robot = LIBRARY.puma560;
  const chain = compileRobot(robot);
  expect(travelBetween(robot, chain, HERE, HERE).isHere).toBe(true);
  const there = HERE.with(3, HERE[3] - 70).with(0, HERE[0] + 20);
  expect(travelBetween(robot, chain, HERE, there)).toMatchObject({ joint: 3, by: 70, isHere: false });
});

test.each(['scara_cobra600', 'kuka_youbot', 'mitsubishi_rv2aj'])('%s has no controller code, and says why', (id) => {
  const robot = /** @type {Record<string, RobotDoc>} */ (LIBRARY)[id];
  const { fanuc, kuka } = configurationAt(robot, compileRobot(robot), newDocument(robot).posture);
  expect(fanuc).toEqual({ text: null, reason: 'not-six-axes' });
  expect(kuka).toEqual({ status: null, turn: null, reason: 'not-six-axes' });
});

describe('a family', () => {
  const inLine = [20, 60, -150, 30, 0, -10];

  test('of a wrist in line is a line of postures that leave the tool where it is', () => {
    const robot = LIBRARY.puma560;
    const { chain, T, all } = solved(robot, inLine);
    expect(all.families.length).toBeGreaterThan(0);
    const wanted = tcp(robot, inLine);
    const family = all.families.find(({ withinLimits }) => withinLimits) ?? all.families[0];
    const line = familyLine(robot, chain, T, family);
    expect(line.leader).toBe(3);
    expect(line.members.length).toBeGreaterThan(40);
    for (const { posture, value } of line.members) {
      expect(posture[3]).toBe(value);
      expect(apart(tcp(robot, posture), wanted)).toBeLessThan(2e-7);
      robot.joints.forEach(({ lower = -Infinity, upper = Infinity }, i) => {
        expect(posture[i]).toBeGreaterThanOrEqual(lower - 1e-9);
        expect(posture[i]).toBeLessThanOrEqual(upper + 1e-9);
      });
    }
    const values = line.members.map(({ value }) => value);
    expect(values).toEqual([...values].sort((a, b) => a - b));
    const found = compilePosture(robot, line.members[line.start].posture);
    found.forEach((value, i) => expect(value).toBeCloseTo(family.q[i], 12));
  });
});

describe('the R-2000iB/165F at a pose that was published with its pendant numbers', () => {
  const link = /** @type {const} */ ({ kind: 'auto' });
  const rows = [
    [0, 0, 312, -90],
    [-90, 0, 1075, 180],
    [0, 0, 225, -90],
    [0, -1280, 0, 90],
    [0, 0, 0, -90],
    [0, -270, 0, 180], // 215 of the flange and 55 of the tool
  ];
  /** @type {RobotDoc} */
  const robot = {
    ...{ name: 'R-2000iB/165F', info: {}, units: { length: 'mm', angle: 'deg' }, convention: 'standard' },
    base: { xyz: [0, 0, 0] },
    tool: { xyz: [0, 0, 0] },
    joints: rows.map(([theta, d, a, alpha], i) => ({
      ...{ id: `j${i + 1}`, type: 'revolute', theta, d, a, alpha, lower: -360, upper: 360, link },
      controller: i === 2 ? { sign: 1, offset: 0, coupledTo: 'j2', coupling: -1 } : { sign: 1, offset: 0, coupling: 0 },
    })),
  };
  const PENDANT = [7.962, -5.284, -36.25, 77.661, -51.975, -79.273];
  const POSE = [1500, 0, 360, 135, -45, 0];
  /** The table's third angle is counted from the upper arm, the pendant's from level. */
  const posture = PENDANT.with(2, PENDANT[2] + PENDANT[1]);

  test('stands at that pose, with those numbers, as N U T', () => {
    const chain = compileRobot(robot);
    pendantValues(robot, posture).forEach((value, i) => expect(value).toBeCloseTo(PENDANT[i], 9));
    const T = Float64Array.from({ length: 16 }, (_, k) => tcp(robot, posture)[k % 4][k >> 2]);
    xyzwprOf(robot, T).forEach((value, i) => expect(Math.abs(value - POSE[i])).toBeLessThan(i < 3 ? 0.02 : 0.002));
    expect(configurationAt(robot, chain, posture).fanuc).toEqual({ text: 'N U T, 0, 0, 0', reason: null });
  });

  test('has among the solutions of that pose the one with those numbers and that name', () => {
    const chain = compileRobot(robot);
    const T = poseFromXyzwpr(robot, POSE);
    const home = newDocument(robot);
    const { solutions, complete } = describeSolutions(robot, chain, home.posture, solveAll(home, chain, T));
    expect(complete).toBe(true);
    const same = solutions.filter(({ posture: found }) =>
      pendantValues(robot, found).every((value, i) => Math.abs(value - PENDANT[i]) < 0.002),
    );
    expect(same.map(({ fanuc }) => fanuc.text)).toEqual(['N U T, 0, 0, 0']);
    const twin = solutions.filter(({ posture: found }) => {
      const pendant = pendantValues(robot, found);
      return Math.abs(pendant[4] + PENDANT[4]) < 0.002 && Math.abs(pendant[0] - PENDANT[0]) < 0.002;
    });
    expect(twin.map(({ fanuc }) => fanuc.text?.slice(0, 5))).toContain('F U T');
  });
});
