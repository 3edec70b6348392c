/**
 * What a program does between its moves: outputs that change, inputs that it waits for, waits, calls of programs that only the
 * controller has. An output that is set to what it is already has no effect, and is none of them.
 *
 * @import { KrlModule } from '../../karel/krl/tree.js'
 * @import { Effect, State } from '../../karel/run/machine.js'
 * @import { NeutralStep } from '../../karel/write/neutral.js'
 *
 * @typedef {{ kind: 'input', port: number, value: boolean }} AskedInput
 * @typedef {AskedInput | { kind: 'output', port: number, value: boolean } | { kind: 'wait', seconds: number } |
 *   { kind: 'call', program: string }} Deed
 * @typedef {{ file: string, line: number }} Where
 * @typedef {{ deed: Deed, after: number, where: Where }} FoundDeed   after: so many moves
 */

/** Waits have hundredths of a second in TP; what becomes one of them, or none, is not compared. */
const HUNDREDTH = 0.01;
const SHORT = 1.51 * HUNDREDTH;
const MILLI = 10 ** -3;

/** Whether an output changes: of each, what it was set to last. */
function createOutputs() {
  /** @type {Map<number, boolean>} */
  const held = new Map();
  return (/** @type {Deed} */ deed) => {
    if (deed.kind !== 'output') return true;
    if (held.get(deed.port) === deed.value) return false;
    held.set(deed.port, deed.value);
    return true;
  };
}

/** @param {readonly NeutralStep[]} steps @returns {{ deed: Deed, after: number }[]} */
export function deedsOf(steps) {
  const isChange = createOutputs();
  let after = 0;
  return steps.flatMap((step) => {
    if (step.kind === 'move') after++;
    if (step.kind === 'move' || step.kind === 'comment') return [];
    return isChange(step) ? [{ deed: step, after }] : [];
  });
}

/** KRL of this page goes from line to line. @param {KrlModule} module @returns {{ deed: Deed, after: number, line: number }[]} */
export function deedsOfKrl({ statements }) {
  const isChange = createOutputs();
  let after = 0;
  return statements.flatMap((node) => {
    if (node.kind === 'motion') after++;
    const deed = krlDeed(node);
    return deed && isChange(deed) ? [{ deed, after, line: node.span?.line ?? 0 }] : [];
  });
}

/** @param {KrlModule['statements'][number]} node @returns {Deed | null} */
function krlDeed(node) {
  if (node.kind === 'wait') return { kind: 'wait', seconds: node.seconds };
  if (node.kind === 'wait-for') return { kind: 'input', port: node.input, value: node.value };
  if (node.kind === 'call') return { kind: 'call', program: node.program };
  const [, output] = (node.kind === 'assign' && /^\$OUT\[(\d+)\]$/.exec(node.target)) || [];
  return output && node.kind === 'assign' ? { kind: 'output', port: Number(output), value: node.value === true } : null;
}

/**
 * Watches a FANUC run, statement by statement.
 * @param {Pick<State, 'ports'>} memory
 * @param {(deed: Deed) => void} onDeed
 */
export function watchDeeds({ ports }, onDeed) {
  /** Of the statement: the input that it has looked at last, and what that was. @type {{ asked: AskedInput | null, waited: number, hasMoved: boolean }} */
  let now = { asked: null, waited: 0, hasMoved: false };
  /** @type {Record<string, unknown>} */
  let outputs = { ...ports.DOUT };
  ports.DIN = new Proxy(ports.DIN ?? {}, {
    get(held, port) {
      now.asked = { kind: 'input', port: Number(port), value: held[String(port)] === true };
      return held[String(port)];
    },
  });
  return {
    /** @param {Effect} effect */
    note(effect) {
      if (effect.kind === 'wait') now.waited += Number(effect.milliseconds);
      if (effect.kind === 'move') now.hasMoved = true;
      if (effect.kind === 'call') onDeed({ kind: 'call', program: String(effect.program) });
    },
    /** A statement is over. */
    flush() {
      for (const [port, value] of Object.entries(ports.DOUT ?? {}))
        if (outputs[port] !== value) onDeed({ kind: 'output', port: Number(port), value: value === true });
      outputs = { ...ports.DOUT };
      if (now.asked) onDeed(now.asked);
      else if (now.waited > 0 && !now.hasMoved) onDeed({ kind: 'wait', seconds: now.waited * MILLI });
      now = { asked: null, waited: 0, hasMoved: false };
    },
  };
}

/**
 * What code does otherwise than its program between moves: of each gap the first difference, and where.
 * @param {readonly FoundDeed[]} found
 * @param {readonly { deed: Deed, after: number }[]} wanted
 * @param {readonly Where[]} moves   of the code
 * @returns {{ message: string, where: Where }[]}
 */
export function deedDifferences(found, wanted, moves) {
  const [done, toDo] = [byGap(found), byGap(wanted)];
  return Array.from({ length: moves.length + 1 }, (_, after) => after).flatMap((after) => {
    const [here, asked] = [done.get(after) ?? [], toDo.get(after) ?? []];
    const at = Array.from({ length: Math.max(here.length, asked.length) }, (_, i) => i).find(
      (i) => !isSame(here[i]?.deed, asked[i]?.deed),
    );
    if (at === undefined) return [];
    const [one, other] = [here[at], asked[at]];
    const where = one?.where ?? moves[Math.min(after, moves.length - 1)];
    return [{ where, message: `${one ? said(one.deed) : 'nothing'}, not ${other ? said(other.deed) : 'anything'}` }];
  });
}

/** Those that are compared, by how many moves come before. @template {{ deed: Deed, after: number }} One @param {readonly One[]} deeds */
function byGap(deeds) {
  /** @type {Map<number, One[]>} */
  const gaps = new Map();
  for (const one of deeds) {
    const gap = gaps.get(one.after);
    if (!isLong(one.deed)) continue;
    if (gap) gap.push(one);
    else gaps.set(one.after, [one]);
  }
  return gaps;
}

/** @param {Deed} deed */
const isLong = (deed) => deed.kind !== 'wait' || deed.seconds > SHORT;

/** Names as controllers have them: letters, digits, and lines below. @param {string} name */
const plain = (name) => name.toUpperCase().replace(/[^A-Z0-9]/g, '');

/** @param {Deed | undefined} a @param {Deed | undefined} b */
function isSame(a, b) {
  if (!a || !b) return a === b;
  if (a.kind === 'wait' && b.kind === 'wait') return Math.abs(a.seconds - b.seconds) <= 0.51 * HUNDREDTH;
  if (a.kind === 'call' && b.kind === 'call') return plain(a.program) === plain(b.program);
  return (a.kind === 'output' || a.kind === 'input') && a.kind === b.kind && a.port === b.port && a.value === b.value;
}

/** @param {Deed} deed */
function said(deed) {
  switch (deed.kind) {
    case 'output':
      return `output ${deed.port} ${deed.value ? 'on' : 'off'}`;
    case 'input':
      return `a wait for input ${deed.port} ${deed.value ? 'on' : 'off'}`;
    case 'wait':
      return `a wait of ${Number(deed.seconds.toFixed(3))} s`;
    case 'call':
      return `a call of ${deed.program}`;
  }
}
