import { expect, test } from 'vitest';
import {
  createController,
  goOn,
  restoreController,
  runController,
  saveController,
} from '../../../src/karel/controller.js';
import { parseKarel } from '../../../src/karel/parser.js';
import { parseTp } from '../../../src/karel/tp/parser.js';
import { listing } from './tpListing.js';

/** @import { Effect } from '../../../src/karel/run/machine.js' */
/** @import { Program } from '../../../src/karel/tree.js' */

const karel = (/** @type {string} */ text) => /** @type {Program} */ (parseKarel(text).tree);
const tp = (/** @type {string} */ name, /** @type {string[]} */ ...lines) => parseTp(listing(lines, [], { name })).tree;

const FILLER = karel(`PROGRAM filler
%NOLOCKGROUP
VAR status, n : INTEGER
  joints : ARRAY[6] OF REAL
  target : JOINTPOS
ROUTINE mover FROM mover
BEGIN
  FOR n = 1 TO 6 DO joints[n] = n * 10; ENDFOR
  CNV_REL_JPOS(joints, target, status)
  SET_JPOS_REG(1, target, status)
  SET_INT_REG(1, 30, status)
  mover
  GET_REG(2, DIN[1], n, joints[1], status)
  WRITE('back with ', n, CR)
END filler
`);
const MOVER = tp('MOVER', 'J PR[1] R[1]% FINE   ', '  R[2]=R[1]+1', '  DO[3]=ON', '  CALL LAST(7)');
const LAST = karel(`PROGRAM last
VAR i, st : INTEGER
BEGIN
  IF UNINIT(i) THEN i = 0; ENDIF
  i = i + 1
  SET_INT_REG(9, i, st)
  IF DOUT[3] THEN WRITE('last ', i, CR); ENDIF
END last
`);

/** @param {ReturnType<typeof runController>} run */
function ended(run) {
  /** @type {Effect[]} */
  const effects = [];
  let next = run.next();
  for (; !next.done; next = run.next()) effects.push(next.value);
  return { effects, outcome: next.value };
}
const ALL = { karel: { filler: FILLER, last: LAST }, listings: { MOVER } };

test('KAREL fills registers, calls TP, which moves, and calls KAREL: all see the same controller', () => {
  const { effects, outcome } = ended(runController('filler', ALL));
  expect(outcome).toMatchObject({ status: 'ended' });
  expect(effects).toMatchObject([
    {
      kind: 'move',
      motion: 'J',
      isJoint: true,
      position: [10, 20, 30, 40, 50, 60],
      speed: { value: 30, unit: '%' },
      in: 'MOVER',
    },
    { kind: 'write', text: expect.stringContaining('last'), in: 'LAST' },
    { kind: 'write', text: expect.stringContaining('back with'), in: 'FILLER' },
  ]);
  expect(outcome.state?.registers).toMatchObject({ 2: { value: 31 }, 9: { value: 1 } });
});

test('variables of KAREL keep their values from one call to the next', () => {
  const { outcome } = ended(
    runController('main', {
      karel: { last: LAST },
      listings: { MAIN: tp('MAIN', '  CALL LAST', '  CALL LAST', '  CALL LAST') },
    }),
  );
  expect(outcome.state?.registers[9]).toMatchObject({ value: 3 });
});

test('an alarm, a call of what is not here, and a program that cannot run are told of the program they are in', () => {
  const alarm = ended(
    runController('main', { listings: { MAIN: tp('MAIN', '  CALL SUB'), SUB: tp('SUB', '  R[1]=R[2]') } }),
  );
  expect(alarm.outcome).toMatchObject({ status: 'alarm', alarm: { routine: 'SUB', line: 12 } });
  const missing = ended(runController('main', { listings: { MAIN: tp('MAIN', '  CALL NOWHERE') } }));
  expect(missing.effects).toMatchObject([{ kind: 'call', program: 'NOWHERE', in: 'MAIN', line: 12 }]);
  const refused = ended(
    runController('main', {
      karel: { bad: karel('PROGRAM bad\nBEGIN\n  x = 1\nEND bad\n') },
      listings: { MAIN: tp('MAIN', '  CALL BAD') },
    }),
  );
  expect(refused.outcome).toMatchObject({ status: 'refused', program: 'BAD', diagnostics: [{ code: 'unknown-name' }] });
  expect(() => runController('nobody', {}).next()).toThrow(RangeError);
});

test('an endless pair of programs is stopped by one budget', () => {
  const again = tp('AGAIN', '  LBL[1]', '  CALL LAST', '  JMP LBL[1]');
  expect(
    ended(runController('again', { karel: { last: LAST }, listings: { again } }, { steps: 3000 })).outcome.status,
  ).toBe('budget');
});

test('a state that is put back, wherever it was taken, gives the same again', () => {
  const host = { traceSteps: true };
  const whole = ended(runController('filler', ALL, host));
  for (let stop = 1; stop < whole.effects.length; stop += 3) {
    const controller = createController('filler', ALL, host);
    const run = goOn(controller);
    for (let i = 0; i < stop; i++) run.next();
    const saved = saveController(controller);
    ended(run);
    restoreController(controller, saved);
    const rest = ended(goOn(controller));
    expect(rest.effects).toEqual(whole.effects.slice(stop));
    expect(rest.outcome.state).toEqual(whole.outcome.state);
  }
});

test('a KAREL program reads what TP has called it with', () => {
  const asked = karel(`PROGRAM asked
VAR kind, whole, st, i : INTEGER
  broken : REAL
  words : STRING[20]
BEGIN
  FOR i = 1 TO 4 DO
    GET_TPE_PRM(i, kind, whole, broken, words, st)
    IF st = 0 THEN WRITE(kind, CR); ELSE WRITE('none', CR); ENDIF
  ENDFOR
  WRITE(whole, ' ', broken, ' ', words, CR)
END asked
`);
  const { effects } = ended(
    runController('main', { karel: { asked }, listings: { MAIN: tp('MAIN', "  CALL ASKED(7,2.5,'part')") } }),
  );
  const written = effects.map(({ text }) => String(text)).join('');
  expect(written.split('\n').map((line) => line.trim())).toEqual(['1', '2', '3', 'none', '7 2.5 part', '']);
});

test('a state in a program that was called by its name as text is put back, too', () => {
  const first = karel(
    "PROGRAM first\nVAR i : INTEGER\n  s : STRING[8]\nBEGIN\n  s = 'last'\n  CALL_PROG(s, i)\n  CALL_PROG('other', i)\nEND first\n",
  );
  const other = karel("PROGRAM other\nBEGIN\n  WRITE('other', CR)\n  WRITE('again', CR)\nEND other\n");
  const programs = { karel: { first, other, last: LAST }, listings: {} };
  const controller = createController('first', programs, { traceSteps: true });
  const run = goOn(controller);
  let next = run.next();
  while (next.value && 'kind' in next.value && next.value.kind !== 'write') next = run.next();
  const saved = saveController(controller);
  const rest = ended(run).effects;
  restoreController(controller, saved);
  expect(ended(goOn(controller)).effects).toEqual(rest);
  expect(rest.filter(({ kind }) => kind === 'write')).toHaveLength(1);
});
