/** TP under the debugger, alone and with KAREL: where it stops, what is shown and set, how it moves the arm, and that going back is exact. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';
import { configOf } from '../../../src/karel/run/positions.js';
import { codeArm } from '../../../src/model/code/codeArm.js';
import { positionForCode, systemAtFirst } from '../../../src/model/code/codeFrames.js';
import { planOfMove } from '../../../src/model/code/codeMoves.js';
import { createCodeRun } from '../../../src/model/code/codeRun.js';
import { atOnce } from '../../../src/model/inSlices.js';
import { verifyInSlices } from '../../../src/model/controller/verifyCode.js';
import { registersNamed, registerTyped } from '../../../src/model/code/codeSignals.js';
import { createGivenRegisters } from '../../../src/model/code/givenRegisters.js';
import { compileRobot } from '../../../src/model/compile.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { runs, SEED } from '../../helpers/property.js';
import { listing } from '../karel/tpListing.js';

/** @import { ProgramDoc } from '../../../src/model/document.js' */
/** @import { CodeRun } from '../../../src/model/code/codeDebugger.js' */

const ARM = { joints: () => [0, 0, 0, 0, 0, 0], position: () => [500, 0, 300, 180, 0, 0, 0] };
const NOWHERE = () => null;
const anyLine = () => true;

/** @param {string} id @param {string[]} lines @param {string[]} [positions] @returns {ProgramDoc} */
const tp = (id, lines, positions) => ({
  id,
  language: 'fanuc-tp',
  text: listing(lines, positions, { name: id.toUpperCase() }),
});
/** @param {string} id @param {string} text @returns {ProgramDoc} */
const karel = (id, text) => ({ id, language: 'karel', text });
/** The line of the file that has the line of the program. */
const at = (/** @type {number} */ line) => 11 + line;

/** @param {readonly ProgramDoc[]} programs @param {Record<string, unknown>} [system] */
function runOf(programs, system) {
  const made = createCodeRun(programs, programs[0].id, ARM, system);
  if (!('run' in made)) throw new Error(made.diagnostics[0].message);
  return made.run;
}

/** To the end, with what it wants done in between. @param {CodeRun} run */
function ended(run) {
  const effects = [];
  for (let i = 0; i < 5000; i++) {
    const stop = run.advance(() => false, 1000, NOWHERE);
    if (stop.kind === 'over') return effects;
    if (stop.effect) effects.push(stop.effect);
  }
  throw new Error('Expected the program to end.');
}

const FILLER = karel(
  'filler',
  `PROGRAM filler
VAR n, st : INTEGER
ROUTINE mover FROM mover
BEGIN
  SET_INT_REG(1, 7, st)
  mover
  n = n_of(2)
END filler
ROUTINE n_of(i : INTEGER) : INTEGER
VAR isr : BOOLEAN
  k, s : INTEGER
  r : REAL
BEGIN
  GET_REG(i, isr, k, r, s)
  RETURN(k)
END n_of
`,
);
const MOVER = tp('mover', ['R[2:count]=R[1]+1', 'CALL LAST(5)', 'DO[3:done]=ON']);
const LAST = tp('last', ['R[3]=AR[1]*2']);

test('a register is typed as on a pendant, or shorter', () => {
  expect(['R[5]', 'pr 12', ' PR[2000] '].map(registerTyped)).toEqual([
    { bank: 'R', index: 5 },
    { bank: 'PR', index: 12 },
    { bank: 'PR', index: 2000 },
  ]);
  for (const text of ['', '5', 'R[0]', 'R[-1]', 'R[1.5]', 'PR[2001]', 'SR[1]', 'R[R[4]]', 'R[99999]'])
    expect(registerTyped(text)).toBeNull();
});

test('KAREL calls TP, which calls TP: each stops in its own file, with those that wait for it', () => {
  const run = runOf([FILLER, MOVER, LAST]);
  const places = [];
  while (run.advance(anyLine, 1, NOWHERE).kind === 'line') {
    const { id, line, depth, task } = /** @type {NonNullable<ReturnType<CodeRun['place']>>} */ (run.place());
    places.push([id, line, depth, task]);
    if (id === 'last') {
      expect(run.stack().map((frame) => [frame.id, frame.line])).toEqual([
        ['filler', 6],
        ['mover', at(2)],
        ['last', at(1)],
      ]);
      expect(run.variables()).toEqual([{ name: 'AR[1]', type: 'REAL', value: '5', owner: 'LAST' }]);
    }
  }
  expect(places.slice(0, 6)).toEqual([
    ['filler', 5, 1, 0],
    ['filler', 6, 1, 0],
    ['mover', at(1), 2, 0],
    ['mover', at(2), 2, 0],
    ['last', at(1), 3, 0],
    ['mover', at(3), 2, 0],
  ]);
  expect(run.variables()).toContainEqual({ name: 'n', type: 'INTEGER', value: '8' });
  expect(run.registers().map(({ bank, index, value }) => `${bank}[${index}]=${value}`)).toEqual([
    'R[1]=7',
    'R[2]=8',
    'R[3]=10',
  ]);
  expect(run.state().ports.DOUT[3]).toBe(true);
});

test('a program that is called and has an error stops the run there, and says which', () => {
  const run = runOf([tp('main', ['CALL BAD']), tp('bad', ['JMP LBL[9]'])]);
  ended(run);
  expect(run.outcome()).toMatchObject({
    status: 'alarm',
    alarm: { reason: expect.stringContaining('BAD has an error in line 12') },
  });
  const unknown = runOf([tp('main', ['CALL WORSE']), karel('worse', 'PROGRAM worse\nBEGIN\nx = 1\nEND worse\n')]);
  ended(unknown);
  expect(unknown.outcome()?.alarm?.reason).toMatch(/^WORSE has an error in line 3/);
  const own = createCodeRun([tp('bad', ['IF R[1]=,JMP LBL[1]'])], 'bad', ARM);
  expect(own).toMatchObject({ diagnostics: [{ severity: 'error' }] });
});

test('what is not known is passed over and told; a call of nobody too; an endless loop gives the page its turn', () => {
  const run = runOf([tp('main', ['Weave End[1]', 'CALL NOBODY', 'R[1]=5'])]);
  expect(ended(run)).toMatchObject([
    { kind: 'skipped', text: 'Weave End[1]', line: at(1) },
    { kind: 'call', program: 'NOBODY', line: at(2) },
  ]);
  const endless = runOf([tp('main', ['LBL[1]', 'JMP LBL[1]'])]);
  for (let i = 0; i < 3; i++) expect(endless.advance(() => false, 200, NOWHERE)).toEqual({ kind: 'busy' });
  const empty = runOf([karel('p', 'PROGRAM p\nBEGIN\nWHILE TRUE DO\nENDWHILE\nEND p\n')]);
  for (let i = 0; i < 3; i++) expect(empty.advance(() => false, 500, NOWHERE)).toEqual({ kind: 'busy' });
});

test('registers and signals are set while it stands still, and stay set when it goes on and back', () => {
  const run = runOf([
    tp('main', ['R[1]=1', 'PR[1]=LPOS', 'R[1]=R[1]+PR[1,3]', 'IF DI[2]=ON,JMP LBL[1]', 'R[2]=0', 'LBL[1]', 'R[2]=9']),
  ]);
  for (let i = 0; i < 3; i++) run.advance(anyLine, 1, NOWHERE);
  expect(run.place()?.line).toBe(at(3));
  run.setRegister('R', 1, 0, 2.5);
  run.setRegister('PR', 1, 2, 40);
  run.setPort('DIN', 2, true);
  run.advance(anyLine, 1, NOWHERE);
  expect(run.registers()[0]).toMatchObject({ bank: 'R', index: 1, value: '42.5', numbers: [42.5] });
  run.back();
  expect(run.registers().map(({ numbers }) => numbers)).toEqual([[2.5], [500, 0, 40, 180, 0, 0]]);
  run.advance(anyLine, 1, NOWHERE);
  run.advance(anyLine, 1, NOWHERE);
  expect(run.place()?.line).toBe(at(7));
});

test('registers that have no value can be given one, which the next run finds', () => {
  const programs = [tp('a', ['R[1]=R[2:count]+1', '!R[3]', 'PR[4,3]=PR[4,3]+R[1]'])];
  expect(registersNamed(programs)).toEqual([
    { bank: 'R', index: 1 },
    { bank: 'R', index: 2 },
    { bank: 'PR', index: 4 },
  ]);
  const given = createGivenRegisters();
  const tried = (/** @type {Parameters<CodeRun['setRegister']>[]} */ ...settings) => {
    const run = runOf(programs);
    given.giveTo(run);
    for (let i = 0; i < 20 && !run.outcome(); i++) run.advance(() => false, 100, NOWHERE);
    for (const setting of settings) {
      given.note(run, setting);
      run.setRegister(...setting);
    }
    return { reason: run.outcome()?.alarm?.reason, registers: run.registers().map(({ numbers }) => numbers) };
  };
  expect(tried(['R', 2, 0, 4]).reason).toBe('R[2] has no value');
  expect(tried(['PR', 4, 2, 10], ['R', 1, 0, 99]).reason).toContain('PR[4]');
  // what the program has set is its own
  expect(tried()).toEqual({ reason: undefined, registers: [[5], [4], [0, 0, 15, 0, 0, 0]] });
  const files = [{ name: 'a.ls', language: /** @type {const} */ ('fanuc-tp'), text: programs[0].text }];
  const doc = newDocument(firstRobot);
  const verified = atOnce(verifyInSlices(doc, null, files, doc.posture, given.settings()));
  expect(verified.findings.map(({ message }) => message)).toEqual(['Taken as they were set by hand: R[2], PR[4].']);
});

test('what is watched is worked out where the program is, and changes nothing', () => {
  const run = runOf([tp('main', ['R[1]=4', 'DO[1]=ON', 'R[2]=1'])]);
  for (let i = 0; i < 3; i++) run.advance(anyLine, 1, NOWHERE);
  expect(run.watch('R[1]*2+1')).toEqual({ value: '9' });
  expect(run.watch('DO[1]=ON')).toEqual({ value: 'ON' });
  expect(run.watch('R[7]')).toEqual({ fault: 'R[7] has no value' });
  expect(run.watch('R[1')).toMatchObject({ fault: expect.stringContaining('"]"') });
  const other = runOf([karel('p', FUNCTIONS)]);
  for (let i = 0; i < 4; i++) other.advance(anyLine, 1, NOWHERE);
  expect(other.stack()).toHaveLength(2);
  const before = JSON.stringify(other.state());
  expect(other.watch('x * 2 + list[2]')).toEqual({ value: '16' });
  expect(other.watch("'a' + 'b'")).toEqual({ value: "'ab'" });
  expect(other.watch('total > 2.5')).toEqual({ value: 'TRUE' });
  expect(other.watch('CURPOS(0, 0)')).toMatchObject({ value: expect.stringContaining('500.0 0.0 300.0') });
  expect(other.watch('DIN[5]')).toEqual({ value: 'FALSE' });
  expect(other.watch('GET_POS_REG(1, list[3])')).toMatchObject({ value: expect.any(String) });
  expect(other.watch('twice(3)')).toMatchObject({ fault: expect.stringContaining('not called') });
  expect(other.watch('nobody')).toMatchObject({ fault: expect.stringContaining('"nobody"') });
  expect(other.watch('x +')).toMatchObject({ fault: expect.stringContaining('Expected') });
  expect(other.watch('x x')).toMatchObject({ fault: expect.stringContaining('the end of the expression') });
  expect(JSON.stringify(other.state())).toBe(before);
});

const FUNCTIONS = `PROGRAM p
VAR list : ARRAY[3] OF INTEGER
  total : REAL
ROUTINE twice(x : INTEGER) : INTEGER
BEGIN
  RETURN(x + x)
END twice
BEGIN
  list[2] = 6
  total = 3
  list[1] = twice(5)
END p
`;

/** @param {number[]} values  x y z w p r */
const cartesian = ([x, y, z, w, p, r], config = "CONFIG : 'N U T, 0, 0, 0',") =>
  `P[1]{\n   GP1:\n\tUF : 0, UT : 0,\t\t${config}\n\tX = ${x} mm,\tY = ${y} mm,\tZ = ${z} mm,\n\tW = ${w} deg,\tP = ${p} deg,\tR = ${r} deg\n};`;

test('TP moves the arm in the frames that are chosen, at its speeds, and in the configuration that a position has', () => {
  const bare = newDocument(firstRobot);
  const frames = /** @type {const} */ ([
    { kind: 'user', id: 'table', number: 3, xyz: [100, 200, 50], rpy: [0, 0, 90] },
    { kind: 'tool', id: 'pen', number: 2, xyz: [0, 0, 120], rpy: [0, 0, 0] },
  ]);
  const doc = /** @type {typeof bare} */ ({ ...bare, frames });
  const system = systemAtFirst(doc);
  const run = runOf(
    [
      tp(
        'main',
        [
          'UFRAME_NUM=0',
          'UTOOL_NUM=0',
          'J P[1] 50% FINE',
          'UFRAME_NUM=3',
          'UTOOL_NUM=2',
          'PR[1]=LPOS',
          'PR[1,1]=150',
          'PR[1,2]=-250',
          'PR[1,3]=50',
          'PR[1,4]=180',
          'PR[1,5]=0',
          'PR[1,6]=-90',
          'L PR[1] 200mm/sec FINE',
          'L PR[1] 2sec FINE',
          'UTOOL_NUM=7',
          'J PR[1] 50% FINE',
        ],
        [cartesian([450, 150, -300, 180, 0, 0])],
      ),
    ],
    system,
  );
  let posture = doc.posture;
  const plans = [];
  for (const effect of ended(run)) {
    if (effect.kind !== 'move') continue;
    const planned = planOfMove(doc, posture, effect, { ...system, ...run.state().system });
    if (!('plan' in planned)) throw new Error(planned.message);
    expect(planned.plan.refused).toBeNull();
    plans.push(planned);
    posture = Array.from(planMomentAt(planned.plan, planned.plan.duration).posture, (value) => (value * 180) / Math.PI);
    if (plans.length === 1) {
      const T = tcpPose(compileRobot(doc.robot), planMomentAt(planned.plan, planned.plan.duration).posture);
      // axis 2 is 671.83 mm up
      expect([T[12], T[13], T[14]].map((value) => value.toFixed(6))).toEqual(['0.450000', '0.150000', '0.371830']);
    }
    if (plans.length === 2) {
      const T = tcpPose(compileRobot(doc.robot), planMomentAt(planned.plan, planned.plan.duration).posture);
      // the frame is turned by 90 degrees about z: x of it is y of the world; the pen is 120 mm below the flange
      expect(T[12]).toBeCloseTo(0.1 + 0.25, 6);
      expect(T[13]).toBeCloseTo(0.2 + 0.15, 6);
      expect(T[14]).toBeCloseTo(0.05 + 0.05 + 0.12, 6);
      const way = Math.hypot(0.35 - 0.45, 0.35 - 0.15, 0.22 - 0.37183);
      expect(planned.plan.duration).toBeGreaterThan(way / 0.2);
      expect(planned.plan.duration).toBeLessThan(way / 0.2 + 0.2);
    }
  }
  expect(plans).toHaveLength(4);
  expect(plans[0].missing).toEqual([]);
  expect(plans[3].missing).toEqual(['UTOOL 7']);
});

test('a configuration that the arm has not there is refused with its name, and speeds are what they say', () => {
  const doc = newDocument(firstRobot);
  const system = systemAtFirst(doc);
  const [near] = ended(runOf([tp('main', ['J P[1] 100% FINE'], [cartesian([450, 150, -300, 180, 0, 0])])], system));
  const asked = (/** @type {object} */ change) => planOfMove(doc, doc.posture, { ...near, ...change }, system);
  const full = asked({});
  if (!('plan' in full)) throw new Error(full.message);
  const half = asked({ speed: { value: 50, unit: '%' } });
  const slow = asked({ speed: { value: 4, unit: 'sec' } });
  if (!('plan' in half && 'plan' in slow)) throw new Error('Expected plans.');
  expect(half.plan.duration).toBeGreaterThan(1.4 * full.plan.duration);
  expect(slow.plan.duration).toBeGreaterThan(4);
  expect(slow.plan.duration).toBeLessThan(4.3);
  const overridden = planOfMove(doc, doc.posture, near, { ...system, OVERRIDE: 50 });
  if (!('plan' in overridden)) throw new Error(overridden.message);
  expect(overridden.plan.duration).toBeCloseTo(half.plan.duration, 9);
  const inConfiguration = (/** @type {string} */ text) =>
    asked({ position: /** @type {number[]} */ (near.position).with(6, Number(configOf(text))) });
  expect(inConfiguration('N U T, 0, 0, 5')).toMatchObject({ plan: { refused: { reason: 'limit', joint: 5 } } });
  expect(inConfiguration('F L D B, 0, 0, 0')).toMatchObject({ message: expect.stringContaining('F L D B, 0, 0, 0') });
  expect(asked({ position: [9000, 0, 0, 0, 0, 0, 1 << 26, 0, 0, 0] })).toEqual({
    message: 'The arm does not reach this pose.',
  });
});

test('where the tool is, is told as the controller counts: back to it is no way at all', () => {
  const doc = newDocument(firstRobot);
  const system = systemAtFirst(doc);
  for (const isTp of [true, false]) {
    const position = [...positionForCode(doc, system, isTp), 0, 0, 0];
    const move = isTp
      ? { motion: 'J', speed: { value: 100, unit: '%' }, termination: { kind: 'FINE' }, userFrame: 0, toolFrame: 0 }
      : { to: 'TO', settings: {} };
    const planned = planOfMove(doc, doc.posture, { kind: 'move', position, isJoint: false, ...move }, system);
    if (!('plan' in planned)) throw new Error(planned.message);
    const end = planMomentAt(planned.plan, planned.plan.duration).posture;
    end.forEach((value, i) => expect(value).toBeCloseTo((doc.posture[i] * Math.PI) / 180, 6));
  }
});

/** Programs of every instruction that changes something, and ends. */
const anyLines = (/** @type {string[]} */ calls) => {
  const register = fc.integer({ min: 1, max: 4 }).map((i) => `R[${i}]`);
  const plain = fc.oneof(
    fc
      .tuple(register, register, fc.constantFrom('+', '-', '*'), fc.integer({ min: 0, max: 9 }))
      .map(([a, b, sign, n]) => `${a}=${b}${sign}${n}`),
    fc.tuple(fc.integer({ min: 1, max: 2 }), register).map(([i, r]) => `PR[${i},3]=PR[1,2]+${r}`),
    fc.constantFrom(
      'PR[2]=LPOS',
      'PR[2]=PR[1]+PR[2]',
      'PR[1]=JPOS',
      'PR[1]=LPOS',
      'SR[1]=SR[1]+R[1]',
      'WAIT .01(sec)',
      'MESSAGE[here]',
      'TIMER[1]=START',
      'TIMER[1]=STOP',
      'R[1]=TIMER[1]',
      'DO[1]=PULSE,0.02sec',
      'DO[2]=(!DO[2])',
      'OVERRIDE=50%',
      'UFRAME_NUM=0',
      'J PR[1] 10% FINE',
      'Spot[1]',
    ),
    fc.constantFrom('R[3]=DI[1]', 'WAIT DI[1]=OFF', ...calls.map((name) => `CALL ${name}(R[1],2)`)),
  );
  const block = fc.oneof(
    { weight: 4, arbitrary: plain.map((line) => [line]) },
    fc
      .tuple(register, fc.integer({ min: 0, max: 3 }), fc.array(plain, { maxLength: 3 }))
      .map(([r, n, inner]) => [`IF (${r}>${n}) THEN`, ...inner, 'ELSE', 'R[4]=0', 'ENDIF']),
    fc
      .tuple(fc.integer({ min: 0, max: 3 }), fc.array(plain, { maxLength: 2 }))
      .map(([n, inner]) => [`FOR R[5]=1 TO ${n}`, ...inner, 'ENDFOR']),
    fc
      .tuple(register, plain)
      .map(([r, line]) => [`SELECT ${r}=1,R[2]=3`, '       =2,R[2]=4', '       ELSE,R[2]=5', line]),
  );
  return fc
    .array(block, { minLength: 1, maxLength: 6 })
    .map((blocks) => ['R[1]=1', 'R[2]=2', 'R[3]=3', 'R[4]=4', 'PR[1]=LPOS', ...blocks.flat()]);
};

test('stepping back over TP, KAREL and both shows every moment as it was, and going on again does the same', () => {
  const cases = fc.tuple(anyLines(['SUB', 'KLP', 'GONE']), anyLines([]), fc.boolean());
  fc.assert(fc.property(cases, goesBack), { numRuns: runs(25), seed: SEED });
});

/** @param {[string[], string[], boolean]} programs */
function goesBack([main, sub, inKarel]) {
  const klp = karel(
    'klp',
    'PROGRAM klp\nVAR i, st : INTEGER\nROUTINE sub FROM sub\nBEGIN\n  IF UNINIT(i) THEN i = 0; ENDIF\n  i = i + 1\n  SET_INT_REG(2, i, st)\n  sub\n  WRITE(i, CR)\nEND klp\n',
  );
  const programs = [tp('main', main), tp('sub', sub), klp];
  const run = runOf(inKarel ? [klp, ...programs.slice(0, 2)] : programs);
  const shown = () =>
    JSON.stringify([
      run.place(),
      run.stack(),
      run.variables(),
      run.registers(),
      run.state().ports,
      run.state().time,
      run.output(),
    ]);
  const seen = [];
  const effects = [];
  for (let i = 0; i < 400; i++) {
    const stop = run.advance(anyLine, 1, () => i);
    if (stop.kind === 'line') seen.push(shown());
    if (stop.effect) effects.push(JSON.stringify(stop.effect));
    if (stop.kind === 'over') break;
  }
  fc.pre(run.outcome() !== null); // a program that sets what another counts by may never end
  const end = JSON.stringify([run.outcome()?.status, run.outcome()?.alarm]);
  for (let i = seen.length - 1; i >= 0; i--) {
    run.back();
    expect(shown()).toBe(seen[i]);
  }
  expect(run.canGoBack()).toBe(false);
  const again = [];
  const effectsAgain = [];
  for (let i = 0; i < 400; i++) {
    const stop = run.advance(anyLine, 1, () => i);
    if (stop.kind === 'line') again.push(shown());
    if (stop.effect) effectsAgain.push(JSON.stringify(stop.effect));
    if (stop.kind === 'over') break;
  }
  expect(again).toEqual(seen.slice(1));
  expect(effectsAgain).toEqual(effects);
  expect(JSON.stringify([run.outcome()?.status, run.outcome()?.alarm])).toBe(end);
}

const KRL = `DEF pick ( )
  ; there and back
  BAS(#VEL_PTP,50)
  BAS(#BASE,0)
  PTP XP1
  WAIT FOR $IN[2]==TRUE
  $OUT[3]=TRUE
  LIN XP2
END
`;
const DATA = `DEFDAT pick
DECL AXIS XP1={A1 0.0,A2 60.0,A3 -180.0,A4 0.0,A5 30.0,A6 0.0}
DECL POS XP2={X 500.0,Y -150.0,Z 700.0,A 0.0,B 90.0,C 0.0}
ENDDAT
`;
/** @param {string} id @param {string} text @returns {ProgramDoc} */
const krl = (id, text) => ({ id, language: 'krl', text });

test('KRL with its data list runs likewise: it waits for inputs, sets outputs, moves in the world, and goes back', () => {
  const programs = [krl('pick', KRL), krl('pick_dat', DATA), krl('other_dat', DATA.replace('pick', 'other'))];
  const run = runOf(programs);
  const seen = [];
  const shown = () => JSON.stringify([run.place(), run.variables(), run.state()]);
  const doc = newDocument(firstRobot);
  const moves = [];
  for (let i = 0; i < 60; i++) {
    if (i === 20) run.setPort('IN', 2, true);
    const stop = run.advance(anyLine, 1, () => i);
    if (stop.kind === 'line') seen.push([run.place()?.line, shown()]);
    if (stop.effect?.kind === 'move') moves.push(stop.effect);
    if (stop.kind === 'over') break;
  }
  expect(seen.map(([line]) => line)).toEqual([3, 4, 5, 6, 7, 8]);
  expect(run.outcome()?.status).toBe('ended');
  expect(run.state().ports.OUT[3]).toBe(true);
  expect(run.watch('vel_ptp')).toEqual({ value: '50' });
  const first = planOfMove(doc, doc.posture, moves[0], run.state().system);
  if (!('plan' in first)) throw new Error(first.message);
  expect(first.plan.refused).toBeNull();
  const there = planMomentAt(first.plan, first.plan.duration).posture;
  expect(there[1]).toBeCloseTo(Math.PI / 3, 9);
  const [, , at7] = seen.toReversed();
  run.back();
  run.back();
  expect(run.place()?.line).toBe(7);
  expect(seen[4][1]).toBe(shown());
  expect(at7[0]).toBe(6);
  // what is wrong in the data list keeps its program from running
  const faulty = createCodeRun([programs[0], krl('pick_dat', DATA.replace('X 500.0', 'X ?'))], 'pick', ARM);
  expect(faulty).toMatchObject({ diagnostics: [{ message: expect.stringMatching(/^pick_dat, line 3: /) }] });
});

test('joints and Cartesian positions become each other by the arm, in assignments, registers and JOINT2POS', () => {
  const doc = newDocument(firstRobot);
  const arm = codeArm(() => doc);
  const text = `PROGRAM p
VAR j, k : JOINTPOS
  here, there, nothing : XYZWPR
  values : ARRAY[6] OF REAL
  ext : ARRAY[3] OF REAL
  st : INTEGER
BEGIN
  values[1] = 10; values[2] = 50; values[3] = -170; values[4] = 5; values[5] = 40; values[6] = 20
  CNV_REL_JPOS(values, j, st)
  here = j
  SET_JPOS_REG(1, j, st)
  there = GET_POS_REG(1, st)
  k = here
  CNV_JPOS_REL(k, values, st)
  nothing = POS(0, 0, 0, 0, 0, 0, here.config_data)
  JOINT2POS(j, nothing, POS(0, 0, 100, 0, 0, 0, here.config_data), 0, here, st, ext, st)
  here.x = 9000
  POS2JOINT(j, here, nothing, nothing, 0, 0, ext, k, st)
END p
`;
  const made = createCodeRun([karel('p', text)], 'p', arm, systemAtFirst(doc));
  if (!('run' in made)) throw new Error(made.diagnostics[0].message);
  const { run } = made;
  /** @param {string} name @param {number} line */
  const at = (name, line) => {
    run.advance((place) => place.line === line, 1000, NOWHERE);
    const found = run.watch(name);
    if (!('value' in found)) throw new Error(found.fault);
    return found.value;
  };
  const posture = [10, 50, -170, 5, 40, 20].map((value) => (value * Math.PI) / 180);
  const T = tcpPose(compileRobot(doc.robot), Float64Array.from(posture));
  expect(Number(at('here.x', 11))).toBeCloseTo(T[12] * 1000, 2);
  expect(Number(at('there.z', 13))).toBeCloseTo(T[14] * 1000 - 671.83, 2);
  for (const [i, value] of [10, 50, -170, 5, 40, 20].entries())
    expect(Number(at(`values[${i + 1}]`, 15))).toBeCloseTo(value, 3);
  // the tool is 100 mm longer, along its z
  run.advance((place) => place.line === 17, 1000, NOWHERE);
  expect(run.watch('here.z')).toMatchObject({ value: expect.any(String) });
  expect(Number(at('here.z', 17))).toBeCloseTo(T[14] * 1000 - 671.83 + 100 * T[10], 2);
  run.advance(() => false, 1000, NOWHERE);
  expect(run.outcome()?.status).toBe('ended');
  expect(run.variables().find(({ name }) => name === 'st')?.value).not.toBe('0');
});

test('joints and positions are in range within the limits of the arm, and where it has a posture', () => {
  const doc = newDocument(firstRobot); // J1 from −160 to 160 degrees
  const text = `PROGRAM p
VAR j : JOINTPOS
  here : XYZWPR
  values : ARRAY[6] OF REAL
  a, b, c, d : BOOLEAN
  st : INTEGER
BEGIN
  values[1] = 160; values[2] = 50; values[3] = -170; values[4] = 5; values[5] = 40; values[6] = 20
  CNV_REL_JPOS(values, j, st)
  a = J_IN_RANGE(j)
  here = j
  b = IN_RANGE(here)
  values[1] = 160.01
  CNV_REL_JPOS(values, j, st)
  c = J_IN_RANGE(j) OR IN_RANGE(j)
  here.x = 9000
  d = IN_RANGE(here)
END p
`;
  const made = createCodeRun(
    [karel('p', text)],
    'p',
    codeArm(() => doc),
    systemAtFirst(doc),
  );
  if (!('run' in made)) throw new Error(made.diagnostics[0].message);
  made.run.advance(() => false, 1000, NOWHERE);
  expect(made.run.outcome()?.status).toBe('ended');
  const seen = made.run.variables().filter(({ type }) => type === 'BOOLEAN');
  expect(seen.map(({ value }) => value)).toEqual(['TRUE', 'TRUE', 'FALSE', 'FALSE']);
});
