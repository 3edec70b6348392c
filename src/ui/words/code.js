/** Controller code: files, the editor, running it. */

export const CODE = {
  title: 'FANUC KAREL + TP',
  empty: 'No code yet',
  emptyDetail:
    'Write a KAREL program and run it on this arm, open one from a file, or record two or more postures: they are written as code.',
  toProgram: 'Record postures',
  files: 'Files',
  copy: 'Copy this file',
  copied: (/** @type {string} */ name) => `${name} is copied.`,
  save: 'Save both files',
  saveOne: 'Save this file',
  saved: (/** @type {string} */ names) => `Saved: ${names}.`,
  text: (/** @type {string} */ name) => `Text of ${name}`,
  notes: 'Before you use it',
  written: 'written from the recorded postures',
  edit: 'Edit a copy',
  more: 'Files: new, open, rename, remove',
  newKarel: 'New KAREL program',
  newKarelDetail: 'It can be checked and run here',
  newTp: 'New TP program',
  newKrl: 'New KRL program',
  onlyEdited: 'It can be edited here, not run',
  openFile: 'Open a file…',
  openDetail: '.kl, .ls, .src or .dat; it becomes part of the model',
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
  notChecked: 'This language is not checked here.',

  variables: 'Variables',
  variable: { name: 'Name', type: 'Type', value: 'Value' },
  stack: 'Where it is',
  signals: 'Signals',
  input: (/** @type {string} */ name) => `${name}, an input: set it`,
  on: 'ON',
  off: 'OFF',
  output: 'Output',
  noOutput: 'Nothing is written yet.',
  answer: 'A line for the program to read',
  send: 'Send',
  called: (/** @type {string} */ name) => `CALL ${name}: not a KAREL program of this model; passed over.`,
  effect: (/** @type {string} */ what) => `${what}: has no effect on the simulated arm.`,
  posted: (/** @type {string} */ message) => `POST_ERR: ${message}`,
  taskAlarm: (/** @type {string} */ task, /** @type {string} */ reason) => `Task ${task} ended: ${reason}`,
  limits:
    'Simulated: every motion stops at its end, a joint motion goes at full rates, a statement takes 0.01 ms. No controller has judged this.',
  template: (/** @type {string} */ name) => `PROGRAM ${name}
-- Move the tool 50 mm up from where it is, and back.
VAR
  here, above : XYZWPR
BEGIN
  here = CURPOS(0, 0)
  above = here
  above.z = here.z + 50.0
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO above
  WRITE('up at ', above.z, CR)
  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO here
END ${name}
`,
};
