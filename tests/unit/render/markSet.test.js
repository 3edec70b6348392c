/** What all sets of marks share: when they are drawn anew, when they only follow, and that nothing is left behind. */
import { expect, test } from 'vitest';
import { createMarkSet } from '../../../src/render/marks/markSet.js';

/** @typedef {import('../../../src/render/marks/marks.js').ArmNow} ArmNow */
/** @typedef {import('../../../src/render/skins.js').Skin} Skin */

const [arm, otherArm] = ['arm', 'other arm'].map((name) => /** @type {ArmNow} */ (/** @type {unknown} */ ({ name })));
const [light, dark] = ['light', 'dark'].map((name) => /** @type {Skin} */ (/** @type {unknown} */ ({ name })));

function watched() {
  /** @type {string[]} */
  const log = [];
  let standing = 0;
  const set = createMarkSet({ skin: light }, '', (now, wanted, skin) => {
    if (wanted === '') return null;
    standing++;
    log.push(['draw', ...[now, skin].map((one) => Object(one).name), wanted].join(' '));
    return {
      remove: () => void standing--,
      follow: () => void log.push('follow'),
      face: () => void log.push('face'),
      take: (next) => next === wanted.toUpperCase(),
    };
  });
  return { set, standing: () => standing, since: () => log.splice(0).join(', ') };
}

test('marks are drawn for an arm and a wish, anew for others of them or of the colours, and never twice', () => {
  const { set, standing, since } = watched();
  set.want('row');
  set.follow();
  expect(since()).toBe('');
  set.show(arm);
  expect(since()).toBe('draw arm light row, follow');
  set.setSkin(dark);
  expect(since()).toBe('draw arm dark row, follow');
  set.show(otherArm);
  expect(since()).toBe('draw other arm dark row, follow');
  set.want('cell');
  expect([since(), standing()]).toEqual(['draw other arm dark cell, follow', 1]);
  set.follow();
  set.face?.(/** @type {never} */ (null));
  expect(since()).toBe('follow, face');
  set.want('CELL'); // which what is drawn can show by itself
  expect(since()).toBe('follow');
  set.want('');
  set.follow();
  expect([since(), standing()]).toEqual(['', 0]);
  set.want('row');
  set.show(null);
  expect(standing()).toBe(0);
});
