/**
 * The composition root: hands clock, storage and chance to everything, and is the only file that knows both the scene
 * (`render`) and the panels (`ui`).
 *
 * @import { Doc } from './model/document.js'
 * @import { AppState, Action } from './model/session.js'
 */
import 'bootstrap/dist/css/bootstrap.min.css';
import './ui/css/tokens.css';
import './ui/css/look.css';
import './ui/css/layout.css';
import { version } from '../package.json';
import { SCHEMA, readQueryParameters } from './io/queryParameters.js';
import { createManualClock } from './model/clock.js';
import { createDerived } from './model/derived.js';
import { LIBRARY, newDocument } from './model/library.js';
import { reduce, startState } from './model/session.js';
import { createStore } from './model/store.js';
import { createViews } from './model/views.js';
import { createAimPanel } from './ui/aimPanel.js';
import { createAnnouncer } from './ui/announce.js';
import { createBar } from './ui/bar.js';
import { createBrowserClock } from './ui/browserClock.js';
import { createCodePanel } from './ui/codePanel.js';
import { createDhTable } from './ui/dhTable.js';
import { createFiles } from './ui/files.js';
import { createJogPanel } from './ui/jogPanel.js';
import { createMessages } from './ui/messages.js';
import { createPosePanel } from './ui/posePanel.js';
import { createProgramPanel } from './ui/programPanel.js';
import { createScripting } from './ui/scripting.js';
import { createShell, runPanels } from './ui/shell.js';
import { createShortcuts } from './ui/shortcuts.js';
import { TEXT } from './ui/strings.js';
import { createTheme } from './ui/theme.js';
import { createViewPanel } from './ui/viewPanel.js';

const { values: parameters, refused } = readQueryParameters(location.search, SCHEMA);
const clock = parameters.clock === 'manual' ? createManualClock() : createBrowserClock();
const shell = createShell();
const messages = createMessages(shell.notices);
for (const { name, text, initial } of refused) {
  messages.warn(initial === null ? TEXT.parameter.unknown(name) : TEXT.parameter.notUnderstood(name, text, initial));
}

/** @type {import('./model/store.js').Store<AppState, Action>} */
const store = createStore(startState(newDocument(LIBRARY[parameters.robot])), reduce);
const derived = createDerived();
const addView = createViews(store, clock, { onError: messages.fault });
const page = { store, addView, derived, clock, announce: createAnnouncer(), messages };

const theme = createTheme(parameters.theme, () => view?.setTheme());
const files = createFiles(page);
createBar(page, shell.bar, { files, theme });
runPanels(page, shell);
createDhTable(page, shell.tabs.robot);
createProgramPanel(page, shell.tabs.program);
createCodePanel(page, shell.tabs.code, { version, today: () => new Date() });
createJogPanel(page, shell.jog);
const pose = createPosePanel(page, shell.pose);
createAimPanel(page, shell.aim);
createShortcuts(page, files);
const view = createViewPanel(page, shell.view, { poseInWords: pose.inWords });

/** @type {Promise<void>} */
const ready = new Promise((resolve) => clock.onFrame(() => resolve()));
Object.assign(window, { denavit: createScripting(page, ready) });
