/** The arms of the library against the numbers of another program, and what a person may expect of each of them. */
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { dexterity } from '../../../src/kinematics/dexterity.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { homePosture, isSliding } from '../../../src/model/document.js';
import { FIRST_ROBOT, LIBRARY, LIBRARY_FAMILIES } from '../../../src/model/library.js';
import { newRobot } from '../../../src/model/robot/newRobot.js';
import { onPendant } from '../../../src/model/controller/pendantNumbers.js';
import { LIBRARY_IDS, firstRobot, loadRobot } from '../../../src/model/shelf.js';

/** @param {string} name */
const fixture = (name) =>
  JSON.parse(readFileSync(new URL(`../../fixtures/kinematics/${name}`, import.meta.url), 'utf8')).arms;

/** @type {Record<string, { joints: [string, number, number, number, number, number, number][] }>} a α d θ lower upper */
const tables = fixture('arms.json');
/** @type {Record<string, { q: number[][], tcp: number[][] }>} three upper rows of the pose, row by row */
const forward = fixture('forward.json');

/** The distance to the next number that a computer knows. @param {number} value */
const ulp = (value) => 2 ** (Math.floor(Math.log2(Math.abs(value))) - 52);

/** Joints whose limits the source has from the maker's axis, though it counts the joint from elsewhere: the axis has them. @type {Record<string, number[]>} */
const LIMITED_ON_AXIS = { kuka_kr5_arc: [2, 5], kuka_kr6_r900: [5], kuka_kr210_l150: [5] };

/** What a first course uses and other programs leave to the reader; with lengths of our own. */
const OUR_OWN = ['planar_rp', 'planar_pr', 'anthropomorphic_3r', 'spherical_wrist'];

test('has all arms that other programs counted for us, and those of a first course', () => {
  expect(Object.keys(tables)).toHaveLength(22);
  expect(Object.keys(LIBRARY).sort()).toEqual([...Object.keys(tables), ...OUR_OWN].sort());
});

test('the ids that the page knows beforehand are those of the library, in the order of its families', async () => {
  expect(LIBRARY_IDS).toEqual(LIBRARY_FAMILIES.flatMap(([, ids]) => ids));
  expect([...LIBRARY_IDS].sort()).toEqual(Object.keys(LIBRARY).sort());
  expect(firstRobot).toBe(LIBRARY[FIRST_ROBOT]);
  for (const id of LIBRARY_IDS) expect(await loadRobot(id)).toBe(LIBRARY[id]);
});

describe.each(Object.keys(tables))('%s', (id) => {
  const chain = compileRobot(LIBRARY[id]);

  test('has the numbers of its source, to the last digit that decimals can give', () => {
    const numbers = chain.joints.map((joint) => [joint.type, joint.a, joint.alpha, joint.d, joint.theta, joint.lower, joint.upper]); // prettier-ignore
    const { limits } = onPendant(LIBRARY[id], homePosture(LIBRARY[id]));
    for (const i of LIMITED_ON_AXIS[id] ?? []) {
      expect(LIBRARY[id].joints[i].controller.offset).not.toBe(0);
      numbers[i].splice(5, 2, ...[limits[i].lower, limits[i].upper].map((degrees) => (degrees * Math.PI) / 180));
    }
    expect(numbers).toHaveLength(tables[id].joints.length);
    tables[id].joints.forEach((row, i) =>
      row.forEach((expected, k) => {
        if (typeof expected === 'string') expect(numbers[i][k]).toBe(expected);
        else
          expect(Math.abs(Number(numbers[i][k]) - expected), `joint ${i + 1}, ${k}`).toBeLessThanOrEqual(ulp(expected));
      }),
    );
  });

  test('takes the tool where another program has it', () => {
    const { q, tcp } = forward[id];
    expect(q).toHaveLength(50);
    q.forEach((posture, i) => {
      const T = tcpPose(chain, posture);
      tcp[i].forEach((expected, k) => {
        const [row, column] = [Math.floor(k / 4), k % 4];
        const off = Math.abs(T[4 * column + row] - expected);
        expect(off).toBeLessThanOrEqual(1e-12 * (column === 3 ? chain.reach : 1));
      });
    });
  });
});

/** Degrees and millimetres that a person would type. @param {number} value */
const isRound = (value) => Number.isInteger(value) || Math.abs(value) < 1 || String(value).length <= 7;

test('limits are round where the source has them round', () => {
  const odd = Object.entries(LIBRARY).flatMap(([id, { joints }]) =>
    joints.some(({ lower, upper }) => !isRound(lower ?? 0) || !isRound(upper ?? 0)) ? [id] : [],
  );
  expect(odd.sort()).toEqual(['abb_irb120', 'fanuc_m10ia']); // these are rounded radians in their URDF: 2.87979, 3.14
});

describe.each(Object.entries(LIBRARY))('%s, as a person meets it', (_id, robot) => {
  test('names its source, stands as its table says, and has two limits and a home between them for every joint', () => {
    expect(robot.name).not.toBe('');
    expect(robot.info.source?.length).toBeGreaterThan(20);
    expect(robot.base).toEqual({ xyz: [0, 0, 0], rpy: [0, 0, 0] });
    expect(robot.tool).toEqual(robot.base);
    for (const { lower = NaN, upper = NaN, home = NaN } of robot.joints) {
      expect(home).toBeGreaterThan(lower);
      expect(home).toBeLessThan(upper);
    }
  });

  test('begins away from singularities', () => expect(leastMotion(robot)).toBeGreaterThan(0.05));
});

test('no two arms have the same name', () => {
  const names = Object.values(LIBRARY).map(({ name }) => name);
  expect(new Set(names).size).toBe(names.length);
});

describe.each([2, 3, 4, 5, 6])('a new robot with %d joints', (count) => {
  const robot = newRobot(count, 'Mine');

  test('has that many, and begins away from singularities and inside its limits', () => {
    expect(robot.joints).toHaveLength(count);
    expect(robot.name).toBe('Mine');
    expect(leastMotion(robot)).toBeGreaterThan(0.05);
    for (const { lower = NaN, upper = NaN, home = NaN } of robot.joints) {
      expect(home).toBeGreaterThan(lower);
      expect(home).toBeLessThan(upper);
    }
  });

  test('moves its tool with every joint', () => {
    const chain = compileRobot(robot);
    const home = homePosture(robot);
    const before = tcpPose(chain, compilePosture(robot, home));
    home.forEach((_, i) => {
      const turned = home.map((value, k) => (k === i ? value + 20 : value));
      const after = tcpPose(chain, compilePosture(robot, turned));
      const way = Math.hypot(...[12, 13, 14].map((k) => after[k] - before[k]));
      expect(way, `joint ${i + 1}`).toBeGreaterThan(0.01 * chain.reach);
    });
  });
});

test('a robot has 2 to 6 joints', () => {
  for (const count of [0, 1, 7, 2.5, NaN]) expect(() => newRobot(count, '')).toThrow('Expected 2 to 6 joints');
});

/**
 * The least singular value at home over the greatest, of the motion that the arm is made for: the place of its tool up to
 * three joints, the whole pose from six, and between them whatever its joints can do; of a wrist, its turning.
 * @param {import('../../../src/model/document.js').RobotDoc} robot
 */
function leastMotion(robot) {
  const chain = compileRobot(robot);
  const q = compilePosture(robot, homePosture(robot));
  const isWrist = robot.joints.every((joint) => !isSliding(joint) && joint.a === 0);
  const part = isWrist ? 'angular' : chain.dof <= 3 ? 'linear' : 'full';
  const { isotropy, freedoms } = dexterity(chain, q, { part });
  expect(freedoms).toBe(part === 'full' ? chain.dof : Math.min(chain.dof, robot.name === 'Planar 3R' ? 2 : 3));
  return isotropy;
}

test('the FANUC arms have their published coupling: on the pendant of the M-10iA J3 counts from the horizontal', () => {
  const coupledIn = (/** @type {typeof LIBRARY[string]} */ { joints }) =>
    joints.flatMap(({ controller: { coupledTo, coupling } }, i) => (coupledTo ? [[i, coupledTo, coupling]] : []));
  for (const [id, robot] of Object.entries(LIBRARY)) {
    expect(coupledIn(robot), id).toEqual(id.startsWith('fanuc_') ? [[2, 'joint_2', -1]] : []);
  }
  const robot = LIBRARY.fanuc_m10ia;
  const values = (/** @type {number[]} */ posture) => onPendant(robot, posture).values;
  const turned = (/** @type {number[]} */ posture) => {
    const T = tcpPose(compileRobot(robot), compilePosture(robot, posture));
    return [0, 1, 2, 4, 5, 6, 8, 9, 10].map((k) => T[k]);
  };
  // the arm leans by 30 degrees and the forearm stays level: on the pendant J3 stays
  const [upright, leaning] = [
    [0, 0, 0, 0, 0, 0],
    [0, 30, 30, 0, 0, 0],
  ];
  turned(leaning).forEach((value, k) => expect(value).toBeCloseTo(turned(upright)[k], 12));
  expect(values(leaning)[2]).toBeCloseTo(0, 12);
  expect(values([0, 0, 30, 0, 0, 0])[2]).toBeCloseTo(30, 12);
});
