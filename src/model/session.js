/**
 * The state of the page: the history of documents, which is saved and undone, and the session, which is neither
 * (what is selected, held, open or aimed at).
 *
 * @import { Doc, JointField } from './document.js'
 * @import { Command } from './commands.js'
 * @import { History } from './history.js'
 * @import { AimAnswer } from './aim/aim.js'
 * @import { Hindrance } from './aim/follow.js'
 * @import { Handle } from './aim/handleAxes.js'
 * @import { JacobianView } from './numbers/jacobianView.js'
 * @import { JogStop } from './jog/jog.js'
 * @import { JogChoices } from './jog/jogChoices.js'
 * @import { NumbersView } from './numbers/numbersView.js'
 * @import { CodeScene } from './code/codeScene.js'
 * @import { Planning } from './program/planned.js'
 * @import { Playback } from './program/player.js'
 * @import { Recording } from './program/recording.js'
 * @import { Taught } from './frames/threePoints.js'
 * @import { ToolKeeps } from './frames/toolChange.js'
 * @import { ProgramCheck } from './workcell/checked.js'
 * @import { WorkcellView } from './workcell/workcellView.js'
 * @import { Probes, ReachHand } from './workspace/asked.js'
 * @import { WorkspaceMaps } from './workspace/mapped.js'
 * @import { WorkspaceView } from './workspace/workspaceView.js'
 *
 * @typedef {'robot' | 'program' | 'code' | 'workspace' | 'jacobian'} Tab
 * @typedef {Tab | 'jog' | 'aim'} Panel
 *
 * @typedef {'none' | 'ends' | 'row' | 'all'} FramesShown  ends: base and tool; row: the two of the selected row
 * @typedef {{ readonly joint: number, readonly at: number, readonly goal: number }} BuildUp
 *   0 … 4: of the row's motions so many are done, the last perhaps in part, and so many are wanted
 *
 * @typedef {object} ToolDrag
 * @property {Float64Array | null} T_world_goal  where the tool is wanted; null while a link is dragged
 * @property {Hindrance | null} hindrance
 * @property {boolean} isHeld   the hand is still on it
 *
 * @typedef {JogStop & { readonly posture: readonly number[] }} JogEnd
 * @typedef {{ readonly hindrance: Hindrance, readonly posture: readonly number[] }} DragEnd
 *
 * @typedef {object} Session
 * @property {Panel} panel      the one that is open, where the screen has room for one only
 * @property {Tab} tab          the one that is open on the left, where there is room for both sides
 * @property {{ readonly joint: number, readonly field: JointField } | null} cell  of the DH table, being edited
 * @property {{ readonly joint: number, readonly field: JointField } | null} pointedCell  likewise, under the pointer
 * @property {number | null} heldJoint  the joint whose slider is in the hand
 * @property {number | null} openJoint  the joint whose limits, home and link are open below the table
 * @property {readonly number[] | null} target  X Y Z W P R in document units; null while it follows the tool
 * @property {string} targetForm  how it is written: the id of one of ORIENTATION_FORMS, or "matrix"
 * @property {'world' | 'user'} targetFrom  what its numbers are seen from; user: the active user frame
 * @property {AimAnswer | null} answer  what inverse kinematics said to the target
 * @property {{ readonly posture: readonly number[], readonly label: string } | null} ghost  where the arm would stand: a solution being looked at
 * @property {FramesShown} frames   of the scene; this and the next stay when another document is opened
 * @property {'perspective' | 'parallel'} projection
 * @property {number | null} trace  of the tool, drawn: counts how often it was begun anew (trace.js); it stays likewise
 * @property {BuildUp | null} build  how a row of the table makes a frame from the one before, being shown
 * @property {Handle} handle    on the tool, to drag it by; it stays when another document is opened
 * @property {'move' | 'turn' | null} toolKeys  what arrow keys in the view do to the tool, once it is taken
 * @property {ToolDrag | null} drag  of the tool, under way
 * @property {DragEnd | null} dragEnd  what the last drag stopped at, for as long as the arm stands where that left it
 * @property {JogEnd | null} jogEnd  what the pendant stopped at, for as long as the arm stands there
 * @property {number | null} pointedLink  the joint that moves the link under the pointer
 * @property {JogChoices} jog  how the arm is jogged
 * @property {JacobianView} jacobian  which one is shown, and how
 * @property {Taught | null} taught  the points of a user frame that is being taught
 * @property {ToolKeeps} toolKeeps  what stays where it is when another tool is chosen
 * @property {NumbersView} numbers  how they are shown and copied
 * @property {Playback | null} playback  of a motion program; null: none has been played or looked at
 * @property {string | null} step   the id of the step that is chosen, of the motion program that is shown
 * @property {{ from: string, to: string } | null} stepRange  ids of the ends of steps that are chosen together (program/stepRange.js)
 * @property {Recording} recording  what "Record here" makes of the posture
 * @property {Planning | null} planning  the program in time, or on its way there
 * @property {WorkcellView} workcell  how obstacles and clearances are looked at
 * @property {ProgramCheck | null} check  whether the program keeps clear of obstacles, or on its way there
 * @property {WorkspaceView | null} workspace  what is asked of the workspace; null until somebody asks. It stays likewise
 * @property {CodeScene} code   of the program of a controller that is open: what the scene shows of it, and is asked there
 * @property {WorkspaceMaps} maps    what is known of the workspace so far
 * @property {Probes} probes  places that were asked for, and traces of single joints
 * @property {ReachHand} reachHand  what a press in the scene does to them
 * @property {number} edition   counts how often the document was exchanged for another (opened, undone), not edited
 *
 * @typedef {History & { readonly session: Session }} AppState
 *
 * Commands with the same gesture, one after the other, are one undo step, and each replaces the one before.
 *
 * @typedef {(Command & { gesture?: string })
 *   | { type: 'undo' } | { type: 'redo' } | { type: 'end-gesture' } | { type: 'cancel-gesture' }
 *   | { type: 'stand', posture: readonly number[] }
 *   | { type: 'show', change: Partial<Session> }} Action  stand: the arm is put there by playing a program, which is no step to undo
 */
import { applyCommand } from './commands.js';
import { deepFreeze } from './freeze.js';
import { FIRST_JACOBIAN } from './numbers/jacobianView.js';
import { FIRST_JOG } from './jog/jogChoices.js';
import { refusal } from './refusals.js';
import { NO_CODE } from './code/codeScene.js';
import { FIRST_HANDLE } from './aim/handleAxes.js';
import { fitUserFrame } from './frames/userAxes.js';
import { FIRST_NUMBERS, fitNumbers } from './numbers/numbersView.js';
import { FIRST_RECORDING } from './program/recording.js';
import { NO_HAND, NO_PROBES } from './workspace/asked.js';
import { NO_MAPS } from './workspace/mapped.js';
import { FIRST_WORKCELL, withoutObstacles } from './workcell/workcellView.js';
import { cancelGesture, endGesture, record, redo, stand, startHistory, undo } from './history.js';

/** @type {Session} */
const FRESH = {
  panel: 'jog',
  tab: 'robot',
  cell: null,
  pointedCell: null,
  heldJoint: null,
  openJoint: null,
  target: null,
  targetForm: 'wpr',
  targetFrom: 'world',
  answer: null,
  ghost: null,
  frames: 'ends',
  projection: 'perspective',
  trace: null,
  build: null,
  handle: FIRST_HANDLE,
  toolKeys: null,
  drag: null,
  dragEnd: null,
  jogEnd: null,
  pointedLink: null,
  jog: FIRST_JOG,
  jacobian: FIRST_JACOBIAN,
  taught: null,
  toolKeeps: 'flange',
  numbers: FIRST_NUMBERS,
  playback: null,
  step: null,
  stepRange: null,
  recording: FIRST_RECORDING,
  planning: null,
  workcell: FIRST_WORKCELL,
  check: null,
  workspace: null,
  code: NO_CODE,
  maps: NO_MAPS,
  probes: NO_PROBES,
  reachHand: NO_HAND,
  edition: 0,
};

/** @param {Doc} doc @returns {AppState} */
export const startState = (doc) => ({ ...startHistory(deepFreeze(doc)), session: FRESH });

/**
 * @param {AppState} state
 * @param {Action} action
 * @returns {AppState} the same object when nothing changed
 * @throws {RangeError} when a command is refused (see refusals.js)
 */
export function reduce(state, action) {
  const { session, ...history } = state;
  switch (action.type) {
    case 'undo':
      return exchanged(settle(state, history, undo(history)), state);
    case 'redo':
      return exchanged(settle(state, history, redo(history)), state);
    case 'end-gesture':
      return settle(state, history, endGesture(history));
    case 'cancel-gesture':
      return settle(state, history, cancelGesture(history));
    case 'stand': {
      const { posture } = action;
      return settle(state, history, stand(history, carryOut(state.doc, { type: 'set-posture', posture })));
    }
    case 'show': {
      const keys = /** @type {(keyof Session)[]} */ (Object.keys(action.change));
      if (keys.every((key) => Object.is(session[key], action.change[key]))) return state;
      return { ...state, session: { ...session, ...action.change } };
    }
    case 'replace-document':
      return unplayed(exchanged(settle(state, history, record(history, carryOut(state.doc, action))), state), state);
    default:
      return settle(state, history, record(history, carryOut(groundOf(state, action.gesture), action), action.gesture));
  }
}

/**
 * A session speaks of a document's joints in a document's units; what no longer makes sense is let go.
 * @param {AppState} state
 * @param {History} history
 * @param {History} next  `history` itself when nothing changed
 * @returns {AppState}
 */
function settle(state, history, next) {
  if (next === history) return state;
  const session = fitUserFrame(state.session, next.doc);
  const { robot } = next.doc;
  const old = history.doc.robot;
  if (robot === old) return { ...next, session };
  const isOther = robot.name !== old.name && robot.joints !== old.joints; // a new name alone makes no other robot
  const sameShape = robot.joints.length === old.joints.length && robot.units === old.units && !isOther;
  const { panel, tab, edition, frames, projection, trace, handle, jog, jacobian, toolKeeps } = session;
  const { targetForm, targetFrom, workcell, workspace } = session;
  const openJoint = session.openJoint === null ? null : Math.min(session.openJoint, robot.joints.length - 1);
  const numbers = fitNumbers(session.numbers, robot);
  const kept = {
    panel,
    tab,
    edition,
    frames,
    projection,
    trace,
    handle,
    jog,
    jacobian,
    targetForm,
    targetFrom,
    toolKeeps,
    workcell,
    workspace,
  };
  return {
    ...next,
    session: sameShape ? { ...session, answer: null, ghost: null } : { ...FRESH, ...kept, openJoint, numbers },
  };
}

/** Another document's programs have been played by nobody, and its obstacles are others. @param {AppState} state @param {AppState} before @returns {AppState} */
const unplayed = (state, before) => {
  if (state === before) return before;
  const workcell = withoutObstacles(state.session.workcell);
  return { ...state, session: { ...state.session, playback: null, planning: null, check: null, workcell } };
};

/** @param {AppState} state @param {AppState} before @returns {AppState} */
function exchanged(state, before) {
  if (state === before) return before;
  return { ...state, session: { ...state.session, edition: before.session.edition + 1 } };
}

/**
 * What a command is applied to: each of a gesture replaces the one before, so all of them apply to the document that the
 * gesture began with. A drag that ends where it began has then changed nothing.
 * @param {AppState} state
 * @param {string} [gesture]
 */
const groundOf = (state, gesture) =>
  gesture !== undefined && gesture === state.gesture?.id ? state.gesture.doc : state.doc;

/**
 * @param {Doc} doc
 * @param {Command} command
 * @returns {Doc} frozen
 * @throws {RangeError} with the reason, when there is one against it
 */
function carryOut(doc, command) {
  const reason = refusal(doc, command);
  if (reason) throw new RangeError(reason.message);
  return deepFreeze(applyCommand(doc, command));
}
