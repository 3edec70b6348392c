/**
 * Small programs by feature (tests/fixtures/karel), each with what it expects in comments: `-- expect: text` for a line that
 * is written, in order; `-- expect stop: reason` where it is stopped; `-- expect error: message` where the checker, or the
 * parser, refuses it. A program without any of these is only read and checked. One file holds the programs of one feature.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
/** @import { Host } from '../../../src/karel/run/machine.js' */
/** @import { Fragment, Program } from '../../../src/karel/tree.js' */
import { checkKarel } from '../../../src/karel/checker.js';
import { createMachine, restoreState, runKarel, runMachine, saveState } from '../../../src/karel/interpreter.js';
import { parseKarel } from '../../../src/karel/parser.js';
import { takeTime } from '../../../src/karel/run/arm.js';
import { printKarel } from '../../../src/karel/printer.js';
import { withoutSpans } from './anyKarel.js';

const FOLDER = new URL('../../fixtures/karel/', import.meta.url);

/** Programs of a file, each from its PROGRAM to the next. @param {string} file */
const programsOf = (file) =>
  readFileSync(new URL(file, FOLDER), 'utf8')
    .split(/^(?=PROGRAM )/m)
    .filter((text) => text.startsWith('PROGRAM '));

const expected = (/** @type {string} */ text, /** @type {string} */ what) =>
  text.split('\n').flatMap((line, i) => {
    const at = line.indexOf(`-- ${what}: `);
    return at < 0 ? [] : [{ line: i + 1, text: line.slice(at + what.length + 5).trim() }];
  });

/** @param {ReturnType<typeof runKarel>} run @param {ReturnType<typeof machineOf>} [machine]  whose motions take their time */
function outcomeOf(run, machine) {
  let written = '';
  let next = run.next();
  for (; !next.done; next = run.next()) {
    if (next.value.kind === 'write') written += next.value.text;
    if (next.value.kind === 'move' && machine) takeTime(machine.state, MOVE_TIME);
  }
  return {
    written: written
      .split('\n')
      .map((line) => line.trim())
      .filter(Boolean),
    outcome: next.value,
  };
}

const MOVE_TIME = 1000;

/** Its moves go on along x, 100 mm each. @param {Program | Fragment} tree @param {Host} [more] */
function machineOf(tree, more) {
  const { machine } = createMachine(tree, {
    ...{ ...HOST, ...more },
    position() {
      const { number, done } = machine.state.arm.last;
      return [number === 0 ? 0 : 100 * (number - 1 + done / MOVE_TIME), 0, 0, 0, 0, 0];
    },
  });
  return machine;
}

const HOST = { files: { 'data.txt': 'first\n2 3.5\n' }, input: ['12', 'abc'], steps: 200_000 };

for (const file of readdirSync(FOLDER).filter((name) => name.endsWith('.kl'))) {
  describe(file, () => {
    test.for(programsOf(file).map((text) => /** @type {const} */ ([/^PROGRAM (\w+)/.exec(text)?.[1] ?? '', text])))(
      '%s',
      ([, text]) => {
        const { tree, diagnostics } = parseKarel(text);
        const errors = [...diagnostics, ...checkKarel(tree)].filter(({ severity }) => severity === 'error');
        const refused = expected(text, 'expect error');
        for (const { line, text: part } of refused) {
          expect(
            errors
              .filter(({ span }) => span.line === line)
              .map(({ message }) => message)
              .join(' '),
          ).toContain(part);
        }
        if (refused.length) return;
        expect(errors).toEqual([]);
        expect(withoutSpans(parseKarel(printKarel(tree)).tree)).toEqual(withoutSpans(tree));

        const machine = machineOf(tree);
        const { written, outcome } = outcomeOf(runMachine(machine), machine);
        const [stop] = expected(text, 'expect stop');
        expect(outcome.alarm && `${outcome.alarm.line} ${outcome.alarm.reason}`).toEqual(
          stop && expect.stringContaining(stop.text),
        );
        if (stop) expect(outcome.alarm?.line).toBe(stop.line);
        expect(written).toEqual(expected(text, 'expect').map((one) => one.text));
      },
    );
  });
}

test('stepping back restores exactly the state before, while the arm moves too, and going on again gives the same', () => {
  const texts = readdirSync(FOLDER)
    .filter((name) => name.endsWith('.kl'))
    .flatMap(programsOf)
    .filter((text) => expected(text, 'expect error').length === 0);
  const every = process.env.DENAVIT_DEEP ? 1 : 8;
  let moving = 0;
  for (const text of texts.filter((one, i) => i % every === 0 || one.startsWith('PROGRAM move'))) {
    const { tree } = parseKarel(text);
    const machine = machineOf(tree, { steps: 3000, traceSteps: true });
    const states = [saveState(machine)];
    const stride = text.startsWith('PROGRAM move') ? 9 : 1;
    const run = runMachine(machine);
    let effects = 0;
    for (let next = run.next(); !next.done && states.length < 40; next = run.next()) {
      if (next.value.kind === 'move') takeTime(machine.state, MOVE_TIME);
      if (++effects % stride === 0) states.push(saveState(machine));
    }
    for (let i = states.length - 1; i > 0; i -= 3) {
      restoreState(machine, states[i - 1]);
      expect(machine.state).toEqual(states[i - 1]);
      if (machine.state.arm.motion) moving++;
      const again = runMachine(machine);
      for (let k = 0; k < stride; k++) {
        const next = again.next();
        if (next.done) break;
        if (next.value.kind === 'move') takeTime(machine.state, MOVE_TIME);
        if (k === stride - 1) expect(machine.state).toEqual(states[i]);
      }
    }
  }
  expect(moving).toBeGreaterThan(50);
});

test('an endless loop ends with the budget', () => {
  const { tree } = parseKarel('PROGRAM p\nVAR i : INTEGER\nBEGIN\ni = 0\nWHILE TRUE DO\ni = 1\nENDWHILE\nEND p');
  expect(outcomeOf(runKarel(tree, { steps: 5000 })).outcome.status).toBe('budget');
});

test('a program that the checker refuses is not run', () => {
  const { outcome } = outcomeOf(runKarel(parseKarel('PROGRAM p\nBEGIN\nx = 1\nEND p').tree));
  expect(outcome).toMatchObject({ status: 'refused', diagnostics: [{ code: 'unknown-name' }] });
});

test('a routine of another program is called there, and its variables are its own', () => {
  const other = parseKarel(
    'PROGRAM other\nVAR n : INTEGER\nROUTINE up(d : INTEGER)\nBEGIN\nIF UNINIT(n) THEN n = 0; ENDIF\nn = n + d\nEND up\nBEGIN\nEND other',
  ).tree;
  const { tree } = parseKarel(
    'PROGRAM p\nVAR n FROM other : INTEGER\nROUTINE up(d : INTEGER) FROM other\nBEGIN\nup(2)\nup(3)\nWRITE(n, CR)\nEND p',
  );
  if (other.kind !== 'program') throw new Error('This is a program.');
  const programs = { other };
  expect(outcomeOf(runKarel(tree, { programs })).written).toEqual(['5']);
});

test('what is no KAREL here is called outside, with its arguments, and MOVE says where', () => {
  const { tree } = parseKarel(`PROGRAM p
VAR a : XYZWPR
ROUTINE mover(speed : INTEGER) FROM mover
BEGIN
a = POS(1, 2, 3, 0, 90, 0, a.config_data)
mover(20)
WITH $SPEED = 100 MOVE TO a
END p`);
  expect([...runKarel(tree)]).toEqual([
    { kind: 'call', program: 'MOVER', args: [20], line: 6 },
    {
      kind: 'move',
      to: 'TO',
      position: [1, 2, 3, 0, 90, 0, 0, 0, 0, 0],
      isJoint: false,
      settings: { $SPEED: 100 },
      line: 7,
    },
  ]);
});

test('an input that changes from outside ends a wait, and fires a handler', () => {
  const { tree } = parseKarel(`PROGRAM p
BEGIN
CONDITION[1]:
  WHEN DIN[2]+ DO
    DOUT[3] = ON
ENDCONDITION
ENABLE CONDITION[1]
WAIT FOR DIN[1]
DELAY 50
IF DOUT[3] THEN WRITE('fired', CR); ENDIF
END p`);
  const { written, outcome } = outcomeOf(
    runKarel(tree, { onScan: (state) => void (state.ports.DIN = { 1: state.time > 100, 2: state.time > 120 }) }),
  );
  expect(outcome.status).toBe('ended');
  expect(written).toEqual(['fired']);
});
