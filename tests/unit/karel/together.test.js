/** What goes on at once: moves that take their time, programs that others began, tasks and handlers of those that wait. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createController, goOn, restoreController, saveController } from '../../../src/karel/controller.js';
import { memoryOf } from '../../../src/karel/controllerTurns.js';
import { parseKarel } from '../../../src/karel/parser.js';
import { takeTime } from '../../../src/karel/run/arm.js';
import { parseTp } from '../../../src/karel/tp/parser.js';
import { runs, SEED } from '../../helpers/property.js';
import { cartesian, listing } from './tpListing.js';

/** @import { Effect } from '../../../src/karel/run/machine.js' */
/** @import { Controller, ControllerHost, Programs } from '../../../src/karel/controllerTurns.js' */
/** @import { Program } from '../../../src/karel/tree.js' */

const POINTS = [cartesian(1, [500, 0, 0, 0, 0, 0]), cartesian(2, [600, 0, 0, 0, 0, 0])];
const karel = (/** @type {string} */ text) => /** @type {Program} */ (parseKarel(text).tree);
const tp = (/** @type {string} */ name, /** @type {readonly string[]} */ lines, group = '1,*,*,*,*') =>
  parseTp(listing(lines, POINTS, { name, group })).tree;
const NO_GROUP = '*,*,*,*,*';
const MOVE_TIME = 1000;

/** Each move takes a second. @param {Controller} controller @param {ReturnType<typeof goOn>} [run] @param {(effect: Effect) => void} [told] @param {number} [time] */
function ended(controller, run = goOn(controller), told = () => {}, time = MOVE_TIME) {
  /** @type {(Effect & { at: number })[]} */
  const effects = [];
  let next = run.next();
  for (; !next.done; next = run.next()) {
    if (next.value.kind === 'move') takeTime(memoryOf(controller), time);
    effects.push({ ...next.value, at: Math.round(memoryOf(controller).time) });
    told(next.value);
  }
  return { effects, outcome: next.value };
}

/** @param {string} start @param {Programs} programs @param {ControllerHost} [host] @param {number} [time]  of a move */
function ran(start, programs, host, time) {
  const controller = createController(start, programs, { steps: 100_000, ...host });
  const { effects, outcome } = ended(controller, undefined, undefined, time);
  expect(outcome).toMatchObject({ status: 'ended' });
  const told = effects.filter(({ kind }) => kind === 'write' || kind === 'move');
  const memory = /** @type {NonNullable<typeof outcome.state>} */ (outcome.state);
  const register = (/** @type {number} */ index) =>
    /** @type {{ value: number } | undefined} */ (memory.registers[index])?.value;
  return { effects, memory, register, told: told.map(({ in: name, kind, at }) => `${name} ${kind} ${at}`) };
}

test('a move whose skip condition is met comes to rest on its way, and the program goes on behind it', () => {
  const lines = [
    '  TIMER[1]=RESET',
    '  TIMER[1]=START',
    '  SKIP CONDITION TIMER[1]>.3',
    'L P[1] 100mm/sec FINE Skip,LBL[1]   ',
    '  R[1]=TIMER[1]',
    '  SKIP CONDITION DI[1]=ON',
    'L P[2] 100mm/sec FINE Skip,LBL[1]   ',
    '  END',
    '  LBL[1]',
    '  R[2]=TIMER[1]',
  ];
  const { register } = ran('MAIN', { listings: { MAIN: tp('MAIN', lines) } });
  expect(register(1)).toBeCloseTo(0.41, 1);
  expect(register(2)).toBeCloseTo(1.41, 1);
});

test('while a TP program that it called moves, a KAREL program watches its conditions and runs its tasks', () => {
  const main = karel(`PROGRAM main
VAR st, t : INTEGER
ROUTINE mover FROM mover
ROUTINE late
BEGIN
  WRITE('late', CR)
END late
BEGIN
  t = 0
  CONDITION[1]:
    WHEN t > 500 DO
      late
  ENDCONDITION
  ENABLE CONDITION[1]
  CONNECT TIMER TO t
  RUN_TASK('other', 0, FALSE, FALSE, 0, st)
  mover
  WRITE('back', CR)
END main
`);
  const other = karel("PROGRAM other\nBEGIN\n  DELAY 200\n  WRITE('other', CR)\n  CANCEL\nEND other\n");
  const programs = {
    karel: { main, other },
    listings: { MOVER: tp('MOVER', ['L P[1] 100mm/sec FINE   ', 'L P[2] 100mm/sec FINE   ']) },
  };
  const { told } = ran('main', programs);
  expect(told).toEqual([
    expect.stringMatching(/^MOVER move [01]$/),
    expect.stringMatching(/^MAIN write 20\d$/),
    expect.stringMatching(/^MOVER move 30\d$/),
    expect.stringMatching(/^MAIN write 50\d$/),
    expect.stringMatching(/^MAIN write 130\d$/),
  ]);
});

test('RUN and RUN_TASK begin programs that have their turns; an endless one holds nobody up', () => {
  const side = tp('SIDE', ['  WAIT    .15(sec)', '  DO[2]=ON'], NO_GROUP);
  const spin = tp('SPIN', ['  LBL[1]', '  R[9]=R[9]+1', '  IF DI[9]=OFF,JMP LBL[1]'], NO_GROUP);
  const lines = [
    '  R[9]=0',
    '  RUN SPIN',
    '  RUN SIDE',
    '  RUN SIDE',
    '  RUN TELL',
    'L P[1] 100mm/sec FINE   ',
    '  DO[1]=ON',
    '  WAIT DO[2]=ON',
  ];
  const tell = karel(
    "PROGRAM tell\n%NOLOCKGROUP\nVAR st : INTEGER\nBEGIN\n  WAIT FOR DOUT[1]\n  WRITE('moved', CR)\n  RUN_TASK('MAIN', 0, FALSE, FALSE, 0, st)\n  IF st <> 0 THEN WRITE('already', CR); ENDIF\n  RUN_TASK('LAST', 0, FALSE, FALSE, 0, st)\nEND tell\n",
  );
  const last = tp('LAST', ['  R[7]=7'], NO_GROUP);
  const programs = { karel: { tell }, listings: { MAIN: tp('MAIN', lines), SIDE: side, SPIN: spin, LAST: last } };
  const { told, effects, register } = ran('MAIN', programs, { endsWithFirst: true }, 100);
  expect(told.map((one) => one.replace(/\d+$/, (at) => String(Math.round(Number(at) / 50))))).toEqual([
    'MAIN move 0',
    ...['TELL write 2', 'TELL write 2'],
  ]);
  expect(effects.filter(({ kind }) => kind === 'run-task')).toMatchObject([
    { program: 'SIDE', runsAlready: true, in: 'MAIN' },
  ]);
  expect(register(7)).toBe(7);
  expect(register(9)).toBeGreaterThan(100);
});

test('an alarm of a program that runs beside ends that one, a call from a task waits for its end', () => {
  const main = karel(`PROGRAM main
VAR st : INTEGER
BEGIN
  RUN_TASK('BAD', 0, FALSE, FALSE, 0, st)
  RUN_TASK('caller', 0, FALSE, FALSE, 0, st)
  DELAY 300
  WRITE('main', CR)
END main
`);
  const caller = karel("PROGRAM caller\nROUTINE sub FROM sub\nBEGIN\n  sub\n  WRITE('called', CR)\nEND caller\n");
  const listings = { BAD: tp('BAD', ['  R[1]=R[2]']), SUB: tp('SUB', ['  WAIT   1.00(sec)'], NO_GROUP) };
  const { told, effects } = ran('main', { karel: { main, caller }, listings });
  expect(effects).toContainEqual(expect.objectContaining({ kind: 'alarm', task: 'BAD', line: 12 }));
  expect(told).toEqual([expect.stringMatching(/^MAIN write 30\d$/), expect.stringMatching(/^MAIN write 100\d$/)]);
});

test('one task has the motion group: another that needs it is not begun, and one that moves without it stops', () => {
  const side = tp('SIDE', ['L P[2] 100mm/sec FINE   ']);
  const quiet = karel(`PROGRAM quiet
%NOLOCKGROUP
VAR st : INTEGER
 p : XYZWPR
BEGIN
  DELAY 50
  IF NOT MOTION_CTL(1) THEN WRITE('not mine', CR); ENDIF
  RUN_TASK('SIDE', 1, FALSE, TRUE, 1, st)
  IF st <> 0 THEN WRITE('refused', CR); ENDIF
  LOCK_GROUP(1, st)
  IF st <> 0 THEN WRITE('held', CR); ENDIF
  DELAY 1500
  LOCK_GROUP(1, st)
  IF MOTION_CTL(1) THEN WRITE('mine', CR); ENDIF
  UNLOCK_GROUP(1, st)
  RUN_TASK('SIDE', 1, FALSE, TRUE, 1, st)
  p = CURPOS(0, 0)
  MOVE TO p
END quiet
`);
  const lines = ['  RUN QUIET', 'L P[1] 100mm/sec FINE   '];
  const programs = { karel: { quiet }, listings: { MAIN: tp('MAIN', lines), SIDE: side } };
  const { effects, told } = ran('MAIN', programs);
  expect(told.map((one) => one.replace(/\d+$/, ''))).toEqual([
    ...['MAIN move ', 'QUIET write ', 'QUIET write ', 'QUIET write ', 'QUIET write ', 'SIDE move '],
  ]);
  expect(effects.filter(({ kind }) => kind === 'write').map(({ text }) => text)).toEqual([
    ...['not mine\n', 'refused\n', 'held\n', 'mine\n'],
  ]);
  const alarm = { code: 'motion-group', reason: expect.stringContaining('SIDE holds the motion group') };
  expect(effects).toContainEqual(
    expect.objectContaining({ kind: 'alarm', task: 'QUIET', alarm: expect.objectContaining(alarm) }),
  );

  const refused = createController('MAIN', { listings: { MAIN: tp('MAIN', ['  RUN SIDE']), SIDE: side } });
  const reason = expect.stringContaining('SIDE is to have the motion group, but MAIN holds');
  expect(ended(refused).outcome).toMatchObject({ status: 'alarm', program: 'MAIN', alarm: { line: 12, reason } });
});

test('a TP program that runs beside is paused with its motion, goes on with it, and is aborted with it', () => {
  const main = karel(`PROGRAM main
%NOLOCKGROUP
VAR st, no, i : INTEGER
 name, t : STRING[20]
ROUTINE tell(attribute : INTEGER)
BEGIN
  name = 'SIDE'
  GET_TSK_INFO(name, no, attribute, i, t, st)
END tell
BEGIN
  RUN_TASK('SIDE', 1, FALSE, TRUE, 1, st)
  DELAY 300
  tell(TSK_STATUS)
  IF i = PG_RUNNING THEN WRITE('runs', CR); ENDIF
  tell(TSK_PROGNAME)
  WRITE(t, CR)
  tell(TSK_LINENUM)
  WRITE(i, CR)
  PAUSE_TASK('SIDE', TRUE, TRUE, st)
  DELAY 2000
  tell(TSK_STATUS)
  IF i = PG_PAUSED THEN WRITE('paused', CR); ENDIF
  CONT_TASK('SIDE', st)
  DELAY 1000
  WRITE('second', CR)
  ABORT_TASK('SIDE', TRUE, TRUE, st)
  tell(TSK_STATUS)
  IF i = PG_ABORTED THEN WRITE('aborted', CR); ENDIF
  ABORT_TASK('NOBODY', TRUE, TRUE, st)
  IF st <> 0 THEN WRITE('nobody', CR); ENDIF
  LOCK_GROUP(1, st)
  IF st = 0 THEN WRITE('free', CR); ENDIF
END main
`);
  const sub = tp('SUB', ['L P[1] 100mm/sec FINE   ', 'L P[2] 100mm/sec FINE   ', '  R[1]=1']);
  const listings = { SIDE: tp('SIDE', ['  CALL SUB', '  R[2]=1']), SUB: sub };
  const { effects, memory, register } = ran('main', { karel: { main }, listings });
  const text = effects.flatMap((one) => (one.kind === 'write' ? [String(one.text).trim()] : []));
  expect(text).toEqual(['runs', 'SUB', '2', 'paused', 'second', 'aborted', 'nobody', 'free']);
  // the first move takes a second; what it loses while it comes to rest it has gained when it is at its rate again
  const moves = effects.filter(({ kind }) => kind === 'move').map(({ at }) => at);
  expect(moves).toEqual([expect.closeTo(0, -1), expect.closeTo(3000, -1)]);
  expect([register(1), register(2)]).toEqual([undefined, undefined]);
  expect(memory.arm).toMatchObject({ motion: null, stopped: [] });
  expect(memory.arm.last).toMatchObject({ number: 2, done: expect.closeTo(350, -1) });
});

test('what a task has called pauses, goes on and ends with it', () => {
  const main = karel(
    "PROGRAM main\nVAR st : INTEGER\nROUTINE sub FROM sub\nBEGIN\n  RUN_TASK('other', 0, FALSE, FALSE, 0, st)\n  sub\n  WRITE('never', CR)\nEND main\n",
  );
  const other = karel(`PROGRAM other
VAR st : INTEGER
BEGIN
  DELAY 300
  PAUSE_TASK('MAIN', TRUE, TRUE, st)
  DELAY 1000
  CONT_TASK('MAIN', st)
  DELAY 500
  ABORT_TASK('MAIN', TRUE, TRUE, st)
  DELAY 200
END other
`);
  const listings = { SUB: tp('SUB', ['L P[1] 100mm/sec FINE   ', '  R[1]=1']) };
  const controller = createController('main', { karel: { main, other }, listings });
  const { effects, outcome } = ended(controller);
  expect(outcome.status).toBe('aborted');
  expect(effects.filter(({ kind }) => kind === 'write')).toEqual([]);
  expect(memoryOf(controller)).toMatchObject({
    registers: {},
    arm: { motion: null, holder: null, last: { done: expect.closeTo(850, -1) } },
  });
});

test('whatever goes on at once: the same programs give the same, from any moment that is put back', () => {
  const statement = fc.constantFrom(
    ...['n = n + 1', 'DELAY 30', 'MOVE TO p', 'MOVE TO p NOWAIT', 'WRITE(n, CR)', 'STOP', 'RESUME', 'CANCEL', 'HOLD'],
    ...['UNHOLD', 'ENABLE CONDITION[1]', 'PULSE DOUT[1] FOR 50 NOWAIT', 'SIGNAL EVENT[1]', 'sub', 'UNHOLD; RESUME'],
    ...['ABORT_TASK', 'PAUSE_TASK'].map((one) => `${one}('SIDE', TRUE, TRUE, st)`),
    ...["PAUSE_TASK('MAIN', TRUE, TRUE, st)", "CONT_TASK('SIDE', st)", "CONT_TASK('MAIN', st)", 'UNLOCK_GROUP(1, st)'],
    ...['MOVE TO p,\n WHEN DOUT[1] DO\n n = n + 1\n UNTIL n > 4\n ENDMOVE', "RUN_TASK('SIDE', 0, FALSE, FALSE, 0, st)"],
    "UNLOCK_GROUP(1, st); RUN_TASK('SIDE', 1, FALSE, TRUE, 1, st)",
  );
  const line = fc.constantFrom(
    ...[
      '  R[1]=R[1]+1',
      '  WAIT    .05(sec)',
      'L P[1] 100mm/sec FINE   ',
      '  DO[1]=PULSE,0.1sec',
      '  RUN SIDE',
      '  CALL SUB',
    ],
    ...['  SKIP CONDITION R[1]>3', 'L P[2] 100mm/sec FINE Skip,LBL[1]   ', '  WAIT DO[1]=OFF', '  CALL TALK'],
  );
  const body = fc.array(statement, { minLength: 2, maxLength: 8 });
  const lines = fc.array(line, { minLength: 1, maxLength: 5 });
  /** A task ends by an alarm while what its program called goes on. @type {[string[], string[], string[], string[], number]} */
  const afterAlarm = [
    ['sub', 'n = n + 1', 'n = n + 1'],
    ['DELAY 30', 'MOVE TO p', 'n = n + 1', 'n = n + 1'],
    ['  WAIT    .05(sec)', 'L P[1] 100mm/sec FINE   '],
    ['  R[1]=R[1]+1'],
    31,
  ];
  fc.assert(
    fc.property(body, body, lines, lines, fc.nat(), (first, second, sub, side, where) => {
      const program = (/** @type {string} */ name, /** @type {string[]} */ statements, begin = '') =>
        karel(
          `PROGRAM ${name}\nVAR n, st : INTEGER\n p : XYZWPR\nROUTINE sub FROM sub\nBEGIN\n n = 0\n CONDITION[1]:\n WHEN EVENT[1] DO\n STOP\n WHEN DOUT[1]- DO\n RESUME\n ENDCONDITION\n${begin}${statements.join('\n')}\nUNHOLD\nRESUME\nEND ${name}\n`,
        );
      const wrapped = (/** @type {string} */ name, /** @type {string[]} */ own) =>
        tp(name, ['  R[1]=0', ...own.filter((one) => !one.includes(`CALL ${name}`)), '  LBL[1]']);
      const programs = {
        karel: {
          main: program('main', first, "RUN_TASK('other', 0, FALSE, FALSE, 0, st)\n"),
          other: program('other', second),
          talk: karel("PROGRAM talk\nBEGIN\n WRITE('talk', CR)\n DELAY 20\nEND talk\n"),
        },
        listings: {
          SUB: wrapped('SUB', sub),
          SIDE: wrapped(
            'SIDE',
            side.filter((one) => !one.includes('CALL SUB')),
          ),
        },
      };
      const begin = () => createController('main', programs, { steps: 700, traceSteps: true });
      const controller = begin();
      /** By effect: some of them. @type {Map<number, ReturnType<typeof saveController>>} */
      const states = new Map();
      let count = 0;
      const whole = ended(controller, goOn(controller), () => {
        if (++count % 16 === 1) states.set(count, saveController(controller));
      });
      expect(ended(begin())).toEqual(whole);
      const [at, state] = [...states][where % states.size];
      restoreController(controller, state);
      let k = at;
      const rest = ended(controller, goOn(controller), () => {
        if (states.has(++k)) expect(saveController(controller)).toEqual(states.get(k));
      });
      expect(rest.effects).toEqual(whole.effects.slice(at));
      expect(rest.outcome).toEqual(whole.outcome);
    }),
    { numRuns: runs(6), seed: SEED, examples: [afterAlarm] },
  );
});
