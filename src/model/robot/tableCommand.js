/**
 * Many numbers of the table at once, as one change: a pasted table. Joints beyond the rows are removed, missing ones added; a
 * joint that becomes the other kind is retyped as by hand. What a row does not name stays as it is.
 *
 * @import { Convention, DhField, Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 *
 * @typedef {object} TableRow
 * @property {'revolute' | 'prismatic'} [type]
 * @property {Partial<Record<DhField, number>>} numbers
 * @property {Partial<Record<DhField, string>>} [texts]  what the numbers were, where they were expressions
 *
 * @typedef {{ type: 'set-table', rows: readonly TableRow[], convention: Convention }} TableCommand
 */
import { DH_FIELDS, MAX_JOINTS, MIN_JOINTS, isSliding } from '../document.js';
import { CONVENTIONS } from '../documentRules.js';
import { applyJointCommand } from './jointCommands.js';
import { keepsText, textOf, withField } from './jointFields.js';
import { badChoice, badNumber, issue, shown } from '../refusalParts.js';
import { badText } from '../textRefusals.js';

/**
 * @param {Doc} doc
 * @param {TableCommand} command  that nothing is against
 * @returns {Doc} the same object when nothing changed
 */
export function applyTableCommand(doc, { rows, convention }) {
  let next = doc;
  while (next.robot.joints.length > rows.length) {
    next = applyJointCommand(next, { type: 'remove-joint', joint: next.robot.joints.length - 1 });
  }
  while (next.robot.joints.length < rows.length) {
    next = applyJointCommand(next, { type: 'add-joint', after: next.robot.joints.length - 1 });
  }
  for (const [joint, { type }] of rows.entries()) {
    if (type === undefined || isSliding(next.robot.joints[joint]) === isSliding({ type })) continue;
    next = applyJointCommand(next, { type: 'set-joint-type', joint, jointType: type });
  }
  for (const [i, { numbers, texts = {} }] of rows.entries()) {
    const old = next.robot.joints[i];
    const joint = DH_FIELDS.reduce((row, field) => {
      const value = numbers[field];
      if (value === undefined || (Object.is(row[field], value) && textOf(row, field) === texts[field])) return row;
      return withField(row, field, value, texts[field]);
    }, old);
    if (joint !== old) next = { ...next, robot: { ...next.robot, joints: next.robot.joints.with(i, joint) } };
  }
  return next.robot.convention === convention ? next : { ...next, robot: { ...next.robot, convention } };
}

/**
 * @param {TableCommand} command
 * @returns {Issue | null}
 */
export function tableRefusal({ rows, convention }) {
  if (!Array.isArray(rows) || rows.length < MIN_JOINTS || rows.length > MAX_JOINTS) {
    const came = Array.isArray(rows) ? rows.length : shown(rows);
    return issue('joint-count', 'robot.joints', `A table has ${MIN_JOINTS} to ${MAX_JOINTS} rows; got ${came}.`);
  }
  const against = badChoice('the convention', 'robot.convention', convention, CONVENTIONS);
  if (against) return against;
  for (const [i, { type, numbers, texts = {} }] of rows.entries()) {
    const path = `robot.joints.${i}`;
    const found =
      (type !== undefined && badChoice('the type', `${path}.type`, type, ['revolute', 'prismatic'])) ||
      Object.entries(numbers)
        .map(([field, value]) =>
          keepsText(field)
            ? badNumber(field, value)
            : issue('field', path, `Expected theta, d, a or alpha, got ${shown(field)}.`),
        )
        .find(Boolean) ||
      Object.entries(texts)
        .map(([field, text]) => badText(field, { field, text }))
        .find(Boolean);
    if (found) return found;
  }
  return null;
}
