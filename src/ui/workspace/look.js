/**
 * What is asked of the workspace, and how it is looked at: changes of it are of the session, and no step to undo.
 *
 * @import { Page } from '../page.js'
 * @import { Session } from '../../model/session.js'
 * @import { WorkspaceView } from '../../model/workspace/workspaceView.js'
 */
import { FIRST_WORKSPACE } from '../../model/workspace/workspaceView.js';

/** @param {Pick<Page, 'store'>} page */
export const viewNow = ({ store }) => store.state.session.workspace ?? FIRST_WORKSPACE;

/** @param {Pick<Page, 'store'>} page @param {Partial<WorkspaceView>} change */
export const lookChange = (page, change) =>
  /** @type {const} */ ({ type: 'show', change: { workspace: { ...viewNow(page), ...change } } });

/** @param {Pick<Page, 'store'>} page @param {Partial<WorkspaceView>} change */
export const look = (page, change) => page.store.dispatch(lookChange(page, change));

/** @param {Pick<Session, 'workspace'>} session @param {string} id  of a fold */
export const isFoldOpen = ({ workspace }, id) => workspace?.open.includes(id) ?? false;
