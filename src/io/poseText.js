/**
 * A pose as text, as people copy it out of programs and off pendants → its numbers, what the text itself says they are, and
 * in which units. Whatever the text is, reading does not throw; what is not understood is refused with what came.
 *
 * @import { Units } from '../model/document.js'
 *
 * @typedef {'place' | 'wpr' | 'abc' | 'xyzw' | 'wxyz' | 'rotation-vector'} Said
 *
 * @typedef {object} PoseText
 * @property {readonly number[]} numbers  in the order X Y Z, then the orientation; or a matrix as it stands
 * @property {Said | null} said           what the numbers are, where the text says so
 * @property {Partial<Units>} units       likewise
 * @property {string} format              who writes so: a key for words
 *
 * @typedef {{ kind: 'empty' | 'too-long' } | { kind: 'word', word: string } | { kind: 'count', count: number }
 *   | { kind: 'missing', names: string }} PoseTextFault
 */
export const MAX_POSE_TEXT = 4000;
export const POSE_COUNTS = [3, 6, 7, 12, 16];

const NUMBER = '[-+−]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+−]?\\d+)?';
const PLAIN = new RegExp(`^${NUMBER}$`);
const METRES = /** @type {const} */ ({ length: 'm', angle: 'rad' });
const PENDANT = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/**
 * @param {string} text
 * @returns {{ found: PoseText, fault: null } | { found: null, fault: PoseTextFault }}
 */
export function readPoseText(text) {
  if (text.trim() === '') return refused({ kind: 'empty' });
  if (text.length > MAX_POSE_TEXT) return refused({ kind: 'too-long' });
  const clean = text.replace(/[−–]/g, '-').replace(/[\u00a0\u2000-\u200a\u202f]/g, ' ');
  return fromJson(clean) ?? fromRobtarget(clean) ?? fromLabels(clean) ?? fromNumbers(clean);
}

/** @param {PoseTextFault} fault */
const refused = (fault) => /** @type {const} */ ({ found: null, fault });

/** @param {readonly number[]} numbers @param {Said | null} said @param {Partial<Units>} units @param {string} format */
const taken = (numbers, said, units, format) =>
  POSE_COUNTS.includes(numbers.length)
    ? /** @type {const} */ ({ found: { numbers, said, units, format }, fault: null })
    : refused({ kind: 'count', count: numbers.length });

/** @param {string} text */
function fromJson(text) {
  /** @type {unknown} */
  let data;
  try {
    data = JSON.parse(text);
  } catch {
    return null;
  }
  if (typeof data !== 'object' || data === null) return null;
  /** @type {number[]} */
  const numbers = [];
  /** @type {string[]} */
  const names = [];
  /** @param {unknown} value @param {string} name */
  function walk(value, name) {
    if (typeof value === 'number') {
      numbers.push(value);
      names.push(name.toLowerCase());
    } else if (typeof value === 'object' && value !== null) {
      for (const [key, inner] of Object.entries(value)) walk(inner, Array.isArray(value) ? '' : key);
    }
  }
  walk(data, '');
  const named = byNames(names, numbers);
  const { units, convention } = /** @type {{ units?: Partial<Units>, convention?: unknown }} */ (data);
  const said = OWN_NAMES[typeof convention === 'string' ? convention : ''] ?? null;
  return taken(named?.numbers ?? numbers, named?.said ?? said, { ...named?.units, ...knownUnits(units) }, 'json');
}

/** Conventions by the names with which this program copies. @type {Record<string, Said>} */
const OWN_NAMES = {
  'FANUC WPR': 'wpr',
  'KUKA ABC': 'abc',
  'Quaternion xyzw': 'xyzw',
  'Quaternion wxyz': 'wxyz',
  'Rotation vector': 'rotation-vector',
};

/** @param {unknown} units @returns {Partial<Units>} */
function knownUnits(units) {
  const { length, angle } = Object(units);
  return {
    ...(['mm', 'cm', 'm'].includes(length) && { length }),
    ...(['deg', 'rad'].includes(angle) && { angle }),
  };
}

/** ABB: [[x,y,z],[q1,q2,q3,q4],[configuration],[other axes]] @param {string} text */
function fromRobtarget(text) {
  const list = `\\[([^[\\]]*)\\]`;
  const match = new RegExp(`\\[\\s*${list}\\s*,\\s*${list}\\s*,\\s*${list}\\s*,\\s*${list}\\s*\\]`).exec(text);
  if (!match) return null;
  const [place, turn, configuration, axes] = match.slice(1).map((part) => part.split(',').map((one) => one.trim()));
  if ([place, turn, configuration, axes].map(({ length }) => length).join() !== '3,4,4,6') return null;
  const parts = [...place, ...turn];
  const wrong = parts.find((part) => !PLAIN.test(part));
  if (wrong !== undefined) return refused({ kind: 'word', word: wrong });
  return taken(parts.map(Number), 'wxyz', PENDANT, 'abb');
}

/** Names of the numbers in the order in which they are taken, and what they then are. */
const SCHEMES = /** @type {const} */ ([
  { names: ['x', 'y', 'z', 'w', 'p', 'r'], said: 'wpr', units: PENDANT, format: 'fanuc' },
  { names: ['x', 'y', 'z', 'a', 'b', 'c'], said: 'abc', units: PENDANT, format: 'kuka' },
  { names: ['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw'], said: 'xyzw', units: {}, format: 'named' },
  { names: ['x', 'y', 'z', 'q1', 'q2', 'q3', 'q4'], said: 'wxyz', units: PENDANT, format: 'abb' },
  { names: ['x', 'y', 'z', 'roll', 'pitch', 'yaw'], said: 'wpr', units: {}, format: 'named' },
  { names: ['x', 'y', 'z', 'rx', 'ry', 'rz'], said: null, units: {}, format: 'named' },
  { names: ['x', 'y', 'z'], said: 'place', units: {}, format: 'named' },
]);

/** A ROS message names the parts of position and orientation alike. */
const ROS = 'x y z x y z w';

/**
 * @param {readonly string[]} names  in lower case
 * @param {readonly number[]} values
 * @returns {PoseText | null} null if these are no names of a pose
 */
function byNames(names, values) {
  if (names.filter((name) => /^[xyzw]$/.test(name)).join(' ') === ROS) {
    const numbers = values.filter((_, i) => /^[xyzw]$/.test(names[i]));
    return { numbers, said: 'xyzw', units: METRES, format: 'ros' };
  }
  const scheme = SCHEMES.find((one) => one.names.every((name) => names.includes(name)));
  if (!scheme) return null;
  const numbers = scheme.names.map((name) => values[names.indexOf(name)]);
  return { ...scheme, numbers };
}

/** X = 450 mm, {X 450, Y 100, …}, "x: 0.45": a name before each number. @param {string} text */
function fromLabels(text) {
  const pairs = [...text.matchAll(new RegExp(`(?<![\\w.])([A-Za-z]\\w*)"?'?\\s*[:=]?\\s*(${NUMBER})(?![\\w.])`, 'g'))];
  const names = pairs.map(([, name]) => name.toLowerCase());
  if (!names.includes('x') || !names.includes('y')) return null;
  const found = byNames(names, pairs.map(([, , value]) => Number(value))); // prettier-ignore
  if (!found) return refused({ kind: 'missing', names: pairs.map(([, name]) => name).join(' ') });
  return taken(found.numbers, found.said, { ...found.units, ...unitsIn(text) }, found.format);
}

/** What the text says of its units: "in mm", "450 mm", "deg". @param {string} text @returns {Partial<Units>} */
function unitsIn(text) {
  const length = /(?<=[\d\s,;(\]])(mm|cm|m)(?=[\s,;)\].}]|$)/.exec(text)?.[1];
  const angle = /(?<=[\d\s,;(\]])(deg|degrees|rad|radians|°)(?![A-Za-z])/.exec(text)?.[1];
  return {
    ...(length && { length: /** @type {Units['length']} */ (length) }),
    ...(angle && { angle: angle.startsWith('rad') ? 'rad' : 'deg' }),
  };
}

/** Numbers alone: CSV, a matrix of numpy or MATLAB, p[…] of Universal Robots. @param {string} text */
function fromNumbers(text) {
  const ur = /\bp\[([^\]]*)\]/.exec(text);
  const units = ur ? METRES : unitsIn(text);
  const bare = (ur ? ur[1] : text)
    .replace(/^\s*(#|%|\/\/).*$/gm, ' ') // comments, and what follows numbers in a line
    .replace(/(#|%|\/\/).*$/gm, ' ')
    .replace(/\b(import .*|dtype\s*=\s*[\w.]+)/g, ' ')
    .replace(/\b[A-Za-z_]\w*\s*=(?!=)/g, ' ')
    .replace(/\b(np|numpy|sp|sympy|torch)\./g, '')
    .replace(/\b(array|matrix|asarray|Matrix|tensor|SE3|Pose)\s*\(/g, ' ');
  // a line that begins with a word is a heading, if others are none
  const numeric = bare.split('\n').filter((line) => !/^\s*[A-Za-z_]/.test(line) || /^\s*(nan|inf)\b/i.test(line));
  const cells = withoutUnits(numeric.some((line) => /\d/.test(line)) ? numeric.join('\n') : bare);
  const parts = (hasDecimalCommas(cells) ? cells.replace(/,/g, '.').split(/[\s;]+/) : cells.split(/[\s,;|&()[\]{}]+/))
    .map((part) => part.trim())
    .filter(Boolean);
  const wrong = parts.find((part) => !PLAIN.test(part) || !Number.isFinite(Number(part)));
  if (wrong !== undefined) return refused({ kind: 'word', word: wrong.slice(0, 40) });
  const own = Object.entries(OWN_NAMES).find(([name]) => text.includes(name))?.[1] ?? null;
  const said = ur && parts.length === 6 ? 'rotation-vector' : own;
  return taken(parts.map(Number), said, units, ur ? 'ur' : 'numbers');
}

/** @param {string} text */
const withoutUnits = (text) => text.replace(/(?<=[\d\s])(mm|cm|m|deg|degrees|rad|radians)(?![A-Za-z])|°/g, ' ');

/** "450,5; 100; 0": a comma between digits, other signs between numbers, no point anywhere. @param {string} text */
const hasDecimalCommas = (text) =>
  !/[.[\]]/.test(text) &&
  /\d,\d/.test(text) &&
  text
    .split(/[;\s]+/)
    .filter(Boolean)
    .every((part) => /^[-+]?\d+(,\d+)?$/.test(part)) &&
  /[;\s]/.test(text.trim());
