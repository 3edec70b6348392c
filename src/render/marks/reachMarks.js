/**
 * What the arm can reach, in the scene: its volume and a section. What is drawn stays until what follows it is ready.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { SectionWanted } from './reachSection.js'
 * @import { Clock } from '../../model/clock.js'
 * @import { VolumeMap } from '../../model/workspace/mapped.js'
 * @import { WorkspaceView } from '../../model/workspace/workspaceView.js'
 *
 * @typedef {object} VolumeWanted
 * @property {VolumeMap} map
 * @property {WorkspaceView} view
 */
import { Vector3 } from 'three';
import { boxOfSection, lifted } from '../../model/workspace/sectionShape.js';
import { inSlices } from '../inSlices.js';
import { sectionOf } from './reachSection.js';
import { pointsOf, solidOf } from './reachVolume.js';

/** @param {{ low: readonly number[], high: readonly number[] }} box */
const cornersOf = ({ low, high }) =>
  [low[0], high[0]].flatMap((x) =>
    [low[1], high[1]].flatMap((y) => [low[2], high[2]].map((z) => new Vector3(x, y, z))),
  );

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
  let giveUpSection = () => {};
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
    giveUpSection();
    if (!section) {
      removeSection();
      removeSection = () => {};
      return onChange();
    }
    const work = sectionOf(section, skin, (group, remove) => {
      removeSection();
      removeSection = remove;
      scene.add(group);
      onChange();
    });
    giveUpSection = inSlices(clock, work);
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
