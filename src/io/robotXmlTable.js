/**
 * The robot file, once: every element and attribute with its type, whether it must be there, what holds when it is not,
 * and where its value is kept. Reader and writer both work from this table, a test holds it against the published schema
 * (public/schema/robot-model-1.0.xsd), and the order here is the order in files we write.
 *
 * `at` is a path in the record that the element belongs to. A record is the file itself, the object in the field
 * `record`, or the next item of the array `list`.
 *
 * @import { ValueType } from './valueTypes.js'
 *
 * @typedef {object} AttributeRule
 * @property {string} name
 * @property {ValueType} type
 * @property {string} at
 * @property {boolean} required
 * @property {unknown} [default]  the value when it is missing; not written
 *
 * @typedef {object} ElementRule
 * @property {string} name
 * @property {number} min         how often it must be in its parent
 * @property {number} max         how often it may be there
 * @property {string} [record]
 * @property {string} [list]
 * @property {string} [noun]      what messages call an item of the list
 * @property {Readonly<Record<string, unknown>>} [constants]  fields of the record that the element's name stands for
 * @property {() => unknown} [absent]  the record when the element is missing, where an empty element means another
 * @property {readonly AttributeRule[]} attributes
 * @property {'all' | 'sequence' | 'choice'} order  of the children: any, this, or any and repeated
 * @property {readonly ElementRule[]} children
 * @property {number} [maxChildren]
 * @property {{ readonly type: ValueType, readonly at: string, readonly default?: unknown, readonly hasLines?: boolean }} [text]
 * @property {string} [foreign]   the list that keeps elements of other namespaces, as text
 * @property {string} [olderNameOf]  read for the sake of older files, never written
 */
import { identityPose, MAX_JOINTS, MAX_POSTURES, MIN_JOINTS } from '../model/document.js';
import * as rules from '../model/documentRules.js';
import { OBSTACLE_SIZES } from '../model/workcell/obstacles.js';
import * as types from './valueTypes.js';

export const ROBOT_NAMESPACE = 'urn:denavit:robot-model:1';
export const ROBOT_VERSION = '1.0';

const LABEL = types.string(rules.MAX_LABEL_LENGTH);

/** @param {string} name @param {ValueType} type @param {string} at @returns {AttributeRule} */
export const required = (name, type, at = name) => ({ name, type, at, required: true });

/** @param {string} name @param {ValueType} type @param {{ at?: string, default?: unknown }} [more] @returns {AttributeRule} */
export const optional = (name, type, { at = name, ...more } = {}) => ({ name, type, at, required: false, ...more });

/** @param {string} name @param {Partial<ElementRule>} more @returns {ElementRule} */
export const element = (name, more) => ({ name, min: 0, max: 1, attributes: [], order: 'all', children: [], ...more });

/** @param {string} name @param {string} at @param {ValueType} [type] */
const textElement = (name, at, type = LABEL) => element(name, { text: { type, at } });

const POSE = [
  optional('xyz', types.VECTOR_3, { default: Object.freeze([0, 0, 0]) }),
  optional('rpy', types.VECTOR_3),
  optional('quat_xyzw', types.QUATERNION, { at: 'quaternion' }),
];

const INFO = element('info', {
  children: [
    element('name', { text: { type: LABEL, at: 'robot.name', default: '' } }),
    textElement('manufacturer', 'robot.info.manufacturer'),
    textElement('author', 'robot.info.author'),
    textElement('licence', 'robot.info.licence'),
    textElement('source', 'robot.info.source'),
    textElement('description', 'robot.info.description', types.string(rules.MAX_DESCRIPTION_LENGTH)),
  ],
});

const JOINT = element('joint', {
  list: 'robot.joints',
  noun: 'joint',
  min: MIN_JOINTS,
  max: MAX_JOINTS,
  attributes: [required('id', types.ID), optional('label', LABEL), required('type', types.choice(rules.JOINT_TYPES))],
  children: [
    element('dh', {
      min: 1,
      attributes: [
        required('theta', types.FINITE),
        required('d', types.FINITE),
        required('a', types.FINITE),
        required('alpha', types.FINITE),
        optional('thetaText', LABEL, { at: 'text.theta' }),
        optional('dText', LABEL, { at: 'text.d' }),
        optional('aText', LABEL, { at: 'text.a' }),
        optional('alphaText', LABEL, { at: 'text.alpha' }),
      ],
    }),
    element('limits', {
      attributes: [
        optional('lower', types.FINITE),
        optional('upper', types.FINITE),
        optional('home', types.FINITE),
        optional('velocity', types.POSITIVE),
        optional('acceleration', types.POSITIVE),
        optional('jerk', types.POSITIVE),
        optional('effort', types.POSITIVE),
      ],
    }),
    element('link', {
      record: 'link',
      attributes: [
        optional('kind', types.choice(rules.LINK_KINDS), { default: 'auto' }),
        optional('radius', types.POSITIVE),
        optional('width', types.POSITIVE),
        optional('height', types.POSITIVE),
        optional('color', types.COLOUR),
      ],
    }),
    element('controller', {
      record: 'controller',
      attributes: [
        optional('sign', types.SIGN, { default: 1 }),
        optional('offset', types.FINITE, { default: 0 }),
        optional('coupledTo', types.ID),
        optional('coupling', types.FINITE, { default: 0 }),
      ],
    }),
  ],
});

const FRAME_ATTRIBUTES = [required('id', types.ID), optional('number', types.POSITIVE_INTEGER), ...POSE];

const FRAME = { list: 'frames', noun: 'frame', max: rules.MAX_FRAMES, attributes: FRAME_ATTRIBUTES };

const TARGET = element('target', {
  list: 'targets',
  noun: 'target',
  max: rules.MAX_TARGETS,
  attributes: [required('id', types.ID), optional('frame', types.ID), optional('configuration', LABEL), ...POSE],
});

/** @param {keyof typeof OBSTACLE_SIZES} kind */
const obstacleElement = (kind) =>
  element(kind, {
    list: 'obstacles',
    noun: 'obstacle',
    max: rules.MAX_OBSTACLES,
    constants: { kind },
    attributes: [
      required('id', types.ID),
      ...OBSTACLE_SIZES[kind].map((size) => required(size, types.POSITIVE)),
      ...POSE,
    ],
  });

const POSTURE = element('posture', {
  list: 'postures',
  noun: 'posture',
  max: MAX_POSTURES + 1,
  attributes: [required('id', types.ID), required('q', types.JOINT_VALUES)],
});

/**
 * Where a move goes, or what it goes past: all of it attributes, so that a step is one element.
 * @param {'target' | 'via'} at
 * @param {(name: string) => string} named
 */
const stepTarget = (at, named) => [
  optional(named('q'), types.JOINT_VALUES, { at: `${at}.values` }),
  optional(named('target'), types.ID, { at: `${at}.id` }),
  optional(named('xyz'), types.VECTOR_3, { at: `${at}.xyz` }),
  optional(named('rpy'), types.VECTOR_3, { at: `${at}.rpy` }),
  optional(named('quat_xyzw'), types.QUATERNION, { at: `${at}.quaternion` }),
  optional(named('configuration'), LABEL, { at: `${at}.configuration` }),
];
const TARGET_KIND = types.choice(['posture', 'target', 'pose']);
const TO = [required('to', TARGET_KIND, 'target.kind'), ...stepTarget('target', (name) => name)];
const VIA = [
  required('via', TARGET_KIND, 'via.kind'),
  ...stepTarget('via', (name) => `via${name[0].toUpperCase()}${name.slice(1)}`),
];
const MOVE = [
  required('speed', types.POSITIVE),
  required('speedUnit', types.choice(rules.SPEED_UNITS)),
  required('acceleration', types.POSITIVE),
  required('ending', types.choice(['fine', 'percent', 'distance']), 'ending.kind'),
  optional('endingValue', types.NOT_NEGATIVE, { at: 'ending.value' }),
  optional('tool', types.ID),
  optional('frame', types.ID),
];
const LAW = [optional('law', types.choice(rules.STEP_LAWS))];
const JOINT_LAW = [optional('law', types.choice(rules.JOINT_LAWS))];
const REMARK = [optional('comment', LABEL)];
const SIGNAL = [required('value', types.choice(['on', 'off']))];

/** @param {string} name @param {string} kind @param {AttributeRule[]} attributes */
const stepElement = (name, kind, attributes) =>
  element(name, {
    list: 'steps',
    noun: 'step',
    max: rules.MAX_STEPS,
    constants: { kind },
    attributes: [required('id', types.ID), ...attributes, optional('disabled', types.FLAG)],
  });

const MOTION_PROGRAM = element('motionProgram', {
  list: 'motionPrograms',
  noun: 'motion program',
  max: rules.MAX_MOTION_PROGRAMS,
  attributes: [required('id', types.ID), required('name', LABEL)],
  order: 'choice',
  maxChildren: rules.MAX_STEPS,
  children: [
    stepElement('jointMove', 'joint', [...TO, ...MOVE, ...JOINT_LAW, ...REMARK]),
    stepElement('linearMove', 'linear', [...TO, ...MOVE, ...LAW, ...REMARK]),
    stepElement('circularMove', 'circular', [...VIA, ...TO, ...MOVE, ...LAW, ...REMARK]),
    stepElement('wait', 'wait', [required('seconds', types.POSITIVE), ...REMARK]),
    stepElement('setOutput', 'set-output', [required('output', types.POSITIVE_INTEGER), ...SIGNAL, ...REMARK]),
    stepElement('waitInput', 'wait-input', [required('input', types.POSITIVE_INTEGER), ...SIGNAL, ...REMARK]),
    stepElement('call', 'call', [required('program', types.ID), ...REMARK]),
    stepElement('label', 'label', [required('label', LABEL), ...REMARK]),
    stepElement('comment', 'comment', [required('text', LABEL)]),
  ],
});

const PROGRAM = element('program', {
  list: 'programs',
  noun: 'program',
  max: rules.MAX_PROGRAMS,
  attributes: [required('id', types.ID), required('language', types.choice(rules.PROGRAM_LANGUAGES))],
  text: { type: types.string(), at: 'text', default: '', hasLines: true },
});

export const ROBOT_MODEL = element('robotModel', {
  min: 1,
  attributes: [
    required('version', types.VERSION),
    required('lengthUnit', types.choice(rules.LENGTH_UNITS), 'robot.units.length'),
    required('angleUnit', types.choice(rules.ANGLE_UNITS), 'robot.units.angle'),
    required('convention', types.choice(rules.CONVENTIONS), 'robot.convention'),
    optional('generator', LABEL),
  ],
  children: [
    INFO,
    element('base', { record: 'robot.base', absent: identityPose, attributes: POSE }),
    element('chain', { min: 1, order: 'sequence', children: [JOINT] }),
    element('tool', { record: 'robot.tool', absent: identityPose, attributes: POSE }),
    element('frames', {
      attributes: [optional('activeUser', types.ID), optional('activeTool', types.ID)],
      order: 'choice',
      maxChildren: rules.MAX_FRAMES,
      children: [
        element('userFrame', { ...FRAME, constants: { kind: 'user' } }),
        element('toolFrame', { ...FRAME, constants: { kind: 'tool' } }),
      ],
    }),
    element('targets', { order: 'sequence', children: [TARGET] }),
    element('obstacles', {
      order: 'choice',
      maxChildren: rules.MAX_OBSTACLES,
      children: [
        obstacleElement('box'),
        obstacleElement('sphere'),
        obstacleElement('cylinder'),
        obstacleElement('plane'),
      ],
    }),
    element('postures', { order: 'sequence', children: [POSTURE] }),
    element('configurations', {
      olderNameOf: 'postures',
      order: 'sequence',
      children: [{ ...POSTURE, name: 'configuration' }],
    }),
    element('motionPrograms', { order: 'sequence', children: [MOTION_PROGRAM] }),
    element('programs', { order: 'sequence', children: [PROGRAM] }),
    textElement('codeOptions', 'codeOptions', types.string(rules.MAX_DESCRIPTION_LENGTH)),
    element('extensions', { order: 'sequence', foreign: 'extensions' }),
  ],
});
