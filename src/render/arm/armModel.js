/**
 * The arm in the scene: meshes that are built when the table changes, and after that only moved. Each link is a group
 * whose matrix is the kernel's frame of it.
 *
 * @import { ArmParts, Part } from './armParts.js'
 * @import { LinkStyle } from './linkPieces.js'
 * @import { PartKind } from './joinery.js'
 * @import { Skin } from '../skins.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Raycaster, Vector3 } from 'three'
 */
import {
  Color,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  ReplaceStencilOp,
} from 'three';
import { identity } from '../../kinematics/pose.js';
import { armParts } from './armParts.js';
import { geometryOf } from './meshes.js';

/** How much of the accent the chosen link takes. */
const TINT = 0.16;

/** @type {readonly PartKind[]} */
const KINDS = ['link', 'joint', 'tool'];

/** Edges lie on the faces that they bound: the faces step back a little for them. */
const BEHIND_EDGES = { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };

/** Where the arm is, the stencil is 1, and ghosts (ghostArms.js) stay away. */
const ARM_STENCIL = { stencilWrite: true, stencilRef: 1, stencilZPass: ReplaceStencilOp };

const SOLID = { ...BEHIND_EDGES, ...ARM_STENCIL };

/** @typedef {{ mesh: Mesh, edges: LineSegments, link: number, parent: number, kind: PartKind, corners: Vector3[] }} Piece */

/** @param {{ skin: Skin, isLow: boolean }} options */
export function createArmModel({ skin, isLow }) {
  const group = new Group();
  group.matrixAutoUpdate = false;
  /** @type {Group[]} */
  let links = [];
  /** @type {Piece[]} */
  let pieces = [];
  /** @type {{ mesh: Mesh, start: Matrix4, joint: number, constant: number }[]} */
  let rods = [];
  /** @type {readonly LinkStyle[]} */
  let styles = [];
  /** @type {number | null} */
  let lit = null;

  const solid = () =>
    isLow ? new MeshLambertMaterial(SOLID) : new MeshStandardMaterial({ ...SOLID, metalness: 0.04 });
  /** @type {ReturnType<typeof solid>[]} */
  let linkMaterials = [];
  const jointMaterial = solid();
  const toolMaterial = solid();
  const edgeMaterial = new LineBasicMaterial({ transparent: true });
  const litMaterial = new LineBasicMaterial();

  /** @param {number} i */
  function usualColour(i) {
    const last = linkMaterials.length - 1;
    if (i === 0) return skin.base;
    if (last < 5 || i < last - 1) return skin.link;
    return i === last ? skin.flange : skin.wrist;
  }

  function paint() {
    linkMaterials.forEach(({ color }, i) => {
      color.set(styles[i - 1]?.color ?? usualColour(i));
      if (i === lit) color.lerp(new Color(skin.accent), TINT);
    });
    jointMaterial.color.set(skin.joint);
    toolMaterial.color.set(skin.tool);
    for (const material of [...linkMaterials, jointMaterial, toolMaterial]) {
      if (material instanceof MeshStandardMaterial) material.roughness = skin.roughness;
    }
    edgeMaterial.color.set(skin.edge);
    edgeMaterial.opacity = skin.edgeOpacity;
    litMaterial.color.set(skin.accent);
    for (const { edges, link, kind } of pieces) {
      edges.material = link === lit && kind === 'link' ? litMaterial : edgeMaterial;
    }
  }

  function clear() {
    for (const { mesh, edges } of pieces) {
      mesh.geometry.dispose();
      edges.geometry.dispose();
    }
    for (const material of linkMaterials) material.dispose();
    for (const link of links) link.clear();
    group.clear();
    [links, pieces, rods, linkMaterials] = [[], [], [], []];
  }

  /**
   * @param {readonly Pick<Part, 'shape' | 'pose'>[]} parts
   * @param {number} link
   * @param {PartKind} kind
   * @param {number} [parent]  the link whose frame it moves with
   */
  function addPiece(parts, link, kind, parent = link) {
    const { faces, edges, corners } = geometryOf(parts);
    const material = kind === 'link' ? linkMaterials[link] : kind === 'joint' ? jointMaterial : toolMaterial;
    const mesh = new Mesh(faces, material);
    const lines = new LineSegments(edges, edgeMaterial);
    mesh.castShadow = mesh.receiveShadow = !isLow;
    mesh.matrixAutoUpdate = lines.matrixAutoUpdate = false;
    mesh.add(lines);
    links[parent].add(mesh);
    pieces.push({ mesh, edges: lines, link, parent, kind, corners });
    return mesh;
  }

  return {
    group,

    /**
     * @param {Chain} chain
     * @param {readonly LinkStyle[]} linkStyles
     * @returns {ArmParts}
     */
    build(chain, linkStyles) {
      clear();
      styles = linkStyles;
      const arm = armParts(chain, styles);
      for (let i = 0; i <= chain.dof; i++) {
        const link = new Group();
        link.matrixAutoUpdate = false;
        group.add(link);
        links.push(link);
        linkMaterials.push(solid());
        for (const kind of KINDS) {
          const parts = arm.parts.filter((part) => part.link === i && part.kind === kind);
          if (parts.length) addPiece(parts, i, kind);
        }
      }
      rods = arm.rods.map(({ shape, pose, link, joint, constant }) => {
        // it looks like the link that comes out, though it is fixed to the other
        const mesh = addPiece([{ shape, pose: identity() }], joint + 1, 'link', link);
        return { mesh, start: new Matrix4().fromArray(pose), joint, constant };
      });
      paint();
      return arm;
    },

    /**
     * @param {Float64Array} frames  of linkFrames
     * @param {ArrayLike<number>} q
     */
    move(frames, q) {
      links.forEach((link, i) => {
        link.matrix.fromArray(frames, 16 * i);
        link.matrixWorldNeedsUpdate = true;
      });
      for (const { mesh, start, joint, constant } of rods) {
        const length = constant + q[joint];
        mesh.visible = Math.abs(length) > 1e-9; // a rod without length has no inside and no outside
        mesh.matrix.copy(start);
        for (const k of [8, 9, 10]) mesh.matrix.elements[k] *= length;
        mesh.matrixWorldNeedsUpdate = true;
      }
    },

    /** @param {number | null} link  to stand out */
    light(link) {
      lit = link;
      paint();
    },

    /** @param {Skin} next */
    setSkin(next) {
      skin = next;
      paint();
    },

    /** What a camera has to get into the picture: the corners of the boxes about all parts, where they are now. */
    corners: () =>
      pieces.flatMap(({ corners, mesh, parent }) =>
        mesh.visible
          ? corners.map((corner) => corner.clone().applyMatrix4(mesh.matrix).applyMatrix4(links[parent].matrix))
          : [],
      ),

    /** The link that a line of sight meets first, and where. @param {Raycaster} sight */
    linkAt(sight) {
      const [first] = sight.intersectObjects(
        pieces.map(({ mesh }) => mesh).filter((mesh) => mesh.visible),
        false,
      );
      const piece = first && pieces.find(({ mesh }) => mesh === first.object);
      return piece ? { link: piece.link, point: first.point } : null;
    },

    /** The frame of a link, to hang a mark in. @param {number} i */
    linkGroup: (i) => links[i],

    dispose() {
      clear();
      for (const material of [jointMaterial, toolMaterial, edgeMaterial, litMaterial]) material.dispose();
    },
  };
}

/** @typedef {ReturnType<typeof createArmModel>} ArmModel */
