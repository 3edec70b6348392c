/** Programs that are written as code and read again, on twelve arms: by chance, and one with everything. */
import fc from 'fast-check';
import { writeKarelMove } from '../../../src/karel/write/karelMove.js';
import { writeKrl } from '../../../src/karel/write/krl.js';
import { writePair } from '../../../src/karel/write/pair.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { limitsOf } from '../../../src/model/document.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { poseInUnits } from '../../../src/model/numbers/poseNumbers.js';

/** @import { Doc, StepDoc } from '../../../src/model/document.js' */
/** @import { MadeProgram } from '../../../src/model/controller/neutralProgram.js' */

export const ARMS = [
  ...['puma560', 'kuka_kr5_arc', 'kuka_kr6_r900', 'kuka_kr210_l150', 'fanuc_lrmate200id', 'fanuc_m10ia', 'abb_irb120'],
  ...['abb_irb140', 'ur5', 'stanford', 'scara_cobra600', 'planar3r'],
];
export const WRITERS = /** @type {const} */ ([
  [writeTp, 'fanuc'],
  [writePair, 'fanuc'],
  [writeKarelMove, 'fanuc'],
  [writeKrl, 'kuka'],
]);
export const WRITTEN = { version: '0.1.0', generatedAt: '2026-07-01T12:00:00Z' };

/** @typedef {{ kind: string, to: number[], speed: number, ending: { kind: string, value?: number } }} WantedStep */

const share = fc.double({ min: 0, max: 1, noNaN: true });
export const anyStep = fc.record({
  kind: fc.constantFrom('joint', 'joint-pose', 'linear', 'linear', 'circular', 'wait', 'output', 'input', 'comment'),
  to: fc.array(share, { minLength: 12, maxLength: 12 }),
  speed: fc.integer({ min: 1, max: 100 }),
  ending: fc.oneof(
    fc.constant({ kind: 'fine' }),
    fc.record({ kind: fc.constantFrom('percent', 'distance'), value: fc.integer({ min: 1, max: 50 }) }),
  ),
});

/** A program whose poses are those of postures near each other, so that most ways can be followed. @param {string} arm @param {readonly WantedStep[]} wanted @returns {Doc} */
export function documentOf(arm, wanted) {
  const doc = newDocument(LIBRARY[arm]);
  const { robot } = doc;
  const chain = compileRobot(robot);
  let here = [...doc.posture];
  const near = (
    /** @type {readonly number[]} */ from,
    /** @type {readonly number[]} */ shares,
    /** @type {number} */ range,
  ) =>
    from.map((value, i) => {
      const { lower, upper } = limitsOf(robot.joints[i]);
      return Math.min(upper, Math.max(lower, value + (shares[i] - 0.5) * range));
    });
  const pose = (/** @type {readonly number[]} */ q) => ({
    kind: /** @type {const} */ ('pose'),
    ...poseInUnits(tcpPose(chain, compilePosture(robot, q)), robot.units),
  });
  const steps = wanted.map(({ kind, to, speed, ending }, i) => {
    const id = `s${i}`;
    if (kind === 'wait') return { id, kind, seconds: speed / 400 }; // each scan of it is an effect
    if (kind === 'output') return { id, kind: 'set-output', output: speed, value: to[0] > 0.5 ? 'on' : 'off' };
    if (kind === 'input') return { id, kind: 'wait-input', input: speed, value: to[0] > 0.5 ? 'on' : 'off' };
    if (kind === 'comment') return { id, kind, text: `at; ${speed} % 'é'` };
    const isJoint = kind.startsWith('joint');
    const middle = near(here, to, isJoint ? 60 : 8);
    const end = isJoint ? middle : near(middle, to.slice(6), 8);
    here = end;
    const target = kind === 'joint' ? { kind: 'posture', values: end } : pose(end);
    const manner = {
      acceleration: 10 + speed / 2,
      ending,
      speed: isJoint ? speed : 5 * speed,
      speedUnit: isJoint ? '%' : 'length/s',
    };
    return { id, kind: isJoint ? 'joint' : kind, target, ...(kind === 'circular' && { via: pose(middle) }), ...manner };
  });
  return { ...doc, motionPrograms: [{ id: 'm', name: 'Round trip', steps: /** @type {StepDoc[]} */ (steps) }] };
}

/** As much of the program as the arm can do. @param {Doc} doc @param {'fanuc' | 'kuka'} brand @returns {{ doc: Doc, made: MadeProgram } | null} */
export function madeOf(doc, brand) {
  const [program] = doc.motionPrograms;
  for (let steps = program.steps; steps.length > 0;) {
    const own = { ...doc, motionPrograms: [{ ...program, steps }] };
    const { made, issues } = neutralProgram(own, own.motionPrograms[0], { brand, ...WRITTEN });
    if (made) return { doc: own, made };
    const at = Number(/steps\.(\d+)/.exec(issues[0].path)?.[1] ?? -1);
    if (at < 0) return null;
    steps = steps.toSpliced(at, 1);
  }
  return null;
}

/** One program with everything, on arms of both brands. */
const shares = (/** @type {number} */ from) => Array.from({ length: 12 }, (_, i) => ((i * 37 + from * 11) % 100) / 100);
export const FIXED = ['joint', 'linear', 'joint-pose', 'circular', 'output', 'linear'].map((kind, i) => ({
  ...{ kind, to: shares(i), speed: 20 + i },
  ending: i % 2 ? { kind: 'fine' } : { kind: 'percent', value: 50 },
}));
export const fixed = (/** @type {string} */ arm, /** @type {'fanuc' | 'kuka'} */ brand) => {
  const tried = madeOf(documentOf(arm, FIXED), brand);
  if (!tried) throw new Error('Expected a program.');
  return tried;
};
