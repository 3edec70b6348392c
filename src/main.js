/**
 * The composition root: makes the parts, hands each what it needs, and is the only file that knows both the scene
 * (`render`) and the panels (`ui`).
 *
 * @import { Doc, RobotDoc } from './model/document.js'
 * @import { AppState, Action } from './model/session.js'
 * @import { Store } from './model/store.js'
 * @import { Clearance } from './model/workcell/workcell.js'
 * @import { Page } from './ui/page.js'
 *
 * @typedef {{ doc: Doc | null, show: (page: Page) => void }} Link  what is in the address
 */
import 'bootstrap/dist/css/bootstrap.min.css';
import './ui/css/tokens.css';
import './ui/css/base.css';
import './ui/css/table.css';
import './ui/css/tableHeads.css';
import './ui/css/panels.css';
import './ui/css/poseAndTarget.css';
import './ui/css/view.css';
import './ui/css/tags.css';
import './ui/css/dialogs.css';
import './ui/css/layout.css';
import './ui/css/phone.css';
import './ui/css/tablet.css';
import { version } from '../package.json';
import { SCHEMA, readQueryParameters } from './io/queryParameters.js';
import { createManualClock } from './model/clock.js';
import { createDerived } from './model/derived.js';
import { reduce, startState } from './model/session.js';
import { FIRST_ROBOT, firstRobot, loadRobot } from './model/shelf.js';
import { startDocument } from './model/startDocument.js';
import { createStore } from './model/store.js';
import { fromKernel } from './model/units.js';
import { createViews } from './model/views.js';
import { automaticRadii } from './render/arm/automaticRadii.js';
import { dragWhenNear } from './render/drag/dragWhenNear.js';
import { createRobotView } from './render/robotView.js';
import { createAimPanel } from './ui/aim/aimPanel.js';
import { createAnnouncer } from './ui/announce.js';
import { startAutosave } from './ui/files/autosave.js';
import { createBar } from './ui/bar.js';
import { createBrowserClock, today } from './ui/browserClock.js';
import { createDhTable } from './ui/robot/dhTable.js';
import { watchDropAndPaste } from './ui/files/dropAndPaste.js';
import { showFirstVisit } from './ui/firstVisit.js';
import { createFiles } from './ui/files/files.js';
import { createJogPanel } from './ui/jog/jogPanel.js';
import { lazyPanel } from './ui/parts/lazyPanel.js';
import { createMessages } from './ui/messages.js';
import { createOpener } from './ui/opener.js';
import { createPosePanel } from './ui/pose/posePanel.js';
import { createRobotSections } from './ui/robot/robotSections.js';
import { createScripting } from './ui/scripting.js';
import { createShell, runPanels } from './ui/shell.js';
import { SHORTCUTS, createShortcuts } from './ui/shortcuts.js';
import { createTheme } from './ui/theme.js';
import { createTouchKeys } from './ui/parts/touchKeys.js';
import { createViewPanel } from './ui/view/viewPanel.js';
import { onceLoaded, whenFirst, whenNear } from './ui/parts/whenFirst.js';

const { values: parameters, refused } = readQueryParameters(location.search, SCHEMA);
const manualClock = parameters.clock === 'manual' ? createManualClock() : null;
const clock = manualClock ?? createBrowserClock();
const shell = createShell(parameters.panels);
const messages = createMessages(shell.notices);
const theme = createTheme(parameters.theme);

/** @type {() => void} */
let sayReady = () => {};
const ready = new Promise((/** @type {(value: void) => void} */ resolve) => (sayReady = resolve));
// Scripts find these at once, also where the arm has to be fetched; the rest is there when `ready` says so.
window.denavit = /** @type {Window['denavit']} */ ({ ready, clock: manualClock });

// No top-level await: what is fetched here may import from this very file, and each would wait for the other.
if (location.hash.length < 2) begin();
else {
  import('./ui/files/linked.js').then(
    ({ linkHere }) => begin(linkHere()),
    (error) => {
      messages.fault(error);
      begin();
    },
  );
}

/** @param {Link | null} link */
function begin(link = null) {
  if (link?.doc) {
    stand(link.doc.robot, false, link);
  } else if (parameters.robot === FIRST_ROBOT) {
    const isOther = refused.some(({ name, why }) => name === 'robot' && why === 'not-understood');
    stand(firstRobot, isOther, link);
  } else {
    loadRobot(parameters.robot).then(
      (robot) => stand(robot, false, link),
      (error) => {
        messages.fault(error);
        stand(firstRobot, true, link);
      },
    );
  }
}

/**
 * Puts up the page around its first robot.
 * @param {RobotDoc} robot
 * @param {boolean} isOther  than the one that was asked for
 * @param {Link | null} link  what it holds comes before what the query asks for
 */
function stand(robot, isOther, link) {
  const { units, q, frames, projection } = parameters;
  const trace = parameters.trace === 'on' ? 0 : null;
  const { doc, faults } = link?.doc ? { doc: link.doc, faults: [] } : startDocument(robot, { units, q, isOther });
  /** @type {Store<AppState, Action>} */
  const store = createStore(startState(doc), reduce);
  store.dispatch({ type: 'show', change: { frames, projection, trace } });
  const derived = createDerived();
  const addView = createViews(store, clock, { onError: messages.fault });
  const camera = {
    where: (/** @type {{ isChosen?: boolean } | undefined} */ only) => stage?.camera(only) ?? null,
    goTo: (/** @type {readonly number[]} */ there) => stage?.goTo(there),
  };
  const announce = createAnnouncer();
  const page = { store, addView, derived, clock, announce, messages, opener: createOpener(store), camera };

  if (refused.length + faults.length > 0) {
    // Words for what the address got wrong are fetched when it did.
    import('./ui/parameterWarnings.js').then((words) => words.warnOfParameters(page, refused, faults), messages.fault);
  }
  const files = createFiles(page);
  const openHelp = async () => {
    const { showHelp } = await import('./ui/help.js'); // messages.js says it when that fails
    showHelp({ version, shortcuts: SHORTCUTS });
  };
  createBar(page, shell.bar, { files, theme, openHelp });
  runPanels(page, shell);
  createDhTable(page, shell.tabs.robot);
  const cells = onceLoaded(async () =>
    (await import('./model/workcell/workcell.js')).createWorkcells(derived, automaticRadii),
  );
  createRobotSections(page, shell.tabs.robot, {
    automaticRadii: ({ units }) =>
      automaticRadii(derived.chain(store.state.doc)).map((radius) => fromKernel('length', radius, units)),
    cells,
  });
  lazyPanel(
    page,
    shell.tabs.program,
    ({ tab }) => tab === 'program',
    async () => {
      const { createProgramPanel } = await import('./ui/program/programPanel.js');
      return (host) => createProgramPanel(page, host, files, cells);
    },
  );
  lazyPanel(
    page,
    shell.tabs.code,
    ({ tab }) => tab === 'code',
    async () => {
      const { createCodePanel } = await import('./ui/code/codePanel.js');
      return (host) => createCodePanel(page, host, { version, today });
    },
  );
  const mapping = onceLoaded(async () => {
    const [{ createMapping }, { createSceneLine }, { createWorkspaceView }, panel] = await Promise.all([
      import('./ui/workspace/mapping.js'),
      import('./ui/workspace/sceneLine.js'),
      import('./render/workspaceView.js'),
      import('./ui/workspace/workspacePanel.js'),
    ]);
    createMapping(page);
    if (stage) {
      createWorkspaceView(page, stage);
      createSceneLine(page, shell.view);
    }
    return panel;
  });
  whenNear(shell.app, '[data-opens=workspace]', mapping);
  lazyPanel(
    page,
    shell.tabs.workspace,
    ({ tab }) => tab === 'workspace',
    async () => {
      const { createWorkspacePanel } = await mapping();
      return (host) => createWorkspacePanel(page, host);
    },
  );
  lazyPanel(
    page,
    shell.tabs.jacobian,
    ({ tab }) => tab === 'jacobian',
    async () => {
      const { createJacobianPanel } = await import('./ui/jacobian/jacobianPanel.js');
      return (host) => createJacobianPanel(page, host);
    },
  );
  whenFirst(
    page,
    ({ session }) => session.workspace !== null,
    async () => void (await mapping()),
  );
  whenFirst(
    page,
    ({ doc }) => doc.motionPrograms.length > 0 && shell.has('program'),
    async () => {
      const [{ createTimeline }, { createProgramView }] = await Promise.all([
        import('./ui/program/timeline.js'),
        import('./render/programView.js'),
      ]);
      const { text } = createTimeline(page, shell.time, shell.view, cells);
      if (stage) createProgramView(page, stage, text);
    },
  );
  createJogPanel(page, shell.jog);
  const pose = createPosePanel(page, shell.pose);
  createAimPanel(page, shell.aim);
  createShortcuts(page, { files, openHelp });
  watchDropAndPaste(page, files);
  createTouchKeys(page, shell.app);
  const calm = matchMedia('(prefers-reduced-motion: reduce)');
  const isCalm = () => calm.matches;
  const wide = matchMedia('(min-width: 700px)');
  const isWide = () => wide.matches;
  const view = createViewPanel(page, shell.view, { isCalm, isWide, poseInWords: pose.inWords });

  const stage = createRobotView(page, {
    host: view.stageHost,
    quality: parameters.quality,
    firstLook: parameters.view === 'iso' ? 'home' : parameters.view,
    text: view.text,
    isCalm,
    freePart: view.freePart,
    onGridStep: view.showGridStep,
    onDraw: view.showViewpoint,
    onLook: view.look,
    onError: messages.fault,
  });
  if (stage) {
    view.surround(stage);
    files.offerPicture(stage.picture);
    theme.onChange(stage.setTheme);
    const userFrame = () => derived.user(store.state.doc);
    const { missing } = view.text;
    whenFirst(
      page,
      ({ doc, session }) => doc.obstacles.length > 0 || session.workcell.isOpen || session.workcell.hasCapsules,
      async () => {
        const [{ createWorkcellView }, { createObstacleDrag }, { nearestLabel }] = await Promise.all([
          import('./render/workcellView.js'),
          import('./render/drag/obstacleDrag.js'),
          import('./ui/workcell/closenessText.js'),
        ]);
        const text = (/** @type {Clearance} */ near) => nearestLabel(near, store.state.doc.robot.units);
        const { obstacleAt } = createWorkcellView(page, stage, { cells: await cells(), text });
        createObstacleDrag(page, { stage, room: shell.view, missing, obstacleAt });
      },
    );
    whenFirst(
      page,
      ({ session }) => session.code.path !== null,
      async () => (await import('./render/codeView.js')).createCodeView(page, stage),
    );
    dragWhenNear(page, { stage, room: shell.view, isWide, missing, userFrame, onError: messages.fault });
  } else {
    view.sayWhyEmpty();
  }

  if (!parameters.panels && parameters.hint === 'on' && !manualClock) showFirstVisit(shell.view);
  link?.show(page);
  addEventListener('hashchange', async () => (await import('./ui/files/linked.js')).followLink(page));
  const visit = Math.random().toString(36).slice(2);
  if (parameters.autosave === 'on') startAutosave(page, { visit, today, ready });
  clock.onFrame(() => clock.onFrame(sayReady));
  Object.assign(window.denavit, createScripting(page, { ready, clock: manualClock }));
}
