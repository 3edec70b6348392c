/**
 * The solids that an arm is made of, as plain numbers: a convex outline in the xy plane, raised along z by a profile.
 * Drums, cones, beams and bars are all of this one kind, so that their normals and the edges to be drawn are known
 * exactly and need not be searched for in a finished mesh. No Three.js and no WebGL: this runs anywhere.
 *
 * @typedef {object} Corner  a circle that the outline is wrapped round
 * @property {number} x
 * @property {number} y
 * @property {number} radius
 * @property {boolean} [sharp]  draw an edge along z in the middle of its arc
 *
 * @typedef {object} Shape
 * @property {readonly Corner[]} corners  counterclockwise; the outline is their hull
 * @property {readonly (readonly [inset: number, z: number])[]} profile  in order of z; the inset is inwards
 *
 * @typedef {object} Solid
 * @property {number[]} positions  x y z of each vertex
 * @property {number[]} normals
 * @property {number[]} indices    three to a triangle
 * @property {number[]} edges      x y z of each end of each line
 */
import { toRadians } from '../../model/units.js';

/** How many sides a full circle has: enough to look round at any size that a screen has. */
const SIDES = 48;

/** Faces that meet at more than this have an edge drawn between them. */
const CREASE = toRadians(28);

const TURN = 2 * Math.PI;

/** @param {number} from @param {number} to @param {number} chamfer @returns {[number, number][]} */
function chamfered(from, to, chamfer) {
  const [low, high] = from < to ? [from, to] : [to, from];
  const c = Math.min(chamfer, (high - low) / 3);
  return [
    [c, low],
    [0, low + c],
    [0, high - c],
    [c, high],
  ];
}

/**
 * A cylinder about z with chamfered rims.
 * @param {number} radius
 * @param {number} from  z of one end
 * @param {number} to    z of the other
 * @param {number} [chamfer]  as a part of the radius
 * @returns {Shape}
 */
export const drum = (radius, from, to, chamfer = 0.1) => ({
  corners: [{ x: 0, y: 0, radius }],
  profile: chamfered(from, to, radius * chamfer),
});

/**
 * A frustum about z.
 * @param {number} radius     at `from`
 * @param {number} endRadius  at `to`
 * @param {number} from
 * @param {number} to
 * @returns {Shape}
 */
export function cone(radius, endRadius, from, to) {
  const widest = Math.max(radius, endRadius);
  /** @type {[number, number][]} */
  const profile = [
    [widest - radius, from],
    [widest - endRadius, to],
  ];
  return { corners: [{ x: 0, y: 0, radius: widest }], profile: from < to ? profile : profile.reverse() };
}

/**
 * A plate from the z axis to a parallel axis at x = length (which may be negative), lying across z from −thickness / 2 to
 * thickness / 2, with rounded ends about both axes.
 * @param {number} length
 * @param {number} radius     about the z axis
 * @param {number} endRadius  about the other
 * @param {number} thickness
 * @returns {Shape}
 */
export function beam(length, radius, endRadius, thickness) {
  const near = { x: 0, y: 0, radius };
  const far = { x: length, y: 0, radius: endRadius };
  const widest = radius >= endRadius ? near : far;
  const corners = Math.abs(length) <= Math.abs(radius - endRadius) ? [widest] : length > 0 ? [near, far] : [far, near];
  const chamfer = Math.min(0.12 * Math.min(radius, endRadius), thickness / 8);
  return { corners, profile: chamfered(-thickness / 2, thickness / 2, chamfer) };
}

/**
 * The same, but cut off square at x = length.
 * @param {number} length
 * @param {number} radius     about the z axis
 * @param {number} halfWidth  at the cut
 * @param {number} thickness
 * @returns {Shape}
 */
export function stub(length, radius, halfWidth, thickness) {
  const chamfer = Math.min(0.12 * Math.min(radius, halfWidth), thickness / 8);
  const x = length - Math.sign(length) * chamfer;
  const y = (halfWidth - chamfer) * Math.sign(length);
  const isInside = Math.hypot(x, y) + chamfer <= radius; // too short to have corners
  const ends = isInside ? [] : [-y, y].map((side) => ({ x, y: side, radius: chamfer, sharp: true }));
  return { corners: [{ x: 0, y: 0, radius }, ...ends], profile: chamfered(-thickness / 2, thickness / 2, chamfer) };
}

/**
 * A rectangular bar along z.
 * @param {number} halfX
 * @param {number} halfY
 * @param {number} from
 * @param {number} to
 * @returns {Shape}
 */
export function bar(halfX, halfY, from, to) {
  const radius = 0.14 * Math.min(halfX, halfY);
  const [x, y] = [halfX - radius, halfY - radius];
  /** @param {number} cx @param {number} cy */
  const corner = (cx, cy) => ({ x: cx, y: cy, radius, sharp: true });
  return {
    corners: [corner(x, y), corner(-x, y), corner(-x, -y), corner(x, -y)],
    profile: chamfered(from, to, radius * 0.8),
  };
}

/** @typedef {{ x: number, y: number, nx: number, ny: number, sharp: boolean }} Point  of an outline, with its normal */

/** @param {readonly Corner[]} corners @returns {Point[]} */
function outlineOf(corners) {
  /** @param {Corner} corner @param {number} angle @param {boolean} sharp */
  const point = ({ x, y, radius }, angle, sharp) => {
    const [nx, ny] = [Math.cos(angle), Math.sin(angle)];
    return { x: x + radius * nx, y: y + radius * ny, nx, ny, sharp };
  };
  if (corners.length === 1)
    return Array.from({ length: SIDES }, (_, i) => point(corners[0], (TURN * i) / SIDES, false));
  return corners.flatMap((corner, i) => {
    const start = tangentNormal(corners.at(i - 1) ?? corner, corner);
    const end = tangentNormal(corner, corners[(i + 1) % corners.length]);
    const arc = (((end - start) % TURN) + TURN) % TURN;
    const steps = 2 * Math.ceil((SIDES * arc) / TURN / 2 - 1e-9) || 2; // even, so that there is a point in the middle
    return Array.from({ length: steps + 1 }, (_, k) =>
      point(corner, start + (arc * k) / steps, Boolean(corner.sharp) && 2 * k === steps),
    );
  });
}

/** The direction, outwards, of the common tangent of two circles passed counterclockwise. @param {Corner} a @param {Corner} b */
function tangentNormal(a, b) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  return Math.atan2(dy, dx) - Math.acos(Math.max(-1, Math.min(1, (a.radius - b.radius) / Math.hypot(dx, dy))));
}

/**
 * @param {Shape} shape
 * @returns {Solid}
 */
export function solidOf({ corners, profile }) {
  const outline = outlineOf(corners);
  const sides = outline.length;
  /** @type {Solid} */
  const solid = { positions: [], normals: [], indices: [], edges: [] };

  /** @param {Point} p @param {readonly [number, number]} level @returns {[number, number, number]} */
  const place = ({ x, y, nx, ny }, [inset, z]) => [x - inset * nx, y - inset * ny, z];

  // a ring of vertices with normals that lean by `lean` from the outline's own: (cos, sin) = (1, 0) is straight outwards
  /** @param {readonly [number, number]} level @param {number} cos @param {number} sin */
  const ring = (level, cos, sin) => {
    const first = solid.positions.length / 3;
    const [inset, z] = level;
    for (const { x, y, nx, ny } of outline) {
      solid.positions.push(x - inset * nx, y - inset * ny, z);
      solid.normals.push(nx * cos, ny * cos, sin);
    }
    return first;
  };

  /** @param {readonly [number, number]} level */
  const drawRim = (level) => {
    outline.forEach((p, i) => solid.edges.push(...place(p, level), ...place(outline[(i + 1) % sides], level)));
  };

  let direction = -Math.PI / 2; // of the face before, as the lean of its normal; the lower cap looks down
  for (let i = 0; i + 1 < profile.length; i++) {
    const [[lowInset, low], [highInset, high]] = [profile[i], profile[i + 1]];
    const lean = Math.atan2(highInset - lowInset, high - low);
    if (lean - direction > CREASE) drawRim(profile[i]);
    direction = lean;
    const below = ring(profile[i], Math.cos(lean), Math.sin(lean));
    const above = ring(profile[i + 1], Math.cos(lean), Math.sin(lean));
    for (let k = 0; k < sides; k++) {
      const next = (k + 1) % sides;
      solid.indices.push(below + k, below + next, above + next, below + k, above + next, above + k);
    }
    for (const p of outline) if (p.sharp) solid.edges.push(...place(p, profile[i]), ...place(p, profile[i + 1]));
  }
  const top = profile[profile.length - 1];
  if (Math.PI / 2 - direction > CREASE) drawRim(top);
  for (const [level, up] of /** @type {const} */ ([
    [profile[0], -1],
    [top, 1],
  ])) {
    const first = ring(level, 0, up);
    for (let k = 1; k + 1 < sides; k++) {
      solid.indices.push(first, first + (up > 0 ? k : k + 1), first + (up > 0 ? k + 1 : k));
    }
  }
  return solid;
}
