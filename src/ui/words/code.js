/** Controller code: files, the editor, running it. */

/** Where a new program takes the tool, and what the place is called. */
const wayOf = { x: 'along x', y: 'along y', z: 'up' };
const placeAt = { x: 'aside', y: 'aside', z: 'above' };

export const CODE = {
  empty: 'No code yet',
  ways: {
    own: { title: 'Write it', detail: 'KAREL or TP, checked while you type, run on this arm.' },
    written: { title: 'Have it written', detail: 'For FANUC and KUKA, from postures of the arm or a motion program.' },
  },
  record: 'Record this posture',
  recorded: (/** @type {number} */ count) =>
    count === 0
      ? 'Two postures are enough: record one, move the arm, record the next.'
      : 'One posture is recorded. Move the arm, and record the next.',
  toProgram: 'To motion programs',
  files: 'Files',
  copy: 'Copy this file',
  copied: (/** @type {string} */ name) => `${name} is copied.`,
  text: (/** @type {string} */ name) => `Text of ${name}`,
  more: 'Files: new, open, rename, remove',
  newKarel: 'New KAREL program',
  newKarelDetail: 'It can be checked and run here',
  newTp: 'New TP program',
  newKrl: 'New KRL program',
  newTpDetail: 'It can be checked and run here, and called by KAREL',
  krlDetail: 'It is read as far as this page writes it',
  openFile: 'Open a file…',
  openDetail: '.kl, .ls, .src, .dat, or headers as .klh; it becomes part of the model',
  rename: (/** @type {string} */ name) => `Rename ${name}…`,
  remove: (/** @type {string} */ name) => `Remove ${name}`,
  removed: (/** @type {string} */ name) => `${name} is removed; undo brings it back.`,
  added: (/** @type {string} */ name) => `${name} is added.`,
  nameLabel: 'Name of the program',
  keepName: 'Rename',
  tooLarge: (/** @type {string} */ name) => `${name} is larger than 1 MB. Expected the text of a program.`,
  notText: (/** @type {string} */ name) => `${name} is no text. Expected a program in KAREL, TP (.ls) or KRL.`,
  breakpoint: 'Breakpoint',
  nextLine: 'Next line',
  stopSet: (/** @type {number} */ line) => `Breakpoint at line ${line}`,
  stopCleared: (/** @type {number} */ line) => `No breakpoint at line ${line}`,

  controls: 'Run the program',
  run: 'Run',
  pause: 'Pause',
  stop: 'Stop',
  into: 'Step into',
  over: 'Step over',
  out: 'Step out',
  back: 'Step back',
  status: {
    ready: 'Ready',
    running: (/** @type {number} */ line) => `Running line ${line}`,
    moving: (/** @type {number} */ line) => `The arm moves by line ${line}`,
    held: (/** @type {number} */ line) => `The arm is held on its way by line ${line}, until UNHOLD`,
    halted: (/** @type {number} */ line) => `The motion of line ${line} is stopped, until RESUME`,
    waiting: (/** @type {number} */ line) => `Line ${line} waits`,
    paused: (/** @type {number} */ line) => `Stopped before line ${line}`,
    asks: (/** @type {number} */ line) => `Line ${line} reads a line`,
    ended: 'The program has ended',
    aborted: 'The program ended by ABORT',
    stopped: 'Stopped',
    budget: 'Ended after 50 million statements: it may never end by itself',
    alarm: (/** @type {number} */ line, /** @type {string} */ reason) => `Line ${line}: ${reason}`,
    noMove: (/** @type {number} */ line, /** @type {string} */ reason) =>
      `Line ${line}, the arm does not move: ${reason}`,
    moved: 'Stopped: the arm was moved by someone else',
    noProgram: 'No PROGRAM here: run the one that includes this text',
    faulty: (/** @type {number} */ count) =>
      count === 1 ? 'One error is in the way; it is marked.' : `${count} errors are in the way; they are marked.`,
  },
  refused: {
    singularity: 'the line passes a singular posture',
    limit: 'a joint would pass its limit',
    orientation: 'the tool cannot turn so on the way',
    start: 'the way does not begin where the arm is',
    reach: 'the way leaves the reach of the arm',
    arc: 'no circle passes the three points',
  },
  checking: 'Looking for errors…',
  noProblems: 'No errors found',
  problems: (/** @type {number} */ errors, /** @type {number} */ warnings) =>
    [
      errors > 0 && `${errors} ${errors === 1 ? 'error' : 'errors'}`,
      warnings > 0 && `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}`,
    ]
      .filter(Boolean)
      .join(', '),
  goToProblem: 'Go to the next one',
  line: (/** @type {number} */ line) => `Line ${line}`,
  tpCall: 'Write as TP call',
  noTpCall: (/** @type {string} */ reason) => `It cannot be written as a TP call. ${reason}`,
  tpCalls: (/** @type {string} */ names) => `Each MOVE calls TP now: ${names}. Undo brings them back.`,
  severity: { error: 'Error', warning: 'Warning' },
  noProblemsKrl: 'No errors found; KRL is read here as far as this page writes it',
  format: 'Format',
  formatted: 'The lines are in order; undo brings them back.',
  inOrder: 'The lines are in order already.',
  ghost: (/** @type {number} */ line) => `line ${line}`,
  leadsNowhere: (/** @type {string} */ reason) => `Run from where the arm stands, it stops here: ${reason}`,

  shown: 'What the program knows',
  parts: { variables: 'Variables', registers: 'Registers', output: 'Output' },
  variable: { name: 'Name', type: 'Type', value: 'Value' },
  watch: 'Watch an expression',
  addWatch: 'Watch',
  unwatch: (/** @type {string} */ text) => `Watch ${text} no longer`,
  noRegisters: 'No register has a value yet.',
  noRegistersKrl: 'KRL has no registers.',
  otherRegister: 'Another register: R[5], PR[12]',
  showRegister: 'Show',
  noSuchRegister: (/** @type {string} */ got) =>
    `Expected a register such as R[5] or PR[12], numbered from 1 to 2000; got “${got}”.`,
  unset: 'none',
  stack: 'Where it is',
  signals: 'Signals',
  input: (/** @type {string} */ name) => `${name}, an input: set it`,
  on: 'ON',
  off: 'OFF',
  noOutput: 'Nothing is written yet.',
  answer: 'A line for the program to read',
  send: 'Send',
  called: (/** @type {string} */ name) => `CALL ${name}: no program of this model; passed over.`,
  runs: (/** @type {string} */ name) => `RUN ${name}: no program of this model; passed over.`,
  runsAlready: (/** @type {string} */ name) => `RUN ${name}: it runs already; passed over.`,
  skipped: (/** @type {number} */ line, /** @type {string} */ text) =>
    `Line ${line}, "${text}": not known here; passed over.`,
  noFrame: (/** @type {string} */ frame) =>
    `${frame} is not among the frames of this model: taken as one that changes nothing.`,
  effect: (/** @type {string} */ what) => `${what}: has no effect on the simulated arm.`,
  date: 'GET_TIME: the simulated clock begins at 0:00 on 1 January 2000.',
  noEffect: (/** @type {string} */ what) => `${what} is taken to succeed; nothing is done.`,
  posted: (/** @type {string} */ message) => `POST_ERR: ${message}`,
  taskAlarm: (/** @type {string} */ task, /** @type {string} */ reason) => `Task ${task} ended: ${reason}`,
  simulated: 'Simulated; no controller has judged this',
  limits:
    'Every motion stops at its end; joint moves of KAREL go at $SPEED / $SPEEDLIMJNT of the full rates, which is not verified; one that is cancelled, stopped, held or skipped comes to rest on its way within 0.1 s, which is not how a controller brakes. Frame 0 is on axis 1, at the height of axis 2; where axis 1 slides, it is the base.',
  /** How far and where the tool goes in a new program, mm. */
  newWay: 50,
  /** @param {string} name @param {'x' | 'y' | 'z'} axis  that it goes along @param {string} mover  the TP program that it calls */
  template: (name, axis, mover) => `PROGRAM ${name}
-- Move the tool 50 mm ${wayOf[axis]} from where it is, and back:
-- KAREL fills PR[1], and calls a TP program to move there.
%ENVIRONMENT REGOPE
%NOLOCKGROUP
VAR
  here, ${placeAt[axis]} : XYZWPR
  status : INTEGER
ROUTINE ${mover} FROM ${mover}
BEGIN
  $GROUP[1].$UFRAME = $MOR_GRP[1].$NILPOS
  $GROUP[1].$UTOOL = $MOR_GRP[1].$NILPOS
  here = CURPOS(0, 0)
  ${placeAt[axis]} = here
  ${placeAt[axis]}.${axis} = here.${axis} + 50.0
  SET_POS_REG(1, ${placeAt[axis]}, status)
  ${mover}
  WRITE('${wayOf[axis]} at ', ${placeAt[axis]}.${axis}, CR)
  SET_POS_REG(1, here, status)
  ${mover}
END ${name}
`,
  moverTemplate: (/** @type {string} */ name) => `/PROG  ${name.toUpperCase()}
/ATTR
COMMENT\t\t= "go to PR[1]";
LINE_COUNT\t= 3;
DEFAULT_GROUP\t= 1,*,*,*,*;
/MN
   1:  UFRAME_NUM=0 ;
   2:  UTOOL_NUM=0 ;
   3:L PR[1] 100mm/sec FINE    ;
/POS
/END
`,
  limitsKrl:
    'KRL is read and run here as far as this page writes it; every motion stops at its end. BASE 0 is taken to be the world.',
  tpTemplate: (/** @type {string} */ name, /** @type {'x' | 'y' | 'z'} */ axis) => `/PROG  ${name.toUpperCase()}
/ATTR
COMMENT\t\t= "${placeAt[axis]} and back";
LINE_COUNT\t= 9;
DEFAULT_GROUP\t= 1,*,*,*,*;
/MN
   1:  !${`50 mm ${wayOf[axis]}, back by DI[1]`} ;
   2:  UFRAME_NUM=0 ;
   3:  UTOOL_NUM=0 ;
   4:  PR[1:here]=LPOS ;
   5:  PR[2:${placeAt[axis]}]=PR[1:here] ;
   6:  PR[2,${'xyz'.indexOf(axis) + 1}]=PR[1,${'xyz'.indexOf(axis) + 1}]+50 ;
   7:L PR[2:${placeAt[axis]}] 100mm/sec FINE    ;
   8:  WAIT DI[1:go back]=ON ;
   9:L PR[1:here] 100mm/sec FINE    ;
/POS
/END
`,
  krlTemplate: (/** @type {string} */ name) => `DEF ${name} ( )
  ; positions stand in braces, as in PTP {A1 0,A2 -90,...} and LIN {X 500,Y 0,Z 500,A 0,B 90,C 0},
  ; or by their names in a program of their own, which begins with DEFDAT ${name}
  BAS(#VEL_PTP,50)
  WAIT FOR $IN[1]==TRUE
  $OUT[1]=TRUE
  WAIT SEC 1.0
  $OUT[1]=FALSE
END
`,
};
