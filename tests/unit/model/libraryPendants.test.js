/**
 * Arms of the library as their controllers count them: axis values and the flange's frame belong together as in the makers' own
 * frames, by plain matrices that share nothing with the kernel.
 */
import { expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { pendantValues } from '../../../src/model/controller/controllerValues.js';
import { LIBRARY } from '../../../src/model/library.js';

/** @typedef {number[]} Matrix  three rows of four */

/** @param {Matrix} A @param {Matrix} B @returns {Matrix} */
const times = (A, B) =>
  Array.from({ length: 12 }, (_, i) => {
    const [row, k] = [4 * Math.floor(i / 4), i % 4];
    return A[row] * B[k] + A[row + 1] * B[k + 4] + A[row + 2] * B[k + 8] + (k === 3 ? A[row + 3] : 0);
  });
const move = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => [
  1,
  0,
  0,
  x,
  0,
  1,
  0,
  y,
  0,
  0,
  1,
  z,
];
/** @param {'x' | 'y' | 'z'} axis @param {number} degrees @returns {Matrix} */
function turn(axis, degrees) {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  if (axis === 'x') return [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0];
  return axis === 'y' ? [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0] : [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0];
}

/** A1, A4 and A6 turn the other way; the arm is level at A2 = A3 = 0; $FLANGE has z ahead and x down (kuka_experimental). @param {number[]} lengths @param {number[]} A */
const kuka = ([d1, a1, l2, e, l4, l6], [a, b, c, d, f, g]) =>
  [
    ...[move(0, 0, d1), turn('z', -a), move(a1, 0, 0), turn('y', b), move(l2, 0, 0), turn('y', c), move(0, 0, e)],
    ...[turn('x', -d), move(l4, 0, 0), turn('y', f), move(l6, 0, 0), turn('x', -g), turn('y', 90)],
  ].reduce(times);

/** J3 is measured from the horizontal; axes +z, +y, −y, −x, −y, −x (ros-industrial/fanuc). @param {number[]} lengths @param {number[]} J */
const fanuc = ([d1, a1, l2, e, l4, l6], [a, b, c, d, f, g]) =>
  [
    ...[move(0, 0, d1), turn('z', a), move(a1, 0, 0), turn('y', b), move(0, 0, l2), turn('y', -b - c), move(0, 0, e)],
    ...[turn('x', -d), move(l4, 0, 0), turn('y', -f), move(l6, 0, 0), turn('x', -g), turn('y', -90), turn('x', 180)],
  ].reduce(times);

test.for(
  /** @type {[string, typeof kuka, number[]][]} */ ([
    ['kuka_kr5_arc', kuka, [400, 180, 600, 120, 620, 115]],
    ['kuka_kr6_r900', kuka, [400, 25, 455, 35, 420, 80]],
    ['kuka_kr210_l150', kuka, [750, 350, 1250, -55, 1500, 230]],
    ['fanuc_lrmate200id', fanuc, [330, 50, 330, 35, 335, 80]],
    ['fanuc_m10ia', fanuc, [450, 150, 600, 200, 640, 100]],
  ]),
)('%s is counted as its controller counts, and its flange is the controller’s', ([id, makers, lengths]) => {
  const robot = LIBRARY[id];
  const chain = compileRobot(robot);
  for (const q of [
    [0, 0, 0, 0, 0, 0],
    [11, -22, 33, -44, 55, -66],
    [-80, 15, -40, 120, -70, 200],
  ]) {
    const T = tcpPose(chain, compilePosture(robot, q));
    makers(lengths, pendantValues(robot, q)).forEach((value, i) => {
      const [row, column] = [Math.floor(i / 4), i % 4];
      expect(T[4 * column + row] * (column === 3 ? 1000 : 1)).toBeCloseTo(value, 9);
    });
  }
});
