/**
 * How the workcell is looked at. It goes with the session: nothing of it is in the file.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {object} WorkcellView
 * @property {boolean} isOpen      somebody reads clearances, be there obstacles or not
 * @property {string | null} chosen  the id of the obstacle that is edited
 * @property {readonly string[]} hidden  ids of those that are not drawn; they stand in the way all the same
 * @property {boolean} hasCapsules  the arm is drawn as the check sees it
 * @property {number | null} margin  m, what a program is to keep to obstacles; null: as is fit for the arm's size
 */
import { roundStep } from '../roundStep.js';

/** @type {WorkcellView} */
export const FIRST_WORKCELL = { isOpen: false, chosen: null, hidden: [], hasCapsules: false, margin: null };

/** Of its characteristic length, what an arm keeps where nobody says it: 5 mm for one that reaches a metre. */
const MARGIN_SHARE = 1 / 100;

/**
 * What a program is to keep to obstacles, m.
 * @param {Pick<WorkcellView, 'margin'>} view
 * @param {Pick<Chain, 'characteristicLength'>} chain
 */
export const marginNow = ({ margin }, { characteristicLength }) =>
  margin ?? roundStep(characteristicLength * MARGIN_SHARE).step;

/**
 * Another document has other obstacles, though they may be called the same.
 * @param {WorkcellView} view
 * @returns {WorkcellView}
 */
export const withoutObstacles = (view) => ({ ...view, chosen: null, hidden: [] });
