/** MOVE of KAREL as calls of TP: the arm goes the same way, or nothing is changed and a sentence says why. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { previewOf } from '../../../src/model/code/codePreview.js';
import { withTpCalls } from '../../../src/model/code/tpCalls.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Doc, ProgramDoc } from '../../../src/model/document.js' */

const WRITTEN = { version: '0.1.0', generatedAt: '2026-07-01T12:00:00Z' };
/** m: 0.01 mm. */
const NEAR = 1e-5;

/** @param {string} body @param {string} [declared] @param {string} arm @returns {Doc} */
const documentOf = (body, declared = '', arm = 'puma560') => ({
  ...newDocument(LIBRARY[arm]),
  programs: [
    {
      ...{ id: 'main', language: 'karel' },
      text: `PROGRAM main
-- kept
VAR a, b : XYZWPR
  j : JOINTPOS
  q : ARRAY[6] OF REAL
  i, st : INTEGER
${declared}
BEGIN
  a = CURPOS(0, 0)
  j = CURJPOS(0, 0)
  b = a  -- kept too
${body}
END main
`,
    },
  ],
});

/** @param {Doc} doc */
function wayOf(doc) {
  const steps = previewOf(doc, 'main');
  for (;;) {
    const { done, value } = steps.next();
    if (!done) continue;
    expect(value.faults).toEqual([]);
    return value.moves.map(({ way }) => way.map((place) => [...place]));
  }
}

/** @param {Doc} doc */
function rewritten(doc) {
  const made = withTpCalls(doc, 'main', WRITTEN);
  if ('reason' in made) throw new Error(made.reason);
  return { ...doc, programs: made.programs };
}

/** @param {Doc} doc @param {number} count  of moves */
function expectSameWay(doc, count) {
  const after = rewritten(doc);
  const [before, now] = [wayOf(doc), wayOf(after)];
  expect(before).toHaveLength(count);
  expect(now).toHaveLength(count);
  before.forEach((way, i) =>
    way.forEach((place, k) => expect(Math.hypot(...place.map((x, n) => x - now[i][k][n]))).toBeLessThan(NEAR)),
  );
  return after.programs;
}

const LIN = '$MOTYPE = LINEAR, $SPEED = 200.0, $TERMTYPE = FINE';

describe('the arm goes the same way', () => {
  test('in small programs by chance', () => {
    const move = fc.record({
      ...{ axis: fc.constantFrom('x', 'y', 'z'), by: fc.integer({ min: -40, max: 40 }), isJoint: fc.boolean() },
      ...{
        with: fc.boolean(),
        speed: fc.integer({ min: 1, max: 900 }),
        end: fc.constantFrom('FINE', 'NOSETTLE', 'NODECEL'),
      },
      block: fc.constantFrom('', 'IF', 'FOR', 'call'),
    });
    fc.assert(
      fc.property(
        fc.array(move, { minLength: 1, maxLength: 4 }),
        fc.constantFrom('puma560', 'fanuc_lrmate200id'),
        (all, arm) => {
          const body = all.map(({ axis, by, isJoint, with: isWith, speed, end, block }) => {
            const settings = [`$MOTYPE = ${isJoint ? 'JOINT' : 'LINEAR'}`, `$SPEED = ${speed}.0`, `$TERMTYPE = ${end}`];
            const there = `    a.${axis} = a.${axis} + ${by}.0`.replace('+ -', '- ');
            const go = isWith
              ? [`    WITH ${settings.join(', ')} MOVE TO a`]
              : [...settings, 'MOVE TO a'].map((one) => `    ${one}`);
            if (block === 'call') return [there, `    WITH ${LIN} MOVE TO a`, '    back'].join('\n');
            const open = block === 'IF' ? '  IF i < 9 THEN' : block === 'FOR' ? '  FOR i = 1 TO 2 DO' : '';
            return [open, there, ...go, block && `  END${block}`].filter(Boolean).join('\n');
          });
          const doc = documentOf(
            ['  i = 0', ...body].join('\n'),
            `ROUTINE back\nBEGIN\n  WITH ${LIN} MOVE TO b -- back\nEND back`,
            arm,
          );
          expectSameWay(
            doc,
            all.reduce((sum, { block }) => sum + (block === 'FOR' || block === 'call' ? 2 : 1), 0),
          );
        },
      ),
      { seed: SEED, numRuns: runs(6) },
    );
  });

  test('in another frame, with another tool, and to joint values', () => {
    const doc = documentOf(`  $GROUP[1].$UFRAME = $MOR_GRP[1].$NILPOS
  $UTOOL = $MOR_GRP[1].$NILPOS
  a = CURPOS(0, 0)
  $MNUFRAME[1, 2] = a
  $UFRAME = $MNUFRAME[1, 2]
  b = CURPOS(0, 0)
  b.z = 30.0
  WITH ${LIN} MOVE TO b
  $UFRAME = $MOR_GRP[1].$NILPOS
  WITH $MOTYPE = JOINT, $TERMTYPE = VARDECEL, $DECELTOL = 50 MOVE TO j`);
    const programs = expectSameWay(doc, 2);
    expect(programs[0].text.split('\n').slice(1, 3)).toEqual(['%ENVIRONMENT REGOPE', '%NOLOCKGROUP']);
    expect(programs[1].text).toContain('UFRAME_NUM=2');
    expect(programs[2].text).toMatch(/J PR\[100\] 10% CNT50/);
  });
});

test('all else of the text stays; what is used already is left alone', () => {
  const doc = documentOf(
    `  SET_POS_REG(100, a, mv_stat)\n  WITH ${LIN} MOVE TO b -- there`,
    '  mv_stat : INTEGER\n%LOCKGROUP = 1\n%ENVIRONMENT REGOPE',
  );
  const [main, mover] = rewritten(doc).programs;
  expect(mover.id).toBe('main_mv');
  expect(mover.text).toMatch(/L PR\[99\] 200mm\/sec FINE/);
  const [before, after] = [doc.programs[0], main].map(({ text }) => text.split('\n'));
  expect(before.filter((line) => !after.includes(line))).toEqual([
    '%LOCKGROUP = 1',
    `  WITH ${LIN} MOVE TO b -- there`,
  ]);
  expect(after.filter((line) => !before.includes(line))).toEqual([
    '%NOLOCKGROUP',
    ...['VAR', '  mv_stat2 : INTEGER', 'ROUTINE main_mv FROM main_mv', 'ROUTINE mv_check(what : STRING)'],
    '  IF mv_stat2 <> 0 THEN',
    "    WRITE(what, ' gave status ', mv_stat2, CR)",
    ...['    ABORT', '  ENDIF', 'END mv_check', '  SET_POS_REG(99, b, mv_stat2)', "  mv_check('SET_POS_REG')"],
    '  main_mv -- there',
  ]);
});

describe('it is refused, with the line', () => {
  test.each([
    [`  WITH ${LIN}, $UFRAME = $MNUFRAME[1, 2] MOVE TO a`, '$UFRAME is to be set before'],
    ['  MOVE TO a', 'Line 12: $MOTYPE is no number that is known here'],
    ['  WITH $MOTYPE = LINEAR, $TERMTYPE = FINE MOVE TO a', '$SPEED is no number'],
    ['  WITH $MOTYPE = LINEAR, $SPEED = 100 MOVE TO a', '$TERMTYPE is no number'],
    ['  i = 200\n  WITH $MOTYPE = LINEAR, $SPEED = i, $TERMTYPE = FINE MOVE TO a', 'Line 13: $SPEED is no number'],
    ['  $SPEED = 100\n  other\n  WITH $MOTYPE = LINEAR, $TERMTYPE = FINE MOVE TO a', '$SPEED is no number'],
    [
      '  $SPEED = 9\n  FOR i = 1 TO 2 DO\n    WITH $MOTYPE = LINEAR, $TERMTYPE = FINE MOVE TO a\n    $SPEED = 99\n  ENDFOR',
      'Line 14: $SPEED',
    ],
    [
      '  IF i > 1 THEN\n    $SPEED = 9\n  ENDIF\n  WITH $MOTYPE = LINEAR, $TERMTYPE = FINE MOVE TO a',
      'Line 15: $SPEED',
    ],
    [
      '  $SPEED = 9\n  CONDITION[1]:\n    WHEN DIN[1] DO\n      $SPEED = 99\n  ENDCONDITION\n  WITH $MOTYPE = LINEAR, $TERMTYPE = FINE MOVE TO a',
      'Line 17: $SPEED',
    ],
    [`  $UFRAME = b\n  WITH ${LIN} MOVE TO a`, 'Line 13: $UFRAME is not known'],
    [`  WITH ${LIN} MOVE TO a NOWAIT`, 'NOWAIT cannot stay'],
    [`  WITH ${LIN} MOVE TO a, UNTIL DIN[1] ENDMOVE`, 'WHEN and UNTIL'],
    [`  WITH ${LIN} MOVE NEAR a BY 10.0`, 'not NEAR'],
    [`  WITH ${LIN}, $ORIENT_TYPE = RSWORLD MOVE TO a`, '$ORIENT_TYPE'],
    [`  WITH ${LIN} MOVE TO j`, 'LINEAR to a position'],
    [`  WITH ${LIN} MOVE TO a\n  CANCEL`, 'Line 13: CANCEL'],
  ])('%s', (body, reason) => {
    const made = withTpCalls(documentOf(body, 'ROUTINE other FROM other'), 'main', WRITTEN);
    expect('reason' in made && made.reason).toContain(reason);
  });
});
