/**
 * Which of the document's user frames and tools is in use, as on a controller: at most one of each kind. With no tool chosen
 * the robot's own holds, and with no user frame the world.
 *
 * @import { Doc, FrameDoc, PoseDoc } from './document.js'
 */

/** @param {Doc} doc @param {FrameDoc['kind']} kind @returns {FrameDoc | null} */
export const activeFrame = ({ frames }, kind) =>
  frames.find((frame) => frame.kind === kind && frame.active === true) ?? null;

/** Where the TCP is, seen from the flange. @param {Doc} doc @returns {PoseDoc} */
export const toolInUse = (doc) => activeFrame(doc, 'tool') ?? doc.robot.tool;
