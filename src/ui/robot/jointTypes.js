/** @import { RobotDoc } from '../../model/document.js' */
import { isSliding } from '../../model/document.js';

/** "6R" or "RRPR": a joint's letter each, a single kind shortened. @param {RobotDoc} robot */
export function typesOf({ joints }) {
  const letters = joints.map((joint) => (isSliding(joint) ? 'P' : 'R')).join('');
  return /^(.)\1*$/.test(letters) ? `${letters.length}${letters[0]}` : letters;
}
