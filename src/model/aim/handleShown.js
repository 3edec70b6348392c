/**
 * Whether the handle is wanted on the tool: as a person chose, or else where the screen is wide enough not to be filled by it.
 * @import { Session } from '../session.js'
 */

/**
 * @param {Pick<Session, 'handle' | 'build'>} session
 * @param {boolean} isWide
 */
export const isHandleShown = ({ handle, build }, isWide) => build === null && (handle.isShown ?? isWide);
