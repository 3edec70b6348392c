/**
 * Wherever a person chose the user frame, it is the active one; where none is, that is the world.
 *
 * @import { Doc } from '../document.js'
 * @import { Handle } from '../aim/handleAxes.js'
 * @import { JacobianView } from '../numbers/jacobianView.js'
 * @import { JogChoices } from '../jog/jogChoices.js'
 * @import { NumbersView } from '../numbers/numbersView.js'
 */

/**
 * @template {{ readonly handle: Handle, readonly jog: JogChoices, readonly jacobian: JacobianView, readonly numbers: NumbersView, readonly targetFrom: 'world' | 'user' }} Session
 * @param {Session} session
 * @param {Doc} doc
 * @returns {Session} the same object if it fits
 */
export function fitUserFrame(session, { activeUser }) {
  const { handle, jog, jacobian, numbers, targetFrom } = session;
  const isUsed = [handle.axes, jog.frame, jacobian.frame, numbers.frame, numbers.from, targetFrom].includes('user');
  if (activeUser !== undefined || !isUsed) return session;
  return {
    ...session,
    targetFrom: 'world',
    handle: handle.axes === 'user' ? { ...handle, axes: 'world' } : handle,
    jog: jog.frame === 'user' ? { ...jog, frame: 'world' } : jog,
    jacobian: jacobian.frame === 'user' ? { ...jacobian, frame: 'world' } : jacobian,
    numbers: {
      ...numbers,
      frame: numbers.frame === 'user' ? 'tool' : numbers.frame,
      from: numbers.from === 'user' ? 'world' : numbers.from,
    },
  };
}
