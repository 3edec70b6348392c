/**
 * The positions behind /POS: `P[1:"label"]{ … };`, each over several lines.
 *
 * @import { TpGroup, TpPositionPart, TpValue } from './tree.js'
 */

/** The line that begins one. */
export const POSITION = /^\s*P\[\s*(\d+)\s*(?::\s*"([^"]*)"\s*)?\]\s*\{/;

const GROUP = /GP(\d)\s*:/y;
const FRAMES = /UF\s*:\s*(F|\d+)\s*,\s*UT\s*:\s*(F|\d+)\s*,?/y;
const CONFIGURATION = /CONFIG\s*:\s*'([^']*)'\s*,?/y;
const VALUE = /([XYZWPR]|[JE]\d)\s*=\s*(\*+|-?\d*\.?\d+|-?\d+\.)\s*(mm|deg)\s*,?/y;
const SPACE = /\s+/y;

/**
 * @param {string} text  of the whole position
 * @returns {{ position: TpPositionPart | null, at: number }} null, and where what was not understood begins
 */
export function readPosition(text) {
  const head = /** @type {RegExpExecArray} */ (POSITION.exec(text));
  const end = text.lastIndexOf('}');
  /** @type {TpGroup[]} */
  const groups = [];
  /** @type {TpGroup & { values: TpValue[] } | null} */
  let group = null;
  let at = head[0].length;
  const take = (/** @type {RegExp} */ pattern) => {
    pattern.lastIndex = at;
    const match = pattern.exec(text);
    if (match) at = pattern.lastIndex;
    return match;
  };
  while (at < end) {
    if (take(SPACE)) continue;
    const first = take(GROUP);
    if (first) {
      group = { group: Number(first[1]), userFrame: 'F', toolFrame: 'F', values: [] };
      groups.push(group);
      continue;
    }
    if (!group) return { position: null, at };
    const frames = take(FRAMES);
    const configuration = frames ? null : take(CONFIGURATION);
    const value = frames || configuration ? null : take(VALUE);
    if (frames) [group.userFrame, group.toolFrame] = frames.slice(1).map((one) => (one === 'F' ? 'F' : Number(one)));
    else if (configuration) group.configuration = configuration[1].trim();
    else if (value) {
      const [, name, digits, unit] = value;
      group.values.push({
        name,
        value: digits.startsWith('*') ? null : Number(digits),
        unit: /** @type {'mm' | 'deg'} */ (unit),
      });
    } else return { position: null, at };
  }
  const label = head[2];
  return {
    position: { kind: 'position', number: Number(head[1]), ...(label !== undefined && { label }), groups },
    at: -1,
  };
}

/** Joint values by their names in the order of the axes, null for one that is not there; null where it is Cartesian. @param {TpGroup} group @returns {(number | null)[] | null} */
export function jointValues({ values }) {
  const joints = values.filter(({ name }) => /^J\d/.test(name));
  const named = (/** @type {string} */ name) => joints.find((one) => one.name === name)?.value ?? null;
  return joints.length === 0 ? null : joints.map((_, i) => named(`J${i + 1}`));
}

/** X Y Z W P R, or null where one is missing. @param {TpGroup} group @returns {(number | null)[] | null} */
export function cartesianValues({ values }) {
  const found = [...'XYZWPR'].map((name) => values.find((value) => value.name === name));
  return found.every((value) => value !== undefined) ? found.map((value) => value?.value ?? null) : null;
}
