/**
 * All text of the page, as whole sentences with named blanks; nothing else in `ui` holds words. Numbers arrive already
 * formatted (format.js).
 */
export const TEXT = {
  product: 'Denavit',
  unnamedRobot: 'Robot without a name',
  title: (/** @type {string} */ robot) => `${robot} · Denavit`,
  close: 'Close',
  fault: (/** @type {string} */ message) => `Something broke here: ${message} The rest of the page goes on working.`,
  noWebGl:
    'This browser shows no 3-D graphics (WebGL is off or missing), so the arm cannot be drawn. The table, the joints and the poses go on working.',

  bar: {
    chooseRobot: 'Choose a robot',
    file: 'File',
    open: 'Open a robot file…',
    openDetail: 'XML, as this page saves it',
    save: 'Save the robot as XML',
    saveDetail: 'Table, limits, recorded postures',
    undo: 'Undo',
    redo: 'Redo',
    theme: 'Colours: light or dark',
    themeNow: { light: 'Light colours.', dark: 'Dark colours.' },
    unitsOf: (/** @type {string} */ length, /** @type {string} */ angle) => `${length} · ${angle}`,
    unitsLabel: 'Units of the document',
  },

  library: {
    title: 'Choose a robot',
    search: 'Search by name, type or source',
    searchHint: '6R, KUKA, wrist …',
    list: 'Robots',
    found: (/** @type {number} */ n) => (n === 1 ? '1 robot' : `${n} robots`),
    none: (/** @type {string} */ text) => `No robot matches “${text}”.`,
    family: {
      textbook: 'Textbook arms',
      straightLines: 'SCARA, cylinder and gantry',
      industrial: 'Industrial arms',
      light: 'Light and collaborative arms',
    },
    facts: (/** @type {string} */ types, /** @type {number} */ n, /** @type {string} */ reach) =>
      `${types} · ${n} DOF · reach up to ${reach}`,
    isOpen: 'open now',
    chosen: (/** @type {string} */ robot) => `${robot} is open.`,
    freshTitle: 'New robot',
    freshName: 'New robot',
    fresh: (/** @type {number} */ n) => `New robot with ${n} joints`,
    joints: 'joints',
    freshHint: 'Starts from a table in which every joint moves the tool; undo brings your robot back.',
  },

  panels: {
    label: 'Panels',
    robot: 'Robot',
    jog: 'Jog',
    aim: 'Aim',
    program: 'Program',
    code: 'Code',
    left: 'Robot and program',
    right: 'Joints and poses',
    view: '3-D view of the arm',
  },

  view: {
    tools: 'View',
    fit: 'Fit the arm into the view',
    describe: (/** @type {string} */ robot, /** @type {string} */ pose) =>
      `${robot} in 3-D. ${pose} Arrow keys orbit, plus and minus zoom, F fits.`,
    grid: (/** @type {string} */ step) => `Grid ${step}`,
  },

  table: {
    title: 'Denavit–Hartenberg table',
    conventionName: { standard: 'Standard DH', modified: 'Modified DH (Craig)' },
    conventionOrder: {
      standard: 'Rz(θ) · Tz(d) · Tx(a) · Rx(α)',
      modified: 'Rx(α) · Tx(a) · Rz(θ) · Tz(d)',
    },
    joint: 'Joint',
    lower: 'lower',
    upper: 'upper',
    jointType: { revolute: 'revolute', prismatic: 'prismatic', continuous: 'continuous' },
    unlimited: 'none',
    cell: (/** @type {number} */ joint, /** @type {string} */ field, /** @type {string} */ unit) =>
      `Joint ${joint}, ${field}, ${unit}`,
    fieldName: {
      theta: 'joint angle θ',
      d: 'link offset d',
      a: 'link length a',
      alpha: 'link twist α',
      lower: 'lower limit',
      upper: 'upper limit',
      home: 'home',
    },
    unitName: { mm: 'millimetres', cm: 'centimetres', m: 'metres', deg: 'degrees', rad: 'radians' },
    hint: 'Each row leads from one joint axis to the next. Choose a cell to see what it means and change it.',
    source: 'Source',
    kept: 'Kept as it was:',
  },

  /** Joints, units and convention of the whole table. */
  structure: {
    menu: (/** @type {string} */ joint) => `${joint}: type, place, remove`,
    menuOf: (/** @type {number} */ joint, /** @type {string} */ type) => `Joint ${joint}, ${type}: change or add`,
    add: 'Add joint',
    type: {
      revolute: 'Turns (revolute)',
      prismatic: 'Slides (prismatic)',
      continuous: 'Turns without end (continuous)',
    },
    clears: 'Its limits, home and controller values are cleared.',
    clearsLimits: 'Its limits are cleared.',
    typed: {
      revolute: (/** @type {string} */ joint) => `${joint} turns now.`,
      prismatic: (/** @type {string} */ joint) => `${joint} slides now.`,
      continuous: (/** @type {string} */ joint) => `${joint} turns without end now.`,
    },
    addAfter: (/** @type {string} */ joint) => `Add a joint after ${joint}`,
    added: (/** @type {string} */ joint) => `${joint} is added. Its zeros do not move the arm yet.`,
    duplicate: (/** @type {string} */ joint) => `Duplicate ${joint}`,
    duplicated: (/** @type {string} */ joint, /** @type {string} */ copy) =>
      `${copy} is a copy of ${joint}, at its home.`,
    up: (/** @type {string} */ joint) => `Move ${joint} up`,
    down: (/** @type {string} */ joint) => `Move ${joint} down`,
    moved: (/** @type {string} */ joint, /** @type {number} */ place) => `${joint} is joint ${place} now.`,
    remove: (/** @type {string} */ joint) => `Remove ${joint}`,
    removed: (/** @type {string} */ joint) => `${joint} is removed, and its value in every recorded posture.`,
    unitsHint: 'Converts the numbers; the robot stays.',
    unit: (/** @type {string} */ name, /** @type {string} */ sign) =>
      `${name[0].toUpperCase()}${name.slice(1)} (${sign})`,
    converted: (/** @type {string} */ unit) => `The numbers are in ${unit} now; the robot is the same.`,
    convention: 'Convention:',
    conventionName: { standard: 'standard', modified: 'modified (Craig)' },
    conventionDetail: {
      standard: 'Frame i sits at the far end of link i.',
      modified: 'Frame i sits on the axis of joint i.',
    },
    convert: (/** @type {string} */ name) => `Convert to ${name}`,
    convertDetail: 'Same robot, other numbers. The arm does not move.',
    convertedTo: (/** @type {string} */ name) =>
      `Converted to ${name}: other numbers, the same robot; the arm has not moved.`,
    baseChanged: 'The base changed with the table.',
    toolChanged: 'The tool changed with the table.',
    reread: (/** @type {string} */ name) => `Read the numbers as ${name}`,
    rereadDetail: (/** @type {string} */ distance) => `Same numbers, another robot. The tool jumps by ${distance}.`,
    rereadAs: (/** @type {string} */ name, /** @type {string} */ distance) =>
      `The numbers are read as ${name} now: another robot. The tool moved by ${distance}.`,
  },

  /** What a parameter is, by convention; i counts joints from 1. */
  definition: {
    standard: {
      theta: (/** @type {number} */ i) => `Joint angle: from axis x${sub(i - 1)} to x${sub(i)}, about z${sub(i - 1)}.`,
      d: (/** @type {number} */ i) => `Link offset: from x${sub(i - 1)} to x${sub(i)}, along z${sub(i - 1)}.`,
      a: (/** @type {number} */ i) => `Link length: from axis z${sub(i - 1)} to axis z${sub(i)}, along x${sub(i)}.`,
      alpha: (/** @type {number} */ i) => `Link twist: from axis z${sub(i - 1)} to axis z${sub(i)}, about x${sub(i)}.`,
    },
    modified: {
      theta: (/** @type {number} */ i) => `Joint angle: from axis x${sub(i - 1)} to x${sub(i)}, about z${sub(i)}.`,
      d: (/** @type {number} */ i) => `Link offset: from x${sub(i - 1)} to x${sub(i)}, along z${sub(i)}.`,
      a: (/** @type {number} */ i) => `Link length: from axis z${sub(i - 1)} to axis z${sub(i)}, along x${sub(i - 1)}.`,
      alpha: (/** @type {number} */ i) =>
        `Link twist: from axis z${sub(i - 1)} to axis z${sub(i)}, about x${sub(i - 1)}.`,
    },
    variable: (/** @type {number} */ i) => `This is the constant part; the joint value q${sub(i)} adds to it.`,
    lower: 'The joint value may not go below this.',
    upper: 'The joint value may not go above this.',
    home: 'Where the joint stands at home.',
  },

  jog: {
    title: 'Jog',
    home: 'Go to home',
    slider: (/** @type {number} */ joint) => `Joint ${joint}`,
    field: (/** @type {number} */ joint, /** @type {string} */ unit) => `Joint ${joint}, ${unit}`,
    outside: (/** @type {string} */ joint, /** @type {string} */ limits) =>
      `${joint} stands outside its limits, ${limits}.`,
    stops: (/** @type {string} */ joint, /** @type {string} */ limits) => `${joint} stops: ${limits}.`,
    between: (/** @type {string} */ lower, /** @type {string} */ upper) => `${lower} to ${upper}`,
    atMost: (/** @type {string} */ upper) => `at most ${upper}`,
    atLeast: (/** @type {string} */ lower) => `at least ${lower}`,
    atHome: 'The arm is at home.',
  },

  pose: {
    title: 'Tool pose',
    frame: 'in world',
    convention: 'FANUC WPR',
    conventionDetail: 'Rz(R) · Ry(P) · Rx(W)',
    copy: 'Copy the pose',
    copied: 'The pose is copied.',
    copyFailed: 'The browser does not allow copying here.',
    spoken: (/** @type {string} */ numbers) => `The tool is at ${numbers}.`,
  },

  aim: {
    title: 'Target',
    field: (/** @type {string} */ name, /** @type {string} */ unit) => `Target ${name}, ${unit}`,
    move: 'Move there',
    follow: 'Take the tool pose',
    nearest: 'Go as near as found',
    following: 'The fields follow the tool. Type a pose to aim at.',
    toGo: (/** @type {string} */ distance, /** @type {string} */ angle) => `${distance} and ${angle} to go.`,
    reached: (/** @type {string} */ distance, /** @type {string} */ angle) => `Reached: ${distance}, ${angle} off.`,
    subspace: (/** @type {string} */ task) => `Met as far as this arm can: ${task}`,
    asNear: (/** @type {string} */ distance, /** @type {string} */ angle) =>
      `The arm stands ${distance} and ${angle} off, as near as was found.`,
    wentNearest: 'The arm stands at the nearest posture found.',
  },

  /** Why inverse kinematics did not reach the whole pose. */
  verdict: {
    task: {
      'position-and-tilt': (/** @type {string} */ angle) =>
        `the position and the tilt of the tool. Its turn about the arm’s first axis follows from them and differs by ${angle}.`,
      'position-and-axis': (/** @type {string} */ angle) =>
        `the position and the direction of the tool axis. Its turn about that axis follows from them and differs by ${angle}.`,
      'position-and-turn': (/** @type {string} */ angle) =>
        `the position and the turn about the arm’s first axis. The tilt of the tool is fixed and differs by ${angle}.`,
      'position-and-pitch': (/** @type {string} */ angle) =>
        `the position and the pitch of the tool. The rest of its orientation follows from them and differs by ${angle}.`,
      position: (/** @type {string} */ angle) => `the position. The orientation differs by ${angle}.`,
    },
    beyond: (/** @type {string} */ by) => `Out of reach, by at least ${by}.`,
    distance: (/** @type {string} */ by) =>
      `Out of reach: the tool was found to come no nearer to this place than ${by}.`,
    orientation: 'The tool can be at this place, but no posture turns it this way.',
    outsideLimits: (/** @type {string} */ joint, /** @type {string} */ by) =>
      `Only outside the limits: ${joint} would have to go ${by} past its stop.`,
    notFound: (/** @type {string} */ distance, /** @type {string} */ angle) =>
      `No posture found for this pose. The nearest one found is ${distance} and ${angle} off.`,
    fewJoints: (/** @type {number} */ joints, /** @type {string} */ distance, /** @type {string} */ angle) =>
      `An arm with ${joints} joints cannot take this pose. The nearest posture found is ${distance} and ${angle} off.`,
  },

  program: {
    title: 'Recorded postures',
    record: 'Record here',
    empty: 'Nothing recorded yet',
    emptyDetail: 'Move the arm, record where it stands, and do it again: two postures make a motion.',
    go: (/** @type {string} */ name) => `Move the arm to ${name}`,
    name: (/** @type {number} */ index) => `Name of posture ${index}`,
    remove: (/** @type {string} */ name) => `Delete ${name}`,
    went: (/** @type {string} */ name) => `The arm is at ${name}.`,
    removed: (/** @type {string} */ name) => `${name} is deleted.`,
    renamed: (/** @type {string} */ name) => `It is called ${name} now.`,
    recorded: (/** @type {string} */ name) => `Recorded as ${name}.`,
    one: 'One more posture, and controller code can be written for the motion between them.',
    toCode: 'See the controller code',
    heads: { name: 'posture', values: 'joint values' },
  },

  code: {
    title: 'FANUC KAREL + TP',
    empty: 'No motion to write yet',
    emptyDetail: 'Controller code is written from recorded postures. Record two or more of them.',
    toProgram: 'Record postures',
    files: 'Files',
    copy: 'Copy this file',
    copied: (/** @type {string} */ name) => `${name} is copied.`,
    save: 'Save both files',
    saved: (/** @type {string} */ names) => `Saved: ${names}.`,
    text: (/** @type {string} */ name) => `Text of ${name}`,
    notes: 'Before you use it',
  },

  files: {
    notOpened: (/** @type {string} */ name) => `${name} was not opened`,
    stillHere: (/** @type {string} */ robot) => `${robot} is still here, unchanged.`,
    opened: (/** @type {string} */ name) => `${name} is open.`,
    openedWith: (/** @type {string} */ name) => `${name} is open, with remarks`,
    saved: (/** @type {string} */ name) => `Saved as ${name}.`,
    another: 'Choose another file',
    copyReport: 'Copy report',
    reportCopied: 'The report is copied.',
    tooLarge: (/** @type {string} */ size) => `The file is ${size}; a robot file is at most 1 MB.`,
    unreadable: (/** @type {string} */ reason) => `The browser could not read the file: ${reason}`,
    megabytes: (/** @type {string} */ n) => `${n} MB`,
  },

  number: {
    empty: 'A number is needed here, such as 431.8.',
    comma: (/** @type {string} */ mended) => `Decimals are written with a point: ${mended}.`,
    notANumber: (/** @type {string} */ text) => `“${text}” is not a number; expected one such as 431.8.`,
    tooLarge: 'The number is too large; at most 1e9.',
  },

  done: { undo: 'Undone.', redo: 'Done again.' },

  parameter: {
    notUnderstood: (/** @type {string} */ name, /** @type {string} */ text, /** @type {string} */ initial) =>
      `?${name}=${text} is not understood; using ${initial}.`,
    unknown: (/** @type {string} */ name) => `There is no ?${name} parameter.`,
  },
};

/** @param {number} index */
const sub = (index) => [...String(index)].map((digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]).join('');
