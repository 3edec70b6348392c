/**
 * rlkin, the kinematics format of the Robotics Library, as a table: its schema (rlkin.xsd), but for the order of elements, in
 * which the library takes no interest either. Numbers are the text of elements; lengths are metres, angles degrees.
 *
 * @import { ElementRule } from '../robotXmlTable.js'
 *
 * @typedef {object} RlkinPose   absent numbers are 0; R = Rz · Ry · Rx
 * @property {readonly (number | undefined)[]} translation
 * @property {readonly (number | undefined)[]} rotation
 *
 * @typedef {RlkinPose & { kind: 'world' | 'link' | 'frame', id: string, ignores?: { idref?: string }[] }} RlkinFrame
 * @typedef {RlkinPose & { id: string, from: string, to: string }} RlkinTransform
 *
 * @typedef {object} RlkinOwn
 * @property {'revolute' | 'prismatic'} type
 * @property {number} d
 * @property {number} theta
 * @property {number} a
 * @property {number} alpha
 * @property {number} [max]
 * @property {number} [min]
 * @property {number} [offset]
 * @property {number} [speed]
 * @property {number} [center]
 * @property {object | null} wraparound
 * @typedef {RlkinTransform & RlkinOwn} RlkinJoint
 *
 * @typedef {object} RlkinFile
 * @property {string} [name]
 * @property {string} [manufacturer]
 * @property {RlkinFrame[]} frames
 * @property {RlkinJoint[]} joints
 * @property {RlkinTransform[]} transforms
 */
import { MAX_LABEL_LENGTH } from '../../model/documentRules.js';
import { element, optional, required } from '../robotXmlTable.js';
import * as types from '../valueTypes.js';

/** More of one kind than any file has; the reader's own limit of elements comes first. */
const MANY = 1000;

/** @param {string} name @param {number} [min] */
const number = (name, min = 0) => element(name, { min, text: { type: types.FINITE, at: name } });
const LABEL = types.string(MAX_LABEL_LENGTH);

/** @param {'rotation' | 'translation'} name */
const triple = (name) =>
  element(name, {
    children: ['x', 'y', 'z'].map((axis, i) => element(axis, { text: { type: types.FINITE, at: `${name}.${i}` } })),
  });
const POSE = [triple('rotation'), triple('translation')];

/** @param {'a' | 'b'} name @param {'from' | 'to'} at */
const end = (name, at) => element(name, { min: 1, attributes: [required('idref', types.XML_NAME, at)] });
const ENDS = element('frame', { min: 1, children: [end('a', 'from'), end('b', 'to')] });

const ID = required('id', types.XML_NAME);

/** @param {'world' | 'link' | 'frame'} kind @param {ElementRule[]} [children] */
const frame = (kind, children = []) =>
  element(kind, {
    list: 'frames',
    noun: kind,
    constants: { kind },
    min: kind === 'world' ? 1 : 0,
    max: kind === 'world' ? 1 : MANY,
    attributes: [ID],
    children: [...POSE, ...children],
  });

const IGNORE = element('ignore', {
  list: 'ignores',
  noun: 'ignore',
  max: MANY,
  attributes: [optional('idref', types.XML_NAME)],
});

/** @param {'revolute' | 'prismatic'} type */
const joint = (type) =>
  element(type, {
    list: 'joints',
    noun: type,
    constants: { type },
    max: MANY,
    attributes: [ID],
    children: [
      ENDS,
      ...POSE,
      number('center'),
      element('dh', { min: 1, children: ['d', 'theta', 'a', 'alpha'].map((name) => number(name, 1)) }),
      number('max'),
      number('min'),
      number('offset'),
      element('speed', { text: { type: types.NOT_NEGATIVE, at: 'speed' } }),
      element('wraparound', { record: 'wraparound', absent: () => null }),
    ],
  });

const TRANSFORM = element('transform', {
  list: 'transforms',
  noun: 'transform',
  max: MANY,
  attributes: [ID],
  children: [ENDS, ...POSE],
});

/** The three kinds differ in which arms they can be, not in what their elements mean. */
const KINDS = ['kinematics', 'puma', 'rhino'].map((name) =>
  element(name, {
    children: [
      element('manufacturer', { text: { type: LABEL, at: 'manufacturer' } }),
      element('name', { text: { type: LABEL, at: 'name' } }),
      frame('world'),
      frame('link', [IGNORE]),
      joint('revolute'),
      joint('prismatic'),
      TRANSFORM,
      frame('frame'),
    ],
  }),
);

/** The root, under its two names. @type {ReadonlyMap<string, ElementRule>} */
export const RLKIN_ROOTS = new Map([
  ['rlkin', element('rlkin', { maxChildren: 1, children: KINDS })],
  ['rl', element('rl', { children: [element('kin', { min: 1, maxChildren: 1, children: KINDS })] })],
]);
