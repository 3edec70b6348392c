/** The rooms of the page, and the view of the arm. */

export const PANELS = {
  label: 'Panels',
  robot: 'Robot',
  jog: 'Jog',
  aim: 'Aim',
  program: 'Program',
  code: 'Code',
  workspace: 'Workspace',
  jacobian: 'Jacobian',
  left: 'Robot and program',
  right: 'Joints and poses',
  view: '3-D view of the arm',
  skip: { label: 'Skip', view: 'To the view', robot: 'To the table', jog: 'To the joints', aim: 'To the target' },
  leftEdge: 'Width of the left panel',
};

export const VIEW = {
  tools: 'View',
  fit: 'Fit the arm into the view',
  views: 'Direction of view',
  frames: 'Frames',
  build: 'Build it',
  buildTitle: 'Build it: how a row makes a frame',
  direction: {
    home: 'From front right',
    front: 'Front',
    back: 'Back',
    left: 'Left',
    right: 'Right',
    top: 'Top',
    bottom: 'Bottom',
  },
  projection: { perspective: 'Perspective', parallel: 'Parallel (orthographic)' },
  framesShown: {
    none: 'No frames',
    ends: 'Base and tool',
    row: 'The two of the selected row',
    all: 'All frames',
  },
  trace: { off: 'No trace', on: 'Trace of the tool' },
  traced: 'The trace of the tool is drawn.',
  traceStart: 'start of trace',
  seen: (/** @type {string} */ direction) => `View: ${direction}.`,
  describe: (/** @type {string} */ robot, /** @type {string} */ pose, /** @type {string} */ drawn) =>
    `${robot} in 3-D. ${pose} ${drawn} Arrow keys orbit, with Shift they move the picture, plus and minus zoom, F fits, 0 to 6 choose a view, T takes the tool to move it by keys.`,
  drawnFrames: (/** @type {string[]} */ names) => `Frames drawn: ${names.join(', ')}.`,
  noFrames: 'No frames drawn.',
  frameName: (/** @type {number | 'tool'} */ frame) =>
    frame === 'tool' ? 'tool' : frame === 0 ? 'base' : String(frame),
  userFrame: (/** @type {string} */ id, /** @type {boolean} */ isActive) =>
    `user frame ${id}${isActive ? ' (active)' : ''}`,
  drawnDimension: (/** @type {string} */ text) => `Dimension drawn: ${text}.`,
  building: (/** @type {number} */ row, /** @type {number} */ done) =>
    `“Build it” is open at row ${row}, with ${done} of its 4 motions done.`,
  grid: (/** @type {string} */ step) => `Grid ${step}`,
};
