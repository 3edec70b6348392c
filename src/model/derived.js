/**
 * Everything that follows from the document. Nothing here is stored twice; each value is computed when first asked for,
 * and again only when what it depends on is another object.
 *
 * @import { Doc } from './document.js'
 */
import { linkFrames, tcpPose } from '../kinematics/forward.js';
import { compilePosture, compileRobot } from './compile.js';
import { memo } from './memo.js';

export function createDerived() {
  const chainOf = memo(compileRobot);
  const postureOf = memo(compilePosture);
  const framesOf = memo(linkFrames);
  const tcpOf = memo(tcpPose);

  const chain = (/** @type {Doc} */ { robot }) => chainOf(robot);
  /** Joint values, metres and radians. */
  const posture = (/** @type {Doc} */ { robot, posture: values }) => postureOf(robot, values);
  return {
    chain,
    posture,
    frames: (/** @type {Doc} */ doc) => framesOf(chain(doc), posture(doc)),
    tcp: (/** @type {Doc} */ doc) => tcpOf(chain(doc), posture(doc)),
  };
}

/** @typedef {ReturnType<typeof createDerived>} Derived */
