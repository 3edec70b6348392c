/**
 * Where code would take the arm, without taking it there: its motions from where the arm stands, each with the lines that it belongs
 * to, in its own program and in those that called it. Inputs are taken to come; registers hold what a person gave them.
 *
 * @import { CodeRun } from './codeDebugger.js'
 * @import { Doc, ProgramDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { CodePath } from './codeScene.js'
 * @import { RegisterSetting } from './givenRegisters.js'
 *
 * @typedef {object} PreviewMove
 * @property {readonly { readonly id: string, readonly line: number }[]} lines   of the document's programs, the outermost first
 * @property {readonly number[]} posture   at its end, in document units
 * @property {Float64Array[]} way          places of the tool, seen from the world, m
 *
 * @typedef {{ id: string, line: number, message: string }} PreviewFault
 * @typedef {{ moves: readonly PreviewMove[], faults: readonly PreviewFault[] }} Preview
 */
import { tcpPose } from '../../kinematics/forward.js';
import { compilePosture, compileRobot, postureFromKernel } from '../compile.js';
import { codeSet } from '../controller/codeSets.js';
import { postureAlong } from '../controller/followMoves.js';
import { codeArm } from './codeArm.js';
import { systemAtFirst } from './codeFrames.js';
import { movesOf } from './codeMoves.js';
import { readInSlices } from './codePrograms.js';
import { createCodeRun } from './codeRun.js';
import { comingInputs } from './comingInputs.js';

const MOST_MOVES = 100;
const MOST_STEPS = 20_000;
const MOST_EFFECTS = 4000;
/** Places along a way. */
const PLACES = 24;

/**
 * @param {Doc} doc
 * @param {string} id  of the program; one that another calls is looked at where that calls it
 * @param {readonly RegisterSetting[]} [given]
 * @returns {Generator<null | void, Preview, void>}  a turn for each motion, and for some statements that are read
 */
export function* previewOf(doc, id, given = []) {
  /** @type {PreviewMove[]} */
  const moves = [];
  /** @type {PreviewFault[]} */
  const faults = [];
  const preview = { moves, faults };
  const chain = compileRobot(doc.robot);
  let now = doc;
  const read = yield* readInSlices(doc.programs);
  const begin = (/** @type {string} */ first) =>
    createCodeRun(
      doc.programs,
      first,
      codeArm(() => now),
      systemAtFirst(doc),
      {
        ...{ steps: MOST_STEPS, traceSteps: false, endsWithFirst: true, onScan: comingInputs(doc.programs) },
      },
      read,
    );
  const chosen = /** @type {ProgramDoc} */ (doc.programs.find((one) => one.id === id));
  const caller = codeSet(doc.programs, chosen)[0].program.id;
  let made = begin(caller);
  if (!('run' in made) && caller !== id) made = begin(id);
  if (!('run' in made)) return preview;
  const { run } = made;
  for (const setting of given) run.setRegister(...setting);
  /** Where the arm is after a motion that cannot be made is not known. */
  let isLost = false;
  for (let effects = 0; effects < MOST_EFFECTS && moves.length < MOST_MOVES; effects++) {
    const { kind, effect } = run.advance(
      () => false,
      MOST_STEPS,
      () => null,
    );
    if (kind === 'over') {
      const { alarm } = run.outcome() ?? {};
      const id_ = run.stack().at(-1)?.id;
      if (alarm && alarm.code !== 'faulty' && id_ !== undefined)
        faults.push({ id: id_, line: alarm.line, message: alarm.reason });
      return preview;
    }
    if (effect?.kind === 'read') return preview;
    if (effect?.kind !== 'move') continue;
    const lines = linesOf(run, Number(effect.line));
    const start = compilePosture(now.robot, now.posture);
    if (isLost && effect.motion !== 'J' && !effect.settings) continue;
    const found = withinLimits(movesOf(now, start, effect, run.state().system), chain);
    isLost = 'message' in found;
    if ('message' in found) {
      const { id: at, line } = lines[lines.length - 1];
      if (!faults.some((one) => one.id === at && one.line === line))
        faults.push({ id: at, line, message: found.message });
    } else {
      for (const { move } of found.moves) {
        const { path, end } = move.followed;
        const way = Array.from({ length: PLACES + 1 }, (_, k) =>
          tcpPose(chain, postureAlong(path, k / PLACES)).slice(12, 15),
        );
        const posture = postureFromKernel(now.robot, end);
        moves.push({ lines, posture, way });
        now = { ...now, posture };
      }
    }
    yield;
  }
  return preview;
}

/** Motions by joints, too, end within their limits. @param {ReturnType<typeof movesOf>} found @param {Chain} chain @returns {ReturnType<typeof movesOf>} */
function withinLimits(found, { joints }) {
  const isPast = (/** @type {Float64Array} */ end) =>
    end.some((value, i) => value < joints[i].lower || value > joints[i].upper);
  const past =
    'moves' in found && found.moves.some(({ move }) => move.kernel.kind === 'joint' && isPast(move.followed.end));
  return past ? { message: 'a joint would have to go past its limit' } : found;
}

/** @param {CodeRun} run @param {number} line  where the top is */
const linesOf = (run, line) =>
  run.stack().map((frame, i, all) => ({ id: frame.id, line: i === all.length - 1 ? line : frame.line }));

/** The first motion that belongs to a line of a program. @param {Preview} preview @param {string} id @param {number} line */
export const moveOfLine = ({ moves }, id, line) =>
  moves.find(({ lines }) => lines.some((one) => one.id === id && one.line === line)) ?? null;

/** The path as the scene draws it, with the lines of one program. @param {Preview} preview @param {string} id @returns {CodePath | null} null: nothing moves */
export function pathOf({ moves }, id) {
  if (moves.length === 0) return null;
  const places = moves.flatMap(({ way }) => way);
  const times = Float64Array.from(places, (_, k) => k);
  const axis = (/** @type {number} */ i) => Float64Array.from(places, (at) => at[i]);
  const ends = moves.flatMap(({ lines }, k) => {
    const own = lines.findLast((one) => one.id === id);
    return own ? [{ time: (k + 1) * (PLACES + 1) - 1, step: own.line - 1 }] : [];
  });
  const series = { times, place: [0, 1, 2].map(axis), speed: new Float64Array(times.length) };
  return {
    shown: { series, most: 0, dotEvery: times.length, ends },
    points: ends.map(({ time, step }) => ({ at: [...places[time]], line: step + 1 })),
  };
}
