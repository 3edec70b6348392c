import { expect, test } from 'vitest';
import { runKrl } from '../../../src/karel/krl/interpreter.js';
import { parseKrl } from '../../../src/karel/krl/parser.js';
import { printKrl } from '../../../src/karel/krl/printer.js';
import { krlName } from '../../../src/karel/write/krl.js';

/** @import { KrlModule } from '../../../src/karel/krl/tree.js' */

/** @type {KrlModule} */
const MODULE = {
  kind: 'krl',
  name: 'Demo',
  comments: ['about it', ''],
  statements: [
    { kind: 'comment', text: 'FOLD INI' },
    { kind: 'interrupt', text: 'INTERRUPT ON 3' },
    { kind: 'bas', what: 'INITMOV', value: 0 },
    { kind: 'comment', text: 'ENDFOLD (INI)' },
    { kind: 'bas', what: 'TOOL', value: 2 },
    { kind: 'bas', what: 'BASE', value: 1 },
    { kind: 'bas', what: 'VEL_PTP', value: 20 },
    { kind: 'assign', target: '$APO.CPTP', value: 50 },
    { kind: 'motion', motion: 'PTP', target: 'XP1', approximation: ['C_PTP'] },
    { kind: 'assign', target: '$VEL.CP', value: 0.25 },
    { kind: 'assign', target: '$OUT[3]', value: true },
    { kind: 'motion', motion: 'LIN', target: 'XP2', approximation: [] },
    { kind: 'wait', seconds: 0.5 },
    { kind: 'wait-for', input: 2, value: true },
    { kind: 'motion', motion: 'CIRC', via: 'XP2', target: 'XP3', approximation: ['C_DIS'] },
    { kind: 'call', program: 'gripper' },
  ],
  data: [
    { name: 'XP1', type: 'AXIS', members: { A1: 0, A2: -90, A3: 90.125 } },
    { name: 'XP2', type: 'POS', members: { X: 1, Y: 2, Z: 3, A: 10, B: 20, C: 30, S: 6, T: 27 } },
    { name: 'XP3', type: 'FRAME', members: { X: 4, Y: 5, Z: 6, A: 0, B: -0.5, C: 0 } },
  ],
};
/** @param {unknown} value @returns {unknown} */
const bare = (value) => JSON.parse(JSON.stringify(value, (key, inner) => (key === 'span' ? undefined : inner)));

test('what is written is read as the same', () => {
  const { src, dat } = printKrl(MODULE);
  expect(dat).toContain("DECL POS XP2={X 1.000,Y 2.000,Z 3.000,A 10.000,B 20.000,C 30.000,S 'B110',T 'B11011'}");
  const { tree, diagnostics, datDiagnostics } = parseKrl(src, dat);
  expect([...diagnostics, ...datDiagnostics]).toEqual([]);
  expect(bare(tree)).toEqual(bare(MODULE));
});

test('it runs: PTP, LIN and CIRC are moves with their frames, speeds, and C B A as w p r', () => {
  const { src, dat } = printKrl(MODULE);
  const run = runKrl(parseKrl(src, dat).tree, { input: (index, time) => index === 2 && time > 600 });
  const effects = [...run];
  const moves = effects.filter(({ kind }) => kind === 'move');
  expect(moves).toMatchObject([
    {
      motion: 'J',
      isJoint: true,
      position: [0, -90, 90.125],
      speed: { value: 20, unit: '%' },
      termination: { kind: 'CNT', value: 50 },
      userFrame: 1,
      toolFrame: 2,
    },
    {
      motion: 'L',
      position: [1, 2, 3, 30, 20, 10, 0, 0, 0, 0],
      status: 6,
      turn: 27,
      speed: { value: 250, unit: 'mm/sec' },
      termination: { kind: 'FINE' },
    },
    { motion: 'C', via: [1, 2, 3, 30, 20, 10, 0, 0, 0, 0], termination: { kind: 'DIS' } },
  ]);
  expect(effects.at(-1)).toMatchObject({ kind: 'call', program: 'GRIPPER' });
});

test.for([
  ['LIN XP2', 'the first motion has to be PTP'],
  ['PTP XP9', 'XP9 is not in the data list'],
  ['PTP XP1\nLIN XP1', 'LIN and CIRC need X Y Z A B C'],
])('%s is an alarm', ([lines, reason]) => {
  const { dat } = printKrl(MODULE);
  const { tree } = parseKrl(`DEF a ( )\n${lines}\nEND\n`, dat);
  const run = runKrl(tree);
  let next = run.next();
  while (!next.done) next = run.next();
  expect(next.value).toMatchObject({ status: 'alarm', alarm: { reason: expect.stringContaining(reason) } });
});

test('only the INI fold folds: a step that a person called FOLD is a comment, in the head and among the moves', () => {
  const named = {
    ...MODULE,
    comments: ['FOLD: bending', 'ENDFOLD'],
    statements: [...MODULE.statements, { kind: /** @type {const} */ ('comment'), text: 'FOLD 1' }],
  };
  const { src, dat } = printKrl(named);
  expect(src.match(/^;(END)?FOLD.*$/gm)).toEqual([';FOLD INI', ';ENDFOLD (INI)']);
  expect(parseKrl(src, dat).tree.comments).toEqual(named.comments);
});

test('what it does not know it says, with its line; and what cannot be written is refused', () => {
  const { diagnostics, datDiagnostics } = parseKrl(
    'DEF a ( )\nSPLINE\nPTP XP1\nEND\nx\n',
    'DEFDAT a\nDECL POS XP1={X 1,Y}\nENDDAT\n',
  );
  expect(diagnostics.map(({ span, message }) => [span.line, message.slice(0, 28)])).toEqual([
    [2, 'Expected a statement that is'],
    [5, 'Expected nothing behind END,'],
  ]);
  expect(datDiagnostics.map(({ span }) => span.line)).toEqual([2]);
  for (const part of [
    { name: 'a b' },
    { comments: ['a\nPTP XP1'] },
    { statements: [{ kind: /** @type {const} */ ('call'), program: 'a()\nb' }] },
  ])
    expect(() => printKrl({ ...MODULE, ...part })).toThrow(RangeError);
  expect(['Größe 2', '2 arms', '', 'PTP', 'Trigger', 'a'.repeat(40)].map(krlName)).toEqual([
    'Grosse_2',
    'P_2_arms',
    'P',
    'PTP_1',
    'Trigger_1',
    'a'.repeat(24),
  ]);
});

test('positions may stand in braces at the motion itself; what lacks members, or is no motion to a position, is told', () => {
  const text = [
    'DEF p ( )',
    'PTP {A1 0,A2 -90, A3 90.5}',
    'LIN {E6POS: X 1,Y 2,Z 3,A 10,B 20,C 30,S 6,T 27} C_DIS',
    'CIRC {X 4,Y 5,Z 6,A 0,B 0,C 0}, XP1',
    'WAIT FOR $IN[2]',
    'LIN {X 1}',
    'END',
  ].join('\n');
  const dat = 'DEFDAT p\nDECL FRAME XP1={X 7,Y 8,Z 9,A 0,B 0,C 0}\nENDDAT';
  const { tree, diagnostics } = parseKrl(text, dat);
  expect(diagnostics).toEqual([]);
  expect(bare(parseKrl(printKrl(tree).src, dat).tree.statements)).toEqual(bare(tree.statements));
  const run = runKrl(tree, { input: () => true });
  const moves = [];
  let next = run.next();
  for (; !next.done; next = run.next()) if (next.value.kind === 'move') moves.push(next.value);
  expect(moves).toMatchObject([
    { motion: 'J', isJoint: true, position: [0, -90, 90.5] },
    { motion: 'L', position: [1, 2, 3, 30, 20, 10, 0, 0, 0, 0], status: 6, turn: 27, termination: { kind: 'DIS' } },
    { motion: 'C', via: [4, 5, 6, 0, 0, 0, 0, 0, 0, 0], position: [7, 8, 9, 0, 0, 0, 0, 0, 0, 0] },
  ]);
  expect(next.value).toMatchObject({ status: 'alarm', alarm: { line: 6, reason: 'a position lacks members' } });
  const axes = (/** @type {string} */ place) =>
    runKrl(parseKrl(`DEF p ( )\nPTP ${place}\nEND`).tree, { input: () => true }).next().value;
  expect(axes('{A2 -90,A3 90.5,A1 7}')).toMatchObject({ position: [7, -90, 90.5] });
  for (const place of ['{A0 7,A2 -90,A3 90.5}', '{A1 7,A3 90.5,A4 3}'])
    expect(axes(place)).toMatchObject({ alarm: { reason: 'a position lacks members' } });
  for (const wrong of ['PTP {A1}', 'LIN {X 1,Y {Z 2}}', 'PTP {}', 'LIN_REL {X 1}', 'PTP {X 1'])
    expect([wrong, parseKrl(`DEF p ( )\n${wrong}\nEND`).diagnostics.length]).toEqual([wrong, 1]);
});
