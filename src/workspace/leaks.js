/**
 * Where the border of a field that is reached goes over into that of one that is not, a curve between them has an end that meets nothing. What is
 * reached along such a ring changes there, and once more on its other side: the two places are joined by a line, whose
 * length is a gap of the boundary.
 *
 * @import { Arrangement } from './arrangement.js'
 * @import { GoTo } from './goneTo.js'
 * @import { Vertex } from './traced.js'
 */
import { endsOf } from './arrangement.js';
import { probeBeside, SAFE } from './reachedFields.js';
import { apart } from './traced.js';

/** Places at which a ring is asked at first. */
const LOOKS = 64;

/**
 * @param {Arrangement} arrangement
 * @param {readonly number[]} ring
 * @param {GoTo} goTo
 * @param {number} tolerance
 * @returns {[Vertex, Vertex][]}
 */
export function leaksOf(arrangement, ring, goTo, tolerance) {
  /** @type {Map<number, boolean | null>} */
  const known = new Map();
  /** Whether it is reached beside the k-th line of the ring; null if that is too narrow to ask. @param {number} k */
  const isReachedAt = (k) => {
    const told = known.get(k);
    if (told !== undefined) return told;
    const probe = probeBeside(arrangement, ring[k], 0.5, tolerance);
    const reached = probe && probe.depth >= SAFE ? goTo(probe.u, probe.v, probe.x) === null : null;
    known.set(k, reached);
    return reached;
  };
  const count = Math.min(LOOKS, ring.length);
  const looks = Array.from({ length: count }, (_, i) => Math.floor((i * ring.length) / count)).filter(
    (k) => isReachedAt(k) !== null,
  );
  /** @type {{ vertex: Vertex, ends: boolean }[]} */
  const changes = [];
  looks.forEach((from, i) => {
    const to = looks[(i + 1) % looks.length];
    if (isReachedAt(from) === isReachedAt(to)) return;
    let [low, high] = [from, to > from ? to : to + ring.length];
    while (high - low > 1) {
      const middle = nearestTold(low, high, (k) => isReachedAt(k % ring.length));
      if (middle === null) break;
      if (isReachedAt(middle % ring.length) === isReachedAt(from)) low = middle;
      else high = middle;
    }
    const at = Math.ceil((low + high) / 2) % ring.length;
    changes.push({ vertex: endsOf(arrangement, ring[at])[0], ends: isReachedAt(from) === true });
  });
  /** @type {[Vertex, Vertex][]} */
  const found = [];
  const begins = changes.filter(({ ends }) => !ends);
  for (const { vertex } of changes.filter(({ ends }) => ends)) {
    begins.sort((a, b) => apart(a.vertex, vertex) - apart(b.vertex, vertex));
    const [nearest] = begins.splice(0, 1);
    if (nearest && apart(nearest.vertex, vertex) > 0) found.push([vertex, nearest.vertex]);
  }
  return found;
}

/** The line nearest to the middle of two about which something is told. @param {number} low @param {number} high @param {(k: number) => boolean | null} told */
function nearestTold(low, high, told) {
  const middle = Math.floor((low + high) / 2);
  for (let away = 0; away < high - low; away++) {
    for (const k of [middle - away, middle + away]) if (k > low && k < high && told(k) !== null) return k;
  }
  return null;
}
