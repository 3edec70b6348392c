/**
 * The state of the page in the scene: which part of the state each thing in the picture shows. What is not in every first
 * picture is fetched when it is first wanted.
 *
 * @import { Wanted } from './marks/dimension.js'
 * @import { StageOptions } from './stage.js'
 * @import { LabelText } from './labels.js'
 * @import { MarkSet, MarkTools } from './marks/marks.js'
 * @import { Clock } from '../model/clock.js'
 * @import { Derived } from '../model/derived.js'
 * @import { Convention, DhField } from '../model/document.js'
 * @import { Action, AppState, BuildUp, Session } from '../model/session.js'
 * @import { Store } from '../model/store.js'
 * @import { AddView } from '../model/views.js'
 *
 * @typedef {object} State
 * @property {Store<AppState, Action>} store
 * @property {AddView<AppState>} addView
 * @property {Derived} derived
 * @property {Clock} clock
 */
import { tcpPose } from '../kinematics/forward.js';
import { isAtAnswer, poseFromXyzwpr } from '../model/aim/aim.js';
import { compileLinkStyles, compilePose, compilePosture } from '../model/compile.js';
import { targetPose } from '../model/frames/frames.js';
import { nearestShown } from '../model/aim/nearestShown.js';
import { lostWanted } from '../model/aim/lostShown.js';
import { memo } from '../model/memo.js';
import { isRowField, motionAt } from '../model/robot/rowMotions.js';
import { together } from '../model/views.js';
import { shownFrames, shownUserFrames } from '../model/frames/shownFrames.js';
import { createStage } from './stage.js';

/** An arm with a reach this much larger or smaller (as a logarithm: half as much again) is another one to the eye. */
const OTHER_SIZE = Math.log(1.5);

/** A view that is not this wide, or two thirds as high, shows a part of the arm better than the whole. */
const SMALL = 450;

/**
 * @param {State} state
 * @param {Omit<StageOptions, 'clock'> & {
 *   text: StageOptions['text'] & { nearest: string, lost: { along: string, about: string }, trace: { start: string }, dimension: (joint: number, field: DhField) => LabelText },
 *   onError: (error: unknown) => void,
 * }} options
 * @returns the stage; null without WebGL
 */
export function createRobotView({ store, addView, derived, clock }, options) {
  const stage = createStage({ ...options, clock });
  if (!stage) return null;
  const linkStyles = memo(compileLinkStyles);
  let shown = { edition: 0, name: '', reach: 0 };
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.edition]),
    ([robot, , edition]) => {
      const chain = derived.chain(store.state.doc);
      stage.showArm(chain, linkStyles(robot));
      stage.showPosture(derived.posture(store.state.doc));
      // Another arm is brought into the picture; one whose table is edited stays where the person looks at it.
      const isOther = robot.name !== shown.name || Math.abs(Math.log(chain.reach / shown.reach)) > OTHER_SIZE;
      if (edition !== shown.edition && isOther) stage.fitOther();
      shown = { edition, name: robot.name, reach: chain.reach };
    },
  );
  let settled = store.state.doc;
  addView(
    together(({ doc, gesture }) => [doc.robot, doc.posture, gesture === null]),
    ([robot, posture, isOver]) => {
      if (!isOver || (robot === settled.robot && posture === settled.posture)) return; // not while somebody types or drags
      settled = store.state.doc;
      stage.keepInPicture();
    },
  );
  addView(({ doc, session }) => litJoint(doc.robot.convention, session), stage.highlightJoint);
  addView(
    together(({ session }) => [gaugedJoint(session), session.answer]),
    ([held, answer]) => {
      // the joint that would have to go past its limit is shown unless another is in hand
      const limit = (answer?.status === 'outside-limits' && answer.result.limit) || null;
      const joint = held ?? limit?.joint ?? null;
      stage.holdJoint(joint, limit?.joint === joint ? limit : null);
    },
  );
  addView(
    together((state) => [
      state.doc.robot,
      state.session.target,
      state.doc.posture,
      state.session.answer,
      nearestShown(state),
    ]),
    ([robot, target, posture, answer, nearest]) => {
      // What is missing is drawn from where the arm is as near as it can be: where it stands, or where its ghost does.
      const isAtNearest = answer !== null && !answer.isMet && isAtAnswer(answer, posture);
      const from = nearest && tcpPose(derived.chain(store.state.doc), compilePosture(robot, nearest));
      stage.showTarget(target && poseFromXyzwpr(robot, target), { reached: !isAtNearest && !from, from });
    },
  );
  addView(({ session }) => session.projection, stage.project);

  /**
   * @template {MarkSet} Set
   * @param {() => Promise<(tools: MarkTools) => Set>} load
   */
  function whenWanted(load) {
    /** @type {Promise<Set> | null} */
    let set = null;
    /** @type {((set: Set) => void) | null} */
    let due = null;
    /** @param {boolean} isWanted @param {(set: Set) => void} use  the last one is carried out when the marks are there */
    return (isWanted, use) => {
      due = use;
      if (!isWanted && !set) return;
      set ??= load().then((create) => /** @type {NonNullable<typeof stage>} */ (stage).addMarks(create));
      set.then(
        (marks) => {
          due?.(marks);
          if (due) stage?.touch();
          due = null;
        },
        (error) => {
          set = null;
          options.onError(error);
        },
      );
    };
  }

  const withFrames = whenWanted(async () => (await import('./marks/frameMarks.js')).createFrameMarks);
  addView(
    ({ doc, session }) => shownFrames(session, doc.robot.joints.length).join(),
    () => {
      const { doc, session } = store.state;
      const numbers = shownFrames(session, doc.robot.joints.length);
      stage.showEnds({ base: numbers.includes(0), tool: numbers.includes('tool') });
      const inner = numbers.filter((one) => typeof one === 'number').filter((one) => one > 0);
      withFrames(inner.length > 0, (frames) => frames.want(inner));
    },
  );
  const withDimension = whenWanted(async () => {
    const { createDimensionMarks } = await import('./marks/dimension.js');
    return (tools) => createDimensionMarks({ ...tools, text: options.text.dimension });
  });
  addView(
    together(({ doc, session }) => [doc.robot.convention, session.build, session.pointedCell ?? session.cell]),
    ([convention, build, cell]) => {
      const wanted = build ? dimensionOfBuild(convention, build) : dimensionOfCell(cell);
      withDimension(wanted !== null, (marks) => marks.want(wanted));
    },
  );
  // On a small screen the view goes near the row that is being changed, though not wherever a pointer passes.
  addView(
    together(({ session }) => [session.build?.joint ?? session.cell?.joint ?? null, session.build === null]),
    ([joint]) => {
      // a frame later, when it is known what the player covers
      clock.onFrame(() => {
        if (joint === null || Math.min(stage.width, 1.5 * stage.height) < SMALL) stage.closeIn(joint);
      });
    },
  );

  const withGhosts = whenWanted(async () => (await import('./marks/ghostArms.js')).createGhostArms);
  addView(
    together((state) => [state.doc.robot, state.session.ghost, nearestShown(state)]),
    ([robot, ghost, nearest]) => {
      const wanted = [ghost, nearest && { posture: nearest, label: options.text.nearest }].filter(
        (one) => one !== null,
      );
      withGhosts(wanted.length > 0, (ghosts) =>
        ghosts.want(wanted.map(({ posture, label }) => ({ q: compilePosture(robot, posture), label }))),
      );
    },
  );
  const withTargets = whenWanted(async () => (await import('./marks/targetFrames.js')).createTargetFrames);
  addView(
    together(({ doc }) => [doc.targets, doc.robot.units, doc.frames]),
    ([targets]) =>
      withTargets(targets.length > 0, (marks) =>
        marks.want(targets.map((target) => ({ id: target.id, T_base_target: targetPose(store.state.doc, target) }))),
      ),
  );

  const withEllipsoid = whenWanted(async () => (await import('./marks/ellipsoidMark.js')).createEllipsoidMark);
  addView(
    ({ session }) => session.tab === 'jacobian' && session.jacobian.ellipsoid,
    (kind) => withEllipsoid(kind !== false && kind !== null, (mark) => mark.want(kind || null)),
  );

  const withUserFrames = whenWanted(async () => (await import('./marks/userFrames.js')).createUserFrames);
  addView(
    together(({ doc, session }) => [
      doc.frames,
      doc.activeUser,
      doc.robot.units,
      shownUserFrames(doc, session).length > 0,
    ]),
    () => {
      const { doc, session } = store.state;
      const frames = shownUserFrames(doc, session).map((frame) => ({
        id: frame.id,
        T_world_frame: compilePose(frame, doc.robot.units),
        isActive: frame.id === doc.activeUser,
      }));
      withUserFrames(frames.length > 0, (marks) => marks.want(frames));
    },
  );

  const withTaught = whenWanted(async () => (await import('./marks/taughtPoints.js')).createTaughtPoints);
  addView(
    ({ session }) => session.taught,
    (taught) => withTaught(taught !== null, (marks) => marks.want(taught)),
  );

  const withLost = whenWanted(async () => {
    const { createLostMark } = await import('./marks/lostMark.js');
    return (tools) => createLostMark({ ...tools, text: options.text.lost });
  });
  addView(lostWanted, (wanted) => withLost(wanted !== null, (marks) => marks.want(wanted)));

  const withTrace = whenWanted(async () => {
    const [{ createTraceMark }, { traceOf }] = await Promise.all([
      import('./marks/traceMark.js'),
      import('../model/jog/trace.js'),
    ]);
    const recorder = traceOf({ store, derived });
    return (tools) => createTraceMark({ ...tools, text: options.text.trace, trace: () => recorder.trace });
  });
  addView(
    ({ session }) => session.trace,
    (trace) => withTrace(trace !== null, (mark) => mark.build()),
  );

  const withBuild = whenWanted(async () => (await import('./marks/buildMarks.js')).createBuildMarks);
  addView(
    ({ session }) => session.build,
    (build) => withBuild(build !== null, (marks) => marks.want(build)),
  );
  return stage;
}

/** @param {Convention} convention @param {BuildUp} build @returns {Wanted | null} */
function dimensionOfBuild(convention, { joint, at }) {
  const now = motionAt(convention, at);
  return now && { joint, field: now.motion.field, share: now.share };
}

/** @param {Session['cell']} cell @returns {Wanted | null} */
const dimensionOfCell = (cell) =>
  cell && isRowField(cell.field) ? { joint: cell.joint, field: cell.field, share: 1 } : null;

/**
 * The joint whose link stands out. A modified row says of the link before it how long and how twisted it is.
 * @param {string} convention
 * @param {Session} session
 */
function litJoint(convention, { pointedCell, cell, heldJoint, pointedLink }) {
  const chosen = pointedCell ?? cell;
  if (!chosen) return heldJoint ?? pointedLink;
  const isBefore = convention === 'modified' && (chosen.field === 'a' || chosen.field === 'alpha');
  return isBefore ? chosen.joint - 1 : chosen.joint;
}

/** The joint whose limits are shown: the one in hand, or the one whose limit is being read. @param {Session} session */
function gaugedJoint({ pointedCell, cell, heldJoint }) {
  const chosen = pointedCell ?? cell;
  return chosen && (chosen.field === 'lower' || chosen.field === 'upper') ? chosen.joint : heldJoint;
}
