/**
 * Names from other formats → ids of ours, which are names in code, too.
 */
import { ID_PATTERN } from '../../model/documentRules.js';

const LONGEST = 60; // leaves room for a number behind it

/**
 * An id for each name, all different: what cannot stand in one becomes _, and a name of nothing else is called `instead`.
 * @example
 * idsFor(['shoulder pan', 'shoulder_pan', '1st', '…'], 'joint') // → ['shoulder_pan', 'shoulder_pan_2', '_1st', 'joint']
 * @param {readonly string[]} names
 * @param {string} instead
 * @param {readonly string[]} [used]  by others
 * @returns {string[]}
 */
export function idsFor(names, instead, used = []) {
  const taken = new Set(used);
  return names.map((name) => {
    const plain = name.slice(0, LONGEST).replace(/[^A-Za-z0-9_]/g, '_');
    const start = /^[A-Za-z_]/.test(plain) ? plain : `_${plain}`;
    const stem = /[A-Za-z0-9]/.test(start) && ID_PATTERN.test(start) ? start : instead;
    let id = stem;
    for (let number = 2; taken.has(id); number++) id = `${stem}_${number}`;
    taken.add(id);
    return id;
  });
}
