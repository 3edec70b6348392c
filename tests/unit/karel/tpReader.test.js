import fc from 'fast-check';
import { expect, test } from 'vitest';
import { checkTp } from '../../../src/karel/tp/checker.js';
import { parseTp } from '../../../src/karel/tp/parser.js';
import { printTp } from '../../../src/karel/tp/printer.js';
import { attributeOf, linesOf, nameOf, positionsOf, withoutSource } from '../../../src/karel/tp/tree.js';
import { runs, SEED } from '../../helpers/property.js';
import { cartesian, joints, listing } from './tpListing.js';

/** Every instruction of the frequency table, in forms that listings have. */
const INSTRUCTIONS = [
  'J P[1] 100% FINE   ',
  'J P[1:home] R[5:speed]% CNT100 ACC80   ',
  'J PR[2] 2.5sec CNT R[2]   ',
  'L P[2] 250mm/sec CNT50 Offset,PR[3:shift]   ',
  'L PR[R[7]] 10.5cm/min FINE Tool_Offset,PR[1] INC   ',
  'L P[1] 500deg/sec FINE Skip,LBL[9]   ',
  'L P[1] 100inch/min CR20 Wjnt RTCP   ',
  'L P[1] WELD_SPEED CNT100 COORD   ',
  'L P[1] 100mm/sec CNT100 TB .10sec,CALL GRIP   ',
  'L P[1] 100mm/sec FINE DB 10.0mm,DO[1]=ON   ',
  'C P[2]\n  P[1] 100mm/sec FINE   ',
  'A P[1] 100mm/sec CNT100   ',
  '  !anything goes here: R[1]=2, ((',
  '  --eg:in English ',
  '  //L P[1] 100mm/sec FINE ',
  '  WAIT   1.00(sec)',
  '  WAIT R[3:delay]',
  '  WAIT DI[5:part there]=ON',
  '  WAIT (DI[5] AND !DI[6])',
  '  WAIT RI[1]=OFF- TIMEOUT,LBL[9]',
  '  CALL OTHER',
  "  CALL OTHER(1,R[2],'text',SR[1])",
  '  CALL SR[2]',
  '  RUN BACKGND',
  '  IF R[1:count]>=10,JMP LBL[9]',
  '  IF DI[1]=ON AND DI[2]=OFF,CALL OTHER',
  '  IF R[1]=1 OR R[1]=2 OR R[1]=3,JMP LBL[9]',
  '  IF (DI[1]),R[2]=(R[2]+1)',
  '  IF (R[1]>0 AND !F[3]) THEN',
  '  ELSE',
  '  ENDIF',
  '  SELECT R[1]=1,CALL OTHER',
  '         =2,JMP LBL[9]',
  '         ELSE,CALL OTHER',
  '  FOR R[4]=1 TO R[5]',
  '  ENDFOR',
  '  FOR R[4]=10 DOWNTO (-1)',
  '  ENDFOR',
  '  R[1]=R[2]+R[3]-2.5',
  '  R[1]=R[2] MOD 3',
  '  R[R[1]]=AR[1]',
  '  R[1]=TIMER[2]',
  '  R[1]=$MCR.$GENOVERRIDE',
  '  PR[1]=PR[2]+PR[3]',
  '  PR[1,3]=R[2]*(-1)',
  '  PR[1]=LPOS',
  '  PR[GP1:1]=JPOS',
  '  LBL[9:the end]',
  '  JMP LBL[9]',
  '  JMP LBL[R[1]]',
  '  DO[1]=ON',
  '  DO[2]=PULSE,0.5sec',
  '  RO[3:grip]=OFF',
  '  F[1]=(DI[1] AND R[2]<>3)',
  '  GO[1]=R[1]',
  '  AO[1]=2.5',
  '  UFRAME_NUM=1',
  '  UTOOL_NUM=R[3]',
  '  UFRAME[1]=PR[5]',
  '  UTOOL[R[1]]=PR[6]',
  '  OFFSET CONDITION PR[2]',
  '  TOOL_OFFSET CONDITION PR[2]',
  '  SKIP CONDITION DI[1]=ON',
  '  PAYLOAD[2]',
  '  MESSAGE[ready to go]',
  '  OVERRIDE=50%',
  '  UALM[3]',
  '  TIMER[1]=START',
  '  TIMER[1]=RESET',
  '  SR[1]=SR[2]+SR[3]',
  '  $WAITTMOUT=100',
  '  PAUSE',
  '  ABORT',
  '  END',
  '',
];
const POSITIONS = [cartesian(1, [500, 0.5, -400.25, 180, 0, -45]), joints(2, [1, -2, 3.5, 0, 90, 180])];
const EVERYTHING = listing(INSTRUCTIONS, POSITIONS);

test('every instruction of the frequency table is read as what it is', () => {
  const { tree, diagnostics } = parseTp(EVERYTHING);
  expect(diagnostics).toEqual([]);
  expect(linesOf(tree).filter(({ instruction }) => instruction.kind === 'unknown')).toEqual([]);
  expect(nameOf(tree)).toBe('DEMO');
  expect(attributeOf(tree, 'COMMENT')).toBe('"for a test"');
  expect(linesOf(tree)[10].instruction).toMatchObject({
    kind: 'motion',
    via: { bank: 'P', index: { value: 2 } },
    target: { index: { value: 1 } },
  });
  expect(positionsOf(tree)[0].groups[0]).toMatchObject({ userFrame: 0, toolFrame: 1, configuration: 'N U T, 0, 0, 0' });
  expect(positionsOf(tree)[1]).toMatchObject({ number: 2, label: 'by joints' });
});

test('an unchanged file is written with the same bytes, whatever is in it', () => {
  const lineEnds = ['\n', '\r\n', '\r'];
  const pieces = [
    '   1:',
    'J P[1]',
    '/POS\n',
    'P[1]{',
    '};',
    ';',
    '\n',
    '    :',
    'GP1:',
    '/MN',
    '/PROG A\n',
    ' 99% FINE',
    "'",
    'é',
    '\t',
    'R[',
    ']=',
    '{',
  ];
  const text = fc.oneof(
    fc.array(fc.constantFrom(...pieces)).map((list) => list.join('')),
    fc
      .tuple(fc.nat(EVERYTHING.length), fc.nat(30), fc.string())
      .map(([at, length, other]) => EVERYTHING.slice(0, at) + other + EVERYTHING.slice(at + length)),
  );
  fc.assert(
    fc.property(text, fc.constantFrom(...lineEnds), (source, lineEnd) => {
      const whole = source.replaceAll('\n', lineEnd);
      expect(printTp(parseTp(whole).tree)).toBe(whole);
    }),
    { seed: SEED, numRuns: runs(300) },
  );
  expect(printTp(parseTp(EVERYTHING).tree)).toBe(EVERYTHING);
});

test('written anew, it says the same', () => {
  const { tree } = parseTp(EVERYTHING);
  const bare = withoutSource(tree);
  const again = parseTp(printTp(bare));
  expect(again.diagnostics).toEqual([]);
  expect(withoutSource(again.tree)).toEqual(bare);
});

test('what is not known is kept, said, and stands where it stood', () => {
  const { tree, diagnostics } = parseTp(listing(['  COL DETECT ON', '  R[1]=1'], []));
  expect(linesOf(tree)[0].instruction).toEqual({ kind: 'unknown', text: 'COL DETECT ON' });
  expect(diagnostics).toMatchObject([
    { severity: 'warning', code: 'unknown-instruction', span: { line: 12, column: 8 } },
  ]);
});

test('what real listings have is no fault: the greatest speed, speeds of quick robots, functions, names of backups', () => {
  const lines = [
    '  UFRAME_NUM=0',
    '  UTOOL_NUM=1',
    'L P[1] max_speed FINE   ',
    'L P[1] 4000mm/sec FINE   ',
    '  R[3]=SIN[R[4]]',
  ];
  const text = listing(lines, [POSITIONS[0]]).replace(/\/PROG +\S+/, '/PROG  -BCKEDT-');
  const { tree, diagnostics } = parseTp(text);
  const all = [...diagnostics, ...checkTp(tree)];
  expect(all.map(({ severity, code }) => `${severity} ${code}`)).toEqual([
    'warning unknown-instruction',
    'warning speed',
  ]);
  expect(printTp(withoutSource(parseTp(listing(lines, [POSITIONS[0]])).tree))).toContain('L P[1] max_speed FINE');
});

test.for(
  /** @type {[string, number, string][]} */ ([
    ['J P[1] 100 FINE', 16, 'a unit of speed'],
    ['J P[1] 100% SOON', 18, 'FINE or CNT'],
    ['  IF R[1]=1 JMP LBL[1]', 18, '","'],
    ['  JMP R[1]', 12, 'LBL[…]'],
    ['  R[1]=', 13, 'a register, a port or a number'],
    ['  FOR R[1]=1 UNTIL 3', 19, 'TO or DOWNTO'],
    ['  CALL', 12, 'the name of a program'],
  ]),
)('%s: the place and what was expected', ([line, column, expected]) => {
  const { tree, diagnostics } = parseTp(listing([line, '  R[2]=2']));
  expect(diagnostics).toHaveLength(1);
  expect(diagnostics[0]).toMatchObject({ severity: 'error', span: { line: 12 } });
  expect(diagnostics[0].message).toContain(`Expected ${expected}`);
  expect(diagnostics[0].span.column).toBeGreaterThanOrEqual(column - 3);
  expect(linesOf(tree)[1].instruction.kind).toBe('assign');
});

test('what a person called something can become no instruction', () => {
  const { tree } = parseTp(listing(['  !a']));
  const withRemark = (/** @type {string} */ text) => ({
    ...withoutSource(tree),
    parts: withoutSource(tree).parts.map((part) =>
      part.kind === 'line' ? { ...part, instruction: /** @type {const} */ ({ kind: 'remark', text }) } : part,
    ),
  });
  for (const text of ['a;', 'a\n   2:  ABORT ', 'a\r', 'é', '\u2028'])
    expect(() => printTp(withRemark(text))).toThrow(RangeError);
  expect(() => printTp(withRemark('a, "b" (c) [d] /END'))).not.toThrow();
});

const complaints = (/** @type {string} */ text) =>
  checkTp(parseTp(text).tree).map(({ code, span }) => `${code} ${span.line}`);

test('the checker names labels, blocks, positions, speeds and frames', () => {
  const head = ['  UFRAME_NUM=0', '  UTOOL_NUM=1'];
  expect(complaints(listing([...head, 'J P[1] 100% FINE   '], [POSITIONS[0]]))).toEqual([]);
  expect(complaints(listing(['  JMP LBL[2]', '  LBL[1]', '  LBL[1]']))).toEqual(['label 14', 'label 12']);
  expect(complaints(listing(['  IF (R[1]=1) THEN', '  FOR R[1]=1 TO 2', '  ENDIF', '  ENDFOR']))).toContain('block 14');
  expect(complaints(listing([...head, 'J P[3] 100% FINE   ']))).toEqual(['position 14']);
  expect(
    complaints(
      listing([...head, 'J P[1] 300% FINE   ', 'L P[1] 9999mm/sec CNT101   ', 'L P[1] 10% FINE   '], [POSITIONS[0]]),
    ),
  ).toEqual(['speed 14', 'speed 15', 'termination 15', 'speed 16']);
  expect(complaints(listing(['J P[1] 100% FINE   '], [POSITIONS[0]]))).toEqual(['frames 12']);
  expect(complaints(listing([...head], [POSITIONS[0]]))).toEqual(['unused 15']);
  expect(complaints(listing(['  =2,CALL A']))).toEqual(['select 12']);
  expect(complaints(listing([...head, 'J P[1] 1% FINE '], [POSITIONS[0]], { group: '*,*,*,*,*' }))).toEqual([
    'group 14',
  ]);
});
