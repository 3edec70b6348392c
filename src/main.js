/**
 * The composition root: makes the parts, hands each what it needs, and is the only file that knows both the scene
 * (`render`) and the panels (`ui`).
 *
 * @import { RobotDoc } from './model/document.js'
 * @import { AppState, Action } from './model/session.js'
 * @import { Store } from './model/store.js'
 */
import 'bootstrap/dist/css/bootstrap.min.css';
import './ui/css/tokens.css';
import './ui/css/base.css';
import './ui/css/table.css';
import './ui/css/panels.css';
import './ui/css/view.css';
import './ui/css/dialogs.css';
import './ui/css/layout.css';
import { version } from '../package.json';
import { SCHEMA, readQueryParameters } from './io/queryParameters.js';
import { createManualClock } from './model/clock.js';
import { isAtAnswer, poseFromXyzwpr } from './model/aim.js';
import { compileLinkStyles } from './model/compile.js';
import { createDerived } from './model/derived.js';
import { memo } from './model/memo.js';
import { newDocument } from './model/newDocument.js';
import { reduce, startState } from './model/session.js';
import { FIRST_ROBOT, firstRobot, loadRobot } from './model/shelf.js';
import { createStore } from './model/store.js';
import { createViews, together } from './model/views.js';
import { createStage } from './render/stage.js';
import { createAimPanel } from './ui/aimPanel.js';
import { createAnnouncer } from './ui/announce.js';
import { createBar } from './ui/bar.js';
import { createBrowserClock, today } from './ui/browserClock.js';
import { createDhTable } from './ui/dhTable.js';
import { createFiles } from './ui/files.js';
import { createJogPanel } from './ui/jogPanel.js';
import { lazyPanel } from './ui/lazyPanel.js';
import { createMessages } from './ui/messages.js';
import { createOpener } from './ui/opener.js';
import { createPosePanel } from './ui/posePanel.js';
import { createScripting } from './ui/scripting.js';
import { createShell, runPanels } from './ui/shell.js';
import { createShortcuts } from './ui/shortcuts.js';
import { TEXT } from './ui/strings.js';
import { createTheme } from './ui/theme.js';
import { createViewPanel } from './ui/viewPanel.js';

/** An arm with a reach this much larger or smaller (as a logarithm: half as much again) is another one to the eye. */
const OTHER_SIZE = Math.log(1.5);

const { values: parameters, refused } = readQueryParameters(location.search, SCHEMA);
const manualClock = parameters.clock === 'manual' ? createManualClock() : null;
const clock = manualClock ?? createBrowserClock();
const shell = createShell();
const messages = createMessages(shell.notices);
const theme = createTheme(parameters.theme);
for (const { name, text, initial } of refused) {
  messages.warn(initial === null ? TEXT.parameter.unknown(name) : TEXT.parameter.notUnderstood(name, text, initial));
}

/** @type {() => void} */
let sayReady = () => {};
const ready = new Promise((/** @type {(value: void) => void} */ resolve) => (sayReady = resolve));
// Scripts find these at once, also where the arm has to be fetched; the rest is there when `ready` says so.
window.denavit = /** @type {Window['denavit']} */ ({ ready, clock: manualClock });

// No top-level await: what is fetched here may import from this very file, and each would wait for the other.
if (parameters.robot === FIRST_ROBOT) stand(firstRobot);
else {
  const fetched = loadRobot(parameters.robot).catch((error) => {
    messages.fault(error);
    return firstRobot;
  });
  fetched.then(stand);
}

/** Puts up the page around its first robot. @param {RobotDoc} robot */
function stand(robot) {
  /** @type {Store<AppState, Action>} */
  const store = createStore(startState(newDocument(robot)), reduce);
  const derived = createDerived();
  const addView = createViews(store, clock, { onError: messages.fault });
  const page = { store, addView, derived, clock, announce: createAnnouncer(), messages, opener: createOpener(store) };

  const files = createFiles(page);
  createBar(page, shell.bar, { files, theme });
  runPanels(page, shell);
  createDhTable(page, shell.tabs.robot);
  lazyPanel(
    page,
    shell.tabs.program,
    ({ tab }) => tab === 'program',
    async () => {
      const { createProgramPanel } = await import('./ui/programPanel.js');
      return (host) => createProgramPanel(page, host);
    },
  );
  lazyPanel(
    page,
    shell.tabs.code,
    ({ tab }) => tab === 'code',
    async () => {
      const { createCodePanel } = await import('./ui/codePanel.js');
      return (host) => createCodePanel(page, host, { version, today });
    },
  );
  createJogPanel(page, shell.jog);
  const pose = createPosePanel(page, shell.pose);
  createAimPanel(page, shell.aim);
  createShortcuts(page, files);
  const view = createViewPanel(page, shell.view, { poseInWords: pose.inWords });

  const stage = createStage({
    host: view.stageHost,
    clock,
    quality: parameters.quality,
    text: view.text,
    onGridStep: view.showGridStep,
    onError: messages.fault,
  });
  if (stage) {
    const linkStyles = memo(compileLinkStyles);
    view.surround(stage.canvas, () => stage.fit());
    theme.onChange(stage.setTheme);
    let shown = { edition: 0, name: '', reach: 0 };
    addView(
      together(({ doc, session }) => [doc.robot, doc.posture, session.edition]),
      ([robot, , edition]) => {
        const chain = derived.chain(store.state.doc);
        stage.showArm(chain, linkStyles(robot));
        stage.showPosture(derived.posture(store.state.doc));
        // Another arm is brought into the picture; one whose table is edited stays where the person looks at it.
        const isOther = robot.name !== shown.name || Math.abs(Math.log(chain.reach / shown.reach)) > OTHER_SIZE;
        if (edition !== shown.edition && isOther) stage.fit();
        shown = { edition, name: robot.name, reach: chain.reach };
      },
    );
    addView(({ session }) => session.cell?.joint ?? session.heldJoint, stage.highlightJoint);
    addView(({ session }) => session.heldJoint, stage.holdJoint);
    addView(
      together(({ doc, session }) => [doc.robot, session.target, doc.posture, session.answer]),
      ([robot, target, posture, answer]) => {
        // What is missing is drawn where the arm has gone as near as it can, not where it merely stands.
        const isAtNearest = answer !== null && !answer.isMet && isAtAnswer(answer, posture);
        stage.showTarget(target && poseFromXyzwpr(robot, target), { reached: !isAtNearest });
      },
    );
  } else {
    view.sayWhyEmpty();
  }

  clock.onFrame(() => clock.onFrame(sayReady));
  Object.assign(window.denavit, createScripting(page, { ready, clock: manualClock }));
}
