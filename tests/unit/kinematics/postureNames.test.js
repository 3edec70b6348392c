/**
 * Names and controller codes of postures, judged by published postures, by the makers' definitions in joint angles, and by where
 * the frames of the plain matrices are.
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { PostureName } from '../../../src/kinematics/postureNames.js'
 * @import { Screws } from '../../../src/kinematics/screws.js'
 */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { fanucConfiguration, kukaStatusTurn, namePosture, prepareNames } from '../../../src/kinematics/postureNames.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { recogniseThreeParallel, solveThreeParallel } from '../../../src/kinematics/solvers/threeParallel.js';
import { recogniseWristPartition, solveWristPartition } from '../../../src/kinematics/solvers/wristPartition.js';
import { SEED, runs } from '../../helpers/property.js';
import { arm, columnMajor, oracleForward } from './oracle.js';

const RIGHT = Math.PI / 2;

/** @param {...[number, number, number, number]} rows  θ, d, a, α of a standard table @returns {ChainDescription} */
const turning = (...rows) => ({
  convention: 'standard',
  joints: rows.map(([theta, d, a, alpha]) => ({ type: 'revolute', theta, d, a, alpha })),
});

/** KUKA KR 6 R900 (kr6r900sixx_macro.xacro of ros-industrial/kuka_experimental), in KUKA's values but for the sign of A1. */
const KR6 = turning(
  [0, 0.4, 0.025, -RIGHT],
  [0, 0, 0.455, 0],
  [-RIGHT, 0, 0.035, RIGHT],
  [0, -0.42, 0, -RIGHT],
  [0, 0, 0, RIGHT],
  [0, -0.08, 0, Math.PI],
);

/** FANUC R-2000iB/165F with the tool of the published postures; its third value is J2 + J3. */
const R2000 = turning(
  [0, 0, 0.312, -RIGHT],
  [-RIGHT, 0, 1.075, Math.PI],
  [0, 0, 0.225, -RIGHT],
  [0, -1.28, 0, RIGHT],
  [0, 0, 0, -RIGHT],
  [0, -0.27, 0, Math.PI],
);

/** @type {Record<string, ChainDescription>} */
const SIX = { puma560: arm('puma560'), ur5: arm('ur5'), KR6, R2000 };

const screwsFor = (/** @type {ChainDescription} */ description) => screwsOf(createChain(description));
const namesFor = (/** @type {ChainDescription} */ description) => prepareNames(screwsFor(description));
const inDegrees = (/** @type {number[]} */ ...values) => values.map((value) => (value * Math.PI) / 180);

/** @param {number} count @param {number} dof */
function randomPostures(count, dof) {
  const random = createRandom(SEED);
  return Array.from({ length: count }, () => Array.from({ length: dof }, () => (random() - 0.5) * 2 * Math.PI));
}

/** @param {ChainDescription} description @param {number[]} q */
function everyPosture(description, q) {
  const chain = createChain(description);
  const goal = goalFromStart(chain, columnMajor(oracleForward(description, q).tcp));
  const screws = screwsOf(chain);
  const three = recogniseThreeParallel(screws);
  if (three) return solveThreeParallel(three, goal).postures;
  const wrist = recogniseWristPartition(screws);
  return wrist ? solveWristPartition(wrist, goal).postures : [];
}

describe.each(Object.entries(SIX))('%s', (_, description) => {
  const names = namesFor(description);
  test('all postures of a pose have names of their own', () => {
    let eights = 0;
    for (const q of randomPostures(runs(60), 6)) {
      const all = everyPosture(description, q).map((p) => namePosture(names, p));
      const told = all.map((one) => Object.values(one).join(' '));
      expect(told.join()).not.toMatch(/null/);
      expect(new Set(told).size).toBe(told.length);
      if (told.length === 8) eights++;
    }
    expect(eights).toBeGreaterThan(5);
  });
  test('full turns change nothing, nor which way round the axes after the first are counted, nor where their points are', () => {
    const screws = screwsFor(description);
    fc.assert(
      fc.property(
        fc.array(fc.double({ min: -3, max: 3, noNaN: true }), { minLength: 6, maxLength: 6 }),
        fc.array(fc.boolean(), { minLength: 6, maxLength: 6 }),
        fc.array(fc.integer({ min: -2, max: 2 }), { minLength: 6, maxLength: 6 }),
        (q, flips, turns) => {
          const signs = flips.map((flip, i) => (i > 0 && flip ? -1 : 1));
          /** @type {Screws} */
          const other = {
            ...screws,
            axes: screws.axes.map((value, k) => value * signs[Math.floor(k / 3)]),
            points: screws.points.map((value, k) => value + screws.axes[k] * turns[Math.floor(k / 3)] * 0.3),
          };
          const p = q.map((value, i) => signs[i] * (value + 2 * Math.PI * turns[i]));
          expect(namePosture(prepareNames(other), p)).toEqual(namePosture(names, q));
        },
      ),
      { seed: SEED, numRuns: runs(100) },
    );
  });
});

test.each(['puma560', 'KR6', 'R2000'])('%s: a spherical wrist turned over is the only thing that changes', (name) => {
  const names = namesFor(SIX[name]);
  for (const q of randomPostures(runs(60), 6)) {
    const here = namePosture(names, q);
    const over = q.map((value, i) => (i === 4 ? -value : i > 2 ? value + Math.PI : value));
    expect(namePosture(names, over)).toEqual({ ...here, wrist: here.wrist === 'flip' ? 'no-flip' : 'flip' });
  }
});

test.each(
  /** @type {[string, number, number][]} */ ([
    ['KR6', 1, -2.5],
    ['KR6', 2, 1.7],
    ['KR6', 4, 0.4],
    ['KR6', 4, RIGHT],
    ['R2000', 4, 0.4],
  ]),
)(
  'another zero in a table changes no name of an arm whose axis 2 is in front of axis 1: %s, q[%i] %d',
  (name, joint, zero) => {
    const { joints } = SIX[name];
    const moved = namesFor({
      convention: 'standard',
      joints: joints.map((row, i) => (i === joint ? { ...row, theta: row.theta + zero } : row)),
    });
    for (const q of randomPostures(runs(60), 6)) {
      expect(namePosture(moved, q.with(joint, q[joint] - zero))).toEqual(namePosture(namesFor(SIX[name]), q));
    }
  },
);

/** Where points of the arm are, forward of axis 1 and up, by the frames of a standard table. @param {ChainDescription} description @param {number[]} q @param {number} sign of forward along x of frame 0 at q1 = 0 */
function seenFromSide(description, q, sign) {
  const { frames } = oracleForward(description, q);
  return (/** @type {number} */ i) => [
    sign * (frames[i][0][3] * Math.cos(q[0]) + frames[i][1][3] * Math.sin(q[0])),
    frames[i][2][3],
  ];
}

/** How far the elbow is above the line from shoulder to wrist. @param {number[][]} points */
const rise = ([shoulder, elbow, wrist]) =>
  elbow[1] - shoulder[1] - ((wrist[1] - shoulder[1]) / (wrist[0] - shoulder[0])) * (elbow[0] - shoulder[0]);

describe('what the words mean, seen in the frames', () => {
  test.each(
    /** @type {[string, ChainDescription, number, number[]][]} */ ([
      // frames whose origins are at shoulder, elbow, end of the forearm, and the wrist that is in front or behind
      ['puma560', SIX.puma560, 1, [1, 2, 4, 4]],
      ['KR6', KR6, 1, [1, 2, 4, 4]],
      ['R2000', R2000, 1, [1, 2, 4, 4]],
      ['ur5', SIX.ur5, -1, [1, 2, 3, 5]],
    ]),
  )('%s', (_, description, sign, [shoulder, elbow, hand, wrist]) => {
    const names = namesFor(description);
    let seen = 0;
    for (const q of randomPostures(runs(150), 6)) {
      const at = seenFromSide(description, q, sign);
      const name = namePosture(names, q);
      expect(name.shoulder).toBe(at(wrist)[0] > 0 ? 'front' : 'back');
      // an arm that leans past axis 1 keeps the name it had
      const reach = at(hand)[0] - at(shoulder)[0];
      if (Math.sign(reach) !== Math.sign(at(wrist)[0])) continue;
      expect(name.elbow).toBe(rise([at(shoulder), at(elbow), at(hand)]) > 0 ? 'up' : 'down');
      seen++;
    }
    expect(seen).toBeGreaterThan(50);
  });
  test('a wrist that bends the tool down from a level forearm, its roll at zero, does not flip', () => {
    expect(namePosture(namesFor(KR6), inDegrees(20, -90, 90, 0, 30, 10)).wrist).toBe('no-flip');
    expect(namePosture(namesFor(KR6), inDegrees(20, -90, 90, 0, -30, 10)).wrist).toBe('flip');
    expect(namePosture(namesFor(R2000), inDegrees(0, 0, 0, 0, -30, 0)).wrist).toBe('no-flip');
  });
  test('a UR5 as it is mostly used', () => {
    expect(namePosture(namesFor(SIX.ur5), inDegrees(0, -75, 95, -110, -90, 0))).toEqual({
      shoulder: 'front',
      elbow: 'up',
      wrist: 'no-flip',
    });
  });
});

describe('borders', () => {
  /** @type {[string, number[], PostureName][]} */
  const cases = [
    ['wrist straight', inDegrees(10, -60, 90, 40, 0, 10), { shoulder: 'front', elbow: 'up', wrist: null }],
    ['wrist folded', inDegrees(10, -60, 90, 40, 180, 10), { shoulder: 'front', elbow: 'up', wrist: null }],
    [
      'arm straight',
      [0.1, -0.5, Math.atan2(0.035, 0.42), 0, 1, 0],
      { shoulder: 'front', elbow: null, wrist: 'no-flip' },
    ],
  ];
  test.each(cases)('%s', (_, q, name) => {
    const names = namesFor(KR6);
    expect(namePosture(names, q)).toEqual(name);
    const aside = namePosture(
      names,
      q.map((value) => value + 1e-6),
    );
    expect(Object.values(aside)).not.toContain(null);
  });
  test('wrist over axis 1: neither front nor back, and no elbow either', () => {
    // The forearm of a Puma: (0.4318, 0.0203) across; upper arm 0.4318. Upright, folded until the wrist is over the base.
    const names = namesFor(SIX.puma560);
    const upright = [0, RIGHT, Math.atan2(0.4318, 0.0203) - Math.PI, 0, 1, 0];
    expect(namePosture(names, upright.with(2, -Math.atan2(0.4318, 0.0203)))).toMatchObject({
      shoulder: null,
      elbow: null,
    });
    expect(namePosture(names, [0, RIGHT, 0, 0, 1, 0]).shoulder).toBe('back');
  });
});

describe('FANUC', () => {
  const names = namesFor(R2000);
  /** A published posture with both of its wrists (onerobotics.com, "The perils of six-axis robots", 2013). */
  const [J1, J2, J3, J4, J5, J6] = [7.962, -5.284, -36.25, 77.661, -51.975, -79.273];
  const NUT = inDegrees(J1, J2, J2 + J3, J4, J5, J6);
  const FUT = inDegrees(J1, J2, J2 + J3, J4 - 180, -J5, J6 + 180);

  test('the published posture and its twin', () => {
    const [, , , p] = columnMajor(oracleForward(R2000, NUT).tcp).reduce(
      (/** @type {number[][]} */ columns, value, i) => (columns[i >> 2].push(value), columns),
      [[], [], [], []],
    );
    expect(Math.hypot(p[0] - 1.5, p[1], p[2] - 0.36)).toBeLessThan(2e-5);
    expect(fanucConfiguration(names, NUT)).toEqual({ text: 'N U T, 0, 0, 0', reason: null });
    expect(fanucConfiguration(names, FUT)).toEqual({ text: 'F U T, 0, 0, 0', reason: null });
  });
  test('front and back by the sign of x of the wrist centre, up and down by J2 + J3', () => {
    for (const [, second, third, ...wrist] of randomPostures(runs(100), 6)) {
      // third = J2 + J3 from the forearm level at J2 = 0; pendant's J3 = third − second
      const x = 0.312 + 1.075 * Math.sin(second) + 1.28 * Math.cos(third - second) - 0.225 * Math.sin(third - second);
      const straight = RIGHT - Math.atan2(0.225, 1.28);
      const text = fanucConfiguration(names, [0.3, second, third, ...wrist]).text ?? '';
      expect(text[4]).toBe(x >= 0 ? 'T' : 'B');
      expect(text[2]).toBe(Math.sin(straight - third) > 0 ? 'U' : 'D');
      expect(text[0]).toBe(Math.sin(wrist[1]) < 0 ? 'N' : 'F');
    }
  });
  test('turn numbers count J1, J4 and J6, or what the controller is set to', () => {
    const turns = (/** @type {number[]} */ q, /** @type {[number, number, number] | undefined} */ turnAxes) =>
      fanucConfiguration(names, q, { axisValues: q, turnAxes }).text?.slice(7);
    expect(turns(inDegrees(179, 0, 0, -179, -20, 0), undefined)).toBe('0, 0, 0');
    expect(turns(inDegrees(180, 0, 0, -180, -20, 540), undefined)).toBe('1, -1, 2');
    expect(turns(inDegrees(539, 0, 0, -539, -20, -541), undefined)).toBe('1, -1, -2');
    expect(turns(inDegrees(190, 0, 0, 200, -20, -190), [4, 5, 6])).toBe('1, 0, -1');
    expect(fanucConfiguration(names, NUT, { axisValues: inDegrees(0, 0, 0, 400, 0, 0) }).text).toBe('N U T, 0, 1, 0');
  });
  test('on the border: N, U, T', () => {
    expect(fanucConfiguration(names, [0, 0, 0, 0, 0, 0]).text).toBe('N U T, 0, 0, 0');
    expect(fanucConfiguration(names, [0, 0, RIGHT - Math.atan2(0.225, 1.28), 0, 0, 0]).text).toBe('N U T, 0, 0, 0');
  });
});

describe('KUKA', () => {
  const names = namesFor(KR6);
  test('by the definitions in axis values', () => {
    const straight = Math.atan2(0.035, 0.42);
    for (const q of randomPostures(runs(100), 6)) {
      const [, A2, A3, , A5] = q;
      if (A3 < straight - Math.PI) continue;
      const x = 0.025 + 0.455 * Math.cos(A2) + 0.42 * Math.cos(A2 + A3) + 0.035 * Math.sin(A2 + A3);
      const status = (x < 0 ? 1 : 0) + (A3 >= straight ? 2 : 0) + (A5 < 0 ? 4 : 0);
      const turn = q.reduce((sum, value, i) => sum + (value < 0 ? 2 ** i : 0), 0);
      expect(kukaStatusTurn(names, q)).toEqual({ status, turn, reason: null });
      expect(kukaStatusTurn(names, q, { axisValues: q })).toEqual({ status, turn, reason: null });
    }
  });
  test('the home of a new program (A2 −90, A3 90), and all axes negative', () => {
    expect(kukaStatusTurn(names, inDegrees(0, -90, 90, 0, 0, 0))).toEqual({ status: 2, turn: 2, reason: null });
    expect(kukaStatusTurn(names, inDegrees(-1, -60, -10, -1, -1, -1))).toMatchObject({ status: 4, turn: 63 });
  });
  test('what the controller counts is asked where only it can tell', () => {
    const q = inDegrees(10, -90, 90, 0, 20, 30);
    expect(kukaStatusTurn(names, q)).toMatchObject({ status: 2, turn: 2 });
    expect(kukaStatusTurn(names, q, { axisValues: inDegrees(-10, -90, 90, 0, -20, 30) })).toMatchObject({
      status: 6,
      turn: 2 + 1 + 16,
    });
    // a value of 350° is not negative, but the axis stands where −10° would have it
    expect(kukaStatusTurn(names, q, { axisValues: inDegrees(10, -90, 90, 0, 350, 30) })).toMatchObject({
      status: 6,
      turn: 2,
    });
  });
});

describe('arms of which less can be said', () => {
  const none = { shoulder: null, elbow: null, wrist: null };
  /** @param {ChainDescription} description @param {number[]} q @param {number[]} [up] */
  const nameOf = (description, q, up) => namePosture(prepareNames(screwsFor(description), up), q);

  test('a SCARA is righty with its elbow on the right, seen from above, and as named by its base', () => {
    const scara = arm('scara_cobra600');
    expect(nameOf(scara, [0.3, 0.8, 0.1, 0])).toEqual({ ...none, elbow: 'righty' });
    expect(nameOf(scara, [0.3, -0.8, 0.1, 0])).toEqual({ ...none, elbow: 'lefty' });
    expect(nameOf(scara, [0.3, -0.8, 0.1, 0], [0, 0, -1])).toEqual({ ...none, elbow: 'righty' });
    expect(nameOf(scara, [0.3, 0, 0.1, 0])).toEqual(none);
    const turnedOver = scara.joints.map((row, i) => (i === 0 ? { ...row, alpha: Math.PI } : row));
    expect(nameOf({ ...scara, joints: turnedOver }, [0.3, -0.8, 0.1, 0])).toEqual({ ...none, elbow: 'righty' });
  });
  test('a planar arm that stands has its elbow up or down, whichever way it reaches', () => {
    const planar = arm('planar2r');
    expect(nameOf(planar, [0.3, 0.8])).toEqual({ ...none, elbow: 'righty' });
    // y of the plane is up: the axis points at who looks
    const up = [0, 1, 0];
    for (const q of randomPostures(runs(100), 2)) {
      const [elbow, hand] = [1, 2].map((i) => oracleForward(planar, q).frames[i].map((row) => row[3]));
      const above = elbow[1] - (hand[1] / hand[0]) * elbow[0];
      expect(nameOf(planar, q, up).elbow).toBe(above > 0 ? 'up' : 'down');
    }
    expect(nameOf(planar, [RIGHT - 0.4, 0.8], up)).toEqual(none);
  });
  test('three axes: shoulder and elbow; six that do not meet: nothing', () => {
    const three = { ...KR6, joints: KR6.joints.slice(0, 3) };
    expect(
      nameOf(
        { ...three, joints: [...three.joints.slice(0, 2), { ...three.joints[2], a: 0.4, theta: 0 }] },
        inDegrees(5, -60, 70),
      ),
    ).toEqual({ shoulder: 'front', elbow: 'up', wrist: null });
    const apart = { ...KR6, joints: KR6.joints.map((row, i) => (i === 3 ? { ...row, a: 0.1 } : row)) };
    expect(nameOf(apart, [1, 1, 1, 1, 1, 1])).toEqual(none);
  });
  test.each(
    /** @type {[string, ChainDescription, string][]} */ ([
      ['two axes', arm('planar2r'), 'not-six-axes'],
      ['UR5', arm('ur5'), 'no-spherical-wrist'],
      [
        'a slide',
        { ...KR6, joints: KR6.joints.map((row, i) => (i === 2 ? { ...row, type: 'prismatic' } : row)) },
        'prismatic',
      ],
      [
        'axes 1 and 2 parallel',
        { ...KR6, joints: KR6.joints.map((row, i) => (i === 0 ? { ...row, alpha: 0 } : row)) },
        'no-shoulder',
      ],
      [
        'axes 2 and 3 not',
        { ...KR6, joints: KR6.joints.map((row, i) => (i === 1 ? { ...row, alpha: 0.3 } : row)) },
        'no-elbow',
      ],
      [
        'axes 2 and 3 one',
        { ...KR6, joints: KR6.joints.map((row, i) => (i === 1 ? { ...row, a: 0 } : row)) },
        'no-elbow',
      ],
    ]),
  )('%s: no code, and why', (_, description, reason) => {
    const names = namesFor(description);
    const q = description.joints.map(() => 0.5);
    expect(names.noCode).toBe(reason);
    expect(fanucConfiguration(names, q)).toEqual({ text: null, reason });
    expect(kukaStatusTurn(names, q)).toEqual({ status: null, turn: null, reason });
  });
  test('wrong calls throw', () => {
    const names = namesFor(KR6);
    expect(() => namePosture(names, [0, 0])).toThrow('Expected 6 joint values, got 2.');
    expect(() => fanucConfiguration(names, [0, 0, 0, 0, NaN, 0])).toThrow('joint value 5');
    expect(() => kukaStatusTurn(names, [0, 0, 0, 0, 0, 0], { axisValues: [1] })).toThrow('got 1');
  });
});
