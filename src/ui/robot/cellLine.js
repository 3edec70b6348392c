/**
 * The line under the DH table: which number is being edited, what was typed and what it comes to, and what it means; or
 * why a text was refused, or the question what was meant, each with its ways out. Nothing pops over the numbers.
 *
 * @import { Page } from '../page.js'
 * @import { CellEditor } from './cellEditor.js'
 * @import { Answer, Refused } from '../parts/numberText.js'
 * @import { DhField, JointField, RobotDoc } from '../../model/document.js'
 *
 * @typedef {{ readonly joint: number, readonly field: JointField }} Place
 */
import { isSliding, quantityOf } from '../../model/document.js';
import { keepsText, textOf } from '../../model/robot/jointFields.js';
import { shownText } from '../../model/shownText.js';
import { fill, h, symbol } from '../parts/dom.js';
import { compact, plain, withUnit } from '../parts/format.js';
import { TEXT } from '../strings.js';
import { agreesWith } from '../parts/typedNumber.js';

/** @type {Record<DhField, string>} */
const LETTER = { theta: 'θ', d: 'd', a: 'a', alpha: 'α' };

/** Digits of what an expression comes to. */
const BRIEF = 12;

/** @param {Place | null} one @param {Place | null} other */
const isSame = (one, other) => one?.joint === other?.joint && one?.field === other?.field;

/** @param {Page} page */
export function createCellLine({ store }) {
  const name = h('span', { class: 'b' });
  const value = h('span', { class: 'typed' });
  const meaning = h('p', {});
  const ways = h('div', { class: 'ways' });
  const element = h('div', { class: 'cellbar', id: 'cell-line' }, name, value, meaning, ways);
  // The buttons answer for the cell that has the focus: were it lost to a press, they would be others before the press is over.
  ways.addEventListener('mousedown', (event) => event.preventDefault());
  /** @type {Map<CellEditor, { place: Place, refused: Refused }>} texts that were refused and still stand */
  const standing = new Map();
  /** What the buttons say. */
  let drawn = '';
  /** @type {{ cell: CellEditor, place: Place, answer: Answer<unknown> } | null} as it stands while a person types */
  let typing = null;

  /** The document's number. @param {RobotDoc} robot @param {Place} place */
  function numberOf({ joints, units }, { joint, field }) {
    const number = joints[joint][field];
    return number === undefined
      ? TEXT.table.unlimited
      : withUnit(plain(number), units[quantityOf(joints[joint], field)]);
  }

  /** @param {RobotDoc} robot @param {Place} place */
  function explain(robot, place) {
    const { convention, joints, units } = robot;
    const { joint: row, field } = place;
    const joint = joints[row];
    const number = joint[field];
    const text = textOf(joint, field);
    if (text === undefined || number === undefined) fill(value, h('b', {}, numberOf(robot, place)));
    else {
      const { text: brief, isRounded } = compact(number, BRIEF);
      const comesTo = withUnit(brief, units[quantityOf(joint, field)]);
      fill(value, `${shownText(text)} ${isRounded ? '≈' : '='} `, h('b', {}, comesTo));
    }
    const isVariable = field === (isSliding(joint) ? 'd' : 'theta');
    meaning.textContent = keepsText(field)
      ? [TEXT.definition[convention][field](row + 1), isVariable && TEXT.definition.variable(row + 1)]
          .filter(Boolean)
          .join(' ')
      : TEXT.definition[field];
  }

  /** A file may claim that another text was typed for a number. @param {RobotDoc} robot @param {Place} place */
  function compare({ joints, units }, { joint, field }) {
    const text = textOf(joints[joint], field);
    const number = joints[joint][field];
    if (text === undefined || number === undefined) return;
    const agreement = agreesWith(text, number, { quantity: quantityOf(joints[joint], field), units });
    if (agreement === false) {
      fill(value, h('b', {}, numberOf(store.state.doc.robot, { joint, field })));
      meaning.textContent = TEXT.table.disagrees(`“${shownText(text)}”`);
    } else if (agreement !== true) agreement.then(redraw);
  }

  /** @param {RobotDoc} robot @param {CellEditor} cell @param {Place} place @param {Refused} refused */
  function complain(robot, cell, place, refused) {
    const now = numberOf(robot, place);
    const [waits, keeps] = keepsText(place.field)
      ? [TEXT.table.waits, TEXT.table.keeps]
      : [TEXT.table.waitsPlainly, TEXT.table.stays];
    element.classList.add(refused.isQuestion ? 'ask' : 'bad-n');
    fill(value, h('b', {}, refused.title ?? refused.reason));
    meaning.textContent = refused.isQuestion ? waits(now) : [refused.hint, keeps(now)].filter(Boolean).join(' ');
    drawWays(cell, place, refused);
  }

  /** The buttons that stand are left alone: a pointer or the focus may be on one. @param {CellEditor} cell @param {Place} place @param {Refused} refused */
  function drawWays(cell, { joint, field }, { ways: given = [], isQuestion }) {
    const wanted = [joint, field, isQuestion, ...given.map(({ text }) => text)].join('\n');
    if (wanted === drawn) return;
    drawn = wanted;
    const texts = given.map(({ label, text }) => wayOut(label, () => cell.settle(text)));
    const takeBack = wayOut([TEXT.table.takeBack, h('kbd', {}, TEXT.table.escape)], () => {
      cell.restore();
      cell.input.focus();
    });
    takeBack.classList.remove('btn-outline');
    fill(ways, texts, !isQuestion && takeBack);
  }

  /** Another cell still has a text that was refused: why, and the way there. @param {Place | null} shown */
  function drawOthers(shown) {
    const [other] = shown ? standing : [];
    const wanted = other ? [other[1].place.joint, other[1].place.field, other[1].refused.reason].join('\n') : '';
    if (wanted === drawn) return;
    drawn = wanted;
    if (!other) {
      fill(ways);
      return;
    }
    const [cell, { place, refused }] = other;
    const go = wayOut(TEXT.table.toWaiting, () => cell.input.focus());
    const tone = refused.isQuestion ? 'warn' : 'bad';
    fill(ways, h('span', { class: `sm ${tone}` }, nameOf(place), ': ', refused.title ?? refused.reason), go);
  }

  function redraw() {
    const { robot } = store.state.doc;
    const { cell } = store.state.session;
    for (const [editor, { place }] of standing)
      if (!editor.input.isConnected || place.joint >= robot.joints.length) standing.delete(editor); // another robot was opened
    const live = typing && isSame(typing.place, cell) ? typing : null;
    const asked = live && 'isQuestion' in live.answer && live.answer.isQuestion ? live.answer : null;
    const [old] = live ? [] : [...standing].filter(([, { place }]) => !cell || isSame(place, cell));
    const shown = old ? old[1].place : cell;
    element.classList.remove('ask', 'bad-n');
    element.classList.toggle('is-hint', !shown);
    if (!asked && !old) drawOthers(shown);
    if (!shown) {
      fill(name);
      fill(value);
      meaning.textContent = TEXT.table.hint;
      return;
    }
    fill(name, nameOf(shown));
    if (asked && live) complain(robot, live.cell, shown, asked);
    else if (old) complain(robot, old[0], shown, old[1].refused);
    else {
      explain(robot, shown);
      if (!live) compare(robot, shown);
      else if ('ready' in live.answer) fill(value, TEXT.table.loading);
      else if (live.answer.reason !== null) meaning.textContent = live.answer.reason;
      else if (live.answer.note) meaning.append(' ', live.answer.note);
    }
  }

  return {
    element,
    id: element.id,
    redraw,

    /** @param {CellEditor} cell @param {Place} place @param {Refused | null} refused */
    refuse(cell, place, refused) {
      if (refused === null) standing.delete(cell);
      else standing.set(cell, { place, refused });
      redraw();
    },

    /** While typing: what the text comes to as it stands; null when the typing is over. @param {CellEditor} cell @param {Place} place @param {Answer<unknown> | null} answer */
    typed(cell, place, answer) {
      typing = answer && { cell, place, answer };
      redraw();
    },

    /** To the first way out of a question. @returns {boolean} whether there is one */
    answer() {
      const first = element.classList.contains('ask') ? ways.querySelector('button') : null;
      first?.focus();
      return first !== null;
    },
  };
}

/** @param {Place} place */
const nameOf = ({ joint, field }) =>
  keepsText(field) ? symbol(LETTER[field], joint + 1) : h('span', {}, `J${joint + 1} ${TEXT.table.fieldName[field]}`);

/** @param {string | (string | Node)[]} label @param {() => void} act */
function wayOut(label, act) {
  const button = h('button', { type: 'button', class: 'btn btn-outline' }, label);
  button.addEventListener('click', act);
  return button;
}
