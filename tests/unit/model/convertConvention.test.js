/** Standard ↔ modified: the same robot by plain matrices, and the same numbers there and back. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { applyCommand } from '../../../src/model/commands.js';
import { compilePose, compilePosture, compileRobot } from '../../../src/model/compile.js';
import { refusal } from '../../../src/model/refusals.js';
import { validateDocument } from '../../../src/model/validate.js';
import { SEED, runs } from '../../helpers/property.js';
import { largestDifference, oracleForward, rowsOf, times } from '../kinematics/oracle.js';

/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/document.js').Convention} Convention */
/** @typedef {import('../../../src/model/document.js').JointDoc} JointDoc */
/** @typedef {import('../../../src/model/document.js').PoseDoc} PoseDoc */

const between = (/** @type {number} */ min, /** @type {number} */ max) => fc.double({ min, max, noNaN: true });
/** Zero lengths (axes that meet), twists of 0 and ±180° (parallel, antiparallel), right angles, and any. */
const length = fc.oneof(fc.constant(0), fc.integer({ min: -900, max: 900 }), between(-1000, 1000));
const degrees = fc.oneof(
  fc.constantFrom(0, 0, 180, -180, 90, -90),
  fc.integer({ min: -179, max: 180 }),
  between(-180, 180),
);
const vector = (/** @type {fc.Arbitrary<number>} */ of, /** @type {number} */ n) =>
  fc.array(of, { minLength: n, maxLength: n });
const quaternion = vector(between(-1, 1), 4)
  .filter((q) => Math.hypot(...q) > 0.1)
  .map((q) => q.map((value) => value / Math.hypot(...q)));

/** @type {fc.Arbitrary<PoseDoc>} none, a link, a shift, and any, written either way */
const pose = fc.oneof(
  fc.constant({ xyz: [0, 0, 0], rpy: [0, 0, 0] }),
  fc.tuple(length, degrees).map(([a, alpha]) => ({ xyz: [a, 0, 0], rpy: [alpha, 0, 0] })),
  vector(length, 3).map((xyz) => ({ xyz, rpy: [0, 0, 0] })),
  fc.record({ xyz: vector(length, 3), rpy: vector(degrees, 3) }, { noNullPrototype: true }),
  fc.record({ xyz: vector(length, 3), quaternion }, { noNullPrototype: true }),
);
const row = fc.record({
  ...{ theta: degrees, d: length, a: length, alpha: degrees },
  type: fc.constantFrom(
    /** @type {const} */ ('revolute'),
    /** @type {const} */ ('revolute'),
    /** @type {const} */ ('prismatic'),
  ),
});

/** @type {fc.Arbitrary<Doc>} */
const anyDoc = fc
  .record({
    convention: fc.constantFrom(/** @type {const} */ ('standard'), /** @type {const} */ ('modified')),
    ...{ base: pose, tool: pose, mount: pose },
    rows: fc.array(row, { minLength: 2, maxLength: 6 }),
    values: vector(between(-200, 200), 6),
  })
  .map(({ convention, base, tool, mount, rows, values }) => ({
    robot: {
      ...{ name: 'any', info: {}, units: { length: 'mm', angle: 'deg' }, convention, base, tool },
      joints: rows.map((numbers, i) => ({
        ...{ id: `joint_${i + 1}`, ...numbers, link: { kind: 'auto' } },
        controller: { sign: 1, offset: 0, coupling: 0 },
      })),
    },
    posture: values.slice(0, rows.length),
    postures: [],
    frames: [{ kind: 'tool', id: 't', ...mount }],
    targets: [],
    obstacles: [],
    motionPrograms: [],
    programs: [],
    extensions: [],
  }));

/** @param {Convention} convention @returns {Convention} */
const other = (convention) => (convention === 'standard' ? 'modified' : 'standard');
/** @param {Doc} doc @param {Convention} [convention] */
const convert = (doc, convention = other(doc.robot.convention)) =>
  applyCommand(doc, { type: 'convert-convention', convention });

/**
 * By plain matrices: the tool, the frame on the flange, and each joint's axis as a line (direction and moment).
 * @param {Doc} doc
 */
function described({ robot, posture, frames }) {
  const { frames: T, tcp } = oracleForward(compileRobot(robot), compilePosture(robot, posture));
  const mount = times(T[T.length - 1], rowsOf(compilePose(frames[0], robot.units)));
  const axes = robot.joints.map((_, i) => {
    const [[, , x, px], [, , y, py], [, , z, pz]] = T[robot.convention === 'standard' ? i : i + 1];
    return [x, y, z, py * z - pz * y, pz * x - px * z, px * y - py * x];
  });
  return { tcp, mount, axes };
}

test('the tool, the flange and all joint axes are the same in every posture, to 1e-12', () => {
  fc.assert(
    fc.property(anyDoc, (doc) => {
      const now = convert(doc);
      expect(now.robot.convention).toBe(other(doc.robot.convention));
      expect(validateDocument(now)).toEqual([]);
      const [old, same] = [described(doc), described(now)];
      // lengths are metres here and reach a few of them
      expect(largestDifference(old.tcp, same.tcp)).toBeLessThan(1e-12);
      expect(largestDifference(old.mount, same.mount)).toBeLessThan(1e-12);
      expect(largestDifference(old.axes, same.axes)).toBeLessThan(1e-12);
    }),
    { seed: SEED, numRuns: runs(500) },
  );
});

test('those 500 chains have parallel, antiparallel and intersecting axes, and slides, often enough', () => {
  const docs = fc.sample(anyDoc, { seed: SEED, numRuns: 500 });
  /** @param {(joint: JointDoc) => boolean} has @param {boolean} [alsoLast]  the last link leads to no further axis */
  const count = (has, alsoLast = false) =>
    docs.filter(({ robot: { joints, convention } }) => {
      const links = alsoLast ? joints : convention === 'standard' ? joints.slice(0, -1) : joints.slice(1);
      return links.some(has);
    }).length;
  expect(count(({ alpha, a }) => alpha === 0 && a !== 0)).toBeGreaterThan(50);
  expect(count(({ alpha, a }) => Math.abs(alpha) === 180 && a !== 0)).toBeGreaterThan(50);
  expect(count(({ alpha, a }) => a === 0 && alpha % 180 !== 0)).toBeGreaterThan(50);
  expect(count(({ type }) => type === 'prismatic', true)).toBeGreaterThan(50);
});

test('there and back gives the same robot, and the same numbers where base and tool are not used', () => {
  const none = { xyz: [0, 0, 0], rpy: [0, 0, 0] };
  fc.assert(
    fc.property(anyDoc, (doc) => {
      const back = convert(convert(doc));
      expect(largestDifference(described(doc).tcp, described(back).tcp)).toBeLessThan(2e-12);
      const plain = { ...doc, robot: { ...doc.robot, base: none, tool: none }, frames: [] };
      const written = (/** @type {unknown} */ value) => JSON.parse(JSON.stringify(value)); // minus zero is written as zero
      expect(written(convert(convert(plain)))).toEqual(written(plain));
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});

/** @param {Partial<JointDoc>} numbers @param {number} i @returns {JointDoc} */
const joint = (numbers, i) => ({
  ...{ id: `joint_${i + 1}`, type: 'revolute', theta: 0, d: 0, a: 0, alpha: 0, ...numbers, link: { kind: 'auto' } },
  controller: { sign: 1, offset: 0, coupling: 0 },
});
/** @param {Partial<Doc['robot']>} more @param {Partial<JointDoc>[]} rows @returns {Doc} */
const docOf = (more, rows) => ({
  robot: {
    ...{ name: 'test', info: {}, units: { length: 'mm', angle: 'rad' }, convention: 'standard' },
    base: { xyz: [0, 0, 0], rpy: [0, 0, 0] },
    tool: { xyz: [0, 0, 0], rpy: [0, 0, 0] },
    ...more,
    joints: rows.map(joint),
  },
  ...{
    posture: rows.map(() => 0),
    postures: [],
    frames: [],
    targets: [],
    obstacles: [],
    motionPrograms: [],
    programs: [],
    extensions: [],
  },
});

describe('the numbers', () => {
  const half = { alpha: Math.PI / 2, text: { alpha: 'pi/2', d: '4*5' }, d: 20 };

  test('of a link move one row down, with what was typed; the last go into the tool', () => {
    const { robot } = convert(
      docOf({}, [
        { a: 100, ...half },
        { a: 250, theta: 1 },
      ]),
    );
    expect(robot.joints).toEqual([
      joint({ d: 20, text: { d: '4*5' } }, 0),
      joint({ a: 100, theta: 1, alpha: Math.PI / 2, text: { alpha: 'pi/2' } }, 1),
    ]);
    expect(robot.tool).toEqual({ xyz: [250, 0, 0], rpy: [0, 0, 0] });
    expect(robot.base).toEqual({ xyz: [0, 0, 0], rpy: [0, 0, 0] });
  });

  test('of the first link go into the base when the other way round, behind what is there', () => {
    const base = { xyz: [0, 0, 500], rpy: [0, 0, Math.PI / 2] };
    const { robot } = convert(docOf({ convention: 'modified', base }, [{ a: 100, alpha: 0.25 }, { a: 30 }]));
    expect(robot.base).toEqual({ xyz: [0, 100, 500], rpy: [0.25, 0, Math.PI / 2] });
    expect(robot.joints.map(({ a, alpha }) => [a, alpha])).toEqual([
      [30, 0],
      [0, 0],
    ]);
  });

  test('right angles stay exact in a tool that is used', () => {
    const { robot } = convert(docOf({ tool: { xyz: [0, 0, 100], rpy: [0, 0, 0] } }, [{}, { alpha: -Math.PI / 2 }]));
    expect(robot.tool).toEqual({ xyz: [0, 100, 0], rpy: [-Math.PI / 2, 0, 0] });
  });

  test('gather no dirt in degrees and tenths', () => {
    const units = /** @type {const} */ ({ length: 'm', angle: 'deg' });
    const tool = { xyz: [0.2, 0, 0], rpy: [0.2, 0, 0] };
    const { robot } = convert(docOf({ units, tool }, [{}, { a: 0.1, alpha: 0.1 }]));
    expect(robot.tool).toEqual({ xyz: [0.3, 0, 0], rpy: [0.3, 0, 0] });
  });
});

test('what is converted saves and opens', () => {
  fc.assert(
    fc.property(anyDoc, (doc) => {
      const now = convert(doc);
      const { doc: opened } = readRobotXml(writeRobotXml(now));
      expect(opened?.robot).toEqual(now.robot);
    }),
    { seed: SEED, numRuns: runs(50) },
  );
});

test('reading the numbers in the other order keeps them all, and is another robot', () => {
  const doc = docOf({}, [{ a: 100, alpha: 1 }, { a: 250 }]);
  const now = applyCommand(doc, { type: 'reinterpret-convention', convention: 'modified' });
  expect(now).toEqual({ ...doc, robot: { ...doc.robot, convention: 'modified' } });
  expect(now.robot.joints).toBe(doc.robot.joints);
  expect(applyCommand(now, { type: 'reinterpret-convention', convention: 'modified' })).toBe(now);
  expect(convert(doc, 'standard')).toBe(doc);
});

test('a base that would be beyond 10⁹, and what is no convention, are refused', () => {
  const far = docOf({ convention: 'modified', base: { xyz: [8e8, 0, 0], rpy: [0, 0, 0] } }, [{ a: 8e8 }, {}]);
  const reason = (/** @type {string} */ convention) =>
    refusal(far, { type: 'convert-convention', convention: /** @type {Convention} */ (convention) })?.message;
  expect(reason('standard')).toBe('What base or tool would have to take is beyond 10⁹.');
  expect(reason('modified')).toBeUndefined();
  expect(reason('craig')).toBe('Expected standard or modified as the convention, got "craig".');
});
