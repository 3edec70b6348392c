/**
 * A way made shorter without touching anything: two places on it are joined straight wherever the arm keeps clear between them.
 *
 * @import { Search } from './connectTrees.js'
 */
import { touchOnWay } from '../clearance/clearWay.js';
import { apart, between, lengthOf } from './jointSpace.js';

/** A cut that gains less of the whole is not worth a posture more. */
const WORTH = 1e-3;

/**
 * @param {Search} search
 * @param {readonly Float64Array[]} way  clear
 * @param {number} tries
 * @returns {Float64Array[]} clear, no longer
 */
export function shorten({ cell, space, random, margin }, way, tries) {
  let short = [...way];
  let length = lengthOf(space, short);
  for (let i = 0; i < tries && short.length > 2; i++) {
    const [one, other] = [placeOn(random() * length), placeOn(random() * length)].sort((a, b) => a.after - b.after);
    if (other.after === one.after) continue;
    const joined = [...short.slice(0, one.after + 1), one.posture, other.posture, ...short.slice(other.after + 1)];
    const gain = length - lengthOf(space, joined);
    if (gain < WORTH * length || touchOnWay(cell, one.posture, other.posture, { margin }) !== null) continue;
    short = withoutRepeats(joined);
    length = lengthOf(space, short);
  }
  return short;

  /** @param {number} far  along the way */
  function placeOn(far) {
    let after = 0;
    for (; after < short.length - 2; after++) {
      const piece = apart(space, short[after], short[after + 1]);
      if (far <= piece) break;
      far -= piece;
    }
    const piece = apart(space, short[after], short[after + 1]);
    return { after, posture: between(short[after], short[after + 1], piece > 0 ? Math.min(1, far / piece) : 0) };
  }

  /** @param {Float64Array[]} postures */
  function withoutRepeats(postures) {
    return postures.filter((posture, i) => i === 0 || apart(space, postures[i - 1], posture) > 0);
  }
}

/**
 * Without the postures that it is clear without; it is shorter so, and stops less often.
 * @param {Pick<Search, 'cell' | 'margin'>} search
 * @param {readonly Float64Array[]} way  clear
 * @returns {Float64Array[]} clear
 */
export function withoutNeedless({ cell, margin }, way) {
  const short = [...way];
  for (let i = 1; i < short.length - 1;) {
    if (touchOnWay(cell, short[i - 1], short[i + 1], { margin }) === null) short.splice(i, 1);
    else i++;
  }
  return short;
}
