/**
 * The volume that can be reached, as graphics memory wants it: the surface of the cubes as it came, with a colour for each corner
 * (the mean of its sides), or places as points with the colour of their cube. Made in pieces, since there may be many.
 *
 * @import { Skin } from '../skins.js'
 * @import { VolumeMap } from '../../model/workspace/mapped.js'
 * @import { WorkspaceView } from '../../model/workspace/workspaceView.js'
 */
import {
  BufferAttribute,
  BufferGeometry,
  FrontSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
  Sphere,
  Vector3,
} from 'three';
import { cubeOf, reachValues } from '../../model/workspace/reachValues.js';
import { disposeOf } from '../fatLines.js';
import { plainRamp, rampOf, stepOf } from './reachColours.js';

/** After arm, obstacles and ghosts, before traces and frames. */
const ORDER = 12;

const SIDES_AT_ONCE = 8_000;
const POINTS_AT_ONCE = 10_000;

/** Pixels of a point. */
const POINT = 2;

/** @param {VolumeMap} map @param {WorkspaceView} view @param {Skin} skin */
function colouring({ cubes, summary, hasValues }, { colour }, skin) {
  const isKnown = hasValues || colour === 'height';
  const values = cubes && summary && isKnown ? reachValues(cubes, summary, colour) : null;
  return { values, table: values ? rampOf(skin.ramp) : plainRamp(skin.obstacle) };
}

/**
 * Where it is, so that the renderer need not look at every corner to know.
 * @param {BufferGeometry} geometry
 * @param {VolumeMap['summary']} summary
 */
function placed(geometry, summary) {
  const [low, high] = [new Vector3(...(summary?.low ?? [0, 0, 0])), new Vector3(...(summary?.high ?? [0, 0, 0]))];
  geometry.boundingSphere = new Sphere(low.clone().add(high).multiplyScalar(0.5), low.distanceTo(high) / 2);
}

/** @param {Group} group */
function remove(group) {
  group.removeFromParent();
  for (const part of group.children) disposeOf(/** @type {Mesh} */ (part));
}

/** @typedef {(group: Group, remove: () => void, fade: (opacity: number) => void) => void} Done  what is drawn, and what can be done with it */

/**
 * @param {VolumeMap} map
 * @param {WorkspaceView} view
 * @param {Skin} skin
 * @param {Done} done
 * @returns {Generator<void, void>}
 */
export function* solidOf(map, view, skin, done) {
  const { surface } = map;
  if (!surface) return;
  const { corners, triangles, cubes } = surface;
  const { values, table } = colouring(map, view, skin);
  const sums = new Float32Array(corners.length);
  const counts = new Uint8Array(corners.length / 3);
  for (let side = 0; side < cubes.length; side++) {
    if (side % SIDES_AT_ONCE === SIDES_AT_ONCE - 1) yield;
    const at = values ? stepOf(values, cubes[side]) : 0;
    // two triangles a side, a b c and a c d
    for (const k of [0, 1, 2, 5]) {
      const corner = triangles[6 * side + k];
      counts[corner]++;
      for (let channel = 0; channel < 3; channel++) sums[3 * corner + channel] += table[at + channel];
    }
  }
  const colours = new Uint16Array(corners.length);
  const isLarge = cubes.length > SIDES_AT_ONCE;
  if (isLarge) yield;
  for (let k = 0; k < colours.length; k++) colours[k] = sums[k] / counts[Math.floor(k / 3)];
  if (isLarge) yield;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3, true));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  placed(geometry, map.summary);
  const group = new Group();
  // First how far away it is, so that only its nearest surface is seen, in whatever order the sides come.
  const depth = new Mesh(geometry, new MeshBasicMaterial({ colorWrite: false, transparent: true, side: FrontSide }));
  const material = new MeshLambertMaterial({ vertexColors: true, flatShading: true, transparent: true });
  const faces = new Mesh(geometry, material);
  [depth, faces].forEach((mesh, i) => {
    mesh.renderOrder = ORDER + i;
    mesh.frustumCulled = false;
    group.add(mesh);
  });
  done(
    group,
    () => remove(group),
    (opacity) => {
      material.opacity = opacity;
      material.depthWrite = opacity === 1;
    },
  );
}

/**
 * @param {VolumeMap} map
 * @param {WorkspaceView} view
 * @param {Skin} skin
 * @param {Done} done
 * @returns {Generator<void, void>}
 */
export function* pointsOf(map, view, skin, done) {
  const { cubes, places, hasValues } = map;
  const { values, table } = colouring(map, view, skin);
  const isAnywhere = view.tool === 'any' || !hasValues;
  const material = new PointsMaterial({ size: POINT, sizeAttenuation: false, vertexColors: true });
  const group = new Group();
  for (const chunk of places) {
    const colours = new Uint16Array(chunk.length);
    const kept = isAnywhere ? chunk : new Float32Array(chunk.length);
    let count = 0;
    for (let k = 0; k < chunk.length; k += 3) {
      if (k % (3 * POINTS_AT_ONCE) === 0 && k > 0) yield;
      const cube = cubes ? cubeOf(cubes, chunk[k], chunk[k + 1], chunk[k + 2]) : -1;
      if (!isAnywhere) {
        if (cube < 0 || !cubes?.reached[cube]) continue;
        kept.set(chunk.subarray(k, k + 3), 3 * count);
      }
      const at = values && cube >= 0 ? stepOf(values, cube) : 0;
      for (let channel = 0; channel < 3; channel++) colours[3 * count + channel] = table[at + channel];
      count++;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(kept, 3));
    geometry.setAttribute('color', new BufferAttribute(colours, 3, true));
    geometry.setDrawRange(0, count);
    placed(geometry, map.summary);
    const points = new Points(geometry, material);
    points.frustumCulled = false;
    points.renderOrder = ORDER;
    group.add(points);
    yield;
  }
  done(
    group,
    () => remove(group),
    () => {},
  );
}
