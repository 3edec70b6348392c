/**
 * What the arm can reach, in the scene: its volume and a section. What is drawn stays until what follows it is ready.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { Clock } from '../../model/clock.js'
 * @import { SectionPlane, TracedSection, VolumeMap } from '../../model/workspace/mapped.js'
 * @import { WorkspaceView } from '../../model/workspace/workspaceView.js'
 *
 * @typedef {object} VolumeWanted
 * @property {VolumeMap} map
 * @property {WorkspaceView} view
 *
 * @typedef {SectionPlane & Partial<Pick<TracedSection, 'outlines'>>} SectionWanted
 */
import earcut from 'earcut';
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { boxOfSection, lifted, stripesOf, thinned, withHoles } from '../../model/workspace/sectionShape.js';
import { disposeOf, fatLines } from '../fatLines.js';
import { inSlices } from '../inSlices.js';
import { pointsOf, solidOf } from './reachVolume.js';

const FILL = 0.3;
const WIDTH = 2;
const HIDDEN = 0.45; // of a line that the arm hides
/** After the volume. */
const ORDER = 15;

/** Of what is drawn, so much may lie between two points of an outline (m per m across). */
const FINE = 1 / 2000;

/** @param {{ low: readonly number[], high: readonly number[] }} box */
const cornersOf = ({ low, high }) =>
  [low[0], high[0]].flatMap((x) =>
    [low[1], high[1]].flatMap((y) => [low[2], high[2]].map((z) => new Vector3(x, y, z))),
  );

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
function filled(frame, outlines) {
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
    triangles.push(...earcut(flat, holesAt).map((corner) => first + corner));
  }
  return { corners: Float32Array.from(corners), triangles: Uint32Array.from(triangles) };
}

/**
 * @param {MarkTools & { clock: Clock, onChange: () => void }} tools
 * @returns {MarkSet & { wantVolume: (wanted: VolumeWanted | null) => void, wantSection: (wanted: SectionWanted | null) => void }}
 */
export function createReachMarks({ scene, skin, clock, onChange }) {
  /** @type {VolumeWanted | null} */
  let volume = null;
  /** What the drawing is made of. @type {readonly unknown[]} */
  let made = [];
  /** @type {SectionWanted | null} */
  let section = null;
  let removeVolume = () => {};
  let removeSection = () => {};
  let giveUp = () => {};
  /** @type {(opacity: number) => void} */
  let fade = () => {};
  /** @type {number | null} */
  let faded = null;
  /** As far as it can be seen through now; no reason to make it anew. */
  function fadeNow() {
    const opacity = volume?.view.opacity ?? null;
    if (opacity === null || opacity === faded) return;
    faded = opacity;
    fade(opacity);
    onChange();
  }

  function buildVolume() {
    if (!volume) {
      giveUp();
      if (made.length > 0) onChange();
      made = [];
      removeVolume();
      removeVolume = () => {};
      return;
    }
    const { map, view } = volume;
    const parts =
      view.style === 'points'
        ? [view.style, map.places, map.places.length, map.cubes, map.hasValues, view.colour, view.tool, skin]
        : [view.style, map.surface, map.hasValues, view.colour, skin];
    if (parts.length === made.length && parts.every((part, i) => part === made[i])) return fadeNow();
    made = parts;
    giveUp();
    const work = (view.style === 'points' ? pointsOf : solidOf)(map, view, skin, (group, remove, fadeIt) => {
      removeVolume();
      removeVolume = remove;
      fade = fadeIt;
      faded = null;
      scene.add(group);
      fadeNow();
    });
    giveUp = inSlices(clock, work);
  }

  function buildSection() {
    removeSection();
    removeSection = () => {};
    onChange();
    if (!section) return;
    const { frame, cells, outlines = [] } = section;
    const apart = FINE * cells.size * Math.max(cells.columns, cells.rows);
    const thin = outlines.map(({ places, area }) => ({ points: thinned(places, apart), area }));
    const { corners, triangles } = outlines.length > 0 ? filled(frame, thin) : striped(frame, cells);
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
    scene.add(group);
    removeSection = () => {
      group.removeFromParent();
      [fill, ...lines].forEach(disposeOf);
    };
  }

  return {
    // it stands in the world: the arm moves in it
    show() {},
    follow() {},
    clear() {},
    build() {},
    setSkin(next) {
      skin = next;
      buildVolume();
      buildSection();
    },
    corners() {
      if (volume?.map.summary) return cornersOf(volume.map.summary);
      if (!section) return [];
      const { u, v } = boxOfSection(section);
      const { frame } = section;
      return u.flatMap((across) => v.map((up) => new Vector3(...lifted(frame, across, up))));
    },
    wantVolume(wanted) {
      volume = wanted;
      buildVolume();
    },
    wantSection(wanted) {
      if (wanted === section) return;
      section = wanted;
      buildSection();
    },
  };
}
