/**
 * The handle on the tool: arrows, quarter arcs and small planes in its axes, as large on the screen wherever the eye is, and
 * the ghost of what is wanted where the arm cannot follow. It draws what it is told; dragTool.js tells it.
 *
 * @import { Eye } from '../eye.js'
 * @import { HandlePart, Placed } from './handleParts.js'
 * @import { ArmNow, MarkSet, MarkTools } from '../marks/marks.js'
 * @import { Sight } from '../sight.js'
 *
 * @typedef {object} HandleNow
 * @property {Float64Array} T_world_handle  where it is, and its axes
 * @property {HandlePart | null} lit        under the pointer, or in the hand
 * @property {boolean} isHeld               the others step back
 * @property {Float64Array | null} T_world_ghost  the pose that is wanted and not reached
 */
import {
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from 'three';
import { disposeOf, fatLines, segmentsThrough } from '../fatLines.js';
import { HEAD, PARTS, SHAFT, alongUnit, isSame, isUsable, outlineOf } from './handleParts.js';
import { sightOf } from '../sight.js';
import { cone, solidOf } from '../arm/solid.js';
import { createWantedPose } from '../marks/wantedPose.js';

const ARROW = 104; // pixels: with its letter about 120
const SHARE = 0.34; // of a small picture's lesser side, at most
const WIDTH = { move: 3, turn: 2.25, plane: 1.25, free: 0 };
const LIT_WIDTH = { move: 5, turn: 4.5, plane: 2.5, free: 0 };
const FILL = 0.3;
const LIT_FILL = 0.65;
const ASIDE = 0.22; // how much is left of the others while one is held
const LETTER_GAP = 7;
const GHOST = { arrow: 0.045, gap: 8, order: 46, least: 0.004 }; // in sizes of the arm; the gap in pixels

/** @typedef {{ part: HandlePart, group: Group, paint: (colour: string, isLit: boolean, strength: number) => void, dispose: () => void }} Piece */

/** @param {MarkTools & { missing: (metres: number) => string }} options */
export function createHandle({ scene, skin, labels, missing }) {
  const group = new Group();
  group.matrixAutoUpdate = false;
  group.visible = false;
  scene.add(group);
  const pieces = PARTS.filter(({ kind }) => kind !== 'free').map(createPiece);
  group.add(...pieces.map((piece) => piece.group));
  const dot = Object.assign(labels.add('dot'), { parent: group, visible: false });
  const letters = /** @type {const} */ (['X', 'Y', 'Z']).map((name, axis) => {
    const label = labels.add(`axis axis-${name.toLowerCase()} strong of-handle`);
    label.write(name);
    label.at.fromArray(alongUnit(axis, 1));
    return Object.assign(label, { parent: group, from: new Vector3(), gap: LETTER_GAP, yields: true, visible: false });
  });
  const ghost = createWantedPose({ ...GHOST, skin, labels, missing });
  scene.add(ghost.group);
  /** @type {HandleNow | null} */
  let now = null;
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {Sight | null} */
  let sight = null;
  /** As it was drawn last. @type {Placed | null} */
  let placed = null;

  function paint() {
    for (const piece of pieces) {
      const isLit = isSame(piece.part, now?.lit ?? null);
      const colour = isLit ? skin.accent : skin[/** @type {const} */ (['x', 'y', 'z'])[piece.part.axis]];
      piece.paint(colour, isLit, now?.isHeld && !isLit ? ASIDE : 1);
    }
  }

  /** The size on the screen, and what can be dragged as it is seen. @param {Eye} eye */
  function face(eye) {
    sight = sightOf(eye);
    if (!now) return;
    const { T_world_handle: T } = now;
    const centre = [...T.subarray(12, 15)];
    const axes = [0, 1, 2].map((k) => [...T.subarray(4 * k, 4 * k + 3)]);
    const length = Math.min(ARROW, SHARE * Math.min(eye.width, eye.height)) * sight.perPixel(centre);
    placed = { centre, axes, length };
    group.matrix.fromArray(T).scale(new Vector3(length, length, length));
    group.matrixWorldNeedsUpdate = true;
    const towards = sight.towards(centre);
    for (const { part, group: own } of pieces) {
      own.visible = isUsable(part, towards, axes);
      if (part.kind === 'move') letters[part.axis].visible = own.visible;
    }
  }

  /** @satisfies {MarkSet & Record<string, unknown>} */
  const set = {
    /** @param {ArmNow | null} next */
    show(next) {
      arm = next;
      set.follow();
    },
    follow() {
      if (arm) ghost.measureFrom(arm.T_base_tcp, arm.parts.size);
    },
    clear() {
      arm = null;
    },
    build() {
      ghost.rewrite();
      set.follow();
    },
    /** @param {typeof skin} next */
    setSkin(next) {
      skin = next;
      ghost.setSkin(next);
      paint();
    },
    face,

    /** @param {HandleNow | null} next  null: nothing is drawn */
    place(next) {
      const isRepainted = !isSame(next?.lit ?? null, now?.lit ?? null) || next?.isHeld !== now?.isHeld;
      now = next;
      if (!now) placed = null;
      group.visible = now !== null;
      for (const label of letters) label.visible = now !== null;
      dot.visible = now !== null && now.T_world_ghost !== null; // elsewhere the tool has its own
      if (isRepainted) paint();
      ghost.want(now?.T_world_ghost ?? null, { isMissed: true, hasLetters: false });
      set.follow();
    },

    /** As it was drawn last; null before there was a picture of it. */
    get seen() {
      return placed && sight ? { placed, sight } : null;
    },
    /** Of the arm, m. */
    get size() {
      return arm?.parts.size ?? 1;
    },
    get sight() {
      return sight;
    },
  };
  paint();
  return set;
}

/** @typedef {ReturnType<typeof createHandle>} HandleMarks */

/** @param {HandlePart} part @returns {Piece} */
function createPiece(part) {
  const { kind, axis } = part;
  const group = new Group();
  group.matrixAutoUpdate = false;
  const outline = kind === 'move' ? [alongUnit(axis, SHAFT.from), alongUnit(axis, SHAFT.to)] : outlineOf(part);
  const line = fatLines(segmentsThrough(outline), { width: WIDTH[kind], order: 50 });
  group.add(line);
  const faces = kind === 'turn' ? null : kind === 'move' ? headGeometry(axis) : planeGeometry(outline);
  const mesh =
    faces && new Mesh(faces, new MeshBasicMaterial({ side: DoubleSide, depthTest: false, depthWrite: false }));
  if (mesh) {
    mesh.material.transparent = true;
    mesh.renderOrder = kind === 'plane' ? 49 : 51;
    mesh.frustumCulled = false;
    group.add(mesh);
  }
  return {
    part,
    group,
    paint(colour, isLit, strength) {
      line.material.color = new Color(colour);
      line.material.linewidth = (isLit ? LIT_WIDTH : WIDTH)[kind];
      line.material.opacity = strength;
      mesh?.material.color.set(colour);
      if (mesh) mesh.material.opacity = strength * (kind === 'plane' ? (isLit ? LIT_FILL : FILL) : 1);
    },
    dispose() {
      disposeOf(line);
      if (mesh) disposeOf(mesh);
    },
  };
}

const HEAD_SOLID = solidOf(cone(HEAD.radius, 0, 1 - HEAD.length, 1));

/** The head of the x arrow, with the coordinates moved on. @param {number} axis */
function headGeometry(axis) {
  const { positions, indices } = HEAD_SOLID;
  const moved = positions.map((_, i) => positions[i - (i % 3) + (((i % 3) - axis - 1 + 6) % 3)]);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(moved, 3));
  geometry.setIndex([...indices]);
  return geometry;
}

/** @param {readonly number[][]} outline */
function planeGeometry(outline) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(outline.slice(0, 4).flat(), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}
