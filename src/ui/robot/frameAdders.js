/**
 * The menus by which user frames and tools are added: from numbers, from where the tool is, by three points.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { PoseDoc } from '../../model/document.js'
 * @import { FrameKind } from '../../model/frames/frames.js'
 */
import { identityPose } from '../../model/document.js';
import { poseOnly } from '../../model/frames/frames.js';
import { withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { FRAMES } from '../words/frames.js';

/**
 * @param {object} given
 * @param {(kind: FrameKind, pose: PoseDoc) => void} given.add
 * @param {() => void} given.openPoints
 * @param {() => PoseDoc} given.tcp   where the tool is, seen from the world
 * @param {() => PoseDoc} given.tool  the one in use, seen from the flange
 */
export function frameAdders({ add, openPoints, tcp, tool }) {
  /** @type {Record<FrameKind, () => Choice[]>} */
  const ways = {
    user: () => [
      { title: FRAMES.from.here, detail: FRAMES.from.hereDetail, run: () => add('user', tcp()) },
      { title: FRAMES.from.points, detail: FRAMES.from.pointsDetail, run: openPoints },
      { title: FRAMES.from.numbers, detail: FRAMES.from.userDetail, run: () => add('user', identityPose()) },
    ],
    tool: () => [
      { title: FRAMES.from.numbers, detail: FRAMES.from.toolDetail, run: () => add('tool', identityPose()) },
      { title: FRAMES.from.present, detail: FRAMES.from.presentDetail, run: () => add('tool', poseOnly(tool())) },
    ],
  };
  /** @param {FrameKind} kind */
  function adder(kind) {
    const label = FRAMES.add[kind];
    const attributes = { type: 'button', class: 'btn btn-icon', 'aria-label': label, title: label };
    const button = h('button', attributes, icon('plus'));
    return { button, element: withChoices(button, () => ({ groups: [ways[kind]()] }), { className: 'frames-add' }) };
  }
  return { user: adder('user'), tool: adder('tool') };
}
