/** What is said of controller code while it is typed: problems, names to complete, lines in order, signals, and where it leads. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { scan } from '../../../src/karel/scan/scanner.js';
import { parseTp } from '../../../src/karel/tp/parser.js';
import { linesOf } from '../../../src/karel/tp/tree.js';
import { MAX_REMARK_LENGTH } from '../../../src/karel/write/header.js';
import { codeArm } from '../../../src/model/code/codeArm.js';
import { systemAtFirst } from '../../../src/model/code/codeFrames.js';
import { formatted, whenLineEnds } from '../../../src/model/code/codeFormat.js';
import { namesFor } from '../../../src/model/code/codeNames.js';
import { moveOfLine, pathOf, previewOf } from '../../../src/model/code/codePreview.js';
import { problemsOf } from '../../../src/model/code/codeProblems.js';
import { createCodeRun } from '../../../src/model/code/codeRun.js';
import { registerComments, signalsNamed, signalsOf } from '../../../src/model/code/codeSignals.js';
import { firstWay } from '../../../src/model/code/firstWay.js';
import { codeSet } from '../../../src/model/controller/codeSets.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { CODE } from '../../../src/ui/words/code.js';
import { runs, SEED } from '../../helpers/property.js';
import { listing } from '../karel/tpListing.js';

/** @import { ProgramDoc } from '../../../src/model/document.js' */

/** @param {string} text @returns {ProgramDoc} */
const karel = (text) => ({ id: 'main', language: 'karel', text });
/** @param {string} text @returns {ProgramDoc} */
const tp = (text, id = 'main') => ({ id, language: 'fanuc-tp', text });
/** @param {string} text @returns {ProgramDoc} */
const krl = (text) => ({ id: 'main', language: 'krl', text });
const told = (/** @type {ProgramDoc} */ program) =>
  problemsOf([program], program).map(({ line, severity, message }) => `${line} ${severity} ${message}`);

test('problems of each language stand in the order of the text, at their places', () => {
  expect(told(karel('PROGRAM p\nVAR a, b : XYZWPR\nBEGIN\nMOVE TO a\nIF TRUE THEN MOVE TO b; ENDIF\nEND p\n'))).toEqual(
    [expect.stringContaining('4 warning MOVE is deprecated'), expect.stringContaining('5 warning MOVE is deprecated')],
  );
  expect(told(karel('PROGRAM p\nVAR a : INTEGER\nBEGIN\nEND p\n'))).toEqual(['2 warning "a" is never used.']);
  expect(told(karel("PROGRAM p\nVAR a : INTEGER\nBEGIN\na = 'x'\nEND p\n"))).toEqual([
    expect.stringMatching(/^4 error /),
  ]);
  const text = listing(['R[1]=', 'Weave End[1]', 'JMP LBL[2]'], [], { name: 'MAIN' });
  const problems = problemsOf([], tp(text));
  expect(problems.map(({ line, severity }) => [line, severity])).toEqual([
    [12, 'error'],
    [13, 'warning'],
    [14, 'error'],
  ]);
  expect(text.slice(problems[1].from, problems[1].to)).toContain('Weave End[1]');
  expect(told(krl('DEF a ( )\nPTP XP1\nFOO\nEND\n'))).toEqual([
    expect.stringMatching(/^3 error Expected a statement that is known here/),
  ]);
  expect(told(krl('&ACCESS RVP\n; list\nDEFDAT a\nDECL POS XP1={X 1,Y 2,Z 3,A 0,B 0,C 0}\nDECL x\nENDDAT\n'))).toEqual([
    expect.stringMatching(/^5 error Expected a position/),
  ]);
});

test('nothing is said against what a new program begins with, and its moves are found in order', () => {
  const mover = { id: 'go_lin', language: /** @type {const} */ ('fanuc-tp'), text: CODE.moverTemplate('go_lin') };
  const main = karel(CODE.template('main', 'z', 'go_lin'));
  const others = [mover, tp(CODE.tpTemplate('main', 'z')), krl(CODE.krlTemplate('main'))];
  for (const program of [main, ...others]) expect(problemsOf([program], program)).toEqual([]);
  const doc = { ...newDocument(LIBRARY.fanuc_m10ia), programs: [main, mover] };
  const files = codeSet(doc.programs, main).map(({ file }) => file);
  const { findings, moves } = verifyCode(doc, null, files);
  expect(moves.map(({ file, motion }) => [file, motion])).toEqual(Array(2).fill(['go_lin.ls', 'linear']));
  expect(findings.filter(({ message }) => !message.startsWith('up at '))).toEqual([]);
  // whoever asks what the arm does is told the line
  const made = createCodeRun(
    doc.programs,
    'main',
    codeArm(() => doc),
    systemAtFirst(doc),
  );
  if (!('run' in made)) throw new Error('Expected a program that runs.');
  const never = () => false;
  expect(made.run.advance(never, 1000, () => null).effect?.kind).toBe('move');
  expect(made.run.state().arm.motion?.effect.line).toBe(9);
});

test.for(
  /** @type {[string, string][]} */ ([
    ['ur5', 'z'],
    ['scara_cobra600', 'z'],
    ['stanford', 'z'],
    ['cart_ppp', 'z'],
    ['mitsubishi_rv2aj', 'z'],
    ['planar_pr', 'z'],
    ['planar_rp', 'y'],
    ['planar2r', 'y'],
    ['planar3r', 'y'],
  ]),
)('a new program leads somewhere on a %s, and its remark has room on a pendant', ([id, axis]) => {
  const robot = LIBRARY[id];
  expect(firstWay(newDocument(robot), CODE.newWay)).toBe(axis);
  const text = CODE.tpTemplate('main', /** @type {'y' | 'z'} */ (axis));
  const { faults, moves } = previewed([tp(text)], 'main', [], robot);
  expect(faults).toEqual([]);
  expect(moves).toHaveLength(2);
  expect(/!(.*) ;/.exec(text)?.[1].length).toBeLessThanOrEqual(MAX_REMARK_LENGTH);
});

test('each language completes its own words, and TP what is at hand', () => {
  const other = {
    id: 'mover',
    language: /** @type {const} */ ('karel'),
    text: 'PROGRAM mover_2\nBEGIN\nEND mover_2\n',
  };
  const main = tp(listing(['LBL[3:again]', 'JMP LBL[3]']));
  const names = namesFor([main, other], main);
  expect(names.slice(0, 2).map(({ name }) => name)).toEqual(['CALL MOVER_2', 'JMP LBL[3]']);
  expect(namesFor([], karel('PROGRAM p\nVAR speed : REAL\nBEGIN\nEND p\n'))).toContainEqual({
    name: 'speed',
    kind: 'variable',
    detail: 'REAL',
  });
  expect(namesFor([], krl('')).map(({ name }) => name)).toContain('PTP');
  // what is offered for TP is read, with what it proposes filled in
  for (const { name, typed = name } of names) {
    const line = typed.replace(/\$\{([^}]*)\}/g, '$1').replace(/\s*;$/, '');
    if (/^(CNT|FINE|ACC|Offset|Tool_Offset|Skip)/.test(line)) continue;
    const { diagnostics } = parseTp(listing([line.replace(/\n\s*:/, '\n')]));
    expect([name, ...diagnostics.map(({ message }) => message)]).toEqual([name]);
  }
});

const MESSY = `PROGRAM p -- p
%NOLOCKGROUP
  CONST
one = 1
VAR i : INTEGER
      ROUTINE r(a : INTEGER)
BEGIN
IF a = one THEN -- IF x THEN
-- a remark
i = a &
+ 1
ELSE
SELECT a OF
CASE(1): i = 2
CASE(2):
i = 3
ENDSELECT
ENDIF
END r
BEGIN
WHILE TRUE DO
REPEAT
i = 1
UNTIL i = 1
ENDWHILE
IF i = 1 THEN i = 2; ENDIF
i = 3
END p`;

test('KAREL is set in by its blocks', () => {
  expect(formatted(karel(MESSY)).split('\n')).toEqual([
    'PROGRAM p -- p',
    '%NOLOCKGROUP',
    'CONST',
    '  one = 1',
    'VAR i : INTEGER',
    'ROUTINE r(a : INTEGER)',
    'BEGIN',
    '  IF a = one THEN -- IF x THEN',
    '    -- a remark',
    '    i = a &',
    '      + 1',
    '  ELSE',
    '    SELECT a OF',
    '    CASE(1): i = 2',
    '    CASE(2):',
    '      i = 3',
    '    ENDSELECT',
    '  ENDIF',
    'END r',
    'BEGIN',
    '  WHILE TRUE DO',
    '    REPEAT',
    '      i = 1',
    '    UNTIL i = 1',
    '  ENDWHILE',
    '  IF i = 1 THEN i = 2; ENDIF',
    '  i = 3',
    'END p',
  ]);
});

test('what a preprocessor reads stays where it is: it has to stand at the very beginning of its line', () => {
  const text = 'PROGRAM p\nBEGIN\n%include a\n%define b \\\n      c\n   i = 1\n%ifdef b\nEND p';
  expect(formatted(karel(text))).toBe(text.replace('   i', '  i'));
});

test('TP is numbered, lines without a number too, and counted', () => {
  const text =
    '/PROG  A\n/ATTR\nLINE_COUNT\t= 9;\n/MN\n   7:J P[1] 100% FINE    ;\nC P[2]    \n    :  P[3] 5mm/sec FINE    ;\nR[1]=1 ;\n/POS\nP[1]{\n};\n/END\n';
  expect(formatted(tp(text))).toBe(
    '/PROG  A\n/ATTR\nLINE_COUNT\t= 3;\n/MN\n   1:J P[1] 100% FINE    ;\n   2:C P[2]    \n    :  P[3] 5mm/sec FINE    ;\n   3:  R[1]=1 ;\n/POS\nP[1]{\n};\n/END\n',
  );
});

test('putting lines in order loses nothing, and twice is as once', () => {
  const tokens = (/** @type {string} */ text) => {
    const all = scan(text, () => {});
    return all.map(({ type, text: of, fresh, comments }) => [type, of, fresh, comments.map((one) => one.text)]);
  };
  const bits = fc.constantFrom(
    ...MESSY.split('\n'),
    "s = 'IF -- x'",
    'ENDIF',
    '%define a b \\',
    '   more',
    "'open",
    '',
    '  MOVE TO p, WHEN DIN[1] DO',
    'ENDMOVE',
    'lab::',
    'UNTIL',
    'END',
  );
  const text = fc
    .tuple(fc.array(bits, { maxLength: 25 }), fc.nat({ max: 6 }))
    .map(([lines, n]) => lines.map((line, i) => ' '.repeat((i * n) % 5) + line).join('\n'));
  fc.assert(
    fc.property(text, fc.constantFrom('karel', 'krl'), (source, language) => {
      const program = { language: /** @type {ProgramDoc['language']} */ (language), text: source };
      const once = formatted(program);
      expect(once.split('\n').map((line) => line.trim())).toEqual(source.split('\n').map((line) => line.trim()));
      if (language === 'karel') expect(tokens(once)).toEqual(tokens(source));
      expect(formatted({ ...program, text: once })).toBe(once);
    }),
    { numRuns: runs(200), seed: SEED },
  );
  const tpLines = fc.array(
    fc.constantFrom(
      '   1:R[1]=1 ;',
      'R[2]=2 ;',
      '  12:  !text ;',
      'J P[1] 5% FINE ;',
      '',
      '!a remark ;',
      '    : P[2] ;',
    ),
    { maxLength: 12 },
  );
  fc.assert(
    fc.property(tpLines, (lines) => {
      const source = ['/PROG A', '/ATTR', 'LINE_COUNT = 0;', '/MN', ...lines, '/POS', '/END', ''].join('\n');
      const once = formatted(tp(source));
      const { tree } = parseTp(once);
      expect(linesOf(tree).map(({ number }) => number)).toEqual(linesOf(tree).map((_, i) => i + 1));
      const bare = (/** @type {string} */ text) =>
        text.split('\n').map((line) => line.replace(/^\s*(\d+:)?\s*/, '').replace(/= \d+;/, ''));
      expect(bare(once)).toEqual(bare(source));
      expect(formatted(tp(once))).toBe(once);
    }),
    { numRuns: runs(100), seed: SEED },
  );
});

test('signals that programs name are listed with what they are called, by the words of the language that is open', () => {
  const programs = [
    karel(
      "PROGRAM p\nCONST gripper = 2\nVAR i : INTEGER\nBEGIN\nDOUT[gripper] = ON -- DIN[9]\nIF DIN[1] THEN i = GIN[3]; WRITE('DIN[8]'); ENDIF\nEND p\n",
    ),
    tp(listing(['WAIT DI[1:part in bin]=ON', '!DI[7]', 'F[2]=ON', 'R[4:count]=PR[2,1:up]']), 'tp'),
  ];
  const named = signalsNamed(programs);
  const shown = (/** @type {ProgramDoc['language']} */ language) =>
    signalsOf(named, { DOUT: { 2: true, 5: false }, GIN: { 3: 7 } }, language).map(
      ({ name, comment, isInput, value }) => [name, comment, isInput, value],
    );
  expect(shown('fanuc-tp')).toEqual([
    ['DI[1]', 'part in bin', true, false],
    ['DO[2]', 'gripper', false, true],
    ['DO[5]', '', false, false],
    ['GI[3]', '', true, 7],
    ['F[2]', '', true, false],
  ]);
  expect(shown('karel')[0][0]).toBe('DIN[1]');
  expect([...registerComments(programs)]).toEqual([['R[4]', 'count']]);
});

const P = (/** @type {number} */ number, /** @type {number} */ j1) =>
  `P[${number}]{\n   GP1:\n\tUF : 0, UT : 0,\n\tJ1= ${j1} deg,\tJ2= -20 deg,\tJ3= 0 deg,\tJ4= 0 deg,\tJ5= -30 deg,\tJ6= 0 deg\n};`;

/** @param {readonly ProgramDoc[]} programs @param {string} [id] @param {Parameters<typeof previewOf>[2]} [given] @param {typeof firstRobot} [robot] */
function previewed(programs, id = programs[0].id, given = [], robot = firstRobot) {
  const doc = { ...newDocument(robot), programs };
  const finding = previewOf(doc, id, given);
  for (;;) {
    const next = finding.next();
    if (next.done) return next.value;
  }
}

test('where code leads: the end of each line, also of a line that calls, and what cannot be done is told there', () => {
  const main = tp(
    listing(
      [
        'J P[1] 100% FINE',
        'CALL SUB',
        'WAIT DI[1]=ON',
        'J P[2] 100% FINE',
        'J P[3] 100% FINE',
        'L P[1] 100mm/sec FINE',
        'J P[1] 50% FINE',
      ],
      [P(1, 0), P(2, 20), P(3, 300)],
      { name: 'MAIN' },
    ),
  );
  const sub = tp(listing(['J P[1] 100% FINE'], [P(1, 10)], { name: 'SUB' }), 'sub');
  const preview = previewed([main, sub]);
  expect(
    preview.moves.map(({ lines, posture }) => [
      lines.map(({ id, line }) => `${id} ${line}`).join(),
      Math.round(posture[0]),
    ]),
  ).toEqual([
    ['main 12', 0],
    ['main 13,sub 12', 10],
    ['main 15', 20],
    ['main 18', 0],
  ]);
  expect(moveOfLine(preview, 'main', 13)?.posture[0]).toBeCloseTo(10, 9);
  expect(moveOfLine(preview, 'sub', 12)?.posture[0]).toBeCloseTo(10, 9);
  expect(moveOfLine(preview, 'main', 14)).toBeNull();
  expect(pathOf(preview, 'main')?.points.map(({ line }) => line)).toEqual([12, 13, 15, 18]);
  expect(preview.faults).toEqual([{ id: 'main', line: 16, message: 'a joint would have to go past its limit' }]);
  expect(pathOf(preview, 'sub')?.points.map(({ line }) => line)).toEqual([12]);
  // one that is called leads where its caller has it; where that is faulty, where it leads by itself
  expect(previewed([main, sub], 'sub').moves).toHaveLength(4);
  expect(previewed([tp(listing(['CALL SUB', 'JMP LBL[9]'], [], { name: 'MAIN' })), sub], 'sub').moves).toHaveLength(1);
});

test('where code leads with registers that a person has set', () => {
  const main = tp(listing(['IF R[1]<>2,JMP LBL[1]', 'J P[1] 100% FINE', 'LBL[1]', 'J PR[3] 100% FINE'], [P(1, 20)]));
  expect(previewed([main]).faults.map(({ message }) => message)).toEqual(['R[1] has no value']);
  const { moves, faults } = previewed([main], 'main', [
    ['R', 1, 0, 2],
    ['PR', 3, 0, 400],
    ['PR', 3, 2, 300],
  ]);
  expect(faults).toEqual([]);
  expect(moves.map(({ way }) => [...way[way.length - 1]].map((value) => Number(value.toFixed(6))))[1]).toEqual([
    ...[0.4, 0, 0.97183], // FANUC's world is at the height of axis 2: 671.83 mm
  ]);
});

test('a program that never ends, one that is faulty and one that stops are looked at as far as they go', () => {
  const endless = previewed([
    tp(listing(['LBL[1]', 'J P[1] 100% FINE', 'J P[2] 100% FINE', 'JMP LBL[1]'], [P(1, 0), P(2, 20)])),
  ]);
  expect(endless.moves.length).toBe(100);
  const { faults } = previewed([krl('DEF a ( )\nPTP {X 9000,Y 0,Z 0,A 0,B 0,C 0}\nEND\n')]);
  expect(faults).toMatchObject([{ id: 'main', line: 2 }]);
  expect(previewed([tp(listing(['JMP LBL[5]']))])).toEqual({ moves: [], faults: [] });
  expect(
    previewed([karel('PROGRAM p\nVAR i : INTEGER\nBEGIN\ni = 0\nWHILE TRUE DO\ni = 1\nENDWHILE\nEND p\n')]).moves,
  ).toEqual([]);
  expect(previewed([tp(listing(['R[1]=R[2]']))]).faults).toEqual([
    { id: 'main', line: 12, message: 'R[2] has no value' },
  ]);
});

test('lines that are typed one after the other stand in order, whatever they are; other manners are left alone', () => {
  const typed = (/** @type {string[]} */ lines) => {
    let text = '';
    for (const line of lines) {
      const blanks = text.length - text.trimEnd().length;
      const set = whenLineEnds('karel', text + line, '');
      const own = text.slice(text.lastIndexOf('\n') + 1);
      expect(blanks).toBeGreaterThanOrEqual(own.length);
      if (!set) text += `${line}\n${own}`;
      else text = `${text.slice(0, text.length - own.length)}${set.own}${line}\n${set.next}`;
    }
    return text.trimEnd();
  };
  const text = formatted(karel(MESSY.replace(/^%.*\n|^[ \t]*\n/gm, '')));
  expect(typed(text.split('\n').map((line) => line.trim()))).toBe(text.trimEnd());
  expect(whenLineEnds('karel', 'PROGRAM p\n      VAR i : INTEGER\n      BEGIN', '')).toBeNull();
  expect(whenLineEnds('karel', 'PROGRAM p\nBEGIN\n  IF a THEN', ' b = 1')).toEqual({ own: '  ', next: '    ' });
});
