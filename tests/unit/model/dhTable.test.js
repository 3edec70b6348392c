/** A table that is copied and pasted back is the same table; code for toolboxes is run here by what their manuals say of it. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readTableText } from '../../../src/io/tableText.js';
import { guessColumns } from '../../../src/io/tableTextColumns.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { applyCommand } from '../../../src/model/commands.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { dhTableMatlab, dhTablePython } from '../../../src/model/robot/dhTableCode.js';
import { dhTableText } from '../../../src/model/robot/dhTableText.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { rowsOf } from '../../../src/model/numbers/poseRows.js';
import { planPaste } from '../../../src/ui/robot/pasteTablePlan.js';
import { SEED, runs } from '../../helpers/property.js';

/** @typedef {import('../../../src/model/document.js').Doc} Doc */

const anyLength = fc.oneof(
  fc.constantFrom(0, 431.8, -20.32, 1e-7, 12345.678),
  fc.double({ min: -1e4, max: 1e4, noNaN: true }),
);
const anyAngle = fc.oneof(
  fc.constantFrom(0, 90, -90, 180, 7.5, 12.3456),
  fc.double({ min: -720, max: 720, noNaN: true }),
);

/** An arm of the library with other numbers, in any units and convention. */
const anyTable = fc
  .record({
    robot: fc.constantFrom(...Object.values(LIBRARY)),
    rows: fc.array(fc.tuple(anyAngle, anyLength, anyLength, anyAngle), { minLength: 6, maxLength: 6 }),
    length: fc.constantFrom(/** @type {const} */ ('mm'), /** @type {const} */ ('m')),
    angle: fc.constantFrom(/** @type {const} */ ('deg'), /** @type {const} */ ('rad')),
    convention: fc.constantFrom(/** @type {const} */ ('standard'), /** @type {const} */ ('modified')),
  })
  .map(({ robot, rows, length, angle, convention }) => {
    const joints = robot.joints.map((joint, i) => {
      const [theta, d, a, alpha] = rows[i].map((value) => value + 0);
      return { ...joint, theta, d, a, alpha };
    });
    const doc = newDocument({ ...robot, joints, units: { length: 'mm', angle: 'deg' }, convention });
    const posture = doc.posture.map((_, i) => rows[i][0] / 10);
    return applyCommand({ ...doc, posture }, { type: 'convert-units', units: { length, angle } });
  });

describe('copied and pasted back, the table is the same', () => {
  test.each(/** @type {const} */ (['text', 'csv', 'markdown', 'latex']))('as %s', (format) => {
    fc.assert(
      fc.property(anyTable, ({ robot }) => {
        const { table } = readTableText(dhTableText(robot, format));
        const guess = guessColumns(table?.rows ?? [], 'standard');
        expect(guess.units).toEqual(robot.units);
        expect(guess.isModified).toBe(robot.convention === 'modified');
        const blank = newDocument({ ...LIBRARY.puma560, units: robot.units });
        const plan = planPaste(blank.robot, {
          ...{ rows: (table?.rows ?? []).slice(1), roles: guess.roles, units: robot.units },
          ...{ convention: robot.convention, from: null },
        });
        expect(plan.faults).toEqual([]);
        const pasted = applyCommand(blank, plan.command).robot;
        const numbers = (/** @type {Doc['robot']} */ { convention, joints }) => [
          convention === 'standard',
          joints.map(({ type, theta, d, a, alpha }) => [type === 'prismatic', theta, d, a, alpha]),
        ];
        const [read, wanted] = [pasted, robot].map((each) =>
          numbers(each)
            .flat(3)
            .map((value) => Number(value) + 0),
        ); // −0 is 0
        expect(read).toEqual(wanted);
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('as JSON, with base, tool, units and what the variable is', () => {
    const { robot } = newDocument(LIBRARY.scara_cobra600);
    const read = JSON.parse(dhTableText(robot, 'json'));
    expect(read.units).toEqual(robot.units);
    expect(read.tool).toEqual(robot.tool);
    expect(read.joints.map((/** @type {{ variable: string }} */ { variable }) => variable)).toEqual([
      'theta',
      'theta',
      'd',
      'theta',
    ]);
  });
});

/** @param {number[][]} A @param {number[][]} B */
const times = (A, B) => A.map((row) => B[0].map((_, j) => row.reduce((sum, value, k) => sum + value * B[k][j], 0)));
/** @param {number} t @param {number} z */
const aboutZ = (t, z) => [
  [Math.cos(t), -Math.sin(t), 0, 0],
  [Math.sin(t), Math.cos(t), 0, 0],
  [0, 0, 1, z],
  [0, 0, 0, 1],
];
/** @param {number} t @param {number} x */
const aboutX = (t, x) => [
  [1, 0, 0, x],
  [0, Math.cos(t), -Math.sin(t), 0],
  [0, Math.sin(t), Math.cos(t), 0],
  [0, 0, 0, 1],
];
const STILL = aboutZ(0, 0);

/** A number or a fraction of pi, as Python and MATLAB read it. @param {string} text */
function number(text) {
  const read = /^(-?)(?:(\d+)\*)?pi(?:\/(\d+))?$/.exec(text);
  if (!read) return Number(text);
  const [, sign, over = '1', under = '1'] = read;
  return ((sign ? -1 : 1) * Number(over) * Math.PI) / Number(under);
}

/** @param {number[][]} links  theta, d, a, alpha @param {boolean} isModified */
const along = (links, isModified) =>
  links
    .map(([theta, d, a, alpha]) =>
      isModified ? times(aboutX(alpha, a), aboutZ(theta, d)) : times(aboutZ(theta, d), aboutX(alpha, a)),
    )
    .reduce(times, STILL);

/** Base, joints and tool as the code says. @type {Record<string, (doc: Doc) => number[][]>} */
const RUN = {
  python(doc) {
    const code = dhTablePython(doc);
    const q = /^q = \[(.*)\]$/m.exec(code)?.[1].split(', ').map(Number) ?? [];
    let isModified = false;
    const links = [...code.matchAll(/rtb\.(Revolute|Prismatic)(M?)DH\((.*)\),$/gm)].map(([, kind, M, given], i) => {
      isModified = M === 'M';
      const value = (/** @type {string} */ name) =>
        number(new RegExp(`\\b${name}=([^,\\]]+)`).exec(given)?.[1] ?? 'none');
      const moved = value('offset') + q[i];
      return kind === 'Revolute'
        ? [moved, value('d'), value('a'), value('alpha')]
        : [value('theta'), moved, value('a'), value('alpha')];
    });
    const [base, tool] = ['base', 'tool'].map((end) => {
      const rows = new RegExp(`${end}=SE3\\(np\\.array\\(\\[\\n([\\s\\S]*?)\\n    \\]\\)\\)`).exec(code)?.[1];
      return rows
        ? rows
            .trim()
            .split('\n')
            .map((row) => JSON.parse(row.trim().replace(/,$/, '')))
        : STILL;
    });
    return [base, along(links, isModified), tool].reduce(times);
  },
  matlab(doc) {
    const code = dhTableMatlab(doc);
    const rows = (/** @type {string} */ name) =>
      new RegExp(`^${name} = \\[[^\\n]*\\n([\\s\\S]*?)\\n\\];`, 'm')
        .exec(code)?.[1]
        .split('\n')
        .map((row) => row.trim().split(' ').map(number)) ?? [];
    const list = (/** @type {string} */ name) =>
      new RegExp(`^${name} = \\[(.*)\\];`, 'm').exec(code)?.[1].split(' ').map(number) ?? [];
    const isSlide = [...(/types = \{(.*)\}/.exec(code)?.[1] ?? '').matchAll(/'(\w+)'/g)].map(
      ([, type]) => type === 'prismatic',
    );
    const [q, offset] = [list('q'), list('offset')];
    // The row's own theta or d is not looked at where the joint has it.
    const links = rows('dh').map(([a, alpha, d, theta], i) =>
      isSlide[i] ? [theta, q[i] + offset[i], a, alpha] : [q[i] + offset[i], d, a, alpha],
    );
    const isModified = /dh\(i, :\), 'mdh'/.test(code);
    return [rows('T_world_base'), along(links, isModified), rows('T_flange_tool')].reduce(times);
  },
};

test.each(Object.keys(RUN))('the tool is where %s code puts it, for any table', (language) => {
  fc.assert(
    fc.property(anyTable, (doc) => {
      const wanted = rowsOf(tcpPose(compileRobot(doc.robot), compilePosture(doc.robot, doc.posture)));
      const reach = Math.max(1, ...wanted.flat().map(Math.abs));
      RUN[language](doc).forEach((row, i) =>
        row.forEach((value, j) => expect(Math.abs(value - wanted[i][j])).toBeLessThan(1e-9 * reach)),
      );
    }),
    { seed: SEED, numRuns: runs(150) },
  );
});
