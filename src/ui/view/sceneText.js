/**
 * The words of the scene's labels, in the document's own units.
 *
 * @import { Page } from '../page.js'
 * @import { DhField } from '../../model/document.js'
 *
 * @typedef {readonly (string | readonly [letter: string, index: string])[]} Parts  text, and symbols with their index
 */
import { isSliding, quantityOf } from '../../model/document.js';
import { isInside } from '../../model/jog/jogRange.js';
import { fromKernel } from '../../model/units.js';
import { editable, jointNumber, plain, poseNumber, unitOf, withUnit } from '../parts/format.js';
import { TEXT } from '../strings.js';

/** @type {Record<DhField, string>} */
export const LETTER = { theta: 'θ', d: 'd', a: 'a', alpha: 'α' };

/** @param {Pick<Page, 'store'>} page */
export function createSceneText({ store }) {
  const robot = () => store.state.doc.robot;
  const length = (/** @type {number} */ metres) => fromKernel('length', metres, robot().units);

  return {
    view: '',

    /** @param {number} index */
    jointValue(index) {
      const joint = robot().joints[index];
      const unit = unitOf(joint, robot().units);
      const value = store.state.doc.posture[index];
      const text = `J${index + 1} ${withUnit(jointNumber(value, unit), unit)}`;
      if (!isInside(joint, value)) return TEXT.jog.outsideShort(text);
      return value === joint.lower || value === joint.upper ? TEXT.jog.atLimitShort(text) : text;
    },

    /** @param {number} index @param {'lower' | 'upper'} which */
    jointLimit(index, which) {
      const joint = robot().joints[index];
      const limit = joint[which];
      return limit === undefined ? '' : withUnit(editable(limit), unitOf(joint, robot().units));
    },

    /** @param {number} index @param {number} by  radians or metres */
    jointExcess(index, by) {
      const joint = robot().joints[index];
      const unit = unitOf(joint, robot().units);
      const past = fromKernel(quantityOf(joint, 'home'), by, robot().units);
      return `J${index + 1} +${withUnit(jointNumber(past, unit), unit)}`;
    },

    lost: TEXT.drag.lost,
    nearest: TEXT.drag.nearest,
    trace: { start: TEXT.view.traceStart },

    /** @param {number} metres */
    missing: (metres) => withUnit(poseNumber(length(metres), robot().units.length), robot().units.length),

    /** @param {number} metres  of a square of the floor */
    gridStep: (metres) => withUnit(plain(Number(length(metres).toPrecision(3))), robot().units.length),

    /**
     * What a dimension says: the number of the table and, where the joint value adds to it, both and their sum.
     * @param {number} index
     * @param {DhField} field
     * @returns {Parts}
     */
    dimension(index, field) {
      const joint = robot().joints[index];
      const unit = robot().units[quantityOf(joint, field)];
      const value = (/** @type {string} */ text) => (Number(text) === 0 ? '0' : withUnit(text, unit));
      const number = String(index + 1);
      const constant = joint[field];
      if (field !== (isSliding(joint) ? 'd' : 'theta'))
        return [[LETTER[field], number], ` = ${value(editable(constant))}`];
      const q = store.state.doc.posture[index];
      const sum = value(jointNumber(constant + q, unit));
      const both = `${value(editable(constant))} ${q < 0 ? '−' : '+'} ${value(jointNumber(Math.abs(q), unit))} = `;
      return [[LETTER[field], number], ' + ', ['q', number], ` = ${constant === 0 ? '' : both}${sum}`];
    },
  };
}

/** A label as plain text. @param {Parts} parts */
export const asText = (parts) =>
  parts
    .map((part) =>
      typeof part === 'string' ? part : part[0] + [...part[1]].map((digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]).join(''),
    )
    .join('');
