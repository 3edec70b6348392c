/** Code that is written of a motion program, run under the debugger: the arm gets to where the program has it, in every language. */
import { expect, test } from 'vitest';
import { writeKarelMove } from '../../../src/karel/write/karelMove.js';
import { writeKrl } from '../../../src/karel/write/krl.js';
import { writePair } from '../../../src/karel/write/pair.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { codeArm } from '../../../src/model/code/codeArm.js';
import { systemAtFirst } from '../../../src/model/code/codeFrames.js';
import { planOfMove } from '../../../src/model/code/codeMoves.js';
import { previewOf } from '../../../src/model/code/codePreview.js';
import { createCodeRun } from '../../../src/model/code/codeRun.js';
import { compilePosture, compileRobot, postureFromKernel } from '../../../src/model/compile.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { motionMoves } from '../../../src/model/program/motionPlan.js';
import { readySteps } from '../../helpers/readySteps.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';

/** @import { Doc, ProgramDoc } from '../../../src/model/document.js' */
/** @import { ReadyWords } from '../../../src/model/program/readyPrograms.js' */

const WRITERS = /** @type {const} */ ([
  ['tp', writeTp, 'fanuc'],
  ['pair', writePair, 'fanuc'],
  ['karel-move', writeKarelMove, 'fanuc'],
  ['krl', writeKrl, 'kuka'],
]);
const words = /** @type {ReadyWords} */ (/** @type {unknown} */ (new Proxy({}, { get: () => 'text' })));

/** @returns {Doc} */
function written() {
  const doc = newDocument(firstRobot);
  const steps = readySteps(doc, 'pick-and-place', words);
  if (!steps) throw new Error('Expected a ready program.');
  const program = { id: 'pick', name: 'pick', steps: steps.map((step, i) => ({ ...step, id: `s${i}` })) };
  return /** @type {Doc} */ ({ ...doc, motionPrograms: [program] });
}

/** Where the tool is after each motion of the program itself, seen from the world. @param {Doc} doc */
function wanted(doc) {
  const { moves } = motionMoves(doc, doc.motionPrograms[0]);
  const chain = compileRobot(doc.robot);
  return moves.flatMap((move) =>
    move.kind === 'wait' ? [] : [[...('T_base_tcp' in move ? move.T_base_tcp : tcpPose(chain, move.posture))]],
  );
}

for (const [name, write, brand] of WRITERS)
  test(`${name}: every motion ends where the program has it, and each line is known`, () => {
    const doc = written();
    const { made, issues } = neutralProgram(doc, doc.motionPrograms[0], {
      brand,
      version: '1',
      generatedAt: '2026-01-01T00:00:00Z',
    });
    if (!made) throw new Error(issues[0].message);
    const programs = write(made.program).files.map(({ name: file, language, text }) => ({
      id: file.replace(/\.(\w+)$/, (_, end) => (end === 'dat' ? '_dat' : '')),
      ...{ language, text: text.replaceAll('\r\n', '\n') },
    }));
    const own = { ...doc, programs };
    let now = own;
    const opened = createCodeRun(
      programs,
      programs[0].id,
      codeArm(() => now),
      systemAtFirst(own),
    );
    if (!('run' in opened)) throw new Error(opened.diagnostics[0].message);
    const { run } = opened;
    const chain = compileRobot(doc.robot);
    const ends = [];
    for (let i = 0; i < 5000; i++) {
      const { kind, effect } = run.advance(
        () => false,
        1000,
        () => null,
      );
      if (kind === 'over') {
        expect(run.outcome()).toMatchObject({ status: 'ended' });
        break;
      }
      if (effect?.kind !== 'move') continue;
      const planned = planOfMove(now, now.posture, effect, run.state().system);
      if (!('plan' in planned)) throw new Error(`${effect.line}: ${planned.message}`);
      expect(planned.plan.refused).toBeNull();
      const { posture } = planMomentAt(planned.plan, planned.plan.duration);
      now = { ...now, posture: postureFromKernel(own.robot, posture) };
      ends.push([...tcpPose(chain, posture)]);
    }
    const all = wanted(doc);
    // a way to where the program begins may come first
    expect(ends.length - all.length).toBeGreaterThanOrEqual(0);
    expect(ends.length - all.length).toBeLessThan(2);
    ends.slice(-all.length).forEach((T, i) => T.forEach((value, k) => expect(value).toBeCloseTo(all[i][k], 5)));

    const finding = previewOf(own, programs[0].id);
    let next = finding.next();
    while (!next.done) next = finding.next();
    expect(next.value.faults).toEqual([]);
    expect(next.value.moves).toHaveLength(ends.length);
    expect(next.value.moves.every(({ lines }) => lines.every(({ line, id }) => line > 0 && id !== ''))).toBe(true);
    expect(compilePosture(own.robot, next.value.moves[ends.length - 1].posture)).toHaveLength(6);
  });
