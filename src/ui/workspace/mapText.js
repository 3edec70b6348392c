/**
 * A map in words, for those who listen and those who read.
 *
 * @import { Units } from '../../model/document.js'
 * @import { AppState } from '../../model/session.js'
 * @import { NotMapped, SectionMap, VolumeMap } from '../../model/workspace/mapped.js'
 */
import { holesOf } from '../../model/workspace/sectionShape.js';
import { WORKSPACE } from '../words/workspace.js';
import { SECTION } from '../words/workspaceSection.js';
import { lengthText, measureText, shortLength } from './measures.js';

const WORDS = WORKSPACE.volume;

/**
 * What is counted: a volume, or the area of a region that is a layer of cubes.
 * @param {Pick<VolumeMap, 'cubes' | 'summary'>} map
 */
export function sizeOf({ cubes, summary }) {
  if (!cubes || !summary) return null;
  const { layer, low, high, count } = summary;
  const [value, error] = layer ? [layer.area, layer.areaError] : [cubes.volume, cubes.volumeError];
  const thin = thinness(cubes.freedoms, layer !== null);
  const text = thin ? WORDS.noSize[thin] : measureText(layer ? 'area' : 'volume', value, error);
  // along these there is an extent to speak of
  const axes = ['x', 'y', 'z'].map((axis, k) => ({ axis, low: low[k], high: high[k] }));
  return { isFlat: layer !== null, thin, axes: axes.filter((_, k) => k !== layer?.across), count, text };
}

/** Whether the tool point draws less than what is counted: 1 a curve, 2 a surface. @param {number} freedoms @param {boolean} isFlat @returns {1 | 2 | null} */
const thinness = (freedoms, isFlat) => (freedoms === 1 ? 1 : freedoms === 2 && !isFlat ? 2 : null);

/** @param {AppState} state @param {VolumeMap} map */
export function volumeInWords({ doc }, map) {
  const { units } = doc.robot;
  const found = sizeOf(map);
  if (!found) return WORDS.none;
  const { axes, isFlat, thin, text } = found;
  const ranges = axes.map(({ axis, low, high }) =>
    WORDS.along(axis, shortLength(low, units), shortLength(high, units)),
  );
  const size = thin ? WORDS.thin[thin] : isFlat ? WORDS.sizeFlat(text) : WORDS.size(text);
  return [size, WORDS.extent(ranges)].join(' ');
}

/** Of a section that is not traced, how far its picture can be trusted. @param {NonNullable<SectionMap['first']>} first @param {Units} units */
export const onlyFirst = ({ cells, beside }, units) =>
  cells.columns === 0
    ? SECTION.noneSeen
    : SECTION.onlyFirst(shortLength(cells.size, units), beside > 0 ? shortLength(beside, units) : '');

/** @param {AppState} state @param {SectionMap} map */
export function sectionInWords({ doc }, { section, first }) {
  const { units } = doc.robot;
  if (!section) return first ? onlyFirst(first, units) : SECTION.none;
  if (!section.extent) return SECTION.empty;
  const { area, areaError, volume, volumeError, extent, kind, sides } = section;
  const holes = holesOf(section).length;
  const names = SECTION.axes[kind];
  return [
    SECTION.inWords.area(measureText('area', area, areaError), SECTION.inWords.holes(holes)),
    SECTION.inWords.extent(
      ...[extent.u, extent.v].map(([low, high], i) =>
        SECTION.inWords.along(names[i], lengthText(low, units), lengthText(high, units)),
      ),
    ),
    volume !== null && SECTION.inWords.volume(measureText('volume', volume, volumeError ?? 0)),
    SECTION.inWords[sides],
  ]
    .filter(Boolean)
    .join(' ');
}

/** Why an arm has no map. @param {NotMapped} why */
export const whyText = (why) =>
  why.code === 'unlimited-slide' ? WORKSPACE.notMapped[why.code](why.joint + 1) : WORKSPACE.notMapped[why.code]();
