/**
 * The TP half of a FANUC pair: joint motion through the position registers, in order. It holds no joint values.
 *
 * @import { PairPlan } from './fanucPlan.js'
 * @import { TpLine, TpProgram } from './tpTree.js'
 */
import { moverRemarks, programComment } from './fanucHeader.js';
import { plainText } from './plainText.js';
import { MAX_REMARK_LENGTH } from './tpTree.js';

/** @param {PairPlan} plan @returns {TpProgram} */
export function moverProgram(plan) {
  const { names, robotName, time, moves, speedPercent, userFrame, toolFrame } = plan;
  /** @type {TpLine[]} */
  const lines = moverRemarks(plan).map(remark);
  if (userFrame !== undefined) lines.push({ kind: 'user-frame', number: userFrame });
  if (toolFrame !== undefined) lines.push({ kind: 'tool-frame', number: toolFrame });
  for (const { name, register, termination } of moves) {
    lines.push(remark(`PR[${register}]: '${plainText(name)}'`), {
      kind: 'joint-move',
      register,
      speedPercent,
      termination,
    });
  }
  return { kind: 'tp-program', name: names.tp, comment: programComment(robotName), created: time, lines };
}

/** A remark ends at a semicolon, and holds so many characters. @param {string} text @returns {TpLine} */
const remark = (text) => ({
  kind: 'remark',
  text: text.replaceAll(';', ',').slice(0, MAX_REMARK_LENGTH).trimEnd(),
});
