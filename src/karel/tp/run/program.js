/**
 * A listing made ready to run: its lines, where its labels are, which lines belong together, and its positions.
 *
 * @import { TpLine, TpListing, TpOperand, TpPosition } from '../tree.js'
 *
 * @typedef {object} TpCode
 * @property {string} name
 * @property {readonly TpLine[]} lines
 * @property {ReadonlyMap<number, number>} labels      their lines, from 0
 * @property {ReadonlyMap<number, number>} further     from a line to the one that its block goes on with: IF → behind ELSE or at
 *   ENDIF, ELSE → ENDIF, FOR → ENDFOR, ENDFOR → FOR
 * @property {ReadonlyMap<number, TpPosition>} positions
 * @property {readonly BlockFault[]} faults
 *
 * @typedef {{ line: number, code: string, message: string }} BlockFault  line: from 0
 */
import { linesOf, nameOf, positionsOf } from '../tree.js';

/** @param {TpListing} listing @returns {TpCode} */
export function prepareTp(listing) {
  const lines = linesOf(listing);
  /** @type {Map<number, number>} */
  const labels = new Map();
  /** @type {Map<number, number>} */
  const further = new Map();
  /** @type {BlockFault[]} */
  const faults = [];
  const fault = (/** @type {number} */ line, /** @type {string} */ code, /** @type {string} */ message) =>
    void faults.push({ line, code, message });
  /** @type {{ at: number, kind: 'if-then' | 'else' | 'for' }[]} */
  const open = [];
  const close = (/** @type {number} */ at, /** @type {string} */ word, /** @type {string[]} */ kinds) => {
    const last = open.at(-1);
    if (last && kinds.includes(last.kind)) return open.pop();
    fault(at, 'block', `Expected ${last ? ENDS[last.kind] : 'no'} ${last ? `before ${word}` : word} here.`);
    return undefined;
  };

  for (const [at, { instruction }] of lines.entries()) {
    switch (instruction.kind) {
      case 'label': {
        const label = constant(instruction.label.index);
        if (label === null) break;
        if (labels.has(label)) fault(at, 'label', `LBL[${label}] stands here a second time.`);
        else labels.set(label, at);
        break;
      }
      case 'if-then':
      case 'for':
        open.push({ at, kind: instruction.kind });
        break;
      case 'else': {
        const begin = close(at, 'ELSE', ['if-then']);
        if (begin) further.set(begin.at, at + 1);
        open.push({ at, kind: 'else' });
        break;
      }
      case 'endif': {
        const begin = close(at, 'ENDIF', ['if-then', 'else']);
        if (begin) further.set(begin.at, at);
        break;
      }
      case 'endfor': {
        const begin = close(at, 'ENDFOR', ['for']);
        if (!begin) break;
        further.set(begin.at, at);
        further.set(at, begin.at);
      }
    }
  }
  for (const { at, kind } of open) fault(at, 'block', `Expected ${ENDS[kind]} for this line; none follows.`);
  const positions = new Map(positionsOf(listing).map((position) => [position.number, position]));
  return { name: nameOf(listing), lines, labels, further, positions, faults };
}

const ENDS = { 'if-then': 'ENDIF', else: 'ENDIF', for: 'ENDFOR' };

/** @param {TpOperand} operand @returns {number | null} */
export const constant = (operand) => (operand.kind === 'number' ? operand.value : null);
