/**
 * The keys of a spreadsheet in the DH table, and the pointer over it. Where a person is typing, or has put the cursor into
 * the text, arrows move the cursor until it stands at an end; otherwise the whole text is chosen, typing replaces it, and
 * arrows go from cell to cell. Tab is the browser's own: it goes right and out of the table, so it stays a table of named
 * fields, which a screen reader can read as one, rather than a grid with keys of its own. Only from the end of a row it goes
 * to the first cell of the next, past the joint's button, so that a table can be typed in from a book; Shift+Tab and the left
 * arrow go to that button.
 *
 * @import { Page } from '../page.js'
 * @import { JointField } from '../../model/document.js'
 */
import $ from 'jquery/slim';
import { keepsText } from '../../model/robot/jointFields.js';

/**
 * @param {HTMLTableElement} table
 * @param {() => readonly (readonly HTMLInputElement[])[]} rows  the cells that stand
 * @param {() => boolean} answer  goes to what was asked, if anything was
 */
export function watchTableKeys(table, rows, answer) {
  /** @param {number} row @param {number} column @param {number} down @param {number} right @returns {boolean} whether there was a cell to go to */
  function goFrom(row, column, down, right) {
    const cells = rows();
    let [nextRow, nextColumn] = [row + down, column + right];
    while (cells[nextRow]?.[nextColumn]?.disabled) [nextRow, nextColumn] = [nextRow + down, nextColumn + right];
    cells[nextRow]?.[nextColumn]?.focus();
    return Boolean(cells[nextRow]?.[nextColumn]);
  }

  /** @param {HTMLInputElement} input @param {number} down @param {number} right */
  function go(input, down, right) {
    const row = rows().findIndex((list) => list.includes(input));
    return goFrom(row, rows()[row].indexOf(input), down, right);
  }

  /** The first or the last cell of the row, or of the table. @param {HTMLInputElement} input @param {boolean} isLast @param {boolean} isFar */
  function goToEnd(input, isLast, isFar) {
    const row = isFar ? (isLast ? rows().length - 1 : 0) : rows().findIndex((list) => list.includes(input));
    return isLast ? goFrom(row, rows()[row].length, 0, -1) : goFrom(row, -1, 0, 1);
  }

  /** To the joint's own button, from the first cell of its row. @param {HTMLInputElement} input @returns {boolean} */
  function goToJoint(input) {
    const row = rows().find((list) => list.includes(input));
    const button = row?.find((cell) => !cell.disabled) === input ? input.closest('tr')?.querySelector('button') : null;
    button?.focus();
    return Boolean(button);
  }

  /** From the last cell of a row to the first of the next. @param {HTMLInputElement} input @returns {boolean} */
  function goToNextRow(input) {
    const row = rows().findIndex((list) => list.includes(input));
    return rows()[row].findLast((cell) => !cell.disabled) === input && goFrom(row + 1, -1, 0, 1);
  }

  /** @param {HTMLInputElement} input @param {boolean} isUp */
  function enter(input, isUp) {
    if (input.getAttribute('aria-invalid') === 'true') return answer();
    if (!input.hasAttribute('aria-busy')) return go(input, isUp ? -1 : 1, 0);
    input.addEventListener('settled', () => document.activeElement === input && enter(input, isUp), { once: true });
    return true;
  }

  $(table).on('keydown', 'input', (event) => {
    const input = /** @type {HTMLInputElement} */ (event.currentTarget);
    const { selectionStart: start, selectionEnd: end, value } = input;
    const { key, shiftKey, altKey } = event;
    const isFar = event.ctrlKey || event.metaKey;
    const isAll = start === 0 && end === value.length;
    const isEditing = 'editing' in input.dataset || !isAll;
    const isPlain = !altKey && !isFar && !shiftKey;
    const moved =
      (key === 'ArrowUp' && isPlain && go(input, -1, 0)) ||
      (key === 'ArrowDown' && isPlain && go(input, 1, 0)) ||
      (key === 'ArrowLeft' &&
        isPlain &&
        (isAll || (start === 0 && end === 0)) &&
        (go(input, 0, -1) || goToJoint(input))) ||
      (key === 'Tab' && isPlain && goToNextRow(input)) ||
      (key === 'ArrowRight' && isPlain && (isAll || start === value.length) && go(input, 0, 1)) ||
      (key === 'Enter' && !altKey && enter(input, shiftKey)) ||
      ((key === 'Home' || key === 'End') &&
        !shiftKey &&
        (isFar || !isEditing) &&
        goToEnd(input, key === 'End', isFar)) ||
      (key === 'F2' && turnCursor(input, isEditing));
    if (moved) event.preventDefault();
  });
}

/** F2: into the text, and out of it again. @param {HTMLInputElement} input @param {boolean} isEditing */
function turnCursor(input, isEditing) {
  if (isEditing) input.select();
  else input.setSelectionRange(input.value.length, input.value.length);
  return true;
}

/**
 * The parameter under a mouse is told, so that it can be shown in the scene. A finger touches a cell to edit it, which says
 * the same.
 * @param {Page} page
 * @param {HTMLTableElement} table
 * @param {readonly JointField[]} fields  of the columns
 */
export function watchTablePointer({ store }, table, fields) {
  /** @param {number | null} joint @param {JointField} [field] */
  function point(joint, field) {
    const old = store.state.session.pointedCell;
    if (joint === null || field === undefined || !keepsText(field)) {
      if (old) store.dispatch({ type: 'show', change: { pointedCell: null } });
    } else if (old?.joint !== joint || old.field !== field) {
      store.dispatch({ type: 'show', change: { pointedCell: { joint, field } } });
    }
  }
  table.addEventListener('pointerover', ({ target, pointerType }) => {
    const cell = target instanceof Element && pointerType !== 'touch' ? target.closest('td') : null;
    if (cell) point(Number(cell.parentElement?.dataset.row), fields[cell.cellIndex - 1]);
    else point(null);
  });
  table.addEventListener('pointerleave', () => point(null));
}
