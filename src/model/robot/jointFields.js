/**
 * One number of a joint, together with what was typed for it.
 *
 * @import { DhField, JointDoc, JointField } from '../document.js'
 */
import { DH_FIELDS } from '../document.js';

/** Whether a field keeps what was typed: the parameters do, limits and home do not. @param {string} field @returns {field is DhField} */
export const keepsText = (field) => DH_FIELDS.some((known) => known === field);

/** What was typed for a number, if it was an expression. @param {JointDoc} joint @param {JointField} field */
export const textOf = (joint, field) => (keepsText(field) ? joint.text?.[field] : undefined);

/**
 * A new number takes the place of what was typed for the old one, too.
 * @param {JointDoc} joint
 * @param {JointField} field
 * @param {number | undefined} value  undefined takes a limit away
 * @param {string} [typed]
 * @returns {JointDoc}
 */
export function withField(joint, field, value, typed) {
  const { text: old, ...rest } = joint;
  const text = Object.fromEntries(Object.entries(old ?? {}).filter(([name]) => name !== field));
  if (typed !== undefined) text[field] = typed;
  const row = { ...rest, [field]: value, ...(Object.keys(text).length > 0 && { text }) };
  if (value === undefined) delete row[field];
  return row;
}
