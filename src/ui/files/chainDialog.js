/**
 * A robot file that leaves a choice: from which link to which the arm goes, and whether axes that are nearly parallel are made
 * so. What comes of it is shown before anything is opened.
 *
 * @import { Doc, RobotDoc } from '../../model/document.js'
 * @import { Issue } from '../../model/issues.js'
 * @import { ArmAnswer } from '../../io/urdf/armDocument.js'
 * @import { FileChain } from '../../io/robotFile.js'
 * @import { Snap } from '../../io/urdf/urdfArm.js'
 */
import '../css/chainDialog.css';
import { DH_FIELDS } from '../../model/document.js';
import { convertLength, toRadians } from '../../model/units.js';
import { DISMISSES, dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { fill, h, symbol } from '../parts/dom.js';
import { compact, jointIcon, unitSign } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { segments } from '../parts/segments.js';
import { TEXT } from '../strings.js';
import { CHAIN } from '../words/chainDialog.js';

const BRIEF = 8;
const LETTERS = { theta: 'θ', d: 'd', a: 'a', alpha: 'α' };
const TWO_DIGITS = 2;

/** A little more than the largest angle, so that rounding leaves none out. */
const MARGIN = 1 + 1e-6;

/**
 * @param {object} given
 * @param {string} given.name   of the file
 * @param {FileChain['read']} given.readChain  of that file
 * @param {(doc: Doc, issues: readonly Issue[]) => void} given.onOpen
 */
export function chooseChain({ name, readChain, onOpen }) {
  /** @type {{ baseLink?: string, tipLink?: string, isSnapped: boolean, read: ArmAnswer }} */
  const now = { isSnapped: false, read: readChain({}) };
  const base = h('select', { id: 'chain-base', class: 'form-select' });
  const tip = h('select', { id: 'chain-tip', class: 'form-select' });
  const result = h('div', { class: 'chain-result' });
  const open = h('button', { type: 'button', class: 'btn btn-primary' }, icon('folder'), CHAIN.open);
  const question = h('p', { class: 'soft' });
  const snapping = segments(CHAIN.snapLabel, ['keep', 'snap'], { keep: CHAIN.keep, snap: CHAIN.snap }, (value) => {
    now.isSnapped = value === 'snap';
    read();
  });
  const effect = h('p', {});
  const nearly = h('div', { class: 'chain-nearly' }, icon('exclamation', 'warn'), effect, snapping.element);

  /** @param {{ baseLink?: string, tipLink?: string }} [links] */
  function read(links = { baseLink: now.baseLink, tipLink: now.tipLink }) {
    Object.assign(now, links);
    const exact = readChain(links);
    const largest = Math.max(0, ...exact.snaps.map(({ angle }) => angle));
    now.read = now.isSnapped && largest > 0 ? readChain({ ...links, snap: toRadians(largest) * MARGIN }) : exact;
    draw();
  }

  function draw() {
    const { doc, issues, choices, snaps } = now.read;
    if (choices) {
      fill(
        base,
        [...new Set([choices.base, ...choices.bases])].map((link) => h('option', { value: link }, link)),
      );
      base.value = choices.base;
      fill(
        tip,
        choices.tips.map(({ link, moving }) => h('option', { value: link }, CHAIN.tipChoice(link, moving))),
      );
      if (choices.tips.length === 0) fill(tip, h('option', {}, CHAIN.none));
      else tip.value = now.tipLink ?? choices.tip ?? '';
    }
    question.textContent = choices?.isOpen || !doc || snaps.length === 0 ? CHAIN.question : CHAIN.questionParallel;
    snapping.draw(now.isSnapped ? 'snap' : 'keep');
    nearly.hidden = snaps.length === 0;
    effect.textContent = snaps.length > 0 ? inWords(snaps) : '';
    open.disabled = doc === null;
    const errors = issues.filter(({ severity }) => severity === 'error');
    fill(
      result,
      doc
        ? [preview(doc.robot), h('p', { class: 'soft sm' }, now.isSnapped && snaps.length ? CHAIN.snapped : CHAIN.one)]
        : errors.map(({ message }) => h('p', { class: 'chain-refused' }, icon('octagon', 'bad'), message)),
    );
  }

  base.addEventListener('change', () => read({ baseLink: base.value, tipLink: undefined }));
  tip.addEventListener('change', () => read({ baseLink: now.baseLink, tipLink: tip.value }));
  open.addEventListener('click', () => {
    const { doc, issues } = now.read;
    if (!doc) return;
    dialog.hide();
    onOpen(doc, issues);
  });
  draw();
  const dialog = openDialog({
    name: 'chain-choice takes-files',
    title: 'chain-title',
    fit: 'modal-dialog-centered modal-fullscreen-sm-down',
    content: [
      dialogHead('chain-title', CHAIN.title(name), { below: question }),
      h(
        'div',
        { class: 'chain-body' },
        h(
          'div',
          { class: 'chain-links' },
          h('label', { for: base.id, class: 'soft' }, CHAIN.base),
          base,
          h('label', { for: tip.id, class: 'soft' }, CHAIN.tip),
          tip,
        ),
        nearly,
        h('div', { role: 'status' }, result),
      ),
      dialogFoot(h('button', { ...DISMISSES, class: 'btn btn-outline' }, CHAIN.cancel), open),
    ],
    onShown: () => (open.disabled ? tip : open).focus(),
  });
  return dialog;
}

/** "Axes 2 and 3 are 0.00042° from parallel; treating them …" @param {readonly Snap[]} snaps */
function inWords(snaps) {
  const pairs = snaps.map(({ after, angle }) =>
    CHAIN.nearly(CHAIN.axes(after, after + 1), String(Number(angle.toPrecision(TWO_DIGITS)))),
  );
  const most = convertLength(Math.max(...snaps.map(({ moves }) => moves)), 'm', 'mm');
  return `${pairs.join(', ')}; ${CHAIN.effect(notLess(most))}`;
}

/** Two digits that say no less. @param {number} value */
function notLess(value) {
  if (!(value > 0)) return '0';
  const step = 10 ** (Math.floor(Math.log10(value)) - 1);
  return String(Number((Math.ceil(value / step) * step).toPrecision(TWO_DIGITS)));
}

/** The table that it becomes. @param {RobotDoc} robot */
const preview = ({ joints, units }) =>
  h(
    'div',
    { class: 'dialog-scroll' },
    h(
      'table',
      { class: 'dialog-table chain-table', 'aria-label': CHAIN.result },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, CHAIN.joint),
          h('th', { scope: 'col' }, CHAIN.name),
          DH_FIELDS.map((field) =>
            h(
              'th',
              { scope: 'col', class: 'number' },
              symbol(LETTERS[field]),
              ' ',
              h('span', { class: 'unit' }, field === 'a' || field === 'd' ? unitSign(units.length) : units.angle),
            ),
          ),
        ),
      ),
      h(
        'tbody',
        {},
        joints.map((joint, i) =>
          h(
            'tr',
            {},
            h('th', { scope: 'row' }, `${i + 1} `, icon(jointIcon(joint)), ' ', TEXT.table.jointType[joint.type]),
            h('td', { class: 'name' }, joint.label ?? joint.id),
            DH_FIELDS.map((field) =>
              h('td', { class: joint[field] === 0 ? 'number zero' : 'number' }, compact(joint[field], BRIEF).text),
            ),
          ),
        ),
      ),
    ),
  );
