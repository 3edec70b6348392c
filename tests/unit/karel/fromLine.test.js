/** TP programs that begin at a line of theirs: CALL_PROGLIN, RUN_TASK. */
import { expect, test } from 'vitest';
import { createController, goOn, restoreController, saveController } from '../../../src/karel/controller.js';
import { memoryOf } from '../../../src/karel/controllerTurns.js';
import { parseKarel } from '../../../src/karel/parser.js';
import { parseTp } from '../../../src/karel/tp/parser.js';
import { listing } from './tpListing.js';

/** @import { Program } from '../../../src/karel/tree.js' */

const COUNT = ['  R[1]=R[1]+1', '  R[1]=R[1]+10', '  R[1]=R[1]+100'];
const ECHO = "PROGRAM echo\n%NOLOCKGROUP\nBEGIN\n  WRITE('first', CR)\nEND echo\n";

/** The program of KAREL says what it does; R[1] is 0 at first. @param {string} statement @param {readonly string[]} [lines]  of the TP program COUNT */
function controllerOf(statement, lines = COUNT) {
  const text = `PROGRAM main
%NOLOCKGROUP
VAR n, st : INTEGER
BEGIN
  SET_INT_REG(1, 0, st)
  ${statement}
  WRITE('back', CR)
  DELAY 100
END main
`;
  const read = (/** @type {string} */ one) => /** @type {Program} */ (parseKarel(one).tree);
  const tree = parseTp(listing(lines, [], { name: 'COUNT', group: '*,*,*,*,*' })).tree;
  return createController(
    'main',
    { karel: { main: read(text), echo: read(ECHO) }, listings: { COUNT: tree } },
    { steps: 1000 },
  );
}

/** @param {ReturnType<typeof createController>} controller */
function ran(controller) {
  const run = goOn(controller);
  const told = [];
  let next = run.next();
  for (; !next.done; next = run.next()) {
    if (next.value.kind === 'write') told.push(String(next.value.text).trim());
    if (next.value.kind === 'pause') told.push(`paused ${next.value.in} ${next.value.line}`);
  }
  const register = /** @type {{ value: number } | undefined} */ (memoryOf(controller).registers[1])?.value;
  return { told, register, outcome: next.value };
}

test.each([
  [0, 111],
  [1, 111],
  [2, 110],
  [3, 100],
])('CALL_PROGLIN from line %i, and RUN_TASK', (line, sum) => {
  expect(ran(controllerOf(`CALL_PROGLIN('COUNT', ${line}, n, FALSE)`))).toMatchObject({
    ...{ told: ['back'], register: sum, outcome: { status: 'ended' } },
  });
  expect(ran(controllerOf(`RUN_TASK('COUNT', ${line}, FALSE, FALSE, 0, st)`)).register).toBe(sum);
});

test('it is paused before its line where that is asked for, and goes on from there, from what was saved, too', () => {
  const call = "CALL_PROGLIN('COUNT', 2, n, TRUE)";
  expect(ran(controllerOf(call))).toMatchObject({ told: ['paused COUNT 2', 'back'], register: 110 });
  expect(ran(controllerOf("CALL_PROGLIN('echo', 2, n, TRUE)")).told).toEqual(['paused MAIN 6', 'first', 'back']);
  const controller = controllerOf(call);
  const run = goOn(controller);
  let next = run.next();
  while (!next.done && next.value.kind !== 'pause') next = run.next();
  const saved = saveController(controller);
  const first = ran(controller);
  restoreController(controller, saved);
  expect(ran(controller)).toEqual(first);
  expect(first).toMatchObject({ told: ['back'], register: 110 });
});

test('programs of KAREL begin at their beginning; a line that is not there, and the end of a loop that has not begun, are alarms', () => {
  expect(ran(controllerOf("CALL_PROGLIN('echo', 4, n, FALSE)")).told).toEqual(['first', 'back']);
  const reasonOf = (/** @type {string} */ statement, /** @type {string[]} */ lines = COUNT) =>
    ran(controllerOf(statement, lines)).outcome.alarm?.reason;
  expect(reasonOf("CALL_PROGLIN('COUNT', 4, n, FALSE)")).toBe('COUNT has no line 4 to begin at');
  expect(reasonOf("CALL_PROGLIN('COUNT', -1, n, FALSE)")).toBe('COUNT has no line -1 to begin at');
  const loop = ['  FOR R[2]=1 TO 3', '  R[1]=R[1]+1', '  ENDFOR'];
  expect(reasonOf("CALL_PROGLIN('COUNT', 2, n, FALSE)", loop)).toContain('has not run');
});
