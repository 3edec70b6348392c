/** Chance for the commands about obstacles: sensible and senseless ones. */
import fc from 'fast-check';

/** @typedef {import('../../../src/model/document.js').PoseDoc} PoseDoc */
/** @typedef {import('../../../src/model/workcell/obstacles.js').NewObstacle} NewObstacle */
/** @typedef {import('../../../src/model/workcell/obstacles.js').ObstacleCommand} ObstacleCommand */

const anyIndex = fc.integer({ min: -1, max: 3 });
const sound = fc.double({ min: 0.01, max: 1e3, noNaN: true });
const anySize = fc.oneof(
  { weight: 12, arbitrary: sound },
  { weight: 1, arbitrary: fc.constantFrom(0, -0, -1, NaN, Infinity, 2e9) },
);
const anyKind = fc.constantFrom('box', 'sphere', 'cylinder', 'plane', 'plane', 'cone', '__proto__');

/** @param {fc.Arbitrary<PoseDoc>} anyPose */
function obstacleAt(anyPose) {
  const fields = { kind: anyKind, width: anySize, depth: anySize, height: anySize, radius: anySize };
  return fc
    .tuple(fc.option(anyPose, { freq: 9 }), fc.record(fields, { requiredKeys: ['kind', 'radius', 'height'] }))
    .map(([pose, rest]) => /** @type {NewObstacle} */ (/** @type {unknown} */ (pose && { ...pose, ...rest })));
}

/** @param {fc.Arbitrary<PoseDoc>} anyPose @returns {fc.Arbitrary<ObstacleCommand & { gesture?: string }>} */
export const obstacleCommandOf = (anyPose) =>
  fc.oneof(
    fc.record({ type: fc.constant(/** @type {const} */ ('add-obstacle')), obstacle: obstacleAt(anyPose) }),
    fc.record({
      type: fc.constant(/** @type {const} */ ('edit-obstacle')),
      index: anyIndex,
      obstacle: obstacleAt(anyPose),
      gesture: fc.option(fc.constantFrom('a', 'b'), { nil: undefined }),
    }),
    fc.record({
      type: fc.constant(/** @type {const} */ ('rename-obstacle')),
      index: anyIndex,
      id: fc.oneof(fc.constantFrom('table', 'box_1', 'sphere_1', ''), fc.string()),
    }),
    fc.record({ type: fc.constant(/** @type {const} */ ('remove-obstacle')), index: anyIndex }),
  );
