/**
 * Types of KAREL as values, and what may be put where.
 *
 * @typedef {object} Type
 * @property {'INTEGER' | 'REAL' | 'BOOLEAN' | 'STRING' | 'VECTOR' | 'CONFIG' | 'POSITION' | 'XYZWPR' | 'XYZWPREXT' | 'JOINTPOS'
 *   | 'FILE' | 'BYTE' | 'SHORT' | 'STRUCTURE' | 'ARRAY' | 'PATH' | 'OPAQUE' | 'UNKNOWN' | 'NOTHING'} kind
 * @property {string} [name]            of a structure or an opaque type
 * @property {number} [length]          of a string
 * @property {readonly number[]} [sizes]  of an array; none where any will do
 * @property {Type} [of]
 * @property {ReadonlyMap<string, Type>} [fields]  by name in capitals
 * @property {Type | null} [node]       of a path
 * @property {Type | null} [header]
 */

/** @param {Type['kind']} kind @returns {Type} */
const plain = (kind) => Object.freeze({ kind });

export const INTEGER = plain('INTEGER');
export const REAL = plain('REAL');
export const BOOLEAN = plain('BOOLEAN');
export const STRING = plain('STRING');
export const VECTOR = plain('VECTOR');
export const CONFIG = plain('CONFIG');
export const POSITION = plain('POSITION');
export const XYZWPR = plain('XYZWPR');
export const XYZWPREXT = plain('XYZWPREXT');
export const JOINTPOS = plain('JOINTPOS');
export const FILE = plain('FILE');
/** Of what nobody knows: it goes with everything, so that one fault is told once. */
export const UNKNOWN = plain('UNKNOWN');
/** Of a routine that gives no value. */
export const NOTHING = plain('NOTHING');

const OPAQUE =
  'GROUP_ASSOC COMMON_ASSOC CAM_SETUP MODEL VIS_PROCESS QUEUE_TYPE DISP_DAT_T COL_DESC_T XWORK_T AXISPOS'.split(' ');
export const OPAQUE_TYPES = new Set(OPAQUE);

/** What a node of a PATH is where nobody says more. Of its fields public programs confirm NODE_POS; the others are not verified. @type {Type} */
const STD_PTH_NODE = {
  kind: 'STRUCTURE',
  name: 'STD_PTH_NODE',
  fields: new Map([
    ['NODE_POS', POSITION],
    ['GROUP_DATA', { kind: 'OPAQUE', name: 'GROUP_ASSOC' }],
    ['COMMON_DATA', { kind: 'OPAQUE', name: 'COMMON_ASSOC' }],
  ]),
};

/** @type {Readonly<Record<string, Type>>} */
export const NAMED_TYPES = {
  ...{ INTEGER, REAL, BOOLEAN, STRING, VECTOR, CONFIG, POSITION, XYZWPR, XYZWPREXT, JOINTPOS, FILE },
  ...{ BYTE: plain('BYTE'), SHORT: plain('SHORT'), PATH: { kind: 'PATH', node: null, header: null } },
  STD_PTH_NODE,
  ...Object.fromEntries(Array.from({ length: 9 }, (_, i) => [`JOINTPOS${i + 1}`, JOINTPOS])),
};

const POSITIONS = new Set(['POSITION', 'XYZWPR', 'XYZWPREXT', 'JOINTPOS']);

/** @param {Type} type */
export const isWhole = ({ kind }) => kind === 'INTEGER' || kind === 'BYTE' || kind === 'SHORT';
/** @param {Type} type */
export const isNumber = (type) => isWhole(type) || type.kind === 'REAL';
/** @param {Type} type */
export const isPosition = ({ kind }) => POSITIONS.has(kind);
/** @param {Type} type */
export const isUnknown = ({ kind }) => kind === 'UNKNOWN' || kind === 'OPAQUE';

/** Whether a value of one type may be assigned to a variable of the other. @param {Type} from @param {Type} to @returns {boolean} */
export function fits(from, to) {
  if (isUnknown(from) || isUnknown(to)) return true;
  if (isNumber(from) && to.kind === 'REAL') return true;
  if (isWhole(from) && isWhole(to)) return true;
  if (isPosition(from) && isPosition(to)) return true;
  if (from.kind !== to.kind) return false;
  if (from.kind === 'STRUCTURE') return from.name === to.name;
  if (from.kind !== 'ARRAY') return true;
  const [a, b] = [flattened(from), flattened(to)];
  const isOpen = a.sizes.length === 0 || b.sizes.length === 0;
  return (isOpen || a.sizes.length === b.sizes.length) && fits(a.of, b.of);
}

/** An array of arrays is one with more dimensions. @param {Type} type @returns {{ sizes: readonly number[], of: Type }} */
export function flattened({ sizes = [], of = UNKNOWN }) {
  if (of.kind !== 'ARRAY' || sizes.length === 0) return { sizes, of };
  const inner = flattened(of);
  return { sizes: [...sizes, ...inner.sizes], of: inner.of };
}

/** @param {Type} type @returns {string} */
export function typeText(type) {
  if (type.kind === 'ARRAY')
    return `ARRAY${type.sizes?.length ? `[${type.sizes.map((size) => size || '*').join(', ')}]` : ''} OF ${typeText(type.of ?? UNKNOWN)}`;
  if (type.kind === 'STRING' && type.length) return `STRING[${type.length}]`;
  return (type.kind === 'STRUCTURE' || type.kind === 'OPAQUE') && type.name ? type.name : type.kind;
}

/** How many values a variable holds; of a path, its header and a node. Infinity: it holds itself. @param {Type} type @param {Map<Type, number>} [known] @returns {number} */
export function countOf(type, known = new Map()) {
  const before = known.get(type);
  if (before !== undefined) return before;
  known.set(type, Infinity); // until it is counted: whoever comes back to it holds itself
  const { kind, sizes = [], of = UNKNOWN, fields, node, header } = type;
  const parts = kind === 'STRUCTURE' ? [...(fields?.values() ?? [])] : [node, header];
  const sum = parts.reduce((total, part) => total + (part ? countOf(part, known) : 0), 0);
  const count =
    kind === 'ARRAY' ? sizes.reduce((product, size) => product * size, 1) * countOf(of, known) : Math.max(1, sum);
  known.set(type, count);
  return count;
}

const VECTOR_FIELDS = Object.fromEntries(['X', 'Y', 'Z'].map((name) => [name, REAL]));
const XYZWPR_FIELDS = { ...Object.fromEntries([...'XYZWPR'].map((name) => [name, REAL])), CONFIG_DATA: CONFIG };

/** @type {Partial<Record<Type['kind'], Readonly<Record<string, Type>>>>} */
const FIELDS = {
  VECTOR: VECTOR_FIELDS,
  XYZWPR: XYZWPR_FIELDS,
  XYZWPREXT: { ...XYZWPR_FIELDS, EXT1: REAL, EXT2: REAL, EXT3: REAL },
  POSITION: { NORMAL: VECTOR, ORIENT: VECTOR, APPROACH: VECTOR, LOCATION: VECTOR, CONFIG_DATA: CONFIG },
  CONFIG: {
    ...{ CFG_TURN_NO1: INTEGER, CFG_TURN_NO2: INTEGER, CFG_TURN_NO3: INTEGER },
    ...{ CFG_FLIP: BOOLEAN, CFG_LEFT: BOOLEAN, CFG_UP: BOOLEAN, CFG_FRONT: BOOLEAN },
  },
};

/** The type of a field, or null if there is none. @param {Type} type @param {string} name @returns {Type | null} */
export function fieldOf(type, name) {
  const upper = name.toUpperCase();
  if (isUnknown(type)) return UNKNOWN;
  if (type.kind === 'STRUCTURE') return type.fields?.get(upper) ?? null;
  if (type.kind === 'PATH') return type.header ? fieldOf(type.header, name) : null;
  const fields = FIELDS[type.kind];
  return fields && Object.hasOwn(fields, upper) ? fields[upper] : null;
}
