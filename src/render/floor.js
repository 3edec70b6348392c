/**
 * The floor: a grid of two steps that one shader draws sharp at any distance and fades out, and a plane that takes nothing
 * but shadows. The sky is the page's: the canvas is transparent.
 *
 * @import { Skin } from './skins.js'
 */
import { Color, DoubleSide, Group, Mesh, PlaneGeometry, ShaderMaterial, ShadowMaterial } from 'three';
import { roundStep } from '../model/roundStep.js';

/** How many small squares the arm's size is about. */
const SQUARES = 17;

/**
 * The steps of a grid for an arm of this size.
 * @example
 * gridSteps(1.69) // → { minor: 0.1, major: 0.5 }
 * @param {number} size metres
 * @returns {{ minor: number, major: number }}
 */
export function gridSteps(size) {
  const { digit, exponent, step } = roundStep(size / SQUARES);
  return { minor: step, major: Number(`${digit === 5 ? 20 : 5 * digit}e${exponent}`) };
}

const VERTEX = `varying vec2 place;
void main() {
  vec4 world = modelMatrix * vec4(position, 1.0);
  place = world.xy;
  gl_Position = projectionMatrix * viewMatrix * world;
}`;

// The colours are already the screen's: what turns light into them would be most of the work, at each of half the picture's pixels.
const FRAGMENT = `varying vec2 place;
uniform float minorStep, majorStep, extent, minorOpacity, majorOpacity;
uniform vec2 middle;
uniform vec3 minorColour, majorColour;
float lines(vec2 pixel, float gridStep, float width) {
  vec2 off = abs(fract(place / gridStep - 0.5) - 0.5) * gridStep / pixel;
  float line = 1.0 - smoothstep(0.0, width, min(off.x, off.y));
  return line * (1.0 - smoothstep(0.25 * gridStep, 0.6 * gridStep, max(pixel.x, pixel.y)));
}
void main() {
  vec2 pixel = fwidth(place);
  float fade = 1.0 - smoothstep(extent * 0.35, extent, length(place - middle));
  float minorLine = lines(pixel, minorStep, 1.1) * minorOpacity, majorLine = lines(pixel, majorStep, 1.3) * majorOpacity;
  gl_FragColor = vec4(mix(minorColour, majorColour, step(minorLine, majorLine)), max(minorLine, majorLine) * fade);
  if (gl_FragColor.a < 0.002) discard;
}`;

/** @param {{ skin: Skin, isLow: boolean }} options */
export function createFloor({ skin, isLow }) {
  const group = new Group();
  const plane = new PlaneGeometry(2, 2);
  const uniforms = {
    minorStep: { value: 1 },
    majorStep: { value: 5 },
    extent: { value: 1 },
    middle: { value: [0, 0] },
    minorOpacity: { value: 1 },
    majorOpacity: { value: 1 },
    minorColour: { value: new Color() },
    majorColour: { value: new Color() },
  };
  const gridMaterial = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    uniforms,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
  });
  const grid = new Mesh(plane, gridMaterial);
  grid.renderOrder = -1;
  group.add(grid);
  const shadowMaterial = new ShadowMaterial({ color: '#05080D', depthWrite: false });
  const shadow = new Mesh(plane, shadowMaterial);
  shadow.receiveShadow = true;
  shadow.renderOrder = -2;
  if (!isLow) group.add(shadow);

  /** @param {Skin} next */
  function setSkin(next) {
    shadowMaterial.opacity = next.shadow;
    uniforms.minorColour.value.set(next.gridMinor).convertLinearToSRGB();
    uniforms.majorColour.value.set(next.gridMajor).convertLinearToSRGB();
    uniforms.minorOpacity.value = next.gridMinorOpacity;
    uniforms.majorOpacity.value = next.gridMajorOpacity;
  }
  setSkin(skin);

  return {
    group,
    setSkin,
    /**
     * @param {{ minor: number, major: number }} steps
     * @param {number} extent  where the grid has faded out, from the middle
     * @param {readonly [number, number, number]} middle
     */
    lay({ minor, major }, extent, [x, y, z]) {
      uniforms.minorStep.value = minor;
      uniforms.majorStep.value = major;
      uniforms.extent.value = extent;
      uniforms.middle.value = [x, y];
      for (const mesh of [grid, shadow]) {
        mesh.scale.set(extent, extent, 1);
        mesh.position.set(x, y, z);
      }
    },
    dispose() {
      plane.dispose();
      gridMaterial.dispose();
      shadowMaterial.dispose();
    },
  };
}
