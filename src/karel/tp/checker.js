/**
 * What can be said against a TP program before it runs: labels, blocks, positions, speeds, frames, names.
 *
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { TpAction, TpInstruction, TpLine, TpListing, TpMotion, TpOperand, TpRegister } from './tree.js'
 */
import { constant, prepareTp } from './run/program.js';
import { attributeOf, nameOf, positionsOf } from './tree.js';

/** HandlingTool operator's manual, 7.2: what speeds may be, by their unit. */
const SPEEDS = /** @type {Readonly<Record<string, readonly [number, number]>>} */ ({
  ...{ '%': [1, 100], sec: [0.1, 3200], msec: [1, 3_200_000], 'mm/sec': [1, 2000], 'cm/min': [1, 12000] },
  ...{ 'inch/min': [0.1, 4724.41], 'deg/sec': [1, 500] },
});

const MAX_COMMENT = 16;
const MAX_NAME = 36;
const OLD_NAME = 8;

/** @param {TpListing} listing @returns {Diagnostic[]} */
export function checkTp(listing) {
  const code = prepareTp(listing);
  /** @type {Diagnostic[]} */
  const diagnostics = [];
  /** @type {(severity: Diagnostic['severity'], code: string, message: string, part?: { span?: Diagnostic['span'] }) => void} */
  const report = (severity, kind, message, part) =>
    void diagnostics.push({
      severity,
      code: kind,
      message,
      span: part?.span ?? { start: 0, end: 0, line: 1, column: 1 },
    });

  checkHead(listing, report);
  for (const { line, code: kind, message } of code.faults) report('error', kind, message, code.lines[line]);

  /** @type {{ user: boolean, tool: boolean }} */
  const chosen = { user: false, tool: false };
  /** @type {Set<number>} */
  const used = new Set();
  for (const [i, line] of code.lines.entries()) {
    const { instruction } = line;
    for (const label of labelsIn(instruction)) {
      const index = constant(label.index);
      if (index !== null && !code.labels.has(index))
        report('error', 'label', `LBL[${index}] is jumped to, and stands nowhere in this program.`, line);
    }
    if (instruction.kind === 'assign' && instruction.target.kind === 'word') {
      if (instruction.target.word === 'UFRAME_NUM') chosen.user = true;
      if (instruction.target.word === 'UTOOL_NUM') chosen.tool = true;
    }
    if ((instruction.kind === 'case' || instruction.kind === 'case-else') && !followsSelect(code.lines, i))
      report('error', 'select', 'Expected SELECT, or another choice of it, in the line before.', line);
    if (instruction.kind !== 'motion') {
      for (const point of registersIn(instruction)) if (point.bank === 'P') note(point, used);
      continue;
    }
    checkMotion(instruction, line, report);
    for (const point of [instruction.target, instruction.via]) {
      if (point?.bank !== 'P') continue;
      note(point, used);
      const index = constant(point.index);
      if (index !== null && !code.positions.has(index))
        report('error', 'position', `P[${index}] is moved to, and is not among the positions.`, line);
    }
    if (!chosen.user || !chosen.tool) {
      const missing = [...(chosen.user ? [] : ['UFRAME_NUM']), ...(chosen.tool ? [] : ['UTOOL_NUM'])];
      const [are, they] = missing.length > 1 ? ['are', 'they are'] : ['is', 'it is'];
      const message = `${missing.join(' and ')} ${are} not set before this move: ${they} whatever was chosen last.`;
      report('warning', 'frames', message, line);
      chosen.user = chosen.tool = true;
    }
  }
  for (const position of positionsOf(listing)) {
    if (!used.has(position.number)) report('warning', 'unused', `P[${position.number}] is not used.`, position);
    if (code.positions.get(position.number) !== position)
      report('error', 'position', `P[${position.number}] stands here, and once more further down.`, position);
    if (position.groups.some(({ values }) => values.some(({ value }) => value === null)))
      report('warning', 'not-taught', `P[${position.number}] is not taught.`, position);
  }
  return diagnostics;
}

/** @typedef {(severity: Diagnostic['severity'], code: string, message: string, part?: { span?: Diagnostic['span'] }) => void} Report */

/** @param {TpListing} listing @param {Report} report */
function checkHead(listing, report) {
  const name = nameOf(listing);
  const head = listing.parts.find((part) => part.kind === 'section' && part.name === 'PROG');
  if (!/^[A-Z-][A-Z0-9_-]*$/.test(name) || name.length > MAX_NAME)
    report(
      'error',
      'name',
      `Expected a name of a letter, then letters, digits and _, at most ${MAX_NAME}, got "${name}".`,
      head,
    );
  else if (name.length > OLD_NAME)
    report(
      'warning',
      'name-length',
      `The name "${name}" has more than ${OLD_NAME} characters: older controllers do not take it.`,
      head,
    );
  const comment = attributeOf(listing, 'COMMENT')?.replace(/^"|"$/g, '') ?? '';
  if (comment.length > MAX_COMMENT)
    report('warning', 'comment', `The comment has ${comment.length} characters; ${MAX_COMMENT} are kept.`, head);
  const group = attributeOf(listing, 'DEFAULT_GROUP');
  const motion = listing.parts.find((part) => part.kind === 'line' && part.instruction.kind === 'motion');
  if (motion && group !== undefined && /^[*,\s]+$/.test(group))
    report('error', 'group', 'The program moves, and DEFAULT_GROUP says that it has no motion group.', motion);
}

/** @param {TpMotion} motion @param {TpLine} line @param {Report} report */
function checkMotion({ motion, speed, termination }, line, report) {
  const value = constant(speed.value);
  const isShare = speed.unit === '%';
  if (motion === 'J' ? !isShare && !/sec$/.test(speed.unit) : isShare)
    report('error', 'speed', `A speed in ${speed.unit} does not go with ${motion}.`, line);
  const [least, most] = SPEEDS[speed.unit];
  if (value !== null && (value < least || value > most)) {
    // how fast its tool may go is the robot's own
    const isQuick = value > most && /^(mm|cm|inch)/.test(speed.unit);
    const message = isQuick
      ? `${value} ${speed.unit} is more than the ${most} of HandlingTool's manual: not every robot takes it.`
      : `Expected a speed from ${least} to ${most} ${speed.unit}, got ${value}.`;
    report(isQuick ? 'warning' : 'error', 'speed', message, line);
  }
  const end = termination.kind === 'CNT' ? constant(termination.value) : null;
  if (end !== null && (end < 0 || end > 100 || !Number.isInteger(end)))
    report('error', 'termination', `Expected CNT0 to CNT100, got CNT${end}.`, line);
}

/** @param {readonly TpLine[]} lines @param {number} at */
function followsSelect(lines, at) {
  let before = at - 1;
  while (before >= 0 && lines[before].instruction.kind === 'case') before--;
  return before >= 0 && lines[before].instruction.kind === 'select';
}

/** @param {TpRegister} point @param {Set<number>} used */
function note(point, used) {
  const index = constant(point.index);
  if (index !== null) used.add(index);
}

/** Every label that an instruction may jump to. @param {TpInstruction} node @returns {TpRegister[]} */
function labelsIn(node) {
  const from = (/** @type {TpAction} */ action) => (action.kind === 'jump' ? [action.label] : []);
  if (node.kind === 'jump') return [node.label];
  if (node.kind === 'wait-for') return node.timeout ? [node.timeout] : [];
  if (node.kind === 'motion')
    return node.options.flatMap(({ value }) => (value?.kind === 'register' && value.bank === 'LBL' ? [value] : []));
  return 'action' in node ? from(node.action) : [];
}

/** Registers in an assignment, an argument or a condition. @param {TpInstruction} node @returns {TpRegister[]} */
function registersIn(node) {
  if (node.kind === 'assign') return registers(node.value);
  if (node.kind === 'call' || node.kind === 'run') return node.args.flatMap(registers);
  return 'action' in node ? registersIn(node.action) : [];
}

/** @param {TpOperand} node @returns {TpRegister[]} */
function registers(node) {
  if (node.kind === 'register') return [node];
  if (node.kind === 'group') return registers(node.inner);
  if (node.kind === 'unary') return registers(node.operand);
  return node.kind === 'binary' ? [...registers(node.left), ...registers(node.right)] : [];
}
