/** @import { AppState } from '../session.js' */

/** The path that the open code takes the tool along, while code is what is worked at. @param {AppState} state */
export const codePathShown = ({ session }) => (session.tab === 'code' ? session.code.path : null);
