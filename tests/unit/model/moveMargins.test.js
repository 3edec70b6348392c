/** What decimals cost is never so much that another orientation would pass for rounding. */
import { expect, test } from 'vitest';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { roundingOf } from '../../../src/model/controller/moveMargins.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';

/** @typedef {import('../../../src/model/controller/codeMoves.js').CodeMove} CodeMove */

const FEW = Object.keys(LIBRARY).filter((id) => LIBRARY[id].joints.length < 6);

test.each(FEW)('%s: less than a degree, in singular postures and next to them, too', (id) => {
  const doc = newDocument(LIBRARY[id]);
  const { robot } = doc;
  const folded = robot.joints.map(() => 0);
  const postures = [doc.posture, folded, folded.map((_, i) => (i === 1 ? 1e-6 : 0)), folded.map(() => 1e-3)];
  for (const posture of postures) {
    const followed = { chain: compileRobot(robot), end: compilePosture(robot, posture) };
    const move = /** @type {CodeMove} */ (/** @type {unknown} */ ({ followed, isJoint: false }));
    const { millimetres, degrees } = roundingOf(doc, move);
    expect(millimetres).toBeLessThan(0.01);
    expect(degrees).toBeGreaterThan(0);
    expect(degrees).toBeLessThan(1);
  }
});
