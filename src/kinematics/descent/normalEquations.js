/**
 * The normal equations of a least-squares step: H = Jᵀ W J, its lower triangle row by row, and Jᵀ W r.
 * @import { Search } from './search.js'
 */
import * as packing from '../packed.js';

const { MOST_JOINTS } = packing; // the module's own: see frames.js

/**
 * @param {Pick<Search, 'weight' | 'residual' | 'J' | 'H' | 'gradient'>} search  H and gradient are filled
 */
export function writeNormalEquations({ weight, residual: r, J, H, gradient }) {
  const n = Math.min(gradient.length, MOST_JOINTS);
  if (n === 6) {
    writeSix(weight, r, J, H, gradient);
    return;
  }
  for (let i = 0; i < n; i++) {
    const a = 6 * i;
    const row = n * i;
    const w0 = J[a] * weight;
    const w1 = J[a + 1] * weight;
    const w2 = J[a + 2] * weight;
    const j3 = J[a + 3];
    const j4 = J[a + 4];
    const j5 = J[a + 5];
    gradient[i] = w0 * r[0] + w1 * r[1] + w2 * r[2] + j3 * r[3] + j4 * r[4] + j5 * r[5];
    for (let j = 0; j <= i; j++) {
      const b = 6 * j;
      H[row + j] = w0 * J[b] + w1 * J[b + 1] + w2 * J[b + 2] + j3 * J[b + 3] + j4 * J[b + 4] + j5 * J[b + 5];
    }
  }
}

/**
 * The same for six joints, written out, as most arms have them: the loops take half as long again.
 * @param {number} weight
 * @param {Float64Array} r
 * @param {Float64Array} J
 * @param {Float64Array} H
 * @param {Float64Array} gradient
 */
function writeSix(weight, r, J, H, gradient) {
  const r0 = r[0] * weight;
  const r1 = r[1] * weight;
  const r2 = r[2] * weight;
  const r3 = r[3];
  const r4 = r[4];
  const r5 = r[5];
  let j0 = J[0];
  let j1 = J[1];
  let j2 = J[2];
  let j3 = J[3];
  let j4 = J[4];
  let j5 = J[5];
  gradient[0] = j0 * r0 + j1 * r1 + j2 * r2 + j3 * r3 + j4 * r4 + j5 * r5;
  let w0 = j0 * weight;
  let w1 = j1 * weight;
  let w2 = j2 * weight;
  H[0] = w0 * j0 + w1 * j1 + w2 * j2 + j3 * j3 + j4 * j4 + j5 * j5;
  j0 = J[6];
  j1 = J[7];
  j2 = J[8];
  j3 = J[9];
  j4 = J[10];
  j5 = J[11];
  gradient[1] = j0 * r0 + j1 * r1 + j2 * r2 + j3 * r3 + j4 * r4 + j5 * r5;
  w0 = j0 * weight;
  w1 = j1 * weight;
  w2 = j2 * weight;
  H[6] = w0 * J[0] + w1 * J[1] + w2 * J[2] + j3 * J[3] + j4 * J[4] + j5 * J[5];
  H[7] = w0 * j0 + w1 * j1 + w2 * j2 + j3 * j3 + j4 * j4 + j5 * j5;
  j0 = J[12];
  j1 = J[13];
  j2 = J[14];
  j3 = J[15];
  j4 = J[16];
  j5 = J[17];
  gradient[2] = j0 * r0 + j1 * r1 + j2 * r2 + j3 * r3 + j4 * r4 + j5 * r5;
  w0 = j0 * weight;
  w1 = j1 * weight;
  w2 = j2 * weight;
  H[12] = w0 * J[0] + w1 * J[1] + w2 * J[2] + j3 * J[3] + j4 * J[4] + j5 * J[5];
  H[13] = w0 * J[6] + w1 * J[7] + w2 * J[8] + j3 * J[9] + j4 * J[10] + j5 * J[11];
  H[14] = w0 * j0 + w1 * j1 + w2 * j2 + j3 * j3 + j4 * j4 + j5 * j5;
  j0 = J[18];
  j1 = J[19];
  j2 = J[20];
  j3 = J[21];
  j4 = J[22];
  j5 = J[23];
  gradient[3] = j0 * r0 + j1 * r1 + j2 * r2 + j3 * r3 + j4 * r4 + j5 * r5;
  w0 = j0 * weight;
  w1 = j1 * weight;
  w2 = j2 * weight;
  H[18] = w0 * J[0] + w1 * J[1] + w2 * J[2] + j3 * J[3] + j4 * J[4] + j5 * J[5];
  H[19] = w0 * J[6] + w1 * J[7] + w2 * J[8] + j3 * J[9] + j4 * J[10] + j5 * J[11];
  H[20] = w0 * J[12] + w1 * J[13] + w2 * J[14] + j3 * J[15] + j4 * J[16] + j5 * J[17];
  H[21] = w0 * j0 + w1 * j1 + w2 * j2 + j3 * j3 + j4 * j4 + j5 * j5;
  j0 = J[24];
  j1 = J[25];
  j2 = J[26];
  j3 = J[27];
  j4 = J[28];
  j5 = J[29];
  gradient[4] = j0 * r0 + j1 * r1 + j2 * r2 + j3 * r3 + j4 * r4 + j5 * r5;
  w0 = j0 * weight;
  w1 = j1 * weight;
  w2 = j2 * weight;
  H[24] = w0 * J[0] + w1 * J[1] + w2 * J[2] + j3 * J[3] + j4 * J[4] + j5 * J[5];
  H[25] = w0 * J[6] + w1 * J[7] + w2 * J[8] + j3 * J[9] + j4 * J[10] + j5 * J[11];
  H[26] = w0 * J[12] + w1 * J[13] + w2 * J[14] + j3 * J[15] + j4 * J[16] + j5 * J[17];
  H[27] = w0 * J[18] + w1 * J[19] + w2 * J[20] + j3 * J[21] + j4 * J[22] + j5 * J[23];
  H[28] = w0 * j0 + w1 * j1 + w2 * j2 + j3 * j3 + j4 * j4 + j5 * j5;
  j0 = J[30];
  j1 = J[31];
  j2 = J[32];
  j3 = J[33];
  j4 = J[34];
  j5 = J[35];
  gradient[5] = j0 * r0 + j1 * r1 + j2 * r2 + j3 * r3 + j4 * r4 + j5 * r5;
  w0 = j0 * weight;
  w1 = j1 * weight;
  w2 = j2 * weight;
  H[30] = w0 * J[0] + w1 * J[1] + w2 * J[2] + j3 * J[3] + j4 * J[4] + j5 * J[5];
  H[31] = w0 * J[6] + w1 * J[7] + w2 * J[8] + j3 * J[9] + j4 * J[10] + j5 * J[11];
  H[32] = w0 * J[12] + w1 * J[13] + w2 * J[14] + j3 * J[15] + j4 * J[16] + j5 * J[17];
  H[33] = w0 * J[18] + w1 * J[19] + w2 * J[20] + j3 * J[21] + j4 * J[22] + j5 * J[23];
  H[34] = w0 * J[24] + w1 * J[25] + w2 * J[26] + j3 * J[27] + j4 * J[28] + j5 * J[29];
  H[35] = w0 * j0 + w1 * j1 + w2 * j2 + j3 * j3 + j4 * j4 + j5 * j5;
}
