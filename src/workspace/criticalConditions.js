/**
 * What a posture has to meet to lie on a critical curve, on a face of the box of joint values, and which way the curve goes on.
 * With the joint that the plane takes care of at a limit, what the free joints do beside the plane counts as well, by a factor μ.
 *
 * @import { Face } from './criticalCurves.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Vertex } from './traced.js'
 */
import { createSvd, decompose } from '../kinematics/measures/singularValues.js';

const NEWTON_STEPS = 30;

/** Of differences, rad and m. */
const DIFFERENCE = 1e-6;

/** Conditions met within this (arm lengths per radian) are met. */
const MET = 1e-10;

/** A singular value smaller than this, of the largest, belongs to a direction in which the conditions go on being met. */
const FLAT = 1e-5;

/** The place has to move by this share of the arm's length for each radian of the unknowns, or the curve stands still. */
const STANDING = 1e-6;

/**
 * The conditions of one face, at unknowns y = (free arguments …, θ), and μ if that joint is held.
 * @param {SectionMap} map
 * @param {Face} face
 */
export function createConditions(map, { free, x, held }) {
  const n = free.length;
  const m = held === undefined ? n : n + 1;
  const place = Float64Array.from([...x, 0]);
  const scale = map.placement.chain.characteristicLength;
  const values = new Float64Array(m);
  const plus = new Float64Array(m);
  const slopes = new Float64Array(m * (m + 1));
  const svd = createSvd(m, m + 1);
  const step = new Float64Array(m + 1);
  const beside = new Float64Array(2);

  /** @param {Float64Array} y @param {Float64Array} out */
  const write = (y, out) => {
    free.forEach((k, i) => (place[k] = y[i]));
    map.write(place);
    if (held !== undefined) map.writeBeside(held, beside);
    const { f, Jf, Jn } = map;
    const outward = map.kind === 'meridian' ? Math.max(f[0], 1e-12) : 1;
    const [c, s] = [Math.cos(y[n]), Math.sin(y[n])];
    for (let i = 0; i < n; i++) {
      const k = free[i];
      out[i] = ((c * Jf[2 * k]) / outward + s * Jf[2 * k + 1] + (held === undefined ? 0 : y[m] * Jn[k])) / scale;
    }
    if (held !== undefined) out[n] = beside[0] / scale;
  };

  /** The conditions and how they change, decomposed. @param {Float64Array} y @returns {number} the largest condition */
  const decomposeAt = (y) => {
    for (let j = 0; j <= m; j++) {
      const at = y[j];
      y[j] = at + DIFFERENCE;
      write(y, plus);
      y[j] = at - DIFFERENCE;
      write(y, values);
      y[j] = at;
      for (let i = 0; i < m; i++) slopes[m * j + i] = (plus[i] - values[i]) / (2 * DIFFERENCE);
    }
    write(y, values);
    decompose(slopes, svd);
    return values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  };

  return {
    m,
    svd,
    /** Newton's method, the shortest step each time. @param {Float64Array} y changed in place @returns {boolean} whether it has met the conditions */
    meet(y) {
      for (let round = 0; round < NEWTON_STEPS; round++) {
        const most = decomposeAt(y);
        if (most <= MET) return true;
        step.fill(0);
        for (let k = 0; k < m; k++) {
          if (svd.values[k] <= FLAT * svd.values[0]) continue;
          let along = 0;
          for (let i = 0; i < m; i++) along += svd.U[m * k + i] * values[i];
          for (let j = 0; j <= m; j++) step[j] -= (along / svd.values[k]) * svd.V[(m + 1) * k + j];
        }
        const longest = step.reduce((size, value) => Math.max(size, Math.abs(value)), 0);
        const share = Math.min(1, 0.5 / longest);
        for (let j = 0; j <= m; j++) y[j] += share * step[j];
      }
      return false;
    },
    /**
     * The direction along the curve in which the place moves most; null if it does not move.
     * @param {Float64Array} y
     * @returns {{ tangent: Float64Array, du: number, dv: number } | null}
     */
    tangentAt(y) {
      decomposeAt(y);
      const { f, Jf } = map;
      const outward = map.kind === 'meridian' ? Math.max(f[0], 1e-12) : 1;
      /** How the place moves along each direction that is open. @type {number[][]} */
      const open = [];
      for (let k = m; k >= 0; k--) {
        if (k < m && svd.values[k] > FLAT * svd.values[0]) break;
        let [du, dv] = [0, 0];
        for (let i = 0; i < n; i++) {
          du += (svd.V[(m + 1) * k + i] * Jf[2 * free[i]]) / outward;
          dv += svd.V[(m + 1) * k + i] * Jf[2 * free[i] + 1];
        }
        open.push([k, du, dv]);
      }
      // Places only move square to n here: their speed along the curve says how much each direction counts.
      const [nu, nv] = [-Math.sin(y[n]), Math.cos(y[n])];
      const shares = open.map(([, du, dv]) => du * nu + dv * nv);
      const size = Math.hypot(...shares);
      if (size < STANDING * scale) return null;
      const tangent = new Float64Array(m + 1);
      open.forEach(([k], i) => {
        for (let j = 0; j <= m; j++) tangent[j] += (shares[i] / size) * svd.V[(m + 1) * k + j];
      });
      return { tangent, du: nu * size, dv: nv * size };
    },
    /** @param {Float64Array} y @returns {Vertex} */
    vertex(y) {
      const full = Float64Array.from([...x, ...y.subarray(n)]);
      free.forEach((k, i) => (full[k] = y[i]));
      map.write(full);
      return { x: full, u: map.f[0], v: map.f[1] };
    },
    /**
     * Whether a step leads over the axis of a half-plane, to its other side.
     * @param {Float64Array} from
     * @param {Float64Array} to
     */
    crosses(from, to) {
      if (map.kind !== 'meridian') return false;
      const [before, after] = [from, to].map((y) => {
        write(y, values);
        return map.needed();
      });
      return Math.cos(after - before) < 0;
    },
    /** Whether the joint that the plane takes care of can be where it has to be. @param {Float64Array} y */
    isBrought(y) {
      write(y, values);
      return held === undefined ? map.isBrought() : beside[1] > 0;
    },
    /** The same with the normal as it is on the other side of the axis. @param {Float64Array} y @param {number} [half] */
    mirrored: (y, half = Math.PI) => y.with(n, half - y[n]),
    /** @param {Vertex} vertex @returns {Float64Array} */
    unknowns: ({ x: full }) => Float64Array.from([...free.map((k) => full[k]), ...full.subarray(x.length)]),
  };
}
