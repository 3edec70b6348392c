/**
 * What stands around the arm, half transparent, so that nobody has to look for an arm behind it; what touches has thick edges
 * and says so. Bodies of a kind share their geometry and are only stretched and put in place, so that one may be dragged
 * among a hundred.
 *
 * @import { Label } from '../labels.js'
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { ShownObstacle } from '../../model/workcell/workcell.js'
 *
 * @typedef {'usual' | 'chosen' | 'touched'} Look
 * @typedef {object} ObstaclesWanted
 * @property {readonly ShownObstacle[]} obstacles
 * @property {(id: string) => Look} lookOf
 * @property {boolean} areNamed
 */
import { Group, Matrix4, Mesh, MeshLambertMaterial, Raycaster, Vector3 } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { obstacleShape } from './obstacleShapes.js';

const OPACITY = { usual: 0.42, chosen: 0.5, touched: 0.5 };
const THIN = 0.3; // of a plane, which lies under everything
const WIDTH = { usual: 1.25, chosen: 2.25, touched: 3.25 };
const ORDER = 2; // after the arm, before ghosts and paths
/** A plane has no end; as much is drawn of it, in reaches of the arm. */
const PATCH = 1.1;

/** @type {readonly Look[]} */
const LOOKS = ['usual', 'chosen', 'touched'];

/** @typedef {{ shown: ShownObstacle, group: Group, faces: Mesh, edges: LineSegments2, name: Label }} Body */

/** @param {MarkTools} tools */
export function createObstacleMarks({ scene, skin, labels }) {
  const root = new Group();
  root.matrixAutoUpdate = false;
  scene.add(root);
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {ObstaclesWanted | null} */
  let wanted = null;
  /** @type {Map<string, Body>} */
  const bodies = new Map();
  /** @type {Map<ShownObstacle['kind'], { faces: Mesh['geometry'], lines: LineSegmentsGeometry }>} */
  const shapes = new Map();
  const materials = Object.fromEntries(
    LOOKS.flatMap((look) => [true, false].map((isSolid) => [`${look} ${isSolid}`, material(look, isSolid)])),
  );

  /** @param {Look} look @param {boolean} isSolid  not a plane */
  function material(look, isSolid) {
    return {
      faces: new MeshLambertMaterial({
        ...{ transparent: true, opacity: isSolid ? OPACITY[look] : THIN, depthWrite: false, emissiveIntensity: 0.25 },
      }),
      edges: new LineMaterial({ linewidth: WIDTH[look], transparent: true, depthWrite: false }),
    };
  }

  function paint() {
    for (const look of LOOKS) {
      const face = { usual: skin.obstacle, chosen: skin.obstacle, touched: skin.bad }[look];
      const edge = { usual: skin.edge, chosen: skin.accent, touched: skin.bad }[look];
      for (const isSolid of [true, false]) {
        const { faces, edges } = materials[`${look} ${isSolid}`];
        faces.color.set(face);
        faces.emissive.set(face);
        edges.color.set(edge);
        edges.opacity = look === 'usual' ? 0.75 : 1;
      }
    }
  }
  paint();

  /** @param {ShownObstacle['kind']} kind */
  function shapeOf(kind) {
    const known = shapes.get(kind);
    if (known) return known;
    const { faces, lines } = obstacleShape(kind);
    const made = { faces, lines: new LineSegmentsGeometry().setPositions(lines) };
    shapes.set(kind, made);
    return made;
  }

  /** @param {ShownObstacle} shown @returns {Body} */
  function create(shown) {
    const group = new Group();
    group.matrixAutoUpdate = false;
    const { faces: geometry, lines } = shapeOf(shown.kind);
    const faces = new Mesh(geometry, materials[`usual ${shown.kind !== 'plane'}`].faces);
    faces.castShadow = shown.kind !== 'plane';
    faces.renderOrder = shown.kind === 'plane' ? ORDER - 1 : ORDER;
    const edges = new LineSegments2(lines, materials[`usual ${shown.kind !== 'plane'}`].edges);
    edges.renderOrder = ORDER + 1;
    for (const each of [faces, edges]) {
      each.matrixAutoUpdate = false;
      each.frustumCulled = false;
      group.add(each);
    }
    root.add(group);
    const name = Object.assign(labels.add('obstacle-name'), { gap: 4, yields: true, parent: group });
    name.at.set(0, 0, shown.kind === 'sphere' ? 1 : shown.kind === 'plane' ? 0 : 0.5);
    return { shown, group, faces, edges, name };
  }

  /** @param {Body} body */
  function remove({ group, name }) {
    group.removeFromParent();
    name.remove();
  }

  function clear() {
    bodies.forEach(remove);
    bodies.clear();
  }

  function build() {
    const now = wanted;
    root.visible = arm !== null && now !== null;
    if (!arm || !now) return clear();
    const ids = new Set(now.obstacles.map(({ id }) => id));
    for (const [id, body] of bodies) {
      const next = now.obstacles.find((one) => one.id === id);
      if (ids.has(id) && next?.kind === body.shown.kind) continue;
      remove(body);
      bodies.delete(id);
    }
    const { reach } = arm.chain;
    const patch = PATCH * (Number.isFinite(reach) && reach > 0 ? reach : arm.parts.size);
    for (const shown of now.obstacles) {
      const body = bodies.get(shown.id) ?? create(shown);
      bodies.set(shown.id, body);
      body.shown = shown;
      const [x, y, z] = shown.kind === 'plane' ? [patch, patch, patch] : shown.size;
      body.group.matrix.fromArray(shown.T_world_obstacle).multiply(new Matrix4().makeScale(x, y, z));
      body.group.matrixWorldNeedsUpdate = true;
      const look = now.lookOf(shown.id);
      const { faces, edges } = materials[`${look} ${shown.kind !== 'plane'}`];
      body.faces.material = faces;
      body.edges.material = edges;
      body.name.visible = now.areNamed || look !== 'usual';
      body.name.write(shown.id);
    }
  }

  /** @satisfies {MarkSet & Record<string, unknown>} */
  const set = {
    show(/** @type {ArmNow | null} */ next) {
      arm = next;
      build();
    },
    follow() {},
    clear,
    build,
    setSkin(/** @type {typeof skin} */ next) {
      skin = next;
      paint();
    },
    /** @param {ObstaclesWanted | null} next */
    want(next) {
      wanted = next;
      build();
    },
    /** The one that a line of sight meets first, and how far from the eye. @param {{ from: readonly number[], along: readonly number[] }} ray */
    at({ from, along }) {
      const sight = new Raycaster(new Vector3(...from), new Vector3(...along));
      root.updateMatrixWorld();
      const all = [...bodies.values()];
      const [first] = sight.intersectObjects(
        all.map(({ faces }) => faces),
        false,
      );
      const body = first && all.find(({ faces }) => faces === first.object);
      return body ? { id: body.shown.id, distance: first.distance } : null;
    },
  };
  return set;
}

/** @typedef {ReturnType<typeof createObstacleMarks>} ObstacleMarks */
