/**
 * The line under the DH table: which number is being edited, what it means, and, where a text was refused, why.
 * Nothing pops over the numbers.
 *
 * @import { Page } from './page.js'
 * @import { DhField, JointField, RobotDoc } from '../model/document.js'
 */
import { DH_FIELDS, isSliding, quantityOf } from '../model/document.js';
import { fill, h, symbol } from './dom.js';
import { plain, withUnit } from './format.js';
import { TEXT } from './strings.js';

/** @type {Record<DhField, string>} */
const LETTER = { theta: 'θ', d: 'd', a: 'a', alpha: 'α' };

/** @param {JointField} field @returns {field is DhField} */
const isDhField = (field) => DH_FIELDS.some((known) => known === field);

/** @param {Page} page */
export function createCellLine({ store }) {
  const name = h('span', { class: 'b' });
  const value = h('span', {});
  const meaning = h('p', {});
  const element = h('div', { class: 'cellbar', id: 'cell-line' }, name, value, meaning);
  /** @type {Map<HTMLInputElement, { row: number, field: JointField, reason: string }>} texts that were refused and still stand */
  const refused = new Map();

  /** @param {RobotDoc} robot @param {{ joint: number, field: JointField }} cell */
  function explain({ convention, joints, units }, { joint: row, field }) {
    const joint = joints[row];
    const number = joint[field];
    const unit = units[quantityOf(joint, field)];
    fill(name, isDhField(field) ? symbol(LETTER[field], row + 1) : TEXT.table.fieldName[field]);
    fill(value, h('b', {}, number === undefined ? TEXT.table.unlimited : withUnit(plain(number), unit)));
    const isVariable = field === (isSliding(joint) ? 'd' : 'theta');
    meaning.textContent = isDhField(field)
      ? [TEXT.definition[convention][field](row + 1), isVariable && TEXT.definition.variable(row + 1)]
          .filter(Boolean)
          .join(' ')
      : TEXT.definition[field];
  }

  return {
    element,
    id: element.id,

    /** @param {RobotDoc} robot @param {{ joint: number, field: JointField } | null} cell  the one with focus */
    show(robot, cell) {
      for (const input of refused.keys()) if (!input.isConnected) refused.delete(input);
      const [standing] = [...refused.values()].filter(
        (fault) => !cell || (fault.row === cell.joint && fault.field === cell.field),
      );
      element.classList.toggle('bad-n', Boolean(standing));
      const shown = standing ? { joint: standing.row, field: standing.field } : cell;
      element.classList.toggle('is-hint', !shown);
      if (!shown) {
        fill(name);
        fill(value);
        meaning.textContent = TEXT.table.hint;
        return;
      }
      explain(robot, shown);
      if (standing) {
        fill(value, TEXT.table.kept, ' ', ...value.childNodes);
        meaning.textContent = standing.reason;
      }
    },

    /** @param {HTMLInputElement} input @param {number} row @param {JointField} field @param {string | null} reason */
    refuse(input, row, field, reason) {
      if (reason === null) refused.delete(input);
      else refused.set(input, { row, field, reason });
      this.show(store.state.doc.robot, store.state.session.cell);
    },

    /** While typing: why the text will be refused as it stands, quietly. @param {string | null} reason */
    typed(reason) {
      const { robot } = store.state.doc;
      const { cell } = store.state.session;
      if (cell) explain(robot, cell);
      if (reason !== null) meaning.textContent = reason;
    },
  };
}
