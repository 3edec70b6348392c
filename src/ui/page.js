/**
 * What every panel is given: the store and how to watch it, what follows from the document, and a voice.
 *
 * @import { Announce } from './announce.js'
 * @import { Messages } from './messages.js'
 * @import { Opener } from './opener.js'
 * @import { Clock } from '../model/clock.js'
 * @import { Command } from '../model/commands.js'
 * @import { Derived } from '../model/derived.js'
 * @import { Action, AppState, Panel, Tab } from '../model/session.js'
 * @import { Store } from '../model/store.js'
 * @import { AddView } from '../model/views.js'
 *
 * @typedef {Command | Extract<Action, { type: 'show' }>} Change  of the document, or of what the session looks at
 *
 * @typedef {object} Page
 * @property {Store<AppState, Action>} store
 * @property {AddView<AppState>} addView
 * @property {Derived} derived
 * @property {Clock} clock
 * @property {Announce} announce
 * @property {Messages} messages
 * @property {Opener} opener
 * @property {{ where: (only?: { isChosen?: boolean }) => readonly number[] | null, goTo: (there: readonly number[]) => void }} camera
 *   `where` is null without a picture, and, if asked so, while nobody has chosen where it is taken from
 */
import { refusal } from '../model/refusals.js';

/** @type {readonly Tab[]} */
export const TABS = ['robot', 'program', 'code', 'workspace', 'jacobian'];

/** @type {readonly Panel[]} in the order of the dock under the thumb */
export const PANELS = ['robot', 'jog', 'aim', 'program', 'code', 'workspace', 'jacobian'];

/**
 * Open a panel: on the left where it has a place there, and in the sheet of a phone.
 * @param {Page} page
 * @param {Panel} panel
 */
export function openPanel({ store }, panel) {
  const tab = TABS.find((name) => name === panel);
  store.dispatch({ type: 'show', change: tab ? { panel, tab } : { panel } });
  const openers = [...document.querySelectorAll(`[data-opens=${panel}]`)];
  const seen = openers.find((element) => element.checkVisibility());
  if (seen instanceof HTMLElement) seen.focus(); // the button that asked may be on the panel that has just closed
}

/**
 * One step back or forward, said aloud with what it was, if there was one.
 * @param {Page} page
 * @param {'undo' | 'redo'} type
 */
export async function step({ store, announce }, type) {
  const before = store.state;
  store.dispatch({ type });
  if (store.state === before) return;
  const { stepDone } = await import('./stepName.js');
  announce(stepDone(before, type));
}

/**
 * Carry out a command, unless there is something against it; nothing is ever against looking at something.
 * @param {Page} page
 * @param {Change & { gesture?: string }} change
 * @returns {string | null} the reason why not, in a sentence
 */
export function attempt({ store }, change) {
  const reason = change.type === 'show' ? null : refusal(store.state.doc, change);
  if (reason) return reason.message;
  store.dispatch(change);
  return null;
}

let gestures = 0;

/** A new name for a drag or an edit that is to be one undo step. */
export const newGesture = () => `gesture-${++gestures}`;
