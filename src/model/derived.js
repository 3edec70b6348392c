/**
 * Everything that follows from the document. Nothing here is stored twice; each value is computed when first asked for,
 * and again only when what it depends on is another object.
 *
 * @import { Doc } from './document.js'
 */
import { tcpPose } from '../kinematics/forward.js';
import { xyzwprOf } from './aim/aim.js';
import { compilePosture, compileRobot } from './compile.js';
import { memo } from './memo.js';
import { activeFrame, framePose } from './frames/frames.js';

export function createDerived() {
  const chainOf = memo(compileRobot);
  const postureOf = memo(compilePosture);
  const tcpOf = memo(tcpPose);
  const xyzwprFrom = memo(xyzwprOf);
  const userOf = memo(framePose);

  const chain = (/** @type {Doc} */ { robot }) => chainOf(robot);
  /** Joint values, metres and radians. */
  const posture = (/** @type {Doc} */ { robot, posture: values }) => postureOf(robot, values);
  const tcp = (/** @type {Doc} */ doc) => tcpOf(chain(doc), posture(doc));
  return {
    chain,
    posture,
    tcp,
    /** The active user frame seen from the world; the world itself where none is. */
    user: (/** @type {Doc} */ doc) => userOf(activeFrame(doc, 'user'), doc.robot.units),
    /** The tool's pose as X Y Z W P R, in document units. */
    xyzwpr: (/** @type {Doc} */ doc) => xyzwprFrom(doc.robot, tcp(doc)),
  };
}

/** @typedef {ReturnType<typeof createDerived>} Derived */
