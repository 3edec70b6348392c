/**
 * The parts of Three.js's shaders that the scene uses: when the page is built, what stands between `#ifdef USE_X` and its `#endif`
 * is left out for every feature below, none of which a material of the scene switches on. A shader compiler would skip the same lines,
 * so the picture is the same; the first load is some kilobytes lighter. A test holds the list against the sources.
 *
 * @import { Plugin } from 'vite'
 */

/** What a map of each kind, and each other feature, defines when it is there. */
export const UNUSED = [
  ...['MAP', 'ALPHAMAP', 'AOMAP', 'BUMPMAP', 'DISPLACEMENTMAP', 'EMISSIVEMAP', 'ENVMAP', 'GRADIENTMAP', 'LIGHTMAP'],
  ...['METALNESSMAP', 'ROUGHNESSMAP', 'SPECULARMAP', 'NORMALMAP', 'NORMALMAP_OBJECTSPACE', 'NORMALMAP_TANGENTSPACE'],
  ...['ALPHAHASH', 'ANISOTROPY', 'ANISOTROPYMAP', 'BATCHING', 'BATCHING_COLOR', 'CLEARCOAT', 'CLEARCOATMAP'],
  ...['CLEARCOAT_NORMALMAP', 'CLEARCOAT_ROUGHNESSMAP', 'DISPERSION', 'FOG', 'INSTANCING_MORPH', 'IRIDESCENCE'],
  ...['IRIDESCENCEMAP', 'IRIDESCENCE_THICKNESSMAP', 'MORPHCOLORS', 'MORPHNORMALS', 'MORPHTARGETS', 'SHEEN'],
  ...['SHEEN_COLORMAP', 'SHEEN_ROUGHNESSMAP', 'SKINNING', 'SPECULAR_COLORMAP', 'SPECULAR_INTENSITYMAP'],
  ...['THICKNESSMAP', 'TRANSMISSION', 'TRANSMISSIONMAP'],
].map((name) => `USE_${name}`);

/** Counts that are 0 in the scene. */
const NONE = [
  'NUM_LIGHT_PROBE_GRIDS',
  'NUM_CLIPPING_PLANES',
  'NUM_RECT_AREA_LIGHTS',
  'NUM_POINT_LIGHTS',
  'NUM_SPOT_LIGHTS',
];

/**
 * Whether the lines of a condition are ever compiled; null where that depends.
 * @param {string} line  a directive that opens a condition
 * @returns {boolean | null}
 */
function isMet(line) {
  const [, word, name] = /^#(ifdef|ifndef)\s+(\w+)\s*$/.exec(line) ?? [];
  if (word) return UNUSED.includes(name) ? word === 'ifndef' : null;
  const [, only] = /^#if\s+defined\s*\(\s*(\w+)\s*\)\s*$/.exec(line) ?? [];
  if (only) return UNUSED.includes(only) ? false : null;
  const [, count] = /^#if\s+\(?\s*(\w+)\s*>\s*0\s*\)?\s*$/.exec(line) ?? [];
  return count && NONE.includes(count) ? false : null;
}

/**
 * @param {string} shader
 * @returns {string} without the lines that no material of the scene compiles
 */
export function usedLines(shader) {
  const lines = shader.split('\n');
  const inChains = chained(lines);
  /** @type {{ met: boolean | null, isIn: boolean }[]} */
  const open = [];
  const kept = lines.filter((line, i) => {
    const directive = line.trim();
    const inner = open[open.length - 1];
    let isDecided = false;
    if (directive.startsWith('#if')) {
      const met = inChains.has(i) ? null : isMet(directive);
      isDecided = met !== null;
      open.push({ met, isIn: met !== false });
    } else if (directive.startsWith('#else')) {
      isDecided = inner.met !== null;
      if (isDecided) inner.isIn = !inner.met;
    } else if (directive.startsWith('#endif')) {
      isDecided = open.pop()?.met !== null;
    }
    return !isDecided && open.every(({ isIn }) => isIn);
  });
  if (open.length > 0) throw new Error('A condition of a shader is never closed.');
  return kept.join('\n');
}

/** The lines at which conditions with an `#elif` begin: those are left as they are. @param {readonly string[]} lines */
function chained(lines) {
  /** @type {number[]} */
  const open = [];
  const found = new Set();
  lines.forEach((line, i) => {
    const directive = line.trim();
    if (directive.startsWith('#if')) open.push(i);
    else if (directive.startsWith('#elif')) found.add(open[open.length - 1]);
    else if (directive.startsWith('#endif')) open.pop();
  });
  return found;
}

/** A shader's text among the module's constants. */
const SHADER = /^((?:const|var) \w+ = )("(?:[^"\\]|\\.)*")(;)$/gm;

/** @returns {Plugin} */
export const threeParts = () => ({
  name: 'three-parts',
  apply: 'build',
  transform(code, id) {
    if (!/[\\/]three[\\/]build[\\/]three\.module\.js$/.test(id)) return null;
    const lean = code.replace(SHADER, (whole, before, text, after) =>
      text.includes('#if') ? `${before}${JSON.stringify(usedLines(JSON.parse(text)))}${after}` : whole,
    );
    return { code: lean, map: null };
  },
});
