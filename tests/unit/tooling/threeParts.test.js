/** The build leaves out what no material of the scene compiles: is that so, and still so with the next version of Three.js? */
import { readFileSync, readdirSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { UNUSED, usedLines } from '../../../scripts/threeParts.mjs';

const ROOT = new URL('../../../', import.meta.url);
const three = readFileSync(new URL('node_modules/three/build/three.module.js', ROOT), 'utf8');

const lines = (/** @type {string[]} */ ...all) => all.join('\n');

describe('lines of a shader', () => {
  test('of an unused feature are left out, what stands for its absence stays', () => {
    const shader = lines('a', '#ifdef USE_FOG', 'b', '#ifdef OTHER', 'c', '#endif', '#else', 'd', '#endif', 'e');
    expect(usedLines(shader)).toBe(lines('a', 'd', 'e'));
    expect(usedLines(lines('#ifndef USE_FOG', 'a', '#else', 'b', '#endif'))).toBe('a');
    expect(usedLines(lines('#if defined( USE_MAP )', 'a', '#endif', '#if NUM_POINT_LIGHTS > 0', 'b', '#endif'))).toBe(
      '',
    );
  });
  test('of anything else stay as they are', () => {
    for (const shader of [
      lines('#ifdef USE_SHADOWMAP', 'a', '#else', 'b', '#endif'),
      lines('#if defined( USE_FOG ) || defined( OTHER )', 'a', '#endif'),
      lines('#ifdef USE_FOG', 'a', '#elif defined( OTHER )', 'b', '#else', 'c', '#endif'),
      lines('#if NUM_DIR_LIGHTS > 0', 'a', '#endif'),
    ]) {
      expect(usedLines(shader)).toBe(shader);
    }
  });
  test('that are not closed are refused', () => {
    expect(() => usedLines('#ifdef USE_FOG')).toThrow('never closed');
  });
});

test('Three.js knows every feature by the name it is left out by', () => {
  expect(UNUSED.filter((name) => !new RegExp(`\\b${name}\\b`).test(three))).toEqual([]);
});

test('the scene switches none of them on', () => {
  const sources = readdirSync(new URL('src/render', ROOT), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.js'))
    .map((name) => readFileSync(new URL(`src/render/${name}`, ROOT), 'utf8'));
  expect(sources.length).toBeGreaterThan(50);
  const switches = [
    /\b(map|\w+Map|fog|transmission|sheen|clearcoat|iridescence|anisotropy|dispersion|alphaHash|morph\w*|clippingPlanes)\s*[:=][^=]/,
    /\b(SkinnedMesh|BatchedMesh|Mesh(Physical|Toon|Phong|Matcap|Normal)Material|(Point|Spot|RectArea)Light|LightProbe\w*|Fog(Exp2)?)\b/,
  ];
  const found = sources.flatMap((text) => switches.map((wanted) => wanted.exec(text)?.[0])).filter(Boolean);
  expect(found).toEqual([]);
});
