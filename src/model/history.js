/**
 * Undo by keeping documents, not inverse commands: they are small, frozen and share structure.
 *
 * @import { Doc } from './document.js'
 *
 * @typedef {object} History
 * @property {readonly Doc[]} past
 * @property {Doc} doc
 * @property {readonly Doc[]} future
 * @property {{ readonly id: string, readonly past: readonly Doc[], readonly doc: Doc, readonly future: readonly Doc[] } | null} gesture
 *   the drag that is being merged into one step, and what was before it
 */

const LIMIT = 500;

/** @param {Doc} doc @returns {History} */
export const startHistory = (doc) => ({ past: [], doc, future: [], gesture: null });

/**
 * @param {History} history
 * @param {Doc} doc
 * @param {string | null} [gestureId] changes with the same id, one after the other, undo together
 * @returns {History} the same object when the document is the same
 */
export function record(history, doc, gestureId = null) {
  if (doc === history.doc) return history;
  const { past, future, gesture } = history;
  if (gestureId !== null && gestureId === gesture?.id) {
    // Back at the very document it began with: nothing happened, so nothing is to be undone.
    return doc === gesture.doc
      ? { ...gestureUndone(gesture), gesture }
      : { past: began(gesture), doc, future: [], gesture };
  }
  return {
    past: [...past, history.doc].slice(-LIMIT),
    doc,
    future: [],
    gesture: gestureId === null ? null : { id: gestureId, past, doc: history.doc, future },
  };
}

/** Escape in mid-drag: as if it had never begun, redo included. @param {History} history @returns {History} */
export const cancelGesture = (history) =>
  history.gesture ? { ...gestureUndone(history.gesture), gesture: null } : history;

/** The hand is off: the next change is a step of its own. @param {History} history @returns {History} */
export const endGesture = (history) => (history.gesture ? { ...history, gesture: null } : history);

/** @param {History} history @returns {History} the same object when there is nothing to undo */
export function undo(history) {
  const doc = history.past.at(-1);
  if (!doc) return history;
  return { past: history.past.slice(0, -1), doc, future: [history.doc, ...history.future], gesture: null };
}

/** @param {History} history @returns {History} the same object when there is nothing to redo */
export function redo(history) {
  const [doc, ...future] = history.future;
  return doc ? { past: [...history.past, history.doc], doc, future, gesture: null } : history;
}

/** @param {NonNullable<History['gesture']>} gesture */
const gestureUndone = ({ past, doc, future }) => ({ past, doc, future });

/** @param {NonNullable<History['gesture']>} gesture */
const began = ({ past, doc }) => [...past, doc].slice(-LIMIT);
