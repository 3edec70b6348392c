/**
 * Which numbers joints are shown and taken in: the table's own, or the pendant's, which are fetched when they are first asked
 * for.
 *
 * @import { AppState } from '../../model/session.js'
 * @import { JointNumbers } from '../../model/numbers/jointNumbers.js'
 */
import { hasPendant } from '../../model/controller/controllerData.js';
import { MODEL_NUMBERS } from '../../model/numbers/jointNumbers.js';

/** @type {typeof import('./pendantNumbers.js') | null} once it is here */
let pendant = null;

export const fetchPendantNumbers = async () => (pendant ??= await import('./pendantNumbers.js'));

/** @param {AppState} state @returns {JointNumbers} */
export const jointNumbers = ({ doc, session }) =>
  session.numbers.isPendant && pendant && hasPendant(doc.robot) ? pendant.PENDANT_NUMBERS : MODEL_NUMBERS;
