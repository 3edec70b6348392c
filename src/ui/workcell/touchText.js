/**
 * What a step of a program touches, and where, in words.
 *
 * @import { Units } from '../../model/document.js'
 * @import { StepTouch } from '../../model/workcell/checked.js'
 */
import { fromKernel } from '../../model/units.js';
import { compact, fixed, withUnit } from '../parts/format.js';
import { COLLISIONS } from '../words/collisions.js';
import { bodiesText } from './closenessText.js';

const WIDEST = 6;

/** @param {number} metres @param {Units} units */
export const marginText = (metres, units) =>
  withUnit(compact(Number(fromKernel('length', metres, units).toPrecision(12)), WIDEST).text, units.length);

/** "touches box_1" @param {StepTouch} touch */
export const touchShort = (touch) => COLLISIONS.short[touch.isTouch ? 'touch' : 'near'](bodiesText(touch)[1]);

/** @param {StepTouch} touch @param {number} margin  m @param {Units} units */
export function touchSentence(touch, margin, units) {
  const [link, what] = bodiesText(touch);
  const happens = touch.isTouch
    ? COLLISIONS.title.touch(link, what)
    : COLLISIONS.title.near(link, what, marginText(margin, units));
  const where = COLLISIONS.where(fixed(100 * touch.share, 0), fixed(touch.time, 2));
  return COLLISIONS.sentence(touch.step + 1, happens, where);
}
