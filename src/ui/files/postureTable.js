/**
 * A table of postures from a file, looked at before it is taken: what each row does, and why one does nothing. Taking it is
 * one undo step. Fetched with the first such file.
 *
 * @import { Page } from '../page.js'
 * @import { PostureReading } from '../../io/postureCsv.js'
 * @import { PosturePlan } from '../../model/program/posturePlan.js'
 */
import '../css/postureTable.css';
import { planPostures } from '../../model/program/posturePlan.js';
import { DISMISSES, dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { fill, h } from '../parts/dom.js';
import { compact } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { segments } from '../parts/segments.js';
import { POSTURES } from '../words/postureTable.js';

const BRIEF = 8;

/**
 * @param {Page} page
 * @param {string} name  of the file
 * @param {PostureReading} reading  without a fault
 */
export function openPostureTable(page, name, { rows, hasHead, unused }) {
  const { store, announce } = page;
  const { doc } = store.state;
  const { joints, units } = doc.robot;
  /** @type {{ mode: 'add' | 'replace', plan: PosturePlan }} */
  const now = { mode: 'add', plan: planPostures(doc, rows, 'add') };
  const inUnits = [
    ...new Set(joints.map(({ type }) => (type === 'prismatic' ? units.length : units.angle))), // in the order of joints
  ].join(', ');
  const table = h('table', { class: 'dialog-table posture-table', 'aria-label': POSTURES.preview });
  const outcome = h('p', { class: 'sm', role: 'status' });
  const apply = h('button', { type: 'button', class: 'btn btn-primary' });
  const mode = segments(POSTURES.mode, ['add', 'replace'], POSTURES.modes, (value) => {
    now.mode = value;
    draw();
  });

  function draw() {
    now.plan = planPostures(doc, rows, now.mode);
    const { plan } = now;
    mode.draw(now.mode);
    const refused = plan.rows.filter(({ fate }) => fate === 'refused').length;
    const kept = new Set(plan.command.postures.map(({ id }) => id));
    const gone = doc.postures.filter(({ id }) => !kept.has(id)).length;
    outcome.textContent = [refused > 0 && POSTURES.refused(refused), gone > 0 && POSTURES.goes(gone)]
      .filter(Boolean)
      .join(' ');
    apply.textContent = POSTURES.apply(rows.length - refused);
    apply.disabled = plan.isEmpty;
    fill(
      table,
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, POSTURES.line),
          h('th', { scope: 'col' }, POSTURES.name),
          joints.map((joint, i) =>
            h('th', { scope: 'col', class: 'number', title: joint.label ?? joint.id }, POSTURES.joint(i + 1)),
          ),
          h('th', { scope: 'col' }, POSTURES.effect),
        ),
      ),
      h(
        'tbody',
        {},
        plan.rows.flatMap((row, i) => rowsOf(row, rows[i].line, rows[i].q, joints.length)),
      ),
    );
  }

  apply.addEventListener('click', () => {
    const reason = attempt(page, now.plan.command);
    if (reason !== null) {
      outcome.textContent = reason;
      return;
    }
    announce(POSTURES.done(now.plan.rows.filter(({ fate }) => fate !== 'refused').length));
    dialog.hide();
  });
  draw();
  const dialog = openDialog({
    name: 'posture-import takes-files',
    title: 'postures-title',
    fit: 'modal-dialog-centered modal-fullscreen-sm-down',
    content: [
      dialogHead('postures-title', POSTURES.title(name), {
        below: [
          h('p', { class: 'soft' }, hasHead ? POSTURES.read(rows.length, inUnits) : POSTURES.noUnits(inUnits)),
          unused.length > 0 && h('p', { class: 'soft' }, POSTURES.unused(unused.join(', '))),
        ],
      }),
      h(
        'div',
        { class: 'posture-body' },
        h('div', { class: 'row-flex' }, h('span', { class: 'soft' }, POSTURES.mode), mode.element),
        h('div', { class: 'dialog-scroll posture-scroll' }, table),
        outcome,
      ),
      dialogFoot(h('button', { ...DISMISSES, class: 'btn btn-outline' }, POSTURES.cancel), apply),
    ],
    onShown: () => apply.focus(),
  });
  return dialog;
}

/** @param {PosturePlan['rows'][number]} row @param {number} line @param {readonly number[] | null} q @param {number} count */
function rowsOf({ name, fate, reason }, line, q, count) {
  const isRefused = fate === 'refused';
  const values = q
    ? q.map((value) => h('td', { class: 'number' }, compact(value, BRIEF).text))
    : [h('td', { colspan: count })];
  const row = h(
    'tr',
    { class: isRefused ? 'is-refused' : null },
    h('td', { class: 'soft' }, String(line)),
    h('th', { scope: 'row' }, name),
    values,
    h('td', {}, isRefused && icon('octagon', 'bad'), isRefused && ' ', POSTURES.fate[fate]),
  );
  if (!isRefused) return [row];
  return [row, h('tr', { class: 'is-refused why' }, h('td'), h('td', { colspan: count + 2 }, reason))];
}
