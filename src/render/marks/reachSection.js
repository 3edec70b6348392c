/**
 * The section in the scene: what its outlines enclose, or the cells of a first picture, in the plane where it stands. Made in pieces,
 * since an outline may have thousands of points.
 *
 * @import { SectionPlane, TracedSection } from '../../model/workspace/mapped.js'
 * @import { Skin } from '../skins.js'
 *
 * @typedef {SectionPlane & Partial<Pick<TracedSection, 'outlines'>>} SectionWanted
 */
import earcut from 'earcut';
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial } from 'three';
import { lifted, stripesOf, thinned, withHoles } from '../../model/workspace/sectionShape.js';
import { disposeOf, fatLines } from '../fatLines.js';

const FILL = 0.3;
const WIDTH = 2;
const HIDDEN = 0.45; // of a line that the arm hides
/** After the volume. */
const ORDER = 15;

/** Of what is drawn, so much may lie between two points of an outline (m per m across). */
const FINE = 1 / 2000;

/**
 * The cells of a first picture.
 * @param {SectionPlane['frame']} frame
 * @param {SectionPlane['cells']} cells
 */
function striped(frame, cells) {
  const stripes = stripesOf(cells);
  const corners = new Float32Array(3 * stripes.length);
  const triangles = new Uint32Array((6 * stripes.length) / 4);
  for (let k = 0; k < stripes.length; k += 4) {
    const [u0, u1, v0, v1] = stripes.slice(k, k + 4);
    const four = [lifted(frame, u0, v0), lifted(frame, u1, v0), lifted(frame, u1, v1), lifted(frame, u0, v1)];
    corners.set(four.flat(), 3 * k);
    triangles.set([k, k + 1, k + 2, k, k + 2, k + 3], (6 * k) / 4);
  }
  return { corners, triangles };
}

/**
 * What outlines enclose.
 * @param {SectionPlane['frame']} frame
 * @param {readonly { points: readonly number[], area: number }[]} outlines
 */
function* filled(frame, outlines) {
  /** @type {number[]} */
  const corners = [];
  /** @type {number[]} */
  const triangles = [];
  for (const { outer, holes } of withHoles(outlines)) {
    const flat = [outer, ...holes].flatMap((points) => Array.from(points));
    const holesAt = holes.map((_, n) =>
      holes.slice(0, n).reduce((sum, hole) => sum + hole.length / 2, outer.length / 2),
    );
    const first = corners.length / 3;
    for (let k = 0; k < flat.length; k += 2) corners.push(...lifted(frame, flat[k], flat[k + 1]));
    for (const corner of earcut(flat, holesAt)) triangles.push(first + corner);
    yield;
  }
  return { corners: Float32Array.from(corners), triangles: Uint32Array.from(triangles) };
}

/**
 * @param {SectionWanted} section
 * @param {Skin} skin
 * @param {(group: Group, remove: () => void) => void} done
 * @returns {Generator<void, void>}
 */
export function* sectionOf({ frame, cells, outlines = [] }, skin, done) {
  yield; // in this frame the panel draws it
  const apart = FINE * cells.size * Math.max(cells.columns, cells.rows);
  const thin = outlines.map(({ places, area }) => ({ points: thinned(places, apart), area }));
  const { corners, triangles } = outlines.length > 0 ? yield* filled(frame, thin) : striped(frame, cells);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setIndex(new BufferAttribute(triangles, 1));
  const group = new Group();
  const fill = new Mesh(
    geometry,
    new MeshBasicMaterial({
      ...{ color: skin.accent, side: DoubleSide, transparent: true, opacity: FILL, depthWrite: false },
    }),
  );
  fill.renderOrder = ORDER;
  fill.frustumCulled = false;
  const segments = thin.flatMap(({ points }) =>
    points.flatMap((value, i) => {
      if (i % 2) return [];
      const next = (i + 2) % points.length;
      return [...lifted(frame, value, points[i + 1]), ...lifted(frame, points[next], points[next + 1])];
    }),
  );
  const lines =
    segments.length > 0
      ? [
          fatLines(segments, { color: skin.accent, width: WIDTH, opacity: HIDDEN, order: ORDER + 1 }),
          fatLines(segments, { color: skin.accent, width: WIDTH, order: ORDER + 2 }),
        ]
      : [];
  if (lines[1]) lines[1].material.depthTest = true;
  group.add(fill, ...lines);
  done(group, () => {
    group.removeFromParent();
    [fill, ...lines].forEach(disposeOf);
  });
}
