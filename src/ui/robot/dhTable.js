/**
 * The DH table: a grid, not a form. One cell for each number; arrow keys and Enter go from cell to cell as in a
 * spreadsheet, where that does not get in the way of the text cursor.
 *
 * @import { Page } from '../page.js'
 * @import { CellEditor } from './cellEditor.js'
 * @import { JointDoc, JointField, RobotDoc } from '../../model/document.js'
 */
import $ from 'jquery/slim';
import { isSliding, quantityOf } from '../../model/document.js';
import { keepsText, textOf } from '../../model/robot/jointFields.js';
import { together } from '../../model/views.js';
import { editCell } from './cellEditor.js';
import { createCellLine } from './cellLine.js';
import { fill, h, spoken, symbol } from '../parts/dom.js';
import { compact, plain, unitOf, unitSign } from '../parts/format.js';
import { createJointMenu } from './jointMenu.js';
import { fractionOfPi } from '../parts/numberText.js';
import { createStructureControls } from './structureControls.js';
import { TEXT } from '../strings.js';
import { watchTablePaste } from './tablePaste.js';
import { watchTableKeys, watchTablePointer } from './tableKeys.js';
import { readTyped, readTypedLimit } from '../parts/typedNumber.js';

/** @type {readonly { field: JointField, letter: string | null }[]} */
const COLUMNS = [
  { field: 'theta', letter: 'θ' },
  { field: 'd', letter: 'd' },
  { field: 'a', letter: 'a' },
  { field: 'alpha', letter: 'α' },
  { field: 'lower', letter: null },
  { field: 'upper', letter: null },
];

const FIELDS = COLUMNS.map(({ field }) => field);

/** How many characters of a number a cell has room for, and how many beside the variable that it adds to. */
const WIDEST = { theta: 7, d: 8, a: 7, alpha: 5, lower: 5, upper: 5, home: 6 };
const WIDEST_MIXED = { ...WIDEST, d: 7, a: 5 }; // where limits have a unit in each row
const BESIDE_VARIABLE = 4;

/** The column whose constant the joint value adds to. @param {JointDoc} joint @returns {JointField} */
const variableOf = (joint) => (isSliding(joint) ? 'd' : 'theta');

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createDhTable(page, host) {
  const { store, addView } = page;
  const table = h('table', { class: 'grid', 'aria-label': TEXT.table.title });
  const structure = createStructureControls(page);
  const cellLine = createCellLine(page);
  fill(host, structure.head, h('div', { class: 'grid-scroll' }, table), structure.foot, cellLine.element);
  /** @type {CellEditor[][]} one row for each joint */
  let cells = [];
  /** @type {HTMLButtonElement[]} at the head of each row */
  let menus = [];
  /** @type {number | null} the row whose head is to have the focus when the grid stands again */
  let goal = null;

  const jointAt = (/** @type {number} */ index) => store.state.doc.robot.joints[index];
  const show = (/** @type {number} */ joint, /** @type {JointField} */ field) => {
    const value = jointAt(joint)[field];
    return value === undefined ? '' : plain(value);
  };

  /** What a cell shows while nobody edits it: the number, rounded if it must be to fit. @param {HTMLInputElement} input @param {number} row @param {JointField} field */
  function rest(input, row, field) {
    const value = jointAt(row)[field];
    if (value === undefined) return '';
    const { angle } = store.state.doc.robot.units;
    const room = (table.classList.contains('is-mixed') ? WIDEST_MIXED : WIDEST)[field];
    const isTurn = angle === 'rad' && quantityOf(jointAt(row), field) === 'angle';
    const fraction = isTurn ? fractionOfPi(value) : null; // exact where the digits would not be
    const { text, isRounded } =
      fraction && fraction.length <= room ? { text: fraction, isRounded: false } : compact(value, room);
    input.title = text === fraction || isRounded ? plain(value) : '';
    input.classList.toggle('is-rounded', isRounded);
    input.parentElement?.classList.toggle('is-long', text.length > BESIDE_VARIABLE);
    return text;
  }

  /** @param {number} row @param {JointField} field */
  function makeCell(row, field) {
    const { units } = store.state.doc.robot;
    const joint = jointAt(row);
    const unit = units[quantityOf(joint, field)];
    const isLimit = field === 'lower' || field === 'upper';
    const label = TEXT.table.cell(row + 1, TEXT.table.fieldName[field], TEXT.table.unitName[unit]);
    const input = h('input', {
      type: 'text',
      inputmode: 'text',
      'aria-label': label,
      'aria-describedby': cellLine.id,
      autocomplete: 'off',
      spellcheck: 'false',
      placeholder: isLimit ? TEXT.table.unlimited : null,
      disabled: isLimit && joint.type === 'continuous',
    });
    const place = { joint: row, field };
    const measure = () => {
      const { robot } = store.state.doc;
      return { quantity: quantityOf(robot.joints[row], field), units: robot.units };
    };
    const cell = editCell(page, input, {
      measure,
      read: (text) => (isLimit ? readTypedLimit : readTyped)(text, measure()),
      command: (/** @type {number | undefined} */ value, text) => ({
        ...{ type: 'set-joint-field', joint: row, field, value },
        ...(keepsText(field) && text !== undefined && { text }),
      }),
      again: () => ({
        ...{ type: 'set-joint-field', joint: row, field, value: jointAt(row)[field] },
        text: textOf(jointAt(row), field),
      }),
      onDone: () => `${label}: ${show(row, field) || TEXT.table.unlimited}`,
      onReason: (_, refused) => {
        input.classList.toggle('is-asked', refused?.isQuestion ?? false);
        cellLine.refuse(cell, place, refused);
      },
      onTyped: (_, answer) => cellLine.typed(cell, place, answer),
      text: () => textOf(jointAt(row), field) ?? show(row, field),
      resting: () => (jointAt(row) ? rest(input, row, field) : ''), // left because its row is gone
    });
    input.addEventListener('focus', () => {
      store.dispatch({ type: 'show', change: { cell: place } });
      cellLine.redraw(); // at once: a screen reader reads the description now
    });
    return cell;
  }

  /** @param {RobotDoc} robot */
  function build({ joints, units }) {
    const edited = placeOf(document.activeElement);
    cells = joints.map((_, row) => COLUMNS.map(({ field }) => makeCell(row, field)));
    const sameKind = joints.every((joint) => isSliding(joint) === isSliding(joints[0]));
    table.classList.toggle('is-mixed', !sameKind);
    const head = COLUMNS.map(({ field, letter }) => {
      // Limits of a mixed arm have a unit in each row, not in the head.
      const unit = letter || sameKind ? unitSign(units[quantityOf(joints[0], field)]) : '';
      const title = letter
        ? [symbol(letter), spoken(TEXT.table.fieldName[field])]
        : TEXT.table[field === 'lower' ? 'lower' : 'upper'];
      return h(
        'th',
        { scope: 'col', class: letter ? 'dh' : 'limit', 'data-column': field },
        title,
        h('span', { class: 'unit' }, unit === '°' ? 'deg' : unit),
      );
    });
    const focused = menus.findIndex((button) => button === document.activeElement);
    const heads = joints.map((_, row) => createJointMenu(page, row, { say: structure.say, goTo: (to) => (goal = to) }));
    menus = heads.map(({ button }) => button);
    const rows = joints.map((joint, row) =>
      h(
        'tr',
        { 'data-row': row },
        h('th', { scope: 'row', class: 'start' }, heads[row].element),
        COLUMNS.map(({ field, letter }, column) => {
          const isVariable = field === variableOf(joint);
          const ownUnit = !letter && !sameKind ? unitSign(unitOf(joint, units)) : null;
          return h(
            'td',
            {
              class:
                [isVariable && 'has-var', !letter && 'limit', ownUnit && 'has-unit'].filter(Boolean).join(' ') || null,
            },
            isVariable && h('span', { class: 'var', 'aria-hidden': 'true' }, symbol('q', row + 1), '+'),
            cells[row][column].input,
            ownUnit && h('span', { class: 'unit', 'aria-hidden': 'true' }, ownUnit),
          );
        }),
      ),
    );
    fill(
      table,
      h('thead', {}, h('tr', {}, h('th', { scope: 'col', class: 'start' }, TEXT.table.joint), head)),
      h('tbody', {}, rows),
    );
    if (goal !== null || focused >= 0) menus[Math.min(goal ?? focused, menus.length - 1)].focus();
    else if (edited) goOnAt(edited);
    goal = null;
  }

  /** @param {Element | null} element @returns {{ row: number, column: number } | null} */
  function placeOf(element) {
    for (const [row, inputs] of cells.entries()) {
      const column = inputs.findIndex(({ input }) => input === element);
      if (column >= 0) return { row, column };
    }
    return null;
  }

  /** The cell that had the focus is gone, and not every browser says so: the one in its place has it now. @param {{ row: number, column: number }} place */
  function goOnAt({ row, column }) {
    store.dispatch({ type: 'show', change: { cell: null } });
    cells[Math.min(row, cells.length - 1)][column].input.focus({ preventScroll: true });
  }

  watchTableKeys(table, () => cells.map((row) => row.map(({ input }) => input)), cellLine.answer);
  watchTablePointer(page, table, FIELDS);
  watchTablePaste(page, table, structure.foot);
  const isTable = (/** @type {unknown} */ to) =>
    to instanceof Node && (table.contains(to) || cellLine.element.contains(to));
  $([table, cellLine.element]).on('focusout', ({ relatedTarget }) => {
    if (!isTable(relatedTarget)) store.dispatch({ type: 'show', change: { cell: null } });
  });

  /** @param {RobotDoc} robot */
  function draw({ joints }) {
    joints.forEach((joint, row) =>
      COLUMNS.forEach(({ field }, column) => {
        cells[row][column].refresh();
        cells[row][column].input.parentElement?.classList.toggle('zero', joint[field] === 0);
      }),
    );
  }

  /** @type {string} the shape of the grid that stands */
  let shape = '';
  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.robot, session.edition]),
    ([robot, now]) => {
      if (now !== edition) cells.flat().forEach((cell) => cell.forget());
      edition = now;
      const wanted = [
        robot.name,
        robot.units.length,
        robot.units.angle,
        ...robot.joints.map(({ id, type }) => `${id} ${type}`),
      ].join();
      if (wanted !== shape) build(robot);
      shape = wanted;
      draw(robot);
    },
  );
  addView(
    together(({ doc, session }) => [doc.robot, session.cell, session.heldJoint]),
    ([, cell, heldJoint]) => {
      const on = cell?.joint ?? heldJoint;
      for (const row of table.querySelectorAll('tbody tr'))
        row.classList.toggle('on', row.getAttribute('data-row') === String(on));
      cellLine.redraw();
    },
  );
}
