/**
 * The whole DH table as text: for a spreadsheet, a README, a report, a program. The variable of a joint stands with its
 * constant, q₂ + 90, so that the two are never confused; the first head names the convention. Numbers have all their
 * digits, and what is pasted back is the same table. Code for toolboxes is in dhTableCode.js.
 *
 * @import { DhField, JointDoc, JointField, RobotDoc } from '../document.js'
 *
 * @typedef {'text' | 'csv' | 'markdown' | 'latex' | 'json'} TableTextFormat
 */
import { DH_FIELDS, isSliding, limitsOf, quantityOf } from '../document.js';
import { digits } from '../numbers/copyText.js';
import { commonAngle, convertAngle } from '../units.js';

/**
 * How a format writes what is not a plain number.
 * @typedef {object} Signs
 * @property {Record<DhField, string>} letters
 * @property {string} own         index of a parameter that belongs to its own joint
 * @property {string} before      of one that belongs to the joint before
 * @property {string} pi
 * @property {(index: number) => string} variable
 */

/** @type {Signs} */
const WORDS = {
  letters: { theta: 'theta', d: 'd', a: 'a', alpha: 'alpha' },
  own: '_i',
  before: '_(i-1)',
  pi: 'pi',
  variable: (index) => `q${index}`,
};
/** @type {Signs} */
const GREEK = { ...WORDS, letters: { theta: 'θ', d: 'd', a: 'a', alpha: 'α' }, pi: 'π' };
/** @type {Signs} */
const TEX = {
  letters: { theta: '\\theta', d: 'd', a: 'a', alpha: '\\alpha' },
  own: '_{i}',
  before: '_{i-1}',
  pi: '\\pi',
  variable: (index) => `q_{${index}}`,
};

/** @param {RobotDoc} robot */
const conventionOf = ({ convention }) => (convention === 'standard' ? 'Standard DH' : 'Modified DH');

/** A common fraction of π as such, any other number with all its digits. @param {number} value @param {boolean} isRadians @param {string} pi */
function numberText(value, isRadians, pi) {
  const common = isRadians ? commonAngle(convertAngle(value, 'rad', 'deg')) : null;
  return common?.value === value ? common.text.replace(pi === WORDS.pi ? 'pi' : /\*?pi/, pi) : digits(value);
}

/** @param {RobotDoc} robot @param {JointField} field @param {number} index @param {Signs} signs */
function cellText({ joints, units }, field, index, { pi, variable }) {
  const joint = joints[index];
  const value = /** @type {number} */ (joint[field]);
  const text = numberText(value, quantityOf(joint, field) === 'angle' && units.angle === 'rad', pi);
  if (field !== (isSliding(joint) ? 'd' : 'theta')) return text;
  if (value === 0) return variable(index + 1);
  return `${variable(index + 1)} ${value < 0 ? '-' : '+'} ${text.replace(/^-/, '')}`;
}

/** @param {RobotDoc} robot @param {DhField} field @param {Signs} signs */
function headText({ convention }, field, { letters, own, before }) {
  const isBefore = convention === 'modified' && (field === 'a' || field === 'alpha');
  return `${letters[field]}${isBefore ? before : own}`;
}

/** @param {RobotDoc} robot @param {DhField} field */
const unitOf = ({ joints, units }, field) => units[quantityOf(joints[0], field)];

/** Limits with their unit in each cell, because in one column an arm may have degrees and millimetres. @param {RobotDoc} robot @param {JointDoc} joint */
function limitTexts({ units }, joint) {
  const { lower, upper } = limitsOf(joint);
  return [lower, upper].map((value) =>
    Number.isFinite(value) ? `${digits(value)} ${units[quantityOf(joint, 'lower')]}` : '',
  );
}

/** @param {RobotDoc} robot @param {Signs} signs @returns {string[][]} the head first */
function cells(robot, signs) {
  const heads = DH_FIELDS.map((field) => `${headText(robot, field, signs)} [${unitOf(robot, field)}]`);
  const rows = robot.joints.map((joint, i) => [
    String(i + 1),
    ...DH_FIELDS.map((field) => cellText(robot, field, i, signs)),
    ...limitTexts(robot, joint),
  ]);
  return [[conventionOf(robot), ...heads, 'lower', 'upper'], ...rows];
}

/** @param {RobotDoc} robot */
function asLatex(robot) {
  const { name, units } = robot;
  const heads = DH_FIELDS.map((field) => `$${headText(robot, field, TEX)}$ [${unitOf(robot, field)}]`);
  const rows = robot.joints.map((_, i) => [
    String(i + 1),
    ...DH_FIELDS.map((field) => `$${cellText(robot, field, i, TEX).replace(/e([-+]?\d+)$/, ' \\cdot 10^{$1}')}$`),
  ]);
  const line = (/** @type {string[]} */ row) => `  ${row.join(' & ')} \\\\`;
  return [
    `% ${name.replace(/\s+/g, ' ').trim() || 'Robot'}: ${conventionOf(robot)}, ${units.length} and ${units.angle}`,
    '\\begin{tabular}{crrrr}',
    '  \\hline',
    line([conventionOf(robot), ...heads]),
    '  \\hline',
    ...rows.map(line),
    '  \\hline',
    '\\end{tabular}',
  ].join('\n');
}

/** @param {RobotDoc} robot */
function asMarkdown(robot) {
  const [head, ...rows] = cells(robot, GREEK);
  const line = (/** @type {string[]} */ row) => `| ${row.join(' | ')} |`;
  return [line(head), line(head.map((_, i) => (i === 0 ? '---' : '---:'))), ...rows.map(line)].join('\n');
}

/** @param {RobotDoc} robot */
const asJson = ({ name, convention, units, base, tool, joints }) =>
  JSON.stringify(
    {
      ...{ name, convention: `${convention} DH`, units, base, tool },
      joints: joints.map(({ type, theta, d, a, alpha, lower, upper }) => ({
        ...{ type, variable: isSliding({ type }) ? 'd' : 'theta' },
        ...{ theta: theta + 0, d: d + 0, a: a + 0, alpha: alpha + 0, lower, upper },
      })),
    },
    null,
    2,
  );

/** @type {Record<TableTextFormat, (robot: RobotDoc) => string>} */
const WRITERS = {
  text: (robot) =>
    cells(robot, WORDS)
      .map((row) => row.join('\t'))
      .join('\n'),
  csv: (robot) =>
    cells(robot, WORDS)
      .map((row) => row.join(','))
      .join('\n'),
  markdown: asMarkdown,
  latex: asLatex,
  json: asJson,
};

/**
 * @param {RobotDoc} robot
 * @param {TableTextFormat} format
 * @returns {string} lines, the last one ended
 */
export const dhTableText = (robot, format) => `${WRITERS[format](robot)}\n`;
