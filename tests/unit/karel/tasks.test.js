/** Several programs at once: tasks, semaphores, variables of other programs by their names. */
import { expect, test } from 'vitest';
import { createMachine, restoreState, runMachine, saveState } from '../../../src/karel/interpreter.js';
import { parseKarel } from '../../../src/karel/parser.js';

/** @param {string} text */
function program(text) {
  const { tree, diagnostics } = parseKarel(text);
  expect(diagnostics).toEqual([]);
  if (tree.kind !== 'program') throw new Error('This is a program.');
  return tree;
}

/** @param {string} main @param {Record<string, string>} [others] @param {Record<string, Record<string, unknown>>} [variables] */
function machineOf(main, others = {}, variables = {}) {
  const programs = Object.fromEntries(Object.entries(others).map(([name, text]) => [name, program(text)]));
  const { machine, errors } = createMachine(program(main), { programs, variables, steps: 50_000 });
  expect(errors).toEqual([]);
  return machine;
}

/** @param {ReturnType<typeof machineOf>} machine */
function outcomeOf(machine) {
  const effects = [];
  const run = runMachine(machine);
  let next = run.next();
  for (; !next.done; next = run.next()) effects.push(next.value);
  const written = effects.flatMap(({ kind, text }) => (kind === 'write' ? [String(text).trim()] : []));
  return { written, effects, outcome: next.value };
}

const WORKER = `PROGRAM worker
VAR done : INTEGER
BEGIN
DELAY 100
done = 5
WRITE('worker', CR)
POST_SEMA(3)
DELAY 1000
WRITE('late', CR)
END worker`;

const MAIN = `PROGRAM main
VAR
  status : INTEGER
  isLate : BOOLEAN
  done FROM worker : INTEGER
BEGIN
CLEAR_SEMA(3)
RUN_TASK('worker', 0, FALSE, FALSE, 0, status)
WRITE('begun', CR)
PEND_SEMA(3, 50, isLate)
IF isLate THEN WRITE('waits on', CR); ENDIF
PEND_SEMA(3, -1, isLate)
IF NOT isLate THEN WRITE(done, CR); ENDIF
END main`;

test('a task is begun, waited for by a semaphore, and goes on after the program that began it', () => {
  const machine = machineOf(MAIN, { worker: WORKER });
  const { written, outcome } = outcomeOf(machine);
  expect(written).toEqual(['begun', 'waits on', 'worker', '5', 'late']);
  expect(outcome.status).toBe('ended');
  expect(outcome.state.time).toBeGreaterThanOrEqual(1100);
});

test('every moment of two tasks can be put back', () => {
  const machine = machineOf(MAIN, { worker: WORKER });
  const states = [saveState(machine)];
  for (const run = runMachine(machine); !run.next().done;) states.push(saveState(machine));
  expect(states.length).toBeGreaterThan(20);
  for (let i = states.length - 1; i > 0; i--) {
    restoreState(machine, states[i - 1]);
    runMachine(machine).next();
    expect(machine.state).toEqual(states[i]);
  }
  restoreState(machine, states[0]);
  expect(outcomeOf(machine).written).toEqual(['begun', 'waits on', 'worker', '5', 'late']);
});

test('a program runs in one task at a time; it is stopped, held, and let go on by its name', () => {
  const counter = `PROGRAM counter
VAR n : INTEGER
BEGIN
n = 0
WHILE TRUE DO
n = n + 1
DELAY 10
ENDWHILE
END counter`;
  const { written, outcome } = outcomeOf(
    machineOf(
      `PROGRAM main
VAR
  s, number, value : INTEGER
  name, line : STRING[20]
  n FROM counter : INTEGER
BEGIN
RUN_TASK('counter', 0, FALSE, FALSE, 0, s)
RUN_TASK('counter', 0, FALSE, FALSE, 0, s)
IF s <> 0 THEN WRITE('once', CR); ENDIF
DELAY 105
PAUSE_TASK('counter', TRUE, TRUE, s)
value = n
DELAY 100
IF value = n THEN WRITE('held', CR); ENDIF
CONT_TASK('counter', s)
DELAY 100
IF n > value THEN WRITE('goes on', CR); ENDIF
name = 'counter'
GET_TSK_INFO(name, number, TSK_STATUS, value, line, s)
IF value = PG_RUNNING THEN WRITE('runs', CR); ENDIF
ABORT_TASK('counter', TRUE, TRUE, s)
GET_TSK_INFO(name, number, TSK_STATUS, value, line, s)
IF value = PG_ABORTED THEN WRITE('over', CR); ENDIF
ABORT_TASK('nobody', TRUE, TRUE, s)
IF s <> 0 THEN WRITE('nobody', CR); ENDIF
END main`,
      { counter },
    ),
  );
  expect(written).toEqual(['once', 'held', 'goes on', 'runs', 'over', 'nobody']);
  expect(outcome.status).toBe('ended');
});

test('an alarm of a task ends that task alone and is told; a program that is not at hand is begun outside', () => {
  const { written, effects, outcome } = outcomeOf(
    machineOf(
      `PROGRAM main
VAR s : INTEGER
BEGIN
RUN_TASK('broken', 0, FALSE, FALSE, 0, s)
RUN_TASK('tp_one', 0, FALSE, FALSE, 0, s)
DELAY 50
WRITE('still here', CR)
END main`,
      { broken: 'PROGRAM broken\nVAR a, b : INTEGER\nBEGIN\na = b\nEND broken' },
    ),
  );
  expect(written).toEqual(['still here']);
  expect(outcome.status).toBe('ended');
  expect(effects).toContainEqual(
    expect.objectContaining({ kind: 'alarm', task: 'BROKEN', line: 4, alarm: expect.objectContaining({ line: 4 }) }),
  );
  expect(effects).toContainEqual(expect.objectContaining({ kind: 'run-task', program: 'TP_ONE' }));
});

test('CALL_PROG runs a KAREL program in its place, and ABORT in it ends the task', () => {
  const others = {
    part: `PROGRAM part\nBEGIN\nWRITE('part', CR)\nEND part`,
    last: 'PROGRAM last\nBEGIN\nABORT\nEND last',
  };
  const { written, outcome } = outcomeOf(
    machineOf(
      `PROGRAM main\nBEGIN\nCALL_PROG('part', 0)\nWRITE('back', CR)\nCALL_PROG('last', 0)\nWRITE('never', CR)\nEND main`,
      others,
    ),
  );
  expect(written).toEqual(['part', 'back']);
  expect(outcome.status).toBe('aborted');
});

test('variables of any program are read and set by their names, and what cannot be is told by the status', () => {
  const store = `PROGRAM store
TYPE part = STRUCTURE
  size : ARRAY[3] OF REAL
  name : STRING[4]
ENDSTRUCTURE
VAR
  p : part
  n, unset : INTEGER
BEGIN
END store`;
  const { written } = outcomeOf(
    machineOf(
      `PROGRAM main
VAR
  e, s, i : INTEGER
  r : REAL
  t : STRING[10]
BEGIN
GET_VAR(e, 'store', 'n', i, s)
WRITE(i, s, CR)
SET_VAR(e, 'store', 'p.size[2]', 2.5, s)
GET_VAR(e, 'STORE', 'P.SIZE[2]', r, s)
WRITE(r, s, CR)
SET_VAR(e, 'store', 'p.name', 'longer', s)
GET_VAR(e, 'store', 'p.name', t, s)
WRITE(t, CR)
GET_VAR(e, 'store', 'unset', i, s)
IF s <> 0 THEN WRITE('unset', CR); ENDIF
GET_VAR(e, 'store', 'p.size[9]', r, s)
IF s <> 0 THEN WRITE('no such element', CR); ENDIF
GET_VAR(e, 'store', 'nothing', i, s)
IF s <> 0 THEN WRITE('no such name', CR); ENDIF
GET_VAR(e, 'nowhere', 'n', i, s)
IF s <> 0 THEN WRITE('no such program', CR); ENDIF
SET_VAR(e, 'store', 'n', 'text', s)
IF s <> 0 THEN WRITE('another type', CR); ENDIF
SET_VAR(e, '*SYSTEM*', '$MINE[1]', 4, s)
GET_VAR(e, '*system*', '$mine[1]', i, s)
WRITE(i, CR)
$mine[1] = $mine[1] + 1
GET_VAR(e, '*SYSTEM*', '$MINE[1]', i, s)
WRITE(i, CR)
GET_VAR(e, '*system*', '$fast_clock', i, s)
WRITE(s, CR)
END main`,
      { store },
      { Store: { N: 7 } },
    ),
  );
  expect(written).toEqual([
    '70',
    '2.50',
    'long',
    'unset',
    'no such element',
    'no such name',
    'no such program',
    'another type',
    '4',
    '5',
    '0',
  ]);
});
