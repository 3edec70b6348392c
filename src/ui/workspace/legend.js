/**
 * What the colours of the volume mean: the scale with its numbers and units, how much of the volume is in each part of it, and all
 * of it as a list for those who do not see it.
 *
 * @import { Units } from '../../model/document.js'
 * @import { CubeScale, VolumeMap } from '../../model/workspace/mapped.js'
 * @import { ReachColour } from '../../model/workspace/workspaceView.js'
 */
import { fill, h } from '../parts/dom.js';
import { compact, fixed } from '../parts/format.js';
import { WORKSPACE } from '../words/workspace.js';
import { lengthSign, tickText } from './measures.js';

const WORDS = WORKSPACE.volume;

/** Characters of a number of the scale. */
const WIDEST = 7;

/** Decimals of a share of the volume. */
const percent = (/** @type {number} */ share) => fixed(100 * share, share > 0 && share < 0.01 ? 1 : 0);

/** The unit of what is shown. @param {ReachColour} colour @param {Units} units @param {boolean} isFlat */
function unitFor(colour, units, isFlat) {
  if (colour === 'height') return lengthSign(units);
  if (colour === 'manipulability') return isFlat ? 'm²' : 'm³';
  return colour === 'postures' ? '' : '%';
}

/** @param {ReachColour} colour @param {Units} units @param {number} step  between two of them */
function writer(colour, units, step) {
  if (colour === 'height') return (/** @type {number} */ value) => tickText(value, step, units);
  if (colour === 'manipulability')
    return (/** @type {number} */ value) => compact(Number(value.toPrecision(3)), WIDEST).text;
  if (colour === 'postures') return (/** @type {number} */ value) => fixed(value, 0);
  return (/** @type {number} */ value) => fixed(100 * value, 0);
}

export function createLegend() {
  const name = h('p', { class: 'legend-name sm b' });
  const bar = h('div', { class: 'legend-bar', 'aria-hidden': 'true' });
  const ticks = h('div', { class: 'legend-ticks sm', 'aria-hidden': 'true' });
  const counts = h('div', { class: 'legend-counts', 'aria-hidden': 'true' });
  const meaning = h('p', { class: 'sm soft' });
  const list = h('ul', {});
  const table = h('details', { class: 'plot-table' }, h('summary', {}, WORDS.legendTable), list);
  const scale = h('div', { role: 'img' }, counts, bar, ticks);
  const element = h('div', { class: 'legend' }, name, scale, meaning, table);
  /** What is drawn. @type {readonly unknown[]} */
  let drawn = [];

  /**
   * @param {VolumeMap} map
   * @param {ReachColour} colour
   * @param {Units} units
   * @param {{ isFlat: boolean, joints: number }} arm  joints: how many move the tool point
   */
  return {
    element,
    /** @type {(map: VolumeMap, colour: ReachColour, units: Units, arm: { isFlat: boolean, joints: number }) => void} */
    draw(map, colour, units, { isFlat, joints }) {
      const now = [map.cubes, map.hasValues, map.status === 'done', colour, units];
      if (now.every((value, i) => value === drawn[i])) return;
      drawn = now;
      const isKnown = map.cubes !== null && (map.hasValues || colour === 'height');
      const values = isKnown ? (map.summary?.scales[colour] ?? null) : null;
      scale.hidden = table.hidden = values === null;
      const unit = unitFor(colour, units, isFlat);
      name.textContent = WORDS.legend(WORDS.colours[colour], unit);
      const why = !isKnown
        ? WORDS.unknownYet
        : values === null
          ? WORDS.infinitelyMany(joints)
          : [WORDS.meaning[colour], colour === 'height' || colour === 'postures' ? '' : WORDS.estimate]
              .filter(Boolean)
              .join(' ');
      meaning.textContent = why;
      meaning.hidden = why === '';
      if (values) write(values, colour, units, unit);
    },
  };

  /**
   * @param {CubeScale} values
   * @param {ReachColour} colour
   * @param {Units} units
   * @param {string} unit
   */
  function write({ least, most, isCount, shares }, colour, units, unit) {
    const parts = shares.length;
    const text = writer(colour, units, (most - least) / parts);
    const at = (/** @type {number} */ i) => least + ((most - least) * i) / (isCount ? Math.max(1, parts - 1) : parts);
    const marks = Array.from({ length: isCount || most === least ? parts : parts + 1 }, (_, i) => text(at(i)));
    ticks.classList.toggle('is-count', isCount || most === least);
    fill(
      ticks,
      marks.map((mark) => h('span', {}, mark)),
    );
    const largest = Math.max(...shares, 1e-9);
    fill(
      counts,
      shares.map((share) => h('i', { style: `height: ${(100 * share) / largest}%` })),
    );
    const withUnit = (/** @type {string} */ number) => (unit ? `${number} ${unit}` : number);
    const lines = shares.map((share, i) =>
      isCount || most === least
        ? WORDS.count(withUnit(marks[i]), percent(share))
        : WORDS.part(marks[i], withUnit(marks[i + 1]), percent(share)),
    );
    scale.setAttribute('aria-label', WORDS.legendInWords(WORDS.colours[colour], lines));
    fill(
      list,
      lines.map((line) => h('li', {}, line)),
    );
  }
}
