/**
 * Whether the handle is wanted on the tool: as a person chose, or else where the screen is wide enough not to be filled by it. An
 * obstacle that is edited has one of its own, and there are never two.
 *
 * @import { AppState } from '../session.js'
 */

/** The obstacle that is edited and seen, if there is one. @param {Pick<AppState, 'doc' | 'session'>} state */
export function chosenObstacle({ doc, session: { workcell } }) {
  const { isOpen, chosen, hidden } = workcell;
  if (!isOpen || chosen === null || hidden.includes(chosen)) return null;
  return doc.obstacles.find(({ id }) => id === chosen) ?? null;
}

/**
 * @param {Pick<AppState, 'doc' | 'session'>} state
 * @param {boolean} isWide
 */
export const isHandleShown = (state, isWide) =>
  state.session.build === null && (state.session.handle.isShown ?? isWide) && chosenObstacle(state) === null;
