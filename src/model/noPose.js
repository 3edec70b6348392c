/** @import { PoseDoc } from './document.js' */

const NOTHING = [0, 0, 0];

/** Whether a pose turns nothing. @param {PoseDoc} pose */
export const isNoTurn = ({ rpy = NOTHING, quaternion = NOTHING }) =>
  [...rpy, ...quaternion.slice(0, 3)].every((value) => value === 0);

/** Whether a pose moves and turns nothing. @param {PoseDoc} pose */
export const isNoPose = (pose) => pose.xyz.every((value) => value === 0) && isNoTurn(pose);
