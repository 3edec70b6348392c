/**
 * Below the table: what belongs to the robot beside it, folded. Each head says the most important in a line; what is below
 * it is fetched when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import { isSliding } from '../../model/document.js';
import { isNoPose } from '../../model/noPose.js';
import { together } from '../../model/views.js';
import { symbol } from '../parts/dom.js';
import { foldMaker } from '../parts/fold.js';
import { poseInWords } from './poseInWords.js';
import { TEXT } from '../strings.js';

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
 * @param {{ automaticRadii: (robot: RobotDoc) => readonly number[], cells: () => Promise<Workcells> }} scene  how thick links are
 *   drawn by themselves, in document units; the arm among its obstacles
 */
export function createRobotSections(page, host, scene) {
  const { store, addView, clock, messages } = page;
  const fold = foldMaker(clock, messages.fault);
  const joint = fold(
    JOINT_HEAD,
    async (body) => (await import('./jointDetails.js')).createJointDetails(page, body, scene),
    (isOpen) => store.dispatch({ type: 'show', change: { openJoint: isOpen ? shown : null } }),
  );
  const editPose = async (/** @type {HTMLElement} */ body, /** @type {'base' | 'tool'} */ which) => {
    const [{ createPoseEditor }, { robotPose }] = await Promise.all([
      import('./poseEditor.js'),
      import('./poseSubjects.js'),
    ]);
    createPoseEditor(page, body, robotPose(which));
  };
  const base = fold('fold-base', (body) => editPose(body, 'base'));
  const tool = fold('fold-tool', (body) => editPose(body, 'tool'));
  const frames = fold('fold-frames', async (body) => (await import('./framesPanel.js')).createFramesPanel(page, body));
  const obstacles = fold(
    'fold-obstacles',
    async (body) => {
      const [{ createObstaclesPanel }, cells] = await Promise.all([
        import('../workcell/obstaclesPanel.js'),
        scene.cells(),
      ]);
      createObstaclesPanel(page, body, cells);
    },
    (isOpen) => store.dispatch({ type: 'show', change: { workcell: { ...store.state.session.workcell, isOpen } } }),
  );
  const about = fold('fold-about', async (body) => (await import('./robotInfo.js')).createRobotInfo(page, body));
  host.append(...[joint, base, tool, frames, obstacles, about].map(({ element }) => element));

  let shown = 0; // the joint that the head speaks of: known at once, for a key that comes before the next picture
  const follow = () => {
    const { doc, session } = store.state;
    shown = Math.min(session.openJoint ?? session.cell?.joint ?? shown, doc.robot.joints.length - 1);
  };
  follow();
  store.subscribe(follow);
  // With the fold open, whichever row a person goes to is the one that is shown in it.
  host.addEventListener('focusin', ({ target }) => {
    const row = target instanceof Element && target.closest('tr[data-row]')?.getAttribute('data-row');
    if (typeof row !== 'string' || store.state.session.openJoint === null) return;
    store.dispatch({ type: 'show', change: { openJoint: Number(row) } });
  });

  addView(
    together(({ doc, session }) => [doc.robot, session.openJoint, shown]),
    ([robot, open, index]) => {
      const axis = robot.convention === 'standard' ? index : index + 1;
      const way = isSliding(robot.joints[index]) ? TEXT.robot.slides : TEXT.robot.turns;
      joint.setHead(TEXT.robot.joint(index + 1), way, ' ', symbol('z', axis));
      joint.set(open !== null);
    },
  );
  addView(
    ({ doc }) => doc.robot,
    (robot) => {
      base.setHead(TEXT.robot.base, ...poseInWords(robot.base, robot.units, TEXT.robot.noBase));
      tool.setHead(TEXT.robot.tool, ...poseInWords(robot.tool, robot.units, TEXT.robot.noTool));
      about.setHead(TEXT.robot.about, robot.info.source ?? TEXT.robot.noSource);
    },
  );
  addView(
    together(({ doc, session }) => [doc.obstacles.length, session.workcell.isOpen]),
    ([count, isOpen]) => {
      obstacles.setHead(TEXT.robot.obstacles, count === 0 ? TEXT.robot.noObstacles : String(count));
      obstacles.set(isOpen);
    },
  );
  addView(
    together(({ doc }) => [doc.activeUser, doc.activeTool, isNoPose(doc.robot.tool)]),
    ([user, inUse, isFlange]) => frames.setHead(TEXT.robot.frames, TEXT.robot.active(user, inUse, isFlange)),
  );
}
