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
const tp = (/** @type {string} */ name, /** @type {readonly string[]} */ lines) =>
  parseTp(listing(lines, POINTS, { name })).tree;
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

test('RUN and RUN_TASK begin programs that have their turns; one motion at a time; an endless one holds nobody up', () => {
  const side = tp('SIDE', ['  WAIT    .05(sec)', 'L P[2] 100mm/sec FINE   ', '  DO[2]=ON']);
  const spin = tp('SPIN', ['  LBL[1]', '  R[9]=R[9]+1', '  IF DI[9]=OFF,JMP LBL[1]']);
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
    "PROGRAM tell\nVAR st : INTEGER\nBEGIN\n  WAIT FOR DOUT[1]\n  WRITE('moved', CR)\n  RUN_TASK('MAIN', 0, FALSE, FALSE, 0, st)\n  RUN_TASK('LAST', 0, FALSE, FALSE, 0, st)\nEND tell\n",
  );
  const last = tp('LAST', ['  R[7]=7']);
  const programs = { karel: { tell }, listings: { MAIN: tp('MAIN', lines), SIDE: side, SPIN: spin, LAST: last } };
  const { told, effects, register } = ran('MAIN', programs, { endsWithFirst: true }, 100);
  expect(told.map((one) => one.replace(/\d+$/, (at) => String(Math.round(Number(at) / 50))))).toEqual([
    'MAIN move 0',
    'SIDE move 2',
    'TELL write 2',
  ]);
  expect(effects.filter(({ kind }) => kind === 'run-task')).toMatchObject([
    { program: 'SIDE', runsAlready: true, in: 'MAIN' },
    { program: 'MAIN', runsAlready: true, in: 'TELL' },
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
  const listings = { BAD: tp('BAD', ['  R[1]=R[2]']), SUB: tp('SUB', ['  WAIT   1.00(sec)']) };
  const { told, effects } = ran('main', { karel: { main, caller }, listings });
  expect(effects).toContainEqual(expect.objectContaining({ kind: 'alarm', task: 'BAD', line: 12 }));
  expect(told).toEqual([expect.stringMatching(/^MAIN write 30\d$/), expect.stringMatching(/^MAIN write 100\d$/)]);
});

test('whatever goes on at once: the same programs give the same, from any moment that is put back', () => {
  const statement = fc.constantFrom(
    ...['n = n + 1', 'DELAY 30', 'MOVE TO p', 'MOVE TO p NOWAIT', 'WRITE(n, CR)', 'STOP', 'RESUME', 'CANCEL', 'HOLD'],
    ...['UNHOLD', 'ENABLE CONDITION[1]', 'PULSE DOUT[1] FOR 50 NOWAIT', 'SIGNAL EVENT[1]', 'sub', 'UNHOLD; RESUME'],
    ...['MOVE TO p,\n WHEN DOUT[1] DO\n n = n + 1\n UNTIL n > 4\n ENDMOVE', "RUN_TASK('SIDE', 0, FALSE, FALSE, 0, st)"],
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
    { numRuns: runs(6), seed: SEED },
  );
});
