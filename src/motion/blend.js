/**
 * From one move into the next without stopping: within a zone about the corner the rate goes over from that of the one to
 * that of the other, smoothly (by 3λ² − 2λ³), so that it is never more than both allow. What is left of the first way falls
 * from α to 0 while what is gone of the second rises from 0 to β.
 *
 * Two moves of the same tool are blended in space; any others by the joints, whose polynomials meet values, rates and
 * accelerations of both ways.
 *
 * @import { MoveWay } from './moveWay.js'
 * @import { Ending } from './moves.js'
 * @import { ToolPath } from './toolPath.js'
 */
import { tcpPose } from '../kinematics/forward.js';
import { compose, invert } from '../kinematics/pose.js';
import { createSpan, writeSpan } from './hermite.js';
import { postureOn } from './moveWay.js';
import { writeBell } from './pathBound.js';
import { TERMS } from './posturePath.js';

/** A zone reaches no farther than nearly to the middle of a move, so that two never meet. */
const MOST = 0.49;

const HALVINGS = 40;
const SCANS = 32;

/**
 * How long a zone is on either side of the corner, in seconds of the ways.
 * @param {MoveWay} before
 * @param {MoveWay} after
 * @param {Ending} ending
 */
export function zoneOf(before, after, ending) {
  const most = MOST * Math.min(before.length, after.length);
  switch (ending.kind) {
    case 'fine':
      return 0;
    case 'share':
      if (!(ending.share >= 0 && ending.share <= 1)) {
        throw new RangeError(`ending.share: expected a share from 0 to 1, got ${ending.share}.`);
      }
      return ending.share * most;
    case 'distance':
      if (!(ending.distance >= 0 && ending.distance < Infinity)) {
        throw new RangeError(`ending.distance: expected 0 or more metres, got ${ending.distance}.`);
      }
      return Math.min(
        most,
        farAs(before, ending.distance, true) * before.length,
        farAs(after, ending.distance, false) * after.length,
      );
    default: {
      /** @type {never} */
      const unknown = ending;
      throw new TypeError(`Unknown ending: ${JSON.stringify(unknown)}`);
    }
  }
}

/**
 * The share of a way within which the tool is no farther from the corner than that, at most half.
 * @param {MoveWay} way
 * @param {number} distance
 * @param {boolean} isBefore   whether the corner is where it ends
 */
function farAs(way, distance, isBefore) {
  if (distance === 0) return 0;
  const T = new Float64Array(16);
  const placeAt = (/** @type {number} */ fromCorner) => {
    const share = isBefore ? 1 - fromCorner : fromCorner;
    const pose = way.tool ? way.tool.poseAt(share, T) : tcpPose(way.chain, postureOn(way, share), T);
    return pose.subarray(12, 15);
  };
  const origin = placeAt(0).slice();
  const isFar = (/** @type {number} */ share) => {
    const [x, y, z] = placeAt(share);
    return Math.hypot(x - origin[0], y - origin[1], z - origin[2]) > distance;
  };
  let low = 0;
  const far = Array.from({ length: SCANS }, (_, k) => (MOST * (k + 1)) / SCANS).find((share) => {
    if (isFar(share)) return true;
    low = share;
    return false;
  });
  if (far === undefined) return MOST;
  let high = far;
  for (let k = 0; k < HALVINGS; k++) {
    const middle = (low + high) / 2;
    if (isFar(middle)) high = middle;
    else low = middle;
  }
  return low;
}

/** 1 − 2λ + 2λ³ − λ⁴: from 1 with slope −2 to 0, at rest; its second derivative is 0 at both ends. */
const FALL = Float64Array.of(1, -2, 0, 2, -1, 0);
/** The same from the other side: 2λ³ − λ⁴. */
const RISE = Float64Array.of(0, 0, 0, 2, -1, 0);

/**
 * Two ways of a tool in one. Superposed: T = the first's way after what is left of it, and then what is gone of the second.
 * @param {ToolPath} before
 * @param {ToolPath} after
 * @param {number} alpha   share of the first that is left at the beginning
 * @param {number} beta    share of the second that is gone at the end
 * @returns {ToolPath}
 */
export function blendPath(before, after, alpha, beta) {
  const T_base_corner = after.poseAt(0);
  const T_corner_base = invert(T_base_corner);
  const corner = T_base_corner.slice(12, 15);
  const [A, B, R] = [new Float64Array(16), new Float64Array(16), new Float64Array(16)];
  const [a1, a2, b1, b2] = [0, 0, 0, 0].map(() => new Float64Array(6));
  const span = createSpan();
  const own = new Float64Array(TERMS);

  /** Sizes of the derivatives of the shares on a piece, into `own`. @param {Float64Array} law @param {number} size @param {number} from @param {number} to */
  function spanOf(law, size, from, to) {
    const width = to - from;
    // the polynomial about `from`, by λ of the piece
    for (let k = 0; k < TERMS; k++) {
      let [sum, binomial] = [0, 1];
      for (let j = k; j < TERMS; j++) {
        sum += law[j] * binomial * from ** (j - k);
        binomial = (binomial * (j + 1)) / (j + 1 - k);
      }
      own[k] = size * sum * width ** k;
    }
    writeSpan(own, 0, span);
    return span.derivatives;
  }

  /** @param {ToolPath} path @param {Float64Array} derivatives */
  function sixthOfArc(path, derivatives) {
    if (path.bend === 0) return 0;
    const sweep = path.length * path.bend;
    const B6 = new Float64Array(7);
    writeBell(
      derivatives.map((size) => sweep * size),
      B6,
    );
    return B6[6] / path.bend;
  }

  return {
    length: alpha * before.length + beta * after.length,
    turn: alpha * before.turn + beta * after.turn,
    bend: 0,
    poseAt(share, out = new Float64Array(16)) {
      before.poseAt(1 - alpha * valueOf(FALL, share), A);
      after.poseAt(beta * valueOf(RISE, share), B);
      // turned as the first, and then as the second turns from the corner: R_B R_cornerᵀ R_A
      const places = [12, 13, 14].map((k) => A[k] + B[k] - corner[k - 12]);
      compose(compose(B, T_corner_base, R), A, out);
      out.set(places, 12);
      return out;
    },
    motionAt(share, first, second) {
      const [fall, rise] = [1 - alpha * valueOf(FALL, share), beta * valueOf(RISE, share)];
      const [f1, r1] = [-alpha * slopeOf(FALL, share), beta * slopeOf(RISE, share)];
      const [f2, r2] = [-alpha * bendOf(FALL, share), beta * bendOf(RISE, share)];
      before.motionAt(fall, a1, a2);
      after.motionAt(rise, b1, b2);
      compose(after.poseAt(rise, B), T_corner_base, R);
      for (let k = 0; k < 3; k++) {
        first[k] = a1[k] * f1 + b1[k] * r1;
        second[k] = a2[k] * f1 * f1 + a1[k] * f2 + b2[k] * r1 * r1 + b1[k] * r2;
      }
      // the second's turning, and the first's as the second has turned it: ω = ω_B + R ω_A, and its derivative
      const turned = [0, 1, 2].map((k) => R[k] * a1[3] + R[4 + k] * a1[4] + R[8 + k] * a1[5]);
      const [x, y, z] = [3, 4, 5].map((k) => b1[k] * r1);
      const [u, v, w] = turned.map((value) => value * f1);
      const across = [y * w - z * v, z * u - x * w, x * v - y * u];
      for (let k = 0; k < 3; k++) {
        first[3 + k] = b1[3 + k] * r1 + turned[k] * f1;
        second[3 + k] = b1[3 + k] * r2 + turned[k] * f2 + across[k];
      }
    },
    // of a line's place by a share of the fourth degree there is no sixth derivative
    sixthOfPlace: (from, to) =>
      sixthOfArc(before, spanOf(FALL, alpha, from, to)) + sixthOfArc(after, spanOf(RISE, beta, from, to)),
    addTurning(from, to, sums) {
      const fall = spanOf(FALL, alpha * before.turn, from, to);
      for (let k = 1; k < TERMS; k++) sums[k] += fall[k];
      const rise = spanOf(RISE, beta * after.turn, from, to);
      for (let k = 1; k < TERMS; k++) sums[k] += rise[k];
    },
  };
}

/** @param {Float64Array} c @param {number} x */
const valueOf = (c, x) => c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
/** @param {Float64Array} c @param {number} x */
const slopeOf = (c, x) => c[1] + x * (2 * c[2] + x * (3 * c[3] + x * 4 * c[4]));
/** @param {Float64Array} c @param {number} x */
const bendOf = (c, x) => 2 * c[2] + x * (6 * c[3] + x * 12 * c[4]);
