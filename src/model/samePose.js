/** @import { PoseDoc } from './document.js' */

/** The same numbers, written the same way. @param {PoseDoc} one @param {PoseDoc} other */
export const isSamePose = (one, other) =>
  isSameList(one.xyz, other.xyz) && isSameList(one.rpy, other.rpy) && isSameList(one.quaternion, other.quaternion);

/** @param {readonly number[] | undefined} one @param {readonly number[] | undefined} other */
const isSameList = (one, other) =>
  one === other || (one?.length === other?.length && one?.every((value, i) => Object.is(value, other?.[i])) === true);
