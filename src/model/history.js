/**
 * Undo by keeping documents, not inverse commands: they are small, frozen and share structure.
 *
 * Playing a program moves the arm and is nothing to undo: where it stands then is laid over the document, and stays over those
 * before and after it for as long as they say the same of where the arm is. What moves it otherwise is a step again, and where
 * playing left it one before that.
 *
 * @import { Doc } from './document.js'
 *
 * @typedef {object} History
 * @property {readonly Doc[]} past
 * @property {Doc} doc
 * @property {readonly Doc[]} future
 * @property {Doc | null} stood   what `doc` is without where playing has put the arm; null: it has put it nowhere
 * @property {(Pick<History, 'past' | 'doc' | 'future' | 'stood'> & { readonly id: string }) | null} gesture
 *   the drag that is being merged into one step, and what was before it
 */

const LIMIT = 500;

/** @param {Doc} doc @returns {History} */
export const startHistory = (doc) => ({ past: [], doc, future: [], stood: null, gesture: null });

/**
 * @param {History} history
 * @param {Doc} doc
 * @param {string | null} [gestureId] changes with the same id, one after the other, undo together
 * @returns {History} the same object when the document is the same
 */
export function record(history, doc, gestureId = null) {
  if (doc === history.doc) return history;
  const { gesture } = history;
  const same = gestureId !== null && gestureId === gesture?.id ? gesture : null;
  // Back at the very document it began with: nothing happened, so nothing is to be undone.
  if (doc === same?.doc) return { ...gestureUndone(same), gesture };
  const ground = same ?? history;
  const { past, stood } = ground;
  const isLaid = stood !== null && doc.posture === ground.doc.posture;
  const before = stood === null ? [ground.doc] : isLaid ? [stood] : [stood, ground.doc];
  return {
    past: [...past, ...before].slice(-LIMIT),
    doc,
    future: [],
    stood: isLaid ? Object.freeze({ ...doc, posture: stood.posture }) : null,
    gesture: same ?? (gestureId === null ? null : { id: gestureId, ...gestureUndone(history) }),
  };
}

/**
 * Where playing puts the arm.
 * @param {History} history
 * @param {Doc} doc  the same but for the posture
 * @returns {History} the same object when the document is the same
 */
export const stand = (history, doc) =>
  doc === history.doc ? history : { ...history, doc, stood: history.stood ?? history.doc, gesture: null };

/** Escape in mid-drag: as if it had never begun, redo included. @param {History} history @returns {History} */
export const cancelGesture = (history) =>
  history.gesture ? { ...gestureUndone(history.gesture), gesture: null } : history;

/** The hand is off: the next change is a step of its own. @param {History} history @returns {History} */
export const endGesture = (history) => (history.gesture ? { ...history, gesture: null } : history);

/** @param {History} history @returns {History} the same object when there is nothing to undo */
export function undo(history) {
  const { past, future } = history;
  const doc = past.at(-1);
  if (!doc) return history;
  return { past: past.slice(0, -1), ...laidOver(doc, history), future: [recorded(history), ...future], gesture: null };
}

/** @param {History} history @returns {History} the same object when there is nothing to redo */
export function redo(history) {
  const [doc, ...future] = history.future;
  if (!doc) return history;
  return { past: [...history.past, recorded(history)], ...laidOver(doc, history), future, gesture: null };
}

/** What there is to come back to: the document without where playing has put the arm. @param {Pick<History, 'doc' | 'stood'>} history */
export const recorded = ({ doc, stood }) => stood ?? doc;

/**
 * Another document, with the arm where playing has put it, unless that document moves it.
 * @param {Doc} doc
 * @param {History} history
 * @returns {Pick<History, 'doc' | 'stood'>}
 */
function laidOver(doc, { doc: { posture }, stood }) {
  if (stood?.posture !== doc.posture) return { doc, stood: null };
  return { doc: Object.freeze({ ...doc, posture }), stood: doc };
}

/** @param {Pick<History, 'past' | 'doc' | 'future' | 'stood'>} before */
const gestureUndone = ({ past, doc, future, stood }) => ({ past, doc, future, stood });
