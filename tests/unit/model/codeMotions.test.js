/** Time goes on while the arm moves: other statements run on the way, and going back puts program and arm back, on the way too. */
import { expect, test } from 'vitest';
import { codeArm } from '../../../src/model/code/codeArm.js';
import { systemAtFirst } from '../../../src/model/code/codeFrames.js';
import { createCodeMotions } from '../../../src/model/code/codeMotions.js';
import { createCodeRun } from '../../../src/model/code/codeRun.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { firstRobot } from '../../../src/model/shelf.js';

/** @import { CodeRun } from '../../../src/model/code/codeDebugger.js' */
/** @import { MotionMark } from '../../../src/model/code/codeMotions.js' */
/** @import { Doc } from '../../../src/model/document.js' */

/** A program on an arm that stands where it is put. @param {string} text */
function runOf(text) {
  let /** @type {Doc} */ doc = newDocument(firstRobot);
  /** @type {CodeRun | null} */
  let run = null;
  const motions = createCodeMotions(
    () => doc,
    () => run,
  );
  const made = createCodeRun(
    [{ id: 'main', language: 'karel', text }],
    'main',
    codeArm(motions.doc),
    systemAtFirst(doc),
  );
  if (!('run' in made)) throw new Error(made.diagnostics[0].message);
  run = made.run;
  const { advance, back, state } = run;
  const stand = (/** @type {readonly number[]} */ posture) => void (doc = { ...doc, posture });
  return {
    ...{ run, motions, stand, state, posture: motions.posture, doc: () => doc },
    /** To the next statement, or the next effect. @returns {string} its place */
    on(isStop = () => true) {
      const { kind, effect } = advance(isStop, 200, motions.mark);
      if (effect?.kind === 'move' || effect?.kind === 'motion-control') {
        stand(motions.posture());
        const begun = effect.kind === 'move' ? motions.begin(effect) : motions.resume();
        if ('reason' in begun) throw new Error(begun.reason);
      }
      return kind === 'line' ? String(run?.place()?.line) : (effect?.kind ?? kind);
    },
    back() {
      const mark = /** @type {MotionMark} */ (back());
      motions.restore(mark);
      stand(mark.posture);
    },
  };
}

const MOVED = `PROGRAM main
VAR t, n : INTEGER
  here, there : XYZWPR
  up : REAL
ROUTINE look
BEGIN
  there = CURPOS(0, 0)
  up = there.z - here.z
END look
BEGIN
  n = 0
  t = 0
  here = CURPOS(0, 0)
  there = here
  there.z = here.z + 50.0
  CONNECT TIMER TO t
  CONDITION[1]:
    WHEN t >= 200 DO
      look
      STOP
      n = 1
  ENDCONDITION
  ENABLE CONDITION[1]
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO there NOWAIT
  WHILE n < 1 DO DELAY 40; ENDWHILE
  DELAY 300
  RESUME
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO here
END main
`;

test('a handler reads where the arm is on the way; what is stopped goes on from there', () => {
  const run = runOf(MOVED);
  let now = '';
  while (now !== 'over') now = run.on(() => false);
  expect(run.run.outcome()).toMatchObject({ status: 'ended' });
  const up = Number(run.run.variables().find(({ name }) => name === 'up')?.value);
  expect(up).toBeGreaterThan(10);
  expect(up).toBeLessThan(25);
  expect(run.posture().map((value) => value.toFixed(4))).toEqual(
    newDocument(firstRobot).posture.map((v) => v.toFixed(4)),
  );
});

test('going back restores program, time and arm exactly, and going on again does the same', () => {
  const run = runOf(MOVED);
  const shown = () => [run.run.place(), run.run.variables(), run.posture(), structuredClone(run.state())];
  /** @type {unknown[]} */
  const seen = [];
  for (let now = run.on(); now !== 'over'; now = run.on()) if (/\d/.test(now)) seen.push(shown());
  const [last] = [shown()];
  const isOnItsWay = (/** @type {unknown} */ one) =>
    /** @type {{ arm: { motion: unknown } }[]} */ (one)[3].arm.motion !== null;
  expect(seen.filter(isOnItsWay).length).toBeGreaterThan(4);
  for (let i = seen.length - 1; i >= 0; i--) {
    run.back();
    expect(shown()).toEqual(seen[i]);
  }
  for (let now = run.on(), i = 1; now !== 'over'; now = run.on())
    if (/\d/.test(now)) expect(shown()).toEqual(seen[i++]);
  expect(shown()).toEqual(last);
});

test('a motion that is taken up again elsewhere goes to its end from there', () => {
  const run = runOf(`PROGRAM main
VAR here, there : XYZWPR
BEGIN
  here = CURPOS(0, 0)
  there = here
  there.z = here.z + 50.0
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO there NOWAIT
  DELAY 200
  STOP
  DELAY 200
  RESUME
END main
`);
  let now = run.on();
  while (now !== '11') now = run.on();
  const first = newDocument(firstRobot).posture;
  run.stand(run.posture());
  run.motions.settle();
  run.stand(run.doc().posture.map((value, i) => (i === 0 ? value + 5 : value)));
  expect(run.posture()).toBe(run.doc().posture);
  while (now !== 'over') now = run.on();
  expect(run.posture()[0]).toBeCloseTo(first[0], 4);
});

test('a motion begins where the one before ends, however seldom anybody has looked', () => {
  const run = runOf(`PROGRAM main
VAR here, up, aside : XYZWPR
BEGIN
  here = CURPOS(0, 0)
  up = here
  up.z = here.z + 50
  aside = up
  aside.y = here.y + 20
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO up
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO aside
END main
`);
  const { robot } = run.doc();
  const height = () => tcpPose(compileRobot(robot), compilePosture(robot, run.doc().posture))[14];
  const before = height();
  let moves = 0;
  while (moves < 2) if (run.on(() => false) === 'move') moves++;
  expect(height() - before).toBeCloseTo(0.05, 7);
});
