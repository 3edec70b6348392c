/**
 * What undo or redo would do, in words: "link length a of joint 2". Fetched when there is first something to undo.
 *
 * @import { Doc } from '../model/document.js'
 * @import { AppState } from '../model/session.js'
 */
import { recorded } from '../model/history.js';
import { whatChanged } from '../model/whatChanged.js';
import { TEXT } from './strings.js';
import { STEPS } from './words/steps.js';

/** @typedef {'undo' | 'redo'} Step */

/** @param {AppState} state @param {Step} step @returns {string | null} null: there is nothing to undo or redo */
export function stepName(state, step) {
  const other = step === 'undo' ? state.past.at(-1) : state.future[0];
  if (!other) return null;
  const doc = recorded(state);
  return step === 'undo' ? changeName(other, doc) : changeName(doc, other);
}

/** What the button that does it is called. @param {AppState} state @param {Step} step @returns {string | null} likewise */
export function stepTitle(state, step) {
  const name = stepName(state, step);
  return name === null ? null : STEPS.of[step](name);
}

/** What is said when it is done. @param {AppState} before @param {Step} step  that there is */
export const stepDone = (before, step) => STEPS.done[step](stepName(before, step) ?? '');

/** @param {Doc} before @param {Doc} after */
function changeName(before, after) {
  const change = whatChanged(before, after);
  switch (change.what) {
    case 'field':
      return STEPS.field(change.field, change.joint + 1);
    case 'rate':
      return STEPS.rate(change.rate, change.joint + 1);
    case 'type':
    case 'link':
    case 'controller':
    case 'joint':
      return STEPS[change.what](change.joint + 1);
    case 'joint-added':
      return STEPS.jointAdded(change.joint + 1);
    case 'joint-removed':
      return STEPS.jointRemoved(change.joint + 1);
    case 'joint-moved':
      return STEPS.jointMoved(change.joint + 1);
    case 'robot':
    case 'name':
      return STEPS[change.what](change.name || TEXT.unnamedRobot);
    case 'tool-chosen':
      return STEPS.toolChosen(change.id);
    case 'user-chosen':
      return STEPS.userChosen(change.id);
    case 'units':
      return STEPS.units(change.units.length, change.units.angle);
    case 'convention':
      return STEPS.convention[change.convention];
    case 'step':
      return STEPS.step(change.step + 1, STEPS.change[change.change]);
    case 'list':
      return STEPS.inList(STEPS.list[change.list], change.id, STEPS.change[change.change]);
    default:
      return STEPS[change.what];
  }
}
