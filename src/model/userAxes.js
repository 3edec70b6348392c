/**
 * Wherever a person chose the user frame, it is the active one; where none is, that is the world.
 *
 * @import { Doc } from './document.js'
 * @import { Handle } from './handleAxes.js'
 * @import { JogChoices } from './jogChoices.js'
 * @import { NumbersView } from './numbersView.js'
 */

/**
 * @template {{ readonly handle: Handle, readonly jog: JogChoices, readonly numbers: NumbersView }} Session
 * @param {Session} session
 * @param {Doc} doc
 * @returns {Session} the same object if it fits
 */
export function fitUserFrame(session, { activeUser }) {
  const { handle, jog, numbers } = session;
  const isUsed = [handle.axes, jog.frame, numbers.frame, numbers.from].includes('user');
  if (activeUser !== undefined || !isUsed) return session;
  return {
    ...session,
    handle: handle.axes === 'user' ? { ...handle, axes: 'world' } : handle,
    jog: jog.frame === 'user' ? { ...jog, frame: 'world' } : jog,
    numbers: {
      ...numbers,
      frame: numbers.frame === 'user' ? 'tool' : numbers.frame,
      from: numbers.from === 'user' ? 'world' : numbers.from,
    },
  };
}
