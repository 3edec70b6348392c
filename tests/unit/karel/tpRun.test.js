import { expect, test } from 'vitest';
import {
  createTpMachine,
  restoreTpState,
  runTp,
  runTpMachine,
  saveTpState,
} from '../../../src/karel/tp/interpreter.js';
import { parseTp } from '../../../src/karel/tp/parser.js';
import { cartesian, joints, listing } from './tpListing.js';

/** @import { Effect, Host } from '../../../src/karel/run/machine.js' */
/** @import { TpSetting } from '../../../src/karel/tp/interpreter.js' */

const HERE = { joints: () => [1, 2, 3, 4, 5, 6], position: () => [100, 200, 300, 0, 0, 90] };

/** @param {string} text @param {Host} [host] @param {TpSetting} [setting] */
function ran(text, host = {}, setting = {}) {
  /** @type {Effect[]} */
  const effects = [];
  const run = runTp(parseTp(text).tree, { ...HERE, steps: 5000, ...host }, setting);
  let next = run.next();
  for (; !next.done; next = run.next()) effects.push(next.value);
  return { effects, outcome: next.value, moves: effects.filter(({ kind }) => kind === 'move') };
}

/** R[1], R[2], … after a program. @param {...string} lines */
const registersAfter = (...lines) => {
  const { outcome } = ran(listing(lines));
  expect(outcome.alarm).toBeUndefined();
  return Object.fromEntries(
    Object.entries(outcome.state.registers).map(([key, value]) => [
      key,
      /** @type {{ value: number }} */ (value).value,
    ]),
  );
};

test('registers, loops, choices and calls', () => {
  expect(registersAfter('  R[1]=0', '  FOR R[2]=1 TO 4', '  R[1]=R[1]+R[2]', '  ENDFOR')).toEqual({ 1: 10, 2: 4 });
  expect(registersAfter('  R[1]=0', '  FOR R[2]=3 DOWNTO 4', '  R[1]=9', '  ENDFOR')).toEqual({ 1: 0, 2: 3 });
  expect(registersAfter('  R[1]=7 DIV 2', '  R[2]=7 MOD 4', '  R[3]=1/2', '  R[4]=2+3*4', '  R[R[1]]=(-5)')).toEqual({
    1: 3,
    2: 3,
    3: -5,
    4: 14,
  });
  expect(registersAfter('  R[1]=1', '  LBL[1]', '  R[1]=R[1]*2', '  IF R[1]<100,JMP LBL[1]')).toEqual({ 1: 128 });
  expect(
    registersAfter('  R[1]=2', '  IF (R[1]=1) THEN', '  R[2]=1', '  ELSE', '  R[2]=2', '  ENDIF', '  R[3]=3'),
  ).toEqual({ 1: 2, 2: 2, 3: 3 });
  expect(
    registersAfter('  R[1]=1', '  IF (R[1]=1) THEN', '  R[2]=1', '  ELSE', '  R[2]=2', '  ENDIF', '  R[3]=3'),
  ).toEqual({ 1: 1, 2: 1, 3: 3 });
  const select = [
    '  SELECT R[1]=1,JMP LBL[1]',
    '         =2,JMP LBL[2]',
    '         ELSE,JMP LBL[3]',
    '  LBL[1]',
    '  END',
    '  LBL[2]',
    '  R[2]=2',
    '  END',
    '  LBL[3]',
    '  R[2]=3',
  ];
  expect(registersAfter('  R[1]=2', ...select)).toEqual({ 1: 2, 2: 2 });
  expect(registersAfter('  R[1]=1', ...select)).toEqual({ 1: 1 });
  expect(registersAfter('  R[1]=8', ...select)).toEqual({ 1: 8, 2: 3 });
  const called = parseTp(listing(['  R[5]=AR[1]+AR[2]', '  END', '  R[5]=0'], [], { name: 'SUM' })).tree;
  const { outcome } = ran(listing(['  CALL SUM(2,3)', '  R[6]=R[5]+1']), {}, { listings: { SUM: called } });
  expect(outcome.state.registers).toMatchObject({ 5: { value: 5 }, 6: { value: 6 } });
});

test('moves say where to, how fast, how they end, and in which frames', () => {
  const program = listing(
    [
      '  UFRAME_NUM=0',
      '  UTOOL_NUM=1',
      '  R[5]=30',
      'J P[2] R[5]% CNT50 ACC80   ',
      'L P[1] 250mm/sec FINE   ',
      'C P[3]\n  P[1] 100mm/sec CNT100   ',
    ],
    [
      cartesian(1, [500, 1, 2, 180, 0, -45]),
      joints(2, [1, 2, 3, 4, 5, 6]),
      cartesian(3, [400, 0, 0, 180, 0, 0], { config: 'F D B, -1, 0, 1' }),
    ],
  );
  const { moves, outcome } = ran(program);
  expect(outcome.status).toBe('ended');
  expect(moves).toMatchObject([
    {
      to: 'TO',
      motion: 'J',
      isJoint: true,
      position: [1, 2, 3, 4, 5, 6],
      speed: { value: 30, unit: '%' },
      termination: { kind: 'CNT', value: 50 },
      acceleration: 80,
      line: 15,
    },
    { motion: 'L', isJoint: false, userFrame: 0, toolFrame: 1, termination: { kind: 'FINE' }, line: 16 },
    { motion: 'C', viaIsJoint: false },
  ]);
  expect(moves[1].position).toEqual([500, 1, 2, 180, 0, -45, (1 << 26) | (1 << 27), 0, 0, 0]);
  expect(/** @type {number[]} */ (moves[2].via).slice(0, 3)).toEqual([400, 0, 0]);
});

test('offsets, increments and arithmetic of positions', () => {
  const positions = [cartesian(1, [500, 0, 0, 0, 0, 90])];
  const at = (/** @type {string[]} */ ...lines) => {
    const { moves, outcome } = ran(listing(lines, positions));
    expect(outcome.alarm).toBeUndefined();
    return /** @type {number[]} */ (moves[0].position).slice(0, 3).map((value) => Math.round(value * 1000) / 1000 + 0);
  };
  const offset = ['  PR[1]=LPOS', '  PR[1]=PR[1]-PR[1]', '  PR[1,1]=10'];
  expect(at(...offset, 'L P[1] 100mm/sec FINE Offset,PR[1]   ')).toEqual([510, 0, 0]);
  expect(at(...offset, 'L P[1] 100mm/sec FINE Tool_Offset,PR[1]   ')).toEqual([500, 10, 0]);
  expect(at(...offset, '  OFFSET CONDITION PR[1]', 'L P[1] 100mm/sec FINE Offset   ')).toEqual([510, 0, 0]);
  expect(at(...offset, 'L PR[1] 100mm/sec FINE INC   ')).toEqual([110, 200, 300]);
  expect(at('  PR[1]=LPOS', '  PR[1]=PR[1]+PR[1]', 'L PR[1] 100mm/sec FINE   ')).toEqual([200, 400, 600]);
});

test('a position in another frame or tool than the chosen one stops the program, on its line', () => {
  const { outcome } = ran(listing(['  UTOOL_NUM=2', 'L P[1] 100mm/sec FINE   '], [cartesian(1, [1, 2, 3, 0, 0, 0])]));
  expect(outcome).toMatchObject({ status: 'alarm', alarm: { code: 'frame-mismatch', line: 13, routine: 'DEMO' } });
});

test('joint values are told by their names, in whatever order; two of a name leave one untaught', () => {
  const position = joints(1, [10, 20, 30, 40, 50, 60]);
  const gone = (/** @type {string} */ text) =>
    ran(listing(['  UFRAME_NUM=0', '  UTOOL_NUM=1', 'J P[1] 10% FINE   '], [text]));
  const swapped = position.replace(/J1=(\s*[\d.]+ deg,)\s*J2=(\s*[\d.]+ deg)/, 'J2=$1 J1=$2');
  expect(swapped).not.toBe(position);
  expect(gone(position).moves).toMatchObject([{ position: [10, 20, 30, 40, 50, 60] }]);
  expect(gone(swapped).moves).toMatchObject([{ position: [20, 10, 30, 40, 50, 60] }]);
  expect(gone(position.replace('J1=', 'J2=')).outcome).toMatchObject({ alarm: { code: 'uninitialised' } });
});

test('waiting: time, inputs, edges, and the way out of waiting', () => {
  const host = {
    onScan: (/** @type {import('../../../src/karel/run/machine.js').State} */ state) =>
      void (state.time > 100 && ((state.ports.DIN ??= {})[1] = true)),
  };
  const timed = ran(listing(['  TIMER[1]=RESET', '  TIMER[1]=START', '  WAIT    .50(sec)', '  R[1]=TIMER[1]']));
  expect(timed.effects).toMatchObject([{ kind: 'wait', milliseconds: 500 }]);
  expect(timed.outcome.state.registers[1]).toMatchObject({ value: expect.closeTo(0.5, 3) });
  expect(ran(listing(['  WAIT DI[1]=ON', '  R[1]=1']), host).outcome.status).toBe('ended');
  expect(ran(listing(['  WAIT DI[1]=ON+', '  R[1]=1']), host).outcome.status).toBe('ended');
  expect(ran(listing(['  DO[1]=ON', '  WAIT DO[1]=ON+']), {}).outcome.status).toBe('budget');
  const out = ran(listing(['  $WAITTMOUT=100', '  WAIT DI[1]=ON TIMEOUT,LBL[1]', '  R[1]=1', '  LBL[1]', '  R[2]=2']));
  expect(Object.keys(out.outcome.state.registers)).toEqual(['2']);
  expect(out.outcome.state.time).toBeCloseTo(1000, -1);
  const pulse = ran(listing(['  DO[2]=PULSE,0.1sec', '  F[1]=(DO[2])', '  WAIT    .20(sec)', '  F[2]=(DO[2])']));
  expect(pulse.outcome.state.ports.FLG).toEqual({ 1: true, 2: false });
});

test('Skip goes on at its label unless its condition was met', () => {
  const lines = [
    '  SKIP CONDITION DI[1]=ON',
    'L P[1] 100mm/sec FINE Skip,LBL[1]   ',
    '  R[1]=1',
    '  END',
    '  LBL[1]',
    '  R[1]=2',
  ];
  const text = listing(lines, [cartesian(1, [1, 2, 3, 0, 0, 0])]);
  expect(ran(text).outcome.state.registers[1]).toMatchObject({ value: 2 });
  const machine = createTpMachine(parseTp(text).tree, HERE);
  machine.state.ports.DIN = { 1: true };
  expect([...runTpMachine(machine)]).toHaveLength(1);
  expect(machine.state.registers[1]).toMatchObject({ value: 1 });
});

test.for(
  /** @type {[string[], string, number][]} */ ([
    [['  R[1]=R[2]'], 'R[2] has no value', 12],
    [['  R[1]=1/0'], 'division by zero', 12],
    [['  R[1]=1', '  JMP LBL[R[1]]'], 'LBL[1] is not in this program', 13],
    [['J PR[3] 10% FINE   '], 'PR[3] has no value', 12],
    [['L P[3] 10mm/sec FINE   '], 'P[3] is not among the positions', 12],
    [['  CALL DEMO'], 'too deeply', 12],
    [['  IF (R[1]=1) THEN'], 'R[1] has no value', 12],
  ]),
)('%s stops with a reason', ([lines, reason, line]) => {
  const { outcome } = ran(listing(lines), {}, {});
  expect(outcome).toMatchObject({ status: 'alarm', alarm: { line } });
  expect(outcome.alarm?.reason).toContain(reason);
});

test('an endless loop is stopped by the budget, ABORT by itself; what is not known is passed over and told', () => {
  expect(ran(listing(['  LBL[1]', '  JMP LBL[1]'])).outcome.status).toBe('budget');
  expect(ran(listing(['  ABORT', '  R[1]=1'])).outcome).toMatchObject({ status: 'aborted', state: { registers: {} } });
  const { effects, outcome } = ran(listing(['  COL DETECT ON', '  UALM[3]', '  MESSAGE[done]', '  CALL ELSEWHERE(1)']));
  expect(effects).toMatchObject([
    { kind: 'skipped', text: 'COL DETECT ON', line: 12 },
    { kind: 'error', code: 3 },
    { kind: 'write', text: 'done\n' },
    { kind: 'call', program: 'ELSEWHERE', args: [1], line: 15 },
  ]);
  expect(outcome.status).toBe('ended');
});

test('a state that is put back gives the same again', () => {
  const { tree } = parseTp(listing(['  FOR R[1]=1 TO 5', '  R[2]=R[1]*R[1]', '  MESSAGE[next]', '  ENDFOR']));
  const machine = createTpMachine(tree, HERE);
  const run = runTpMachine(machine);
  run.next();
  run.next();
  const saved = saveTpState(machine);
  const rest = (/** @type {typeof run} */ from) => {
    let next = from.next();
    let count = 1;
    for (; !next.done; next = from.next()) count++;
    return [count, JSON.stringify(next.value.state)];
  };
  const first = rest(run);
  restoreTpState(machine, saved);
  expect(rest(runTpMachine(machine))).toEqual(first);
});
