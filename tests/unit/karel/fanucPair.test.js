import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeFanucPair } from '../../../src/karel/fanucPair.js';
import { printKarel } from '../../../src/karel/printer.js';
import { printTp } from '../../../src/karel/tpPrinter.js';
import { runs, SEED } from '../../helpers/property.js';
import { readKarelPair, readTpPair } from './pairReader.js';

/** @import { PairOptions } from '../../../src/karel/fanucPlan.js' */

const ROTARY = Array.from({ length: 6 }, () => false);

/** @type {PairOptions} */
const PUMA = {
  programName: 'Puma_560',
  robotName: 'Puma 560',
  version: '0.1.0',
  generatedAt: '2026-07-01T12:00:00Z',
  convention: ['J1 = q1', 'J2 = -q2 + 90 deg'],
  points: [
    { name: 'p1', jointValues: [0, 45, -180, 0, 45, 0], slides: ROTARY },
    { name: 'above table', jointValues: [30.5, -12.34567, -90.0004, 0.0001, -0.0001, 265.9996], slides: ROTARY },
  ],
};

test('two postures of a Puma 560 as KAREL', () => {
  const [karel] = writeFanucPair(PUMA).files;
  expect(karel.name).toBe('puma_560.kl');
  expect(karel.language).toBe('karel');
  expect(karel.text).toBe(`-- Puma 560: 2 recorded postures
-- Written by Denavit 0.1.0, 2026-07-01 12:00:00
--
-- CAUTION. No controller has run this code and no FANUC translator has seen
-- it. Read it, compare the numbers with the teach pendant, and check it at low
-- speed before running it.
--
-- puma_560.kl fills PR[1] to PR[2] of motion group 1, whatever they hold, and
-- then calls PUMA_MV (puma_mv.ls), which moves through them at 20% of joint
-- speed. Load PUMA_MV first. Never run it alone: it goes wherever the
-- registers say. Some application tools keep PR[1] for themselves.
--
-- Joint values, J1 to J6 in degrees, are meant as the teach pendant shows
-- them:
--   J1 = q1
--   J2 = -q2 + 90 deg
-- They are rounded to 3 decimals, by at most 0.0005 degrees: for a turning
-- axis, 0.009 mm at one metre from it.
--
-- Not verified: that HOLD and alarms stop the motion. The KAREL part is told
-- to go on (%NOPAUSE), the TP part to pause (PAUSE_REQUEST = 0).
PROGRAM puma_560
%COMMENT = 'Puma 560'
%ENVIRONMENT REGOPE
%NOLOCKGROUP
%NOPAUSE = ERROR + COMMAND + TPENABLE

VAR
  joints : ARRAY[6] OF REAL
  target : JOINTPOS
  status : INTEGER

-- The TP program that moves. It must be on the controller before this one runs.
ROUTINE puma_mv FROM puma_mv

-- Puts the joint values into a position register, or stops before anything moves.
ROUTINE fill(reg_no : INTEGER)
BEGIN
  CNV_REL_JPOS(joints, target, status)
  IF status <> 0 THEN
    WRITE('CNV_REL_JPOS refused the joint values of PR[', reg_no, '], status ', status, CR)
    ABORT
  ENDIF
  IF NOT J_IN_RANGE(target) THEN
    WRITE('The joint values of PR[', reg_no, '] are outside the limits of the arm', CR)
    ABORT
  ENDIF
  SET_JPOS_REG(reg_no, target, status)
  IF status <> 0 THEN
    WRITE('SET_JPOS_REG could not write PR[', reg_no, '], status ', status, CR)
    ABORT
  ENDIF
END fill

BEGIN
  -- PR[1]: 'p1'
  joints[1] = 0.000
  joints[2] = 45.000
  joints[3] = -180.000
  joints[4] = 0.000
  joints[5] = 45.000
  joints[6] = 0.000
  fill(1)
  -- PR[2]: 'above table'
  joints[1] = 30.500
  joints[2] = -12.346
  joints[3] = -90.000
  joints[4] = 0.000
  joints[5] = 0.000
  joints[6] = 266.000
  fill(2)
  -- All registers are filled: move.
  puma_mv
END puma_560
`);
});

test('and as TP', () => {
  const [, tp] = writeFanucPair(PUMA).files;
  expect(tp.name).toBe('puma_mv.ls');
  expect(tp.language).toBe('fanuc-tp');
  expect(tp.text.replaceAll('\r\n', '\n')).toBe(`/PROG  PUMA_MV
/ATTR
OWNER\t\t= MNEDITOR;
COMMENT\t\t= "Puma 560";
PROG_SIZE\t= 0;
CREATE\t\t= DATE 26-07-01  TIME 12:00:00;
MODIFIED\t= DATE 26-07-01  TIME 12:00:00;
FILE_NAME\t= ;
VERSION\t\t= 0;
LINE_COUNT\t= 13;
MEMORY_SIZE\t= 0;
PROTECT\t\t= READ_WRITE;
TCD:  STACK_SIZE\t= 0,
      TASK_PRIORITY\t= 50,
      TIME_SLICE\t= 0,
      BUSY_LAMP_OFF\t= 0,
      ABORT_REQUEST\t= 0,
      PAUSE_REQUEST\t= 0;
DEFAULT_GROUP\t= 1,*,*,*,*;
CONTROL_CODE\t= 00000000 00000000;
/MN
   1:  !Puma 560: 2 recorded postures ;
   2:  !Written by Denavit 0.1.0. ;
   3:  !CAUTION: no controller has run ;
   4:  !this. Check it at low speed ;
   5:  !first. ;
   6:  !Run PUMA_560, not this: it fills ;
   7:  !PR[1] to PR[2] and calls this. ;
   8:  !Pendant joint values, J1 to J6 ;
   9:  !in degrees. ;
  10:  !PR[1]: 'p1' ;
  11:J PR[1] 20% FINE    ;
  12:  !PR[2]: 'above table' ;
  13:J PR[2] 20% FINE    ;
/POS
/END
`);
});

test('the text of a file is what its tree prints', () => {
  const [karel, tp] = writeFanucPair(PUMA).files;
  expect(karel.text).toBe(printKarel(karel.tree));
  expect(tp.text).toBe(printTp(tp.tree));
});

test('the same arguments give the same files', () => expect(writeFanucPair(PUMA)).toEqual(writeFanucPair(PUMA)));

test('registers, speed, termination and frames are as asked, and the arm stops at the last point', () => {
  const points = ['a', 'b', 'c'].map((name) => ({ ...PUMA.points[0], name }));
  const options = { firstRegister: 7, speedPercent: 5, termination: 50, userFrame: 0, toolFrame: 2 };
  const [karel, tp] = writeFanucPair({ ...PUMA, ...options, points }).files;
  expect(karel.text.match(/fill\(\d+\)/g)).toEqual(['fill(7)', 'fill(8)', 'fill(9)']);
  const instructions = tp.text.split('\r\n').flatMap((line) => (/^ *\d+:(?! {2}!)(.*?) *;$/.exec(line) ?? []).slice(1));
  expect(instructions).toEqual([
    '  UFRAME_NUM=0',
    '  UTOOL_NUM=2',
    'J PR[7] 5% CNT50',
    'J PR[8] 5% CNT50',
    'J PR[9] 5% FINE',
  ]);
  expect(tp.text).toContain('!PR[7] to PR[9] and calls this. ;');
  expect(karel.text).toContain('-- puma_560.kl fills PR[7] to PR[9] of motion group 1');
});

/** Joint values that are hard to write: tiny, at a rounding edge, large, minus zero. */
const anyValue = fc.oneof(
  fc.double({ min: -99999.999, max: 99999.999, noNaN: true }),
  fc.double({ min: -400, max: 400, noNaN: true }),
  fc.integer({ min: -99999000, max: 99999000 }).map((half) => half / 1000 + 0.0005),
  fc.constantFrom(0, -0, -0.0001, 1e-7, -1e-300, 0.0005, -0.0005, 99999.999, -99999.999),
);
const anyText = fc.oneof(
  fc.string({ unit: 'binary', maxLength: 60 }),
  fc.constantFrom(
    'x\nABORT',
    "'); ABORT",
    'x\r\n  9:J PR[1] 100% FINE ;',
    'a; b',
    '"; PROTECT = READ;',
    'a &',
    '--',
    '\u2028END',
    "it's",
    ';\n/END',
    '﹔',
    '\u037e',
  ),
);
const anyPair = fc
  .record({ axes: fc.array(fc.boolean(), { minLength: 1, maxLength: 9 }), points: fc.integer({ min: 1, max: 5 }) })
  .chain(({ axes, points }) =>
    fc.record({
      programName: anyText,
      robotName: anyText,
      version: anyText,
      generatedAt: fc.constantFrom('2026-07-01T12:00:00Z', '2031-12-31T23:59:59.999+14:00'),
      convention: fc.array(anyText, { maxLength: 3 }),
      points: fc.array(
        fc.record({
          name: anyText,
          jointValues: fc.array(anyValue, { minLength: axes.length, maxLength: axes.length }),
          slides: fc.constant(axes),
        }),
        { minLength: points, maxLength: points },
      ),
      firstRegister: fc.integer({ min: 1, max: 1900 }),
      speedPercent: fc.integer({ min: 1, max: 100 }),
      termination: fc.oneof(fc.constant(/** @type {const} */ ('FINE')), fc.integer({ min: 0, max: 100 })),
    }),
  );

test('whatever it is asked to write, every line is one that the languages know, and the numbers are the ones given', () => {
  fc.assert(
    fc.property(anyPair, (options) => {
      const [karel, tp] = writeFanucPair(options).files;
      const filled = readKarelPair(karel.text);
      const moved = readTpPair(tp.text);
      expect(karel.name).toBe(`${filled.program}.kl`);
      expect(tp.name).toBe(`${moved.program.toLowerCase()}.ls`);
      expect(filled.calls).toBe(moved.program.toLowerCase());
      expect(filled.program).not.toBe(filled.calls);
      expect(filled.axes).toBe(options.points[0].slides.length);

      const registers = options.points.map((_, i) => options.firstRegister + i);
      expect(filled.points.map(({ register }) => register)).toEqual(registers);
      expect(moved.moves.map(({ register }) => register)).toEqual(registers);
      options.points.forEach(({ jointValues }, i) => {
        filled.points[i].values.forEach((value, axis) => {
          // Half a thousandth, and what a double costs beside 100 000.
          expect(Math.abs(value - jointValues[axis])).toBeLessThanOrEqual(0.0005 + 1e-11);
        });
        const last = i === options.points.length - 1;
        const end = last || options.termination === 'FINE' ? 'FINE' : `CNT${options.termination}`;
        expect(moved.moves[i]).toEqual({ register: registers[i], speed: options.speedPercent, end });
      });
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});

test('a point called "x, new line, ABORT" is a comment and nothing else', () => {
  const points = [{ ...PUMA.points[0], name: 'x\nABORT' }];
  const [karel, tp] = writeFanucPair({ ...PUMA, points }).files;
  expect(karel.text).toContain("\n  -- PR[1]: 'x ABORT'\n");
  expect(tp.text).toContain("!PR[1]: 'x ABORT' ;\r\n");
  expect(karel.text.match(/^ *ABORT$/gm)).toHaveLength(3);
});

test.for(
  /** @type {[string, Partial<PairOptions>, string, string][]} */ ([
    ['a name that the controller cannot take', { programName: '2 fast' }, 'program-name-changed', 'programName'],
    ['registers beyond the usual hundred', { firstRegister: 100 }, 'many-registers', 'points'],
    [
      'four axes',
      { points: [{ name: 'p', jointValues: [1, 2, 3, 4], slides: [false, false, true, false] }] },
      'axis-count',
      'points',
    ],
  ]),
)('%s comes with a warning', ([, options, code, path]) => {
  expect(writeFanucPair(PUMA).issues).toEqual([]);
  expect(writeFanucPair({ ...PUMA, ...options }).issues).toMatchObject([{ severity: 'warning', code, path }]);
});

test('the hundredth register is the last usual one', () => {
  expect(writeFanucPair({ ...PUMA, firstRegister: 99 }).issues).toEqual([]);
});

test('the header says which axes slide, and that other than six axes are not verified', () => {
  const points = [{ name: 'p', jointValues: [1, 2, 3, 4], slides: [false, false, true, false] }];
  const [karel, tp] = writeFanucPair({ ...PUMA, points, convention: [] }).files;
  const header = karel.text.split('PROGRAM')[0].replaceAll('\n-- ', ' ');
  expect(header).toContain(
    'J1, J2, J4 in degrees, J3 in mm, are meant as the teach pendant shows them. They are rounded to 3 decimals, by at most 0.0005 degrees or mm',
  );
  expect(header).toContain('Not verified: that CNV_REL_JPOS takes an array of 4 for an arm with 4 axes.');
  expect(tp.text.replace(/ ;\r\n *\d+: {2}!/g, ' ')).toContain(
    ' Pendant joint values, J1, J2, J4 in degrees, J3 in mm. ',
  );
  expect(karel.text).toContain('joints : ARRAY[4] OF REAL');
});

const point = PUMA.points[0];
test.for(
  /** @type {[string, Partial<PairOptions>][]} */ ([
    ['no points', { points: [] }],
    ['no axes', { points: [{ name: 'p', jointValues: [], slides: [] }] }],
    ['ten axes', { points: [{ name: 'p', jointValues: Array(10).fill(0), slides: Array(10).fill(false) }] }],
    ['five values for six axes', { points: [{ ...point, jointValues: [0, 0, 0, 0, 0] }] }],
    ['points of different axes', { points: [point, { ...point, slides: [true, ...ROTARY.slice(1)] }] }],
    ['a value that is no number', { points: [{ ...point, jointValues: [NaN, 0, 0, 0, 0, 0] }] }],
    ['an infinite value', { points: [{ ...point, jointValues: [Infinity, 0, 0, 0, 0, 0] }] }],
    ['a value of 100 000', { points: [{ ...point, jointValues: [-100000, 0, 0, 0, 0, 0] }] }],
    ['register 0', { firstRegister: 0 }],
    ['register 1.5', { firstRegister: 1.5 }],
    ['registers beyond 2000', { firstRegister: 2000 }],
    ['no speed', { speedPercent: 0 }],
    ['CNT of 101', { termination: 101 }],
    ['a time that is none', { generatedAt: 'yesterday' }],
    ['month 13', { generatedAt: '2026-13-01T12:00:00Z' }],
    ['a frame of 1.5', { toolFrame: 1.5 }],
  ]),
)('%s is refused', ([, options]) => expect(() => writeFanucPair({ ...PUMA, ...options })).toThrow(RangeError));
