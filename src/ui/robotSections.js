/**
 * Below the table: what belongs to the robot beside it, folded. Each head says the most important in a line; what is below
 * it is fetched when it is first opened.
 *
 * @import { Page } from './page.js'
 * @import { PoseDoc, RobotDoc } from '../model/document.js'
 * @import { Child } from './dom.js'
 */
import { isSliding } from '../model/document.js';
import { isNoPose, isNoTurn } from '../model/noPose.js';
import { together } from '../model/views.js';
import { h, symbol } from './dom.js';
import { foldMaker } from './fold.js';
import { compact } from './format.js';
import { TEXT } from './strings.js';

/** How many characters of a shift a head has room for. */
const WIDEST = 7;

const JOINT_HEAD = 'fold-joint';

/**
 * Open what belongs to a joint, and go there.
 * @param {Page} page
 * @param {number} joint
 */
export function openJointDetails({ store, clock }, joint) {
  store.dispatch({ type: 'show', change: { openJoint: joint } });
  clock.onFrame(() => document.getElementById(JOINT_HEAD)?.focus()); // when the menu that asked is gone
}

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ automaticRadii: (robot: RobotDoc) => readonly number[] }} scene  how thick links are drawn by themselves, in
 *   document units
 */
export function createRobotSections(page, host, scene) {
  const { store, addView, clock, messages } = page;
  const fold = foldMaker(clock, messages.fault);
  const joint = fold(
    JOINT_HEAD,
    async (body) => (await import('./jointDetails.js')).createJointDetails(page, body, scene),
    (isOpen) => store.dispatch({ type: 'show', change: { openJoint: isOpen ? shown : null } }),
  );
  const editPose = async (/** @type {HTMLElement} */ body, /** @type {'base' | 'tool'} */ which) =>
    (await import('./poseEditor.js')).createPoseEditor(page, body, which);
  const base = fold('fold-base', (body) => editPose(body, 'base'));
  const tool = fold('fold-tool', (body) => editPose(body, 'tool'));
  const about = fold('fold-about', async (body) => (await import('./robotInfo.js')).createRobotInfo(page, body));
  host.append(...[joint, base, tool, about].map(({ element }) => element));

  let shown = 0; // the joint that the head speaks of
  // With the fold open, whichever row a person goes to is the one that is shown in it.
  host.addEventListener('focusin', ({ target }) => {
    const row = target instanceof Element && target.closest('tr[data-row]')?.getAttribute('data-row');
    if (typeof row !== 'string' || store.state.session.openJoint === null) return;
    store.dispatch({ type: 'show', change: { openJoint: Number(row) } });
  });

  addView(
    together(({ doc, session }) => [doc.robot, session.openJoint, session.cell?.joint ?? null]),
    ([robot, open, cellJoint]) => {
      shown = Math.min(open ?? cellJoint ?? shown, robot.joints.length - 1);
      const axis = robot.convention === 'standard' ? shown : shown + 1;
      const way = isSliding(robot.joints[shown]) ? TEXT.robot.slides : TEXT.robot.turns;
      joint.setHead(TEXT.robot.joint(shown + 1), way, ' ', symbol('z', axis));
      joint.set(open !== null);
    },
  );
  addView(
    ({ doc }) => doc.robot,
    (robot) => {
      base.setHead(TEXT.robot.base, ...poseInWords(robot.base, robot, TEXT.robot.noBase));
      tool.setHead(TEXT.robot.tool, ...poseInWords(robot.tool, robot, TEXT.robot.noTool));
      about.setHead(TEXT.robot.about, robot.info.source ?? TEXT.robot.noSource);
    },
  );
}

/** "z 160 mm, turned". @param {PoseDoc} pose @param {RobotDoc} robot @param {string} none @returns {Child[]} */
function poseInWords(pose, { units }, none) {
  if (isNoPose(pose)) return [none];
  const shifts = pose.xyz.flatMap((value, i) =>
    value === 0 ? [] : [[h('span', { class: 'm' }, 'xyz'[i]), ` ${compact(value, WIDEST).text} `]],
  );
  if (shifts.length === 0) return [TEXT.robot.turnedOnly];
  return [...shifts.flat(), units.length, isNoTurn(pose) ? null : `, ${TEXT.robot.turned}`];
}
