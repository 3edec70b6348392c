/**
 * The body of an arm as capsules: every stretch of its links, a segment with a radius. What a table says of a link is its
 * offset along the joint's axis and its length across it, so a link has up to two stretches, and the last one a third, from
 * the flange to the TCP.
 *
 * How far a stretch can go is known without looking at postures: while joint j turns by δ, no point goes farther than δ times
 * its distance from the joint's axis, which is at most the length of the links between; while it slides by δ, δ. Those are
 * the levers, by which a whole way can be called free after a look at some postures of it (clearWay.js).
 *
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {'offset' | 'length' | 'tool'} StretchKind
 *
 * @typedef {object} Stretch
 * @property {number} link    0-based: of the joint that moves it
 * @property {StretchKind} kind
 * @property {number} radius  m
 * @property {boolean} moves  whether a joint can take it anywhere; what stands still is not looked at
 *
 * @typedef {object} ArmBodies
 * @property {Chain} chain
 * @property {readonly Stretch[]} stretches
 * @property {readonly (readonly [number, number])[]} pairs  of stretches that are held against each other: not neighbours
 * @property {readonly [number, number, number]} tcp  seen from the flange, m
 */
import { requirePosture } from '../../kinematics/checks.js';
import { linkFrames } from '../../kinematics/forward.js';

/** Numbers of one stretch: x y z of both ends. */
export const ENDS = 6;

/** A stretch this short, in parts of its radius, is inside the bodies that it joins. */
const STUB = 1e-6;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} radii  of each joint's link, m
 * @returns {ArmBodies}
 */
export function armBodies(chain, radii) {
  if (radii.length !== chain.dof)
    throw new RangeError(`Expected a radius for each of ${chain.dof} links, got ${radii.length}.`);
  Array.from(radii).forEach((radius, k) => {
    if (!(radius > 0 && Number.isFinite(radius)))
      throw new RangeError(`Expected the radius of link ${k + 1} to be above 0, got ${radius}.`);
  });
  const parts = partsOf(chain);
  const lengths = parts.map(({ link, kind }) => longest(chain, link, kind));
  const kept = parts.map((_, i) => i).filter((i) => lengths[i] > STUB * radii[parts[i].link]);
  const stretches = kept.map((i) => {
    const { link, kind } = parts[i];
    const isOnFirstAxis = link === 0 && kind === 'offset' && chain.joints[0].type === 'revolute';
    return Object.freeze({ link, kind, radius: radii[link], moves: !isOnFirstAxis });
  });
  /** @type {[number, number][]} */
  const pairs = [];
  stretches.forEach((one, i) => {
    for (let j = i + 1; j < stretches.length; j++) {
      if (areNeighbours(one, stretches[j])) continue;
      const between = lengths.slice(kept[i] + 1, kept[j]).reduce((sum, length) => sum + length, 0);
      if (between > one.radius + stretches[j].radius) pairs.push([i, j]);
    }
  });
  const [x, y, z] = chain.tool.subarray(12, 15);
  return Object.freeze({
    chain,
    stretches: Object.freeze(stretches),
    pairs: Object.freeze(pairs),
    tcp: Object.freeze(/** @type {const} */ ([x, y, z])),
  });
}

/**
 * Whether at most one joint moves two stretches against each other, the second farther out. How far that one may go is what its
 * limits say, and says it better than capsules: links are built to pass each other there. An offset's own joint does not count,
 * since it only turns it about itself, or lengthens it.
 * @param {Pick<Stretch, 'link' | 'kind'>} one
 * @param {Pick<Stretch, 'link' | 'kind'>} other
 */
const areNeighbours = (one, other) => other.link - one.link - (other.kind === 'offset' ? 1 : 0) <= 1;

/**
 * What the arm consists of, from the base on.
 * @param {Chain} chain
 * @returns {{ link: number, kind: StretchKind }[]}
 */
function partsOf(chain) {
  const links = chain.joints.flatMap((_, link) =>
    /** @type {const} */ (['offset', 'length']).map((kind) => ({ link, kind })),
  );
  return [...links, { link: chain.dof - 1, kind: 'tool' }];
}

/** A modified table has the length of a link in the row after it. @param {Chain} chain @param {number} link */
const lengthOf = ({ convention, joints }, link) =>
  Math.abs((convention === 'modified' ? joints[link + 1] : joints[link])?.a ?? 0);

/** @param {Chain} chain */
const toolLength = ({ tool }) => Math.hypot(tool[12], tool[13], tool[14]);

/** How long a part can be, perhaps Infinity. @param {Chain} chain @param {number} link @param {StretchKind} kind */
function longest(chain, link, kind) {
  if (kind === 'length') return lengthOf(chain, link);
  if (kind === 'tool') return toolLength(chain);
  const { type, d, lower, upper } = chain.joints[link];
  return type === 'revolute' ? Math.abs(d) : Math.max(Math.abs(d + lower), Math.abs(d + upper));
}

/** Room for frames, for each number of joints. @type {Float64Array[]} */
const framesFor = [];

/**
 * Both ends of every stretch in a posture, seen from the chain's root.
 * @param {ArmBodies} bodies
 * @param {ArrayLike<number>} q
 * @param {Float64Array} out  ENDS numbers a stretch
 */
export function writeEnds({ chain, stretches, tcp }, q, out) {
  const frames = linkFrames(chain, q, (framesFor[chain.dof] ??= new Float64Array(16 * (chain.dof + 1))));
  const isModified = chain.convention === 'modified';
  for (let i = 0; i < stretches.length; i++) {
    const { link, kind } = stretches[i];
    const at = ENDS * i;
    const end = 16 * (link + 1);
    if (kind === 'tool') {
      writePoint(frames, end, 0, 0, out, at);
      for (let k = 0; k < 3; k++) {
        out[at + 3 + k] =
          out[at + k] + frames[end + k] * tcp[0] + frames[end + 4 + k] * tcp[1] + frames[end + 8 + k] * tcp[2];
      }
    } else if (kind === 'length') {
      const a = isModified ? chain.joints[link + 1].a : -chain.joints[link].a;
      writePoint(frames, end, 0, 0, out, at);
      writePoint(frames, end, 0, a, out, at + 3); // along x, ahead of a modified frame or behind a standard one
    } else {
      const { type, d } = chain.joints[link];
      const offset = type === 'prismatic' ? d + q[link] : d;
      const axis = isModified ? end : 16 * link;
      writePoint(frames, axis, 8, 0, out, at);
      writePoint(frames, axis, 8, isModified ? -offset : offset, out, at + 3);
    }
  }
  return out;
}

/**
 * The point so far along an axis of a frame: its column 0 is x, 8 is z.
 * @param {Float64Array} frames
 * @param {number} frame
 * @param {0 | 8} axis
 * @param {number} far
 * @param {Float64Array} out
 * @param {number} at
 */
function writePoint(frames, frame, axis, far, out, at) {
  for (let k = 0; k < 3; k++) out[at + k] = frames[frame + 12 + k] + far * frames[frame + axis + k];
}

/**
 * How far any point of each stretch can go for each radian, or metre, that a joint moves anywhere between two postures: a row of
 * n numbers a stretch, 0 where the joint does not move it.
 * @param {ArmBodies} bodies
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {Float64Array} out  n numbers a stretch
 */
export function writeLevers({ chain, stretches, tcp }, from, to, out) {
  const { dof, joints } = chain;
  requirePosture(dof, from);
  requirePosture(dof, to);
  /** @param {number} link */
  const offset = (link) => {
    const { type, d } = joints[link];
    return type === 'revolute' ? Math.abs(d) : Math.max(Math.abs(d + from[link]), Math.abs(d + to[link]));
  };
  for (let i = 0; i < stretches.length; i++) {
    const { link, kind } = stretches[i];
    let lever = kind === 'offset' ? 0 : lengthOf(chain, link) + (kind === 'tool' ? Math.hypot(...tcp) : 0);
    for (let j = dof - 1; j >= 0; j--) {
      if (j > link) {
        out[dof * i + j] = 0;
        continue;
      }
      if (j < link) {
        // past the offset of the link beyond, from the axis of this joint
        lever += offset(j + 1) + lengthOf(chain, j);
      }
      out[dof * i + j] = joints[j].type === 'prismatic' ? 1 : lever;
    }
  }
  return out;
}
