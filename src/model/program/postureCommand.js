/**
 * The list of recorded postures as a whole, as it is read from a table; and with it, perhaps, where the arm stands.
 *
 * @import { Doc, PostureDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 *
 * @typedef {{ type: 'set-postures', postures: readonly PostureDoc[], posture?: readonly number[] }} PostureCommand
 */
import { MAX_POSTURES } from '../document.js';
import { ID_PATTERN, PRESENT_POSTURE_ID } from '../documentRules.js';
import { badPosture, issue } from '../refusalParts.js';

export const POSTURE_NAME =
  'A name is a letter or _, then at most 63 letters, digits or _, and not the word "current".';

/** @param {unknown} id */
export const isPostureName = (id) => typeof id === 'string' && ID_PATTERN.test(id) && id !== PRESENT_POSTURE_ID;

/** @param {Doc} doc @param {PostureCommand} command @returns {Doc} the same object when nothing changed */
export function applyPostureCommand(doc, { postures, posture }) {
  const isSame = (/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b) =>
    a.every((value, i) => Object.is(value, b[i]));
  const moves = posture !== undefined && !isSame(doc.posture, posture);
  const isOther =
    postures.length !== doc.postures.length ||
    postures.some(({ id, q }, i) => id !== doc.postures[i].id || !isSame(q, doc.postures[i].q));
  if (!moves && !isOther) return doc;
  return {
    ...doc,
    ...(moves && { posture: [...posture] }),
    ...(isOther && { postures: postures.map(({ id, q }) => ({ id, q: [...q] })) }),
  };
}

/** @param {Doc} doc @param {PostureCommand} command @returns {Issue | null} */
export function postureRefusal({ posture: { length } }, { postures, posture }) {
  if (!Array.isArray(postures)) return issue('choice', 'postures', 'Expected a list of postures.');
  if (postures.length > MAX_POSTURES)
    return issue('too-many-postures', 'postures', `A model keeps at most ${MAX_POSTURES} recorded postures.`);
  const taken = new Set();
  for (const [i, one] of postures.entries()) {
    const path = `postures.${i}.id`;
    if (!isPostureName(one?.id)) return issue('id', path, POSTURE_NAME);
    if (taken.has(one.id)) return issue('id-taken', path, `Another posture is called "${one.id}" already.`);
    taken.add(one.id);
    const wrong = badPosture(one.q, length);
    if (wrong) return wrong;
  }
  return posture === undefined ? null : badPosture(posture, length);
}
