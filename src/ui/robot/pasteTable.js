/**
 * A pasted table is looked at before it fills the grid: which columns are which, in which units and convention, what each
 * cell comes to and what changes. It is loaded when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { ColumnGuess, ColumnRole, PastedUnits } from '../../io/tableTextColumns.js'
 * @import { Convention, DhField } from '../../model/document.js'
 * @import { Plan } from './pasteTablePlan.js'
 */
import { readTableText } from '../../io/tableText.js';
import { guessColumns } from '../../io/tableTextColumns.js';
import { DH_FIELDS } from '../../model/document.js';
import { convertLength } from '../../model/units.js';
import { ANGLE_UNITS, CONVENTIONS, LENGTH_UNITS } from '../../model/documentRules.js';
import '../css/typedIn.css';
import '../css/pasteTable.css';
import { DISMISSES, dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { fill, h } from '../parts/dom.js';
import { compact, plain, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { planPaste } from './pasteTablePlan.js';
import { TEXT } from '../strings.js';
import { PASTE } from '../words/pasteTable.js';

const ROLES = /** @type {readonly ColumnRole[]} */ (['theta', 'd', 'a', 'alpha', 'offset', 'none']);
const SHOWN_FAULTS = 4;
const BRIEF = 8;

/** Hardly an arm: its table may be in other units than it is read in. */
const SHORT_METRES = 0.01;

/**
 * @param {Page} page
 * @param {string} pasted
 * @param {{ joint: number, field: string } | null} cell  the one that it was pasted into
 */
export function openPasteTable(page, pasted, cell) {
  if (document.querySelector('.paste-table')) return;
  const { store, announce } = page;
  const { robot } = store.state.doc;
  const start = DH_FIELDS.findIndex((field) => field === cell?.field);
  /** @type {{ roles: ColumnRole[], others: ColumnGuess['others'], rows: readonly (readonly string[])[], plan: Plan | null }} */
  const now = { roles: [], others: {}, rows: [], plan: null };

  const text = h('textarea', { class: 'text-box', rows: 5, spellcheck: 'false', id: 'paste-text' });
  text.value = pasted.slice(0, 100_000);
  const summary = h('p', { class: 'soft sm' });
  const length = select(PASTE.lengths, [...LENGTH_UNITS, 'in'], robot.units.length);
  const angle = select(PASTE.angles, ANGLE_UNITS, robot.units.angle);
  const convention = select(PASTE.convention, CONVENTIONS, robot.convention);
  const scope = select(PASTE.scope, ['replace', 'fill'], 'replace', {
    replace: PASTE.replace,
    fill: cell && start >= 0 ? PASTE.fill(`J${cell.joint + 1} ${PASTE.role[/** @type {DhField} */ (cell.field)]}`) : '',
  });
  scope.element.hidden = !cell || start < 0;
  const table = h('table', { class: 'dialog-table paste-preview', 'aria-label': PASTE.preview });
  const outcome = h('div', { class: 'paste-outcome', role: 'status' });
  const apply = h('button', { type: 'button', class: 'btn btn-primary' }, PASTE.apply);
  const cancel = h('button', { ...DISMISSES, class: 'btn btn-outline' }, PASTE.cancel);
  text.setAttribute('aria-label', PASTE.text);

  /** The text is another: everything is guessed anew. */
  function read() {
    const { table: found, fault } = readTableText(text.value);
    now.rows = [];
    if (fault !== null) {
      summary.textContent = text.value.trim() === '' ? '' : PASTE.fault[fault];
      return draw();
    }
    const guess = guessColumns(found.rows, robot.convention);
    now.rows = guess.hasHead ? found.rows.slice(1) : found.rows;
    const isBlock = found.rows[0].length < DH_FIELDS.length && !guess.isNamed;
    if (!scope.element.hidden) scope.control.value = isBlock || now.rows.length < 2 ? 'fill' : 'replace';
    now.roles = [...guess.roles];
    now.others = guess.others;
    if (guess.units.length) length.control.value = guess.units.length;
    if (guess.units.angle) angle.control.value = guess.units.angle;
    if (guess.isModified) convention.control.value = 'modified';
    summary.textContent = [
      PASTE.read(PASTE.format[found.format], now.rows.length, found.rows[0].length),
      !guess.isNamed && PASTE.order,
    ]
      .filter(Boolean)
      .join(' ');
    placeColumns(guess.isNamed);
  }

  /** Columns without names go, in a block, where they were pasted. @param {boolean} isNamed */
  function placeColumns(isNamed) {
    const isFill = scope.control.value === 'fill' && !scope.element.hidden;
    if (isFill && !isNamed) now.roles = now.roles.map((_, column) => DH_FIELDS[start + column] ?? 'none');
    draw();
  }

  function draw() {
    const isFill = scope.control.value === 'fill' && !scope.element.hidden;
    convention.element.hidden = isFill;
    const units = /** @type {PastedUnits} */ ({ length: length.control.value, angle: angle.control.value });
    now.plan = now.rows.length
      ? planPaste(robot, {
          ...{ rows: now.rows, roles: now.roles, others: now.others, units, from: isFill && cell ? cell.joint : null },
          convention: /** @type {Convention} */ (convention.control.value),
        })
      : null;
    apply.disabled = !now.plan || now.plan.faults.length > 0;
    fill(table, now.plan && preview(now.plan, now.rows, now.roles));
    fill(outcome, now.plan && outcomeOf(now.plan, isFill));
  }

  /** @param {Plan} plan @param {boolean} isFill */
  function outcomeOf({ faults, changes, hasPi, rows, longest }, isFill) {
    const { length } = robot.units;
    if (faults.length) {
      const more = faults.length - SHOWN_FAULTS;
      return h(
        'ul',
        { class: 'paste-faults' },
        faults.slice(0, SHOWN_FAULTS).map((fault) => h('li', {}, fault)),
        more > 0 && h('li', {}, PASTE.more(more)),
      );
    }
    const missing = DH_FIELDS.filter((field) => !now.roles.includes(field)).map((field) => PASTE.role[field]);
    const staying = rows.some(({ joint, isRetyped }) => !isRetyped && robot.joints[joint]?.lower !== undefined);
    const retyped = rows.filter(({ isRetyped }) => isRetyped).map(({ joint }) => `J${joint + 1}`);
    return h(
      'p',
      { class: 'sm' },
      [
        PASTE.changes(changes),
        !isFill && rows.length !== robot.joints.length && PASTE.count(robot.joints.length, rows.length),
        !isFill && missing.length > 0 && PASTE.missing(missing.join(', ')),
        retyped.length > 0 && PASTE.types(retyped.join(', ')),
        !isFill && staying && PASTE.limitsStay(retyped.length > 0),
        hasPi && PASTE.piAsRadians,
        !isFill &&
          longest > 0 &&
          convertLength(longest, length, 'm') < SHORT_METRES &&
          PASTE.short(withUnit(compact(longest, BRIEF).text, length)),
      ]
        .filter(Boolean)
        .join(' '),
    );
  }

  text.addEventListener('input', read);
  scope.control.addEventListener('change', () => {
    if (scope.control.value === 'replace') {
      const found = readTableText(text.value).table;
      if (found) now.roles = [...guessColumns(found.rows, robot.convention).roles];
      draw();
    } else placeColumns(guessColumns(readTableText(text.value).table?.rows ?? [['']], robot.convention).isNamed);
  });
  for (const { control } of [length, angle, convention]) control.addEventListener('change', draw);
  table.addEventListener('change', ({ target }) => {
    if (!(target instanceof HTMLSelectElement)) return;
    const column = Number(target.dataset.column);
    const role = /** @type {ColumnRole} */ (target.value);
    now.roles = now.roles.map((old, i) => (i === column ? role : old === role ? 'none' : old));
    draw();
    const again = table.querySelector(`[data-column='${column}']`);
    if (again instanceof HTMLElement) again.focus();
  });
  apply.addEventListener('click', () => {
    if (!now.plan) return;
    const { changes, command } = now.plan;
    const reason = attempt(page, command);
    if (reason !== null) {
      fill(outcome, h('ul', { class: 'paste-faults' }, h('li', {}, reason)));
      return;
    }
    announce(PASTE.done(changes));
    dialog.hide();
  });
  read();
  const dialog = openDialog({
    name: 'paste-table',
    title: 'paste-title',
    fit: 'modal-dialog-centered modal-fullscreen-sm-down',
    content: [
      dialogHead('paste-title', PASTE.title),
      h(
        'div',
        { class: 'paste-body' },
        h('label', { for: text.id, class: 'sm soft' }, PASTE.hint),
        text,
        summary,
        h(
          'div',
          { class: 'paste-options' },
          [scope, length, angle, convention].map(({ element }) => element),
        ),
        h('div', { class: 'dialog-scroll' }, table),
        outcome,
      ),
      dialogFoot(cancel, apply),
    ],
    onShown: () => (now.plan && !apply.disabled ? apply : text).focus(),
  });
}

/** @param {Plan} plan @param {readonly (readonly string[])[]} rows @param {readonly ColumnRole[]} roles */
function preview(plan, rows, roles) {
  const head = roles.map((role, column) => {
    const { control } = select(PASTE.column(column + 1), ROLES, role, PASTE.role);
    control.dataset.column = String(column);
    control.setAttribute('aria-label', PASTE.column(column + 1));
    return h('th', { scope: 'col' }, control);
  });
  const body = plan.rows.map(({ joint, type, isRetyped, cells }, i) =>
    h(
      'tr',
      {},
      h(
        'th',
        { scope: 'row', class: isRetyped ? 'is-new' : null },
        `${joint + 1} `,
        type && icon(type),
        type && h('span', { class: 'visually-hidden' }, TEXT.table.jointType[type]),
      ),
      roles.map((role, column) => {
        const raw = rows[i][column];
        const cell = role === 'none' || role === 'offset' ? undefined : cells[role];
        if (!cell) return h('td', { class: 'is-unused' }, raw);
        if (cell.value === null) return h('td', { class: 'is-bad', title: cell.reason }, raw || '?');
        const shown = compact(cell.value, BRIEF).text;
        const isAsPasted = raw === shown || raw.replace('-', '−') === shown;
        return h(
          'td',
          { class: cell.isNew ? 'is-new' : null, title: plain(cell.value) },
          !isAsPasted && h('small', {}, raw),
          h('span', {}, shown),
        );
      }),
    ),
  );
  return [h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, PASTE.joint), head)), h('tbody', {}, body)];
}

/** @param {string} label @param {readonly string[]} values @param {string} value @param {Record<string, string>} [names] */
function select(label, values, value, names = {}) {
  const control = h(
    'select',
    { class: 'choice-box' },
    values.map((each) => h('option', { value: each }, names[each] ?? each)),
  );
  control.value = value;
  return { control, element: h('label', { class: 'paste-option sm' }, h('span', { class: 'soft' }, label), control) };
}
