/**
 * All text of the page, as whole sentences with named blanks; nothing else in `ui` holds words. Numbers arrive already
 * formatted (format.js). Each part of the page has a file in `words/`; a part that is fetched when it is opened takes its
 * words from there itself, so that the first load does not bring them.
 */
import { AIM, VERDICT } from './words/aim.js';
import { BAR } from './words/bar.js';
import { DRAG } from './words/drag.js';
import { FILES } from './words/files.js';
import { FIRST_VISIT } from './words/firstVisit.js';
import { NUMBER } from './words/input.js';
import { JOG } from './words/jog.js';
import { POSE } from './words/pose.js';
import { ROBOT } from './words/robot.js';
import { STRUCTURE } from './words/structure.js';
import { TABLE, DEFINITION } from './words/table.js';
import { PANELS, VIEW } from './words/view.js';

export const TEXT = {
  product: 'Denavit',
  unnamedRobot: 'Robot without a name',
  title: (/** @type {string} */ robot) => `${robot} · Denavit`,
  close: 'Close',
  fault: (/** @type {string} */ message) => `Something broke here: ${message} The rest of the page goes on working.`,
  fetching: 'One moment…',
  notFetched: 'This part of the page could not be fetched',
  notFetchedDetail:
    'Everything else goes on working. Look whether the connection stands; if it does, save the robot and load the page again.',
  notFetchedNow: 'A part of the page could not be fetched. Look whether the connection stands, then try again.',
  tryAgain: 'Try again',
  openWhole: 'Open in Denavit',
  noWebGl:
    'This browser shows no 3-D graphics (WebGL is off or missing), so the arm cannot be drawn. The table, the joints and the poses go on working.',

  aim: AIM,
  bar: BAR,
  definition: DEFINITION,
  drag: DRAG,
  files: FILES,
  firstVisit: FIRST_VISIT,
  jog: JOG,
  number: NUMBER,
  panels: PANELS,
  pose: POSE,
  robot: ROBOT,
  structure: STRUCTURE,
  table: TABLE,
  verdict: VERDICT,
  view: VIEW,
};
