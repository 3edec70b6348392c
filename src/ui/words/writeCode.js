/** Controller code that is written, and what a run of it on the model has shown. */

export const WRITE = {
  format: 'Language of the code',
  formats: {
    pair: 'FANUC KAREL + TP',
    tp: 'FANUC TP alone',
    'karel-move': 'FANUC KAREL with MOVE (R-J3iB and older)',
    krl: 'KUKA KRL',
  },
  source: 'Written from',
  sources: {
    postures: (/** @type {number} */ count) => `${count} recorded postures`,
    targets: (/** @type {number} */ count) => (count === 1 ? '1 target' : `${count} targets`),
    program: (/** @type {string} */ name) => `Program ${name}`,
  },
  options: 'Options',
  programName: 'Program name',
  firstRegister: 'First position register',
  speedOfProgram: 'Speed, % of the program’s',
  speedOfJoints: 'Speed, % of the joints’ rates',
  frame: 'Positions in',
  frames: { own: 'each step’s own', world: 'the world (0)' },
  user: (/** @type {string} */ name) => `UFRAME or BASE of ${name}`,
  tool: (/** @type {string} */ name) => `UTOOL or TOOL of ${name}`,
  toolInUse: 'the tool in use',
  edit: 'Edit a copy',
  written: 'Written from the model; it changes with it',
  isWriting: (/** @type {string} */ percent) => `Writing, ${percent}%`,
  region: 'Code that is written',
  none: 'No code is written',
  notes: (/** @type {number} */ count) => `Before you use it: ${count === 1 ? '1 note' : `${count} notes`}`,
  newName: 'The files are called after the program; the name is changed where a controller would not take it.',
};

export const VERIFY = {
  save: 'Verify and save',
  region: 'Verification',
  isRunning: (/** @type {string} */ percent) => `Running the code on the model, ${percent}%`,
  cancel: 'Cancel',
  cancelled: 'Given up; nothing was saved.',
  saved: (/** @type {string} */ names) => `Saved: ${names}.`,
  notSaved: 'Not saved.',
  saveAll: 'Save all the same',
  close: 'Close what was found',
  savedUnverified: (/** @type {string} */ names) => `Saved though it is not verified: ${names}.`,
  good: (/** @type {string} */ mm, /** @type {string} */ deg) =>
    `Read again and run on the model: ${mm} mm and ${deg}° from the program at most.`,
  bad: (/** @type {number} */ errors) =>
    `Read again and run on the model: ${errors === 1 ? 'one error' : `${errors} errors`}. The code does not do what the program does, or cannot be run.`,
  alone:
    'Read again and run on the model. Its header names no program of this model, so there is nothing to compare it with.',
  aloneBad: (/** @type {number} */ errors) =>
    `Read again and run on the model: ${errors === 1 ? 'one error' : `${errors} errors`}.`,
  nothing: 'The code makes no moves.',
  corners: 'How a controller rounds corners and speeds up is its own: ways are compared from target to target.',
  assumedRates: 'Joint rates that the model does not state are assumed.',
  strip: 'Along the program',
  lanes: { way: 'Way', limit: 'Limits', singularity: 'Singularity', rate: 'Joint rates' },
  levels: { good: 'in order', warn: 'worth a look', bad: 'a fault', unknown: 'not known' },
  moves: (/** @type {number} */ count) => (count === 1 ? 'Each move: 1' : `Each move: ${count}`),
  movesTable: 'Each move',
  columns: {
    line: 'Line',
    move: 'Move',
    mm: 'mm',
    deg: '°',
    limit: 'Room to a limit',
    singularity: '1/κ',
    rate: 'Rate',
  },
  kinds: { joint: 'joint', linear: 'linear', circular: 'circular' },
  line: (/** @type {number} */ line) => `Line ${line}`,
  toLine: (/** @type {string} */ file, /** @type {number} */ line) => `${file}, line ${line}`,
  joint: (/** @type {number} */ joint) => `J${joint}`,
  noFindings: 'Nothing else was found.',
  findings: 'What was found',
  rounding: (/** @type {string} */ mm, /** @type {string} */ deg) =>
    `The decimals of the language may cost up to ${mm} mm and ${deg}°.`,
  more: (/** @type {number} */ count) => `${count} more`,
};

/** What a certificate in a file's header says of it. */
export const CERTIFICATE = {
  none: 'No certificate: this text has not been verified.',
  valid: (/** @type {string} */ mm, /** @type {string} */ deg) => `As it was verified: ${mm} mm and ${deg}° at most.`,
  altered: 'Altered since it was verified: the text no longer matches its certificate.',
  'other-files': 'As it was verified, but the files that came with it are not all here as they were.',
  'other-model': 'Verified with another robot, or with other numbers of this one.',
};
