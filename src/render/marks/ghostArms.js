/**
 * The arm where it might stand: depth first and one even tint after, so that no part shows through another; its edges; no
 * shadow. The arm itself has marked its pixels (the stencil), and a ghost is drawn beside them, never over them.
 *
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 */
import {
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  EqualDepth,
  NotEqualStencilFunc,
  Vector3,
} from 'three';
import { linkFrames } from '../../kinematics/forward.js';
import { identity } from '../../kinematics/pose.js';
import { createMarkSet } from './markSet.js';
import { geometryOf } from '../arm/meshes.js';

const TINT = 0.13;
const EDGES = 0.4;
const MOST = 2;
const ORDER = 4; // after the arm, before the marks
const STENCIL = 1;

/** @typedef {{ q: ArrayLike<number>, label: string }} Ghost */

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (ghosts: readonly Ghost[]) => void }}  two at most are drawn
 */
export function createGhostArms(tools) {
  const { scene, labels } = tools;
  const beside = { stencilWrite: true, stencilRef: STENCIL, stencilFunc: NotEqualStencilFunc };
  const depth = new MeshBasicMaterial({ colorWrite: false, ...beside });
  const tint = new MeshLambertMaterial({
    ...{ emissiveIntensity: 0.4, transparent: true, opacity: TINT, depthFunc: EqualDepth, depthWrite: false },
    ...beside,
  });
  const line = new LineBasicMaterial({ transparent: true, opacity: EDGES, depthWrite: false, ...beside });

  return createMarkSet(tools, /** @type {readonly Ghost[]} */ ([]), (arm, wanted, skin) => {
    for (const material of [tint, line]) material.color.set(skin.accent);
    tint.emissive.set(skin.accent);
    const group = new Group();
    const names = wanted
      .filter(({ q }) => q.length === arm.chain.dof)
      .slice(0, MOST)
      .map((ghost, i) => addGhost(group, arm, ghost, ORDER + 3 * i));
    scene.add(group);
    group.updateMatrixWorld(true);
    return {
      remove() {
        group.traverse((object) => {
          if (object instanceof Mesh || object instanceof LineSegments) object.geometry.dispose();
        });
        group.removeFromParent();
        for (const name of names) name.remove();
      },
    };
  });

  /** @param {Group} group @param {ArmNow} now @param {Ghost} ghost @param {number} order */
  function addGhost(group, { chain, parts }, { q, label }, order) {
    const frames = linkFrames(chain, q);
    /** @param {number} i */
    const frame = (i) => new Matrix4().fromArray(frames, 16 * i);
    for (let i = 1; i <= chain.dof; i++) {
      const own = parts.parts.filter((part) => part.link === i);
      if (own.length > 0) add(group, geometryOf(own), frame(i), order);
    }
    for (const { shape, pose, link, joint, constant } of parts.rods) {
      const length = constant + q[joint];
      if (Math.abs(length) < 1e-9) continue;
      const place = new Matrix4().fromArray(pose);
      for (const k of [8, 9, 10]) place.elements[k] *= length;
      add(group, geometryOf([{ shape, pose: identity() }]), frame(link).multiply(place), order);
    }
    const name = labels.add('ghost');
    const middle = Math.min(2, chain.dof - 1);
    name.at = new Vector3().fromArray(frames, 16 * (middle + 1) + 12);
    Object.assign(name, { gap: 10, yields: true, stays: true });
    name.write(label);
    return name;
  }

  /** @param {Group} group @param {ReturnType<typeof geometryOf>} geometry @param {Matrix4} place @param {number} order */
  function add(group, { faces, edges }, place, order) {
    const objects = [new Mesh(faces, depth), new Mesh(faces, tint), new LineSegments(edges, line)];
    objects.forEach((object, k) => {
      object.renderOrder = order + k;
      object.matrixAutoUpdate = false;
      object.matrix.copy(place);
      group.add(object);
    });
  }
}
