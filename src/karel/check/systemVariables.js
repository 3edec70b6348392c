/**
 * System variables that programs reckon with, and their types; of all others nobody here knows the type. `$UFRAME` alone is
 * that of the first group.
 *
 * @import { Expression } from '../tree.js'
 * @import { Type } from './types.js'
 */
import { INTEGER, POSITION, REAL, UNKNOWN, XYZWPR } from './types.js';

/** By their text in capitals, without $ and without what stands in brackets. @type {Readonly<Record<string, Type>>} */
const TYPES = {
  ...{ UFRAME: POSITION, UTOOL: POSITION, 'GROUP[].UFRAME': POSITION, 'GROUP[].UTOOL': POSITION },
  ...{ 'MNUFRAME[,]': XYZWPR, 'MNUTOOL[,]': XYZWPR, 'MOR_GRP[].NILPOS': XYZWPR },
  ...{ 'MNUFRAMENUM[]': INTEGER, 'MNUTOOLNUM[]': INTEGER, 'SCR.NUM_GROUP': INTEGER },
  'PARAM_GROUP[].SPEEDLIMJNT': REAL,
  'MOR_GRP[].CUR_NOM_ANG': { kind: 'ARRAY', sizes: [9], of: REAL },
};

/** @param {Expression} node @returns {Type} */
export const systemType = (node) => TYPES[shapeOf(node) ?? ''] ?? UNKNOWN;

/** @param {Expression} node @returns {string | null} null of what is no system variable */
function shapeOf(node) {
  if (node.kind === 'system') return node.name.toUpperCase();
  if (node.kind !== 'index' && node.kind !== 'field') return null;
  const whole = shapeOf(node.target);
  if (whole === null) return null;
  return node.kind === 'index'
    ? `${whole}[${','.repeat(node.indices.length - 1)}]`
    : `${whole}.${node.name.toUpperCase()}`;
}
