/**
 * What can be wrong with a motion program in its document: one list of facts, for commands, files and whatever else brings
 * programs in. A field that its kind of step does not have is a fault, too: nothing would keep it.
 *
 * @import { Doc, MotionProgramDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 *
 * @typedef {[isSound: (value: unknown, doc: Doc) => boolean, expected: string | ((doc: Doc) => string)]} Rule
 */
import {
  ID_PATTERN,
  JOINT_LAWS,
  LARGEST_NUMBER,
  MAX_LABEL_LENGTH,
  MAX_MOTION_PROGRAMS,
  MAX_STEPS,
  STEP_LAWS,
  characterCount,
} from '../documentRules.js';
import { issue, shown } from '../refusalParts.js';
import { badPose } from '../robot/robotRefusals.js';

/** @param {readonly unknown[]} words @returns {Rule} */
const oneOf = (...words) => [(value) => words.includes(value), words.join(' or ')];

/** @param {number} most @returns {Rule} */
const upTo = (most) => [
  (value) => typeof value === 'number' && value > 0 && value <= most,
  `a number above 0 and up to ${most}`,
];

/** @type {Rule} */
const COUNT = [
  (value) => typeof value === 'number' && Number.isInteger(value) && value > 0 && value <= LARGEST_NUMBER,
  'a whole number above 0',
];
/** @type {Rule} */
const NAME = [
  (value) => typeof value === 'string' && ID_PATTERN.test(value),
  'a letter or _, then at most 63 letters, digits or _',
];
/** @type {Rule} */
const TEXT = [
  (value) => typeof value === 'string' && characterCount(value) <= MAX_LABEL_LENGTH,
  `a text of at most ${MAX_LABEL_LENGTH} characters`,
];
const FLAG = oneOf(true, false);
const SIGNAL = oneOf('on', 'off');

const POSE_FIELDS = ['xyz', 'rpy', 'quaternion'];

/** @type {Rule} */
const TARGET = [
  (target, doc) => {
    const { kind, ...rest } = Object(target);
    if (kind === 'posture') {
      const { values, ...more } = rest;
      return hasNo(more) && isVector(values, doc.robot.joints.length);
    }
    if (kind === 'target') {
      const { id, ...more } = rest;
      return hasNo(more) && doc.targets.some((one) => one.id === id);
    }
    const { configuration = '', ...pose } = rest;
    const isPose = kind === 'pose' && Object.keys(pose).every((name) => POSE_FIELDS.includes(name));
    return isPose && TEXT[0](configuration, doc) && badPose('', pose) === null;
  },
  ({ robot: { joints } }) => `a posture of ${joints.length} joint values, the name of a target, or a pose`,
];

/** @type {Rule} */
const ENDING = [
  (ending) => {
    const { kind, value, ...rest } = Object(ending);
    if (!hasNo(rest)) return false;
    if (kind === 'fine') return value === undefined;
    const most = kind === 'percent' ? 100 : LARGEST_NUMBER;
    return ['percent', 'distance'].includes(kind) && typeof value === 'number' && value >= 0 && value <= most;
  },
  'fine, a share from 0 to 100 % or a distance from 0 on',
];

/** @param {'user' | 'tool'} kind @param {string} word @returns {Rule} */
const frame = (kind, word) => [
  (id, { frames }) => frames.some((one) => one.kind === kind && one.id === id),
  `the name of a ${word}`,
];

const MOVE = {
  target: TARGET,
  speed: upTo(LARGEST_NUMBER),
  speedUnit: oneOf('length/s', 'angle/s'),
  acceleration: upTo(100),
  ending: ENDING,
};
const MOVE_MORE = { law: oneOf(...STEP_LAWS), tool: frame('tool', 'tool'), frame: frame('user', 'user frame') };

/** What a step of a kind has besides its kind; what it may have. @type {Record<string, [Record<string, Rule>, Record<string, Rule>?]>} */
const FIELDS = {
  joint: [
    { ...MOVE, speed: upTo(100), speedUnit: oneOf('%') },
    { ...MOVE_MORE, law: oneOf(...JOINT_LAWS) },
  ],
  linear: [MOVE, MOVE_MORE],
  circular: [{ ...MOVE, via: TARGET }, MOVE_MORE],
  wait: [{ seconds: upTo(LARGEST_NUMBER) }],
  'set-output': [{ output: COUNT, value: SIGNAL }],
  'wait-input': [{ input: COUNT, value: SIGNAL }],
  call: [{ program: NAME }],
  label: [{ label: TEXT }],
  comment: [{ text: TEXT }],
};
const KIND = oneOf(...Object.keys(FIELDS));

/** The same with what every step has. @type {Map<unknown, { must: Record<string, Rule>, may: Record<string, Rule> }>} */
const RULES = new Map();
for (const [kind, [must, may]] of Object.entries(FIELDS)) {
  const aside = kind === 'comment' ? null : { comment: TEXT };
  RULES.set(kind, { must: { id: NAME, ...must }, may: { ...may, ...aside, disabled: FLAG } });
}

/**
 * @param {Doc} doc
 * @param {MotionProgramDoc} program  that is, or would be, one of the document's
 * @param {string} path
 * @returns {Generator<Issue>}
 */
export function* motionProgramFaults(doc, program, path) {
  const { id, name, steps, ...rest } = Object(program);
  const owner = `Program ${shown(name)}`;
  yield* faultsOf(owner, path, { id, name }, { id: NAME, name: TEXT }, {}, doc);
  yield* unknownFields(owner, path, rest);
  if (!Array.isArray(steps)) {
    yield issue('choice', `${path}.steps`, `${owner} has no list of steps.`);
    return;
  }
  const ids = new Set();
  for (const [i, step] of steps.entries()) {
    const { kind, ...fields } = Object(step);
    const where = `${path}.steps.${i}`;
    const whose = `Step ${i + 1} of ${shown(name)}`;
    const known = RULES.get(kind);
    if (!known) {
      yield* faultsOf(whose, where, { kind }, { kind: KIND }, {}, doc);
      continue;
    }
    yield* faultsOf(whose, where, fields, known.must, known.may, doc);
    if (ids.has(fields.id)) {
      yield issue(
        'id-taken',
        `${where}.id`,
        `Two steps of ${shown(name)} have the id ${shown(fields.id)}; expected a different id for each.`,
      );
    }
    ids.add(fields.id);
  }
}

/**
 * @param {string} owner @param {string} path @param {Record<string, unknown>} fields
 * @param {Record<string, Rule>} must @param {Record<string, Rule>} may @param {Doc} doc
 */
function* faultsOf(owner, path, fields, must, may, doc) {
  for (const rules of [may, must]) {
    for (const name in rules) {
      const value = fields[name];
      if (value === undefined && rules === may) continue;
      const [isSound, expected] = rules[name];
      if (isSound(value, doc)) continue;
      const wanted = typeof expected === 'string' ? expected : expected(doc);
      yield issue('step', `${path}.${name}`, `${owner} has ${shown(value)} as ${name}; expected ${wanted}.`);
    }
  }
  const isKnown = (/** @type {string} */ name) => Object.hasOwn(must, name) || Object.hasOwn(may, name);
  yield* unknownFields(owner, path, Object.fromEntries(Object.entries(fields).filter(([name]) => !isKnown(name))));
}

/** @param {string} owner @param {string} path @param {Record<string, unknown>} rest */
function* unknownFields(owner, path, rest) {
  for (const name of Object.keys(rest)) yield issue('step', `${path}.${name}`, `${owner} has no field ${shown(name)}.`);
}

/** @param {object} rest */
const hasNo = (rest) => Object.keys(rest).length === 0;

/** @param {unknown} values @param {number} count */
const isVector = (values, count) =>
  Array.isArray(values) &&
  values.length === count &&
  values.every((value) => typeof value === 'number' && Math.abs(value) <= LARGEST_NUMBER);

/**
 * All programs of a document.
 * @param {Doc} doc
 * @returns {Generator<Issue>}
 */
export function* motionFaults(doc) {
  const { motionPrograms } = doc;
  const tooMany = motionCountFault(motionPrograms);
  if (tooMany) yield tooMany;
  for (const [i, program] of motionPrograms.entries()) {
    yield* motionProgramFaults(doc, program, `motionPrograms.${i}`);
    if (motionPrograms.findIndex(({ id }) => id === program.id) !== i) {
      const message = `Two programs have the id ${shown(program.id)}; expected a different id for each.`;
      yield issue('id-taken', `motionPrograms.${i}.id`, message);
    }
  }
}

/** @param {readonly MotionProgramDoc[]} programs */
export function motionCountFault(programs) {
  if (programs.length > MAX_MOTION_PROGRAMS) {
    return issue(
      'too-many-programs',
      'motionPrograms',
      `A model keeps at most ${MAX_MOTION_PROGRAMS} motion programs.`,
    );
  }
  const steps = programs.reduce((sum, program) => sum + program.steps.length, 0);
  if (steps <= MAX_STEPS) return null;
  return issue(
    'too-many-steps',
    'motionPrograms',
    `A model keeps at most ${MAX_STEPS} steps in all its programs; these would be ${steps}.`,
  );
}
