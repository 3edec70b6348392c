/** Code under the debugger: where it stops, what it shows, and that going back is exact; and what its motions come to. */
/** @import { ProgramDoc } from '../../../src/model/document.js' */
import { expect, test } from 'vitest';
import { problemsOf } from '../../../src/model/code/codeProblems.js';
import { codeSet } from '../../../src/model/controller/codeSets.js';
import { runCode } from '../../../src/model/controller/runCode.js';
import { createCodeRun } from '../../../src/model/code/codeRun.js';
import { positionForCode } from '../../../src/model/code/codeFrames.js';
import { planOfMove } from '../../../src/model/code/codeMoves.js';
import { valueText, UNSET } from '../../../src/model/code/codeValues.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { newDocument } from '../../../src/model/newDocument.js';

const ARM = { joints: () => [0, 0, 0, 0, 0, 0], position: () => [0, 0, 0, 0, 0, 0] };
const NOWHERE = () => null;

const MAIN = `PROGRAM main
VAR
  i, n : INTEGER
  p : XYZWPR
ROUTINE twice(x : INTEGER) : INTEGER
VAR
  y : INTEGER
BEGIN
  y = x + x
  RETURN(y)
END twice
BEGIN
  n = 0
  FOR i = 1 TO 3 DO
    n = n + twice(i)
    WRITE(n, CR)
  ENDFOR
END main
`;

/** @param {string} text @param {string} [other] */
function runOf(text, other) {
  const programs = [{ id: 'main', language: /** @type {const} */ ('karel'), text }];
  if (other) programs.push({ id: 'other', language: 'karel', text: other });
  const made = createCodeRun(programs, 'main', ARM);
  if (!('run' in made)) throw new Error(made.diagnostics[0].message);
  return made.run;
}

const anyLine = () => true;
const atLine = (/** @type {number} */ line) => (/** @type {{ line: number }} */ place) => place.line === line;

test('it stops before statements, goes into a routine, over it and out of it', () => {
  const run = runOf(MAIN);
  run.advance(anyLine, 100, NOWHERE);
  expect(run.place()).toMatchObject({ program: 'main', line: 13, depth: 1 });
  run.advance(atLine(9), 100, NOWHERE);
  expect(run.stack()).toEqual([
    { id: 'main', program: 'main', routine: 'main', line: 15 },
    { id: 'main', program: 'main', routine: 'twice', line: 9 },
  ]);
  expect(run.variables()).toContainEqual({ name: 'x', type: 'INTEGER', value: '1', owner: 'twice' });
  expect(run.variables()).toContainEqual({ name: 'y', type: 'INTEGER', value: UNSET, owner: 'twice' });
  expect(run.variables()).toContainEqual({ name: 'n', type: 'INTEGER', value: '0' });
  run.advance(({ depth }) => depth < 2, 100, NOWHERE);
  expect(run.place()).toMatchObject({ line: 16, depth: 1 });
  const end = run.advance(() => false, 1000, NOWHERE);
  expect(end.kind).toBe('over');
  expect(run.outcome()?.status).toBe('ended');
  expect(run.output()).toBe('2\n6\n12\n');
});

test('going back shows every moment as it was, with its output, and going on again does the same', () => {
  const run = runOf(MAIN);
  const shown = () => ({ place: run.place(), variables: run.variables(), output: run.output(), stack: run.stack() });
  const seen = [];
  let number = 0;
  while (run.advance(anyLine, 1, () => ++number).kind === 'line') seen.push(shown());
  expect(seen.length).toBe(14);
  expect(run.back()).toBe(seen.length);
  for (let i = seen.length - 1; i >= 0; i--) {
    expect(shown()).toEqual(seen[i]);
    expect(run.canGoBack()).toBe(i > 0);
    if (i > 0) expect(run.back()).toBe(i);
  }
  run.advance(() => false, 1000, NOWHERE);
  expect(run.output()).toBe('2\n6\n12\n');
});

test('what is faulty is not begun, and an endless loop gives the page its turn', () => {
  const faulty = createCodeRun(
    [{ id: 'main', language: 'karel', text: 'PROGRAM p\nBEGIN\nx = 1\nEND p\n' }],
    'main',
    ARM,
  );
  expect(faulty).toMatchObject({ diagnostics: [{ severity: 'error' }] });
  const run = runOf('PROGRAM p\nVAR i : INTEGER\nBEGIN\ni = 0\nWHILE TRUE DO\ni = 1\nENDWHILE\nEND p\n');
  for (let i = 0; i < 5; i++) expect(run.advance(() => false, 1000, NOWHERE)).toEqual({ kind: 'busy' });
});

test('inputs that a person sets are seen by the program, and what it wants done is told', () => {
  const run = runOf('PROGRAM p\nBEGIN\nWAIT FOR DIN[2]\nDOUT[1] = ON\nPAUSE\nEND p\n');
  run.advance(anyLine, 1, NOWHERE);
  for (let i = 0; i < 5; i++) expect(run.advance(anyLine, 1, NOWHERE)).toMatchObject({ effect: { kind: 'wait' } });
  run.setPort('DIN', 2, true);
  let stop = run.advance(anyLine, 1, NOWHERE);
  while (stop.effect?.kind === 'wait') stop = run.advance(anyLine, 1, NOWHERE);
  expect(run.place()?.line).toBe(4);
  run.advance(anyLine, 1, NOWHERE);
  expect(run.state().ports.DOUT[1]).toBe(true);
  expect(run.advance(anyLine, 1, NOWHERE)).toMatchObject({ effect: { kind: 'pause' } });
});

test('MOVE takes the tool where it says, in millimetres and degrees of the controller', () => {
  const doc = newDocument(firstRobot);
  const run = runOf(`PROGRAM p
VAR a, b, aside : XYZWPR
BEGIN
a = POS(400, 100, 300, 150, 0, 0, a.config_data)
b = a
b.x = b.x + 100
aside = POS(100, 0, 0, 0, 0, 0, a.config_data)
MOVE TO a
WITH $MOTYPE = LINEAR, $SPEED = 100 MOVE TO b
WITH $UFRAME = aside MOVE TO a
END p
`);
  const chain = compileRobot(doc.robot);
  let posture = doc.posture;
  const durations = [];
  for (let stop = run.advance(() => false, 100, NOWHERE); stop.effect; stop = run.advance(() => false, 100, NOWHERE)) {
    const planned = planOfMove(doc, posture, stop.effect, run.state().system);
    if (!('plan' in planned)) throw new Error(planned.message);
    const { duration } = planned.plan;
    expect(planned.plan.refused).toBeNull();
    durations.push(duration);
    const end = planMomentAt(planned.plan, duration).posture;
    const T = tcpPose(chain, end);
    expect(T[12]).toBeCloseTo(durations.length === 1 ? 0.4 : 0.5, 6);
    // FANUC's world is at the height of axis 2: 671.83 mm
    expect([T[13], T[14], T[0]].map((value) => value.toFixed(6))).toEqual(['0.100000', '0.971830', '1.000000']);
    posture = Array.from(end, (value) => (value * 180) / Math.PI);
  }
  expect(durations).toHaveLength(3);
  expect(durations[1]).toBeGreaterThan(0.9);
  expect(compilePosture(doc.robot, posture)).toHaveLength(6);
});

test('joints go at $SPEED / $SPEEDLIMJNT of their full rates, as TP at that share; a line to joint values is a line', () => {
  const doc = newDocument(firstRobot);
  const joints = doc.posture.with(0, 40);
  const planFor = (
    /** @type {Record<string, unknown>} */ effect,
    /** @type {Record<string, number>} */ system = {},
  ) => {
    const move = { kind: 'move', to: 'TO', position: joints, isJoint: true, ...effect };
    const found = planOfMove(doc, doc.posture, move, system);
    if (!('plan' in found)) throw new Error(found.message);
    return found.plan;
  };
  const byTp = { motion: 'J', speed: { value: 20, unit: '%' }, userFrame: 0, toolFrame: 0 };
  const { duration } = planFor(byTp);
  expect(planFor({ settings: { $MOTYPE: 6, $SPEED: 400 } }).duration).toBeCloseTo(duration, 12);
  const system = { 'GROUP[1].SPEED': 100, 'PARAM_GROUP[1].SPEEDLIMJNT': 500 };
  expect(planFor({ settings: {} }, system).duration).toBeCloseTo(duration, 12);
  expect(() => planFor({ settings: { $SPEED: 0 } })).toThrow('Expected $SPEED above 0');
  expect(() => planFor({ settings: {} }, { 'PARAM_GROUP[1].SPEEDLIMJNT': 0 })).toThrow('$SPEEDLIMJNT above 0');
  const chain = compileRobot(doc.robot);
  const line = planFor({ settings: { $MOTYPE: 7, $SPEED: 100 } });
  const placeAt = (/** @type {number} */ share) => {
    const T = tcpPose(chain, planMomentAt(line, share * line.duration).posture);
    return [T[12], T[13], T[14]];
  };
  const [from, middle, to] = [0, 0.5, 1].map(placeAt);
  middle.forEach((value, i) => expect(value).toBeCloseTo((from[i] + to[i]) / 2, 6));
});

test('a position that was never set, and a motion that nobody defines, are refused in words', () => {
  const doc = newDocument(firstRobot);
  const refused = (/** @type {Record<string, unknown>} */ effect) =>
    planOfMove(doc, doc.posture, { kind: 'move', settings: {}, ...effect }, {});
  expect(refused({ to: 'TO', position: undefined })).toMatchObject({
    message: expect.stringContaining('uninitialised'),
  });
  expect(refused({ to: 'RELATIVE', by: [0, undefined, 5] })).toMatchObject({
    message: 'MOVE RELATIVE takes a vector or a position that has been set.',
  });
  expect(refused({ to: 'RELATIVE', by: [0, 0, 5, 0, 0, 0], isJoint: true })).toMatchObject({
    message: expect.stringContaining('got joint values'),
  });
  expect(refused({ to: 'NEAR', by: 5, position: undefined })).toMatchObject({
    message: expect.stringContaining('uninitialised'),
  });
  expect(refused({ to: 'ABOUT', vector: [0, 0, 0], by: 5 })).toMatchObject({
    message: expect.stringContaining('not zero'),
  });
  expect(refused({ to: 'AXIS', axis: 7, by: 5 })).toMatchObject({ message: expect.stringContaining('from 1 to 6') });
  expect(refused({ to: 'TO', position: [9000, 0, 0, 0, 0, 0, 0, 0, 0, 0] })).toMatchObject({
    message: 'The arm does not reach this pose.',
  });
});

test('NEAR and AWAY keep off along the tool, RELATIVE shifts or composes, ABOUT turns about a vector of the tool, AXIS takes one joint', () => {
  const doc = newDocument(firstRobot);
  const chain = compileRobot(doc.robot);
  const start = compilePosture(doc.robot, doc.posture);
  const at = positionForCode(doc, {}, false);
  const endOf = (/** @type {Record<string, unknown>} */ effect, share = 1) => {
    const planned = planOfMove(doc, doc.posture, { kind: 'move', settings: { $MOTYPE: 7 }, ...effect }, {});
    if (!('plan' in planned)) throw new Error(planned.message);
    return planMomentAt(planned.plan, share * planned.plan.duration).posture;
  };
  const T = tcpPose(chain, start);
  for (const effect of [
    { to: 'AWAY', by: 20 },
    { to: 'NEAR', by: 20, position: [...at, 0, 0, 0].slice(0, 10), isJoint: false },
  ]) {
    const T_end = tcpPose(chain, endOf(effect));
    // 20 mm against the tool's z axis
    for (let i = 0; i < 3; i++) expect(T_end[12 + i]).toBeCloseTo(T[12 + i] - 0.02 * T[8 + i], 6);
  }
  const T_turned = tcpPose(chain, endOf({ to: 'ABOUT', vector: [0, 2, 0], by: 30 }));
  for (let i = 0; i < 3; i++) {
    expect(T_turned[12 + i]).toBeCloseTo(T[12 + i], 6);
    expect(T_turned[4 + i]).toBeCloseTo(T[4 + i], 6);
    expect(T_turned[i]).toBeCloseTo((Math.sqrt(3) / 2) * T[i] - T[8 + i] / 2, 6);
  }
  const T_shifted = tcpPose(chain, endOf({ to: 'RELATIVE', by: [0, -30, -20] }));
  const T_composed = tcpPose(chain, endOf({ to: 'RELATIVE', by: [0, -30, -20, 0, 30, 0, 0, 0, 0, 0], isJoint: false }));
  for (let i = 0; i < 3; i++) {
    expect(T_shifted[12 + i]).toBeCloseTo(T[12 + i] + [0, -0.03, -0.02][i], 6);
    expect(T_composed[12 + i]).toBeCloseTo(T[12 + i] - 0.03 * T[4 + i] - 0.02 * T[8 + i], 6);
    expect(T_shifted[i]).toBeCloseTo(T[i], 6);
    expect(T_composed[i]).toBeCloseTo(T_turned[i], 6);
  }
  for (const [share, turn] of [
    [1, Math.PI / 18],
    [0.5, Math.PI / 36],
  ]) {
    const found = endOf({ to: 'AXIS', axis: 1, by: 10 }, share);
    expect(found[0] - start[0]).toBeCloseTo(turn, 9);
    expect([...found.slice(1)]).toEqual([...start.slice(1)].map((value) => expect.closeTo(value, 9)));
  }
});

test('values are shown as code has them', () => {
  const real = { kind: /** @type {const} */ ('REAL') };
  expect(valueText(Math.fround(0.1), real)).toBe('0.1');
  expect(valueText(-2, real)).toBe('-2.0');
  expect(valueText(undefined, real)).toBe(UNSET);
  expect(valueText('it', { kind: 'STRING' })).toBe("'it'");
  expect(valueText(true, { kind: 'BOOLEAN' })).toBe('TRUE');
  expect(valueText([1, 2, undefined], { kind: 'ARRAY', sizes: [3], of: { kind: 'INTEGER' } })).toBe(`[1, 2, ${UNSET}]`);
  expect(valueText([1, 2, 3, 0, 90, 0, 0, 0, 0, 0], { kind: 'XYZWPR' })).toBe(
    '1.0 2.0 3.0 | 0.0 90.0 0.0 | N D B, 0, 0, 0',
  );
});

test('lines of an included file are those of its own text: stops, the stack, alarms and what is wrong', () => {
  const part = 'ROUTINE count\nBEGIN\n  n = n + 1\n  IF n > 1 THEN\n    n = 1 DIV (n - 2)\n  ENDIF\nEND count\n';
  const text = 'PROGRAM main\nVAR n : INTEGER\n%INCLUDE lib\\part.h\nBEGIN\n  n = 0\n  count\n  count\nEND main\n';
  const programs = /** @type {ProgramDoc[]} */ ([
    { id: 'main', language: 'karel', text },
    { id: 'part_h', language: 'karel', text: part },
  ]);
  const made = createCodeRun(programs, 'main', ARM);
  if (!('run' in made)) throw new Error(made.diagnostics[0].message);
  const { run } = made;
  run.advance(({ id, line }) => id === 'part_h' && line === 3, 100, NOWHERE);
  expect(run.stack()).toEqual([
    { id: 'main', program: 'main', routine: 'main', line: 6 },
    { id: 'part_h', program: 'main', routine: 'count', line: 3 },
  ]);
  run.advance(() => false, 1000, NOWHERE);
  expect(run.outcome()).toMatchObject({ status: 'alarm', alarm: { line: 5, file: 'lib\\part.h' } });
  expect(run.stack().at(-1)).toMatchObject({ id: 'part_h' });

  expect(createCodeRun(programs, 'part_h', ARM)).toMatchObject({ diagnostics: [{ code: 'no-program' }] });
  expect(problemsOf(programs, programs[1])).toEqual([]);
  const wrong = { ...programs[1], text: part.replace('n + 1', "'one'") };
  const place = { line: 3, from: part.indexOf('n + 1') };
  expect(problemsOf(programs, wrong)).toEqual([expect.objectContaining({ severity: 'error', ...place })]);
  expect(problemsOf([programs[0], wrong], programs[0])).toEqual([
    expect.objectContaining({ line: 3, from: text.indexOf('%'), message: expect.stringContaining('line 3: ') }),
  ]);
});

test('what a program includes is verified with it, each finding in its own file', () => {
  const text = 'PROGRAM main\nVAR n : INTEGER\n%INCLUDE part\nBEGIN\n  n = 0\n  fill\nEND main\n';
  const part = 'ROUTINE fill\nBEGIN\n  n = 1 DIV n\nEND fill\n';
  const programs = /** @type {ProgramDoc[]} */ ([
    { id: 'part', language: 'karel', text: part },
    { id: 'main', language: 'karel', text },
  ]);
  const set = codeSet(programs, programs[0]).map(({ file }) => file);
  expect(set.map(({ name }) => name)).toEqual(['main.kl', 'part.kl']);
  expect(runCode(set).findings).toEqual([expect.objectContaining({ severity: 'error', file: 'part.kl', line: 3 })]);
});

test('which variable was never set is told, where the line has it', () => {
  const run = runOf("PROGRAM main\nVAR n, other : INTEGER\nBEGIN\n  n = 1\n  n = n + Other -- 'n'\nEND main\n");
  run.advance(() => false, 1000, NOWHERE);
  expect(run.outcome()?.alarm).toMatchObject({ line: 5, reason: 'an uninitialised variable is read: other' });
});
