/**
 * What a table of postures would do to a document's own: which are new, which get other values, which stay; and the command
 * that carries it out.
 *
 * @import { Doc, PostureDoc } from '../document.js'
 * @import { PostureCommand } from './postureCommand.js'
 *
 * @typedef {{ readonly name: string, readonly q: readonly number[] | null, readonly reason: string | null }} Row  name: '' for none
 * @typedef {'new' | 'changed' | 'same' | 'moves' | 'refused'} Fate   moves: the arm goes there
 * @typedef {{ rows: { name: string, fate: Fate, reason: string | null }[], command: PostureCommand, isEmpty: boolean }} PosturePlan
 */
import { MAX_POSTURES } from '../document.js';
import { PRESENT_POSTURE_ID } from '../documentRules.js';
import { POSTURE_NAME, isPostureName } from './postureCommand.js';

/**
 * @param {Doc} doc
 * @param {readonly Row[]} rows
 * @param {'add' | 'replace'} mode
 * @returns {PosturePlan}
 */
export function planPostures(doc, rows, mode) {
  /** @type {PostureDoc[]} */
  const postures = mode === 'add' ? [...doc.postures] : [];
  const before = new Map(doc.postures.map((posture) => [posture.id, posture]));
  const named = new Set(rows.map(({ name }) => name));
  /** @type {readonly number[] | undefined} */
  let posture;
  const planned = rows.map(({ name, q, reason }) => {
    const refused = (/** @type {string} */ why) => ({ name, fate: /** @type {const} */ ('refused'), reason: why });
    if (q === null) return refused(reason ?? '');
    if (name === PRESENT_POSTURE_ID) {
      posture = q;
      return { name, fate: /** @type {const} */ ('moves'), reason: null };
    }
    const id = name === '' ? freeName(new Set([...named, ...postures.map((other) => other.id)])) : name;
    if (!isPostureName(id)) return refused(POSTURE_NAME);
    const at = postures.findIndex((other) => other.id === id);
    if (at < 0 && postures.length >= MAX_POSTURES) return refused(`A model keeps at most ${MAX_POSTURES} postures.`);
    if (at < 0) postures.push({ id, q });
    else postures[at] = { id, q };
    const old = before.get(id);
    const isSame = old?.q.every((value, i) => Object.is(value, q[i]));
    /** @type {Fate} */
    const fate = old === undefined ? 'new' : isSame ? 'same' : 'changed';
    return { name: id, fate, reason: null };
  });
  return {
    rows: planned,
    command: { type: 'set-postures', postures, ...(posture && { posture }) },
    isEmpty: planned.every(({ fate }) => fate === 'refused'),
  };
}

/** The first of p1, p2, … that is free. @param {ReadonlySet<string>} taken */
function freeName(taken) {
  let number = 1;
  while (taken.has(`p${number}`)) number++;
  return `p${number}`;
}
