/**
 * Every query parameter the page understands, from one schema; docs/embedding.md lists them for people. A bad or unknown
 * one is a warning, never a broken page: any text after the question mark gives values and a list of what was refused.
 *
 * @import { AngleUnit, LengthUnit, Units } from '../model/document.js'
 * @import { FramesShown, Panel, Session } from '../model/session.js'
 *
 * @typedef {'one' | 'some' | 'units' | 'numbers'} Kind  one of the values, several of them, one of each quantity, numbers
 * @typedef {Panel | 'pose' | 'bar'} Room  what can stand beside the view
 *
 * @typedef {object} Refused
 * @property {'not-understood' | 'twice' | 'unknown'} why
 * @property {string} name
 * @property {string} text
 * @property {Kind} [kind]
 * @property {readonly string[]} [values]
 * @property {string | null} [initial]  what is used in its place, where that can be named
 */
import { ANGLE_UNITS, LARGEST_NUMBER, LENGTH_UNITS } from '../model/documentRules.js';
import { FIRST_ROBOT, LIBRARY_IDS } from '../model/shelf.js';

/**
 * @template T
 * @typedef {object} Parameter
 * @property {T} initial
 * @property {(text: string) => T | undefined} read  undefined when the text is not acceptable
 * @property {Kind} kind
 * @property {readonly string[]} values  what may be written, where that can be listed
 * @property {string} help
 */

/** More than any arm has; a longer list is not even read. */
const MOST_NUMBERS = 64;
const MOST_ROOMS = 20;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/** @type {readonly Exclude<Room, 'bar'>[]} */
const ROOMS = ['robot', 'program', 'code', 'workspace', 'jacobian', 'jog', 'pose', 'aim'];

/**
 * @template {string} Value
 * @template {Value | null} Initial
 * @param {readonly Value[]} values
 * @param {Initial} initial
 * @param {string} help
 * @returns {Parameter<Value | Initial>}
 */
const oneOf = (values, initial, help) => ({
  ...{ initial, help, kind: 'one', values },
  read: (text) => values.find((value) => value === text),
});

export const SCHEMA = {
  robot: oneOf(LIBRARY_IDS, FIRST_ROBOT, 'The robot to begin with, by its id.'),
  q: /** @type {Parameter<readonly number[] | null>} */ ({
    ...{ initial: null, kind: 'numbers', values: [] },
    read: readNumbers,
    help: 'Joint values in the units of the document, with commas between; none: home.',
  }),
  units: /** @type {Parameter<Partial<Units> | null>} */ ({
    ...{ initial: null, kind: 'units', values: [...LENGTH_UNITS, ...ANGLE_UNITS] },
    read: readUnits,
    help: 'Units that the robot is converted to: a length, an angle or both, as in mm,deg.',
  }),
  panels: /** @type {Parameter<readonly Room[] | null>} */ ({
    ...{ initial: null, kind: 'some', values: [...ROOMS, 'view', 'all', 'none'] },
    read: readRooms,
    help: 'What stands beside the view; the first of them is open. none: the view alone, without the bar.',
  }),
  view: oneOf(
    /** @type {const} */ (['iso', 'front', 'back', 'left', 'right', 'top', 'bottom']),
    'iso',
    'From where the arm is seen at first; iso: from front right.',
  ),
  projection: oneOf(
    /** @type {readonly Session['projection'][]} */ (['perspective', 'parallel']),
    'perspective',
    'How the arm is drawn; parallel: orthographic.',
  ),
  frames: oneOf(
    /** @type {readonly FramesShown[]} */ (['none', 'ends', 'row', 'all']),
    'ends',
    'Which frames are drawn; ends: base and tool, row: the two of the row that is selected.',
  ),
  trace: oneOf(
    /** @type {const} */ (['off', 'on']),
    'off',
    'on: a line is drawn of where the tool has been, from the beginning.',
  ),
  theme: oneOf(
    /** @type {const} */ (['auto', 'light', 'dark']),
    null,
    'Colours; auto follows the system, none the last choice.',
  ),
  hint: oneOf(/** @type {const} */ (['on', 'off']), 'on', 'off: no hint at the first visit.'),
  autosave: oneOf(
    /** @type {const} */ (['on', 'off']),
    'on',
    'off: the work is not kept in the browser for the next visit, nor is earlier work offered.',
  ),
  quality: oneOf(
    /** @type {const} */ (['high', 'low']),
    'high',
    'low draws without shadows and antialiasing: for slow machines and tests.',
  ),
  clock: oneOf(
    /** @type {const} */ (['browser', 'manual']),
    'browser',
    'manual: nothing moves until denavit.clock.tick(seconds) is called. For tests.',
  ),
};

/** @param {string} text */
function readNumbers(text) {
  const parts = text.split(',', MOST_NUMBERS + 1).map((part) => part.trim().replace('\u2212', '-'));
  if (parts.length > MOST_NUMBERS || !parts.every((part) => NUMBER.test(part))) return undefined;
  const numbers = parts.map((part) => Number(part) + 0); // and no -0
  return numbers.every((number) => Math.abs(number) <= LARGEST_NUMBER) ? numbers : undefined;
}

/** @param {string} text @returns {Partial<Units> | undefined} */
function readUnits(text) {
  /** @type {{ length?: LengthUnit, angle?: AngleUnit }} */
  const units = {};
  for (const part of text.split(',', 3)) {
    const [length, angle] = [asOne(LENGTH_UNITS, part), asOne(ANGLE_UNITS, part)];
    if (length && !units.length) units.length = length;
    else if (angle && !units.angle) units.angle = angle;
    else return undefined;
  }
  return units;
}

/** @param {string} text @returns {readonly Room[] | undefined} */
function readRooms(text) {
  const parts = text.split(',', MOST_ROOMS + 1);
  if (parts.length > MOST_ROOMS) return undefined;
  if (parts.length === 1 && parts[0] === 'none') return [];
  /** @type {Set<Room>} */
  const rooms = new Set();
  for (const part of parts) {
    const room = asOne(ROOMS, part);
    if (room) rooms.add(room);
    else if (part === 'all') ROOMS.forEach((other) => rooms.add(other));
    else if (part !== 'view') return undefined;
  }
  return [...rooms, 'bar'];
}

/** @template {string} Value @param {readonly Value[]} values @param {string} text */
const asOne = (values, text) => values.find((value) => value === text.trim());

/**
 * @template {Record<string, Parameter<unknown>>} Schema
 * @param {string} search  as in location.search
 * @param {Schema} schema
 * @returns {{ values: { [K in keyof Schema]: Schema[K]['initial'] }, refused: Refused[] }}
 */
export function readQueryParameters(search, schema) {
  /** @type {Refused[]} */
  const refused = [];
  const given = new URLSearchParams(search);
  const values = Object.fromEntries(
    Object.entries(schema).map(([name, { initial, read, kind, values }]) => {
      const texts = given.getAll(name);
      if (texts.length === 0) return [name, initial];
      const value = read(texts[0]);
      if (value === undefined) {
        const instead = initial === null ? null : String(initial);
        refused.push({ why: 'not-understood', name, text: texts[0], kind, values, initial: instead });
      }
      if (texts.length > 1) refused.push({ why: 'twice', name, text: texts[0] });
      return [name, value === undefined ? initial : value];
    }),
  );
  for (const name of new Set(given.keys())) {
    if (!Object.hasOwn(schema, name)) refused.push({ why: 'unknown', name, text: given.get(name) ?? '' });
  }
  return { values: /** @type {{ [K in keyof Schema]: Schema[K]['initial'] }} */ (values), refused };
}
