/**
 * The bar on top: which robot, its file, undo and redo, units, colours.
 * @import { Child } from './dom.js'
 * @import { IconName } from './icons.js'
 * @import { Page } from './page.js'
 * @import { RobotDoc } from '../model/document.js'
 * @import { Files } from './files.js'
 * @import { Theme } from './theme.js'
 */
import $ from 'jquery/slim';
import Dropdown from 'bootstrap/js/src/dropdown.js';
import { LIBRARY, newDocument } from '../model/library.js';
import { isSliding } from '../model/document.js';
import { fill, h, spoken } from './dom.js';
import { icon } from './icons.js';
import { step } from './page.js';
import { TEXT } from './strings.js';

/** "6R" or "RRPR": a joint's letter each, a single kind shortened. @param {RobotDoc} robot */
function typesOf({ joints }) {
  const letters = joints.map((joint) => (isSliding(joint) ? 'P' : 'R')).join('');
  return /^(.)\1*$/.test(letters) ? `${letters.length}${letters[0]}` : letters;
}

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ files: Files, theme: Theme }} tools
 */
export function createBar(page, host, { files, theme }) {
  const { addView, announce } = page;
  const robotName = h('span', { class: 'b robot-name' });
  const robotTypes = h('span', { class: 'soft wide-only' });
  const units = h('span', { class: 'soft wide-only' });
  const undo = iconButton('undo', TEXT.bar.undo);
  const redo = iconButton('redo', TEXT.bar.redo);
  const colours = iconButton('circleHalf', TEXT.bar.theme);

  fill(
    host,
    h(
      'h1',
      { class: 'brand' },
      icon('brand'),
      spoken(TEXT.product),
      h('span', { class: 'wide-only', 'aria-hidden': 'true' }, TEXT.product),
    ),
    h('span', { class: 'rule wide-only' }),
    menu(TEXT.bar.chooseRobot, [robotName, robotTypes], robotItems(page)),
    menu(null, [TEXT.bar.file], fileItems(files)),
    h('span', { class: 'rule' }),
    undo,
    redo,
    h('span', { class: 'grow' }),
    units,
    h('span', { class: 'rule wide-only' }),
    colours,
  );

  $(undo).on('click', () => step(page, 'undo'));
  $(redo).on('click', () => step(page, 'redo'));
  $(colours).on('click', () => announce(TEXT.bar.themeNow[theme.toggle()]));

  addView(
    ({ doc }) => doc.robot,
    (robot) => {
      robotName.textContent = robot.name || TEXT.unnamedRobot;
      robotTypes.textContent = typesOf(robot);
      fill(units, spoken(TEXT.bar.unitsLabel), ' ', TEXT.bar.unitsOf(robot.units.length, robot.units.angle));
      document.title = TEXT.title(robot.name || TEXT.unnamedRobot);
    },
  );
  addView(
    ({ past }) => past.length === 0,
    (nothing) => void (undo.disabled = nothing),
  );
  addView(
    ({ future }) => future.length === 0,
    (nothing) => void (redo.disabled = nothing),
  );
}

/** @param {IconName} name @param {string} label */
const iconButton = (name, label) =>
  h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': label, title: label }, icon(name));

/**
 * @param {string | null} hint  shown when the pointer rests on it
 * @param {Child[]} content
 * @param {HTMLElement[]} items
 */
function menu(hint, content, items) {
  const button = h(
    'button',
    { type: 'button', class: 'btn', 'data-bs-toggle': 'dropdown', 'aria-expanded': 'false', title: hint },
    content,
    icon('caret', 'caret'),
  );
  const list = h('ul', { class: 'dropdown-menu menu' }, items);
  const dropdown = h('div', { class: 'dropdown' }, button, list); // Bootstrap looks for the list beside the button
  // What an item opens may take the focus; if nothing does, it goes back to where the menu was opened.
  list.addEventListener('click', () => button.focus());
  new Dropdown(button, { popperConfig: { strategy: 'fixed' } });
  return dropdown;
}

/** @param {string} title @param {string} detail @param {() => void} run */
function item(title, detail, run) {
  const button = h('button', { type: 'button', class: 'dropdown-item' }, h('span', {}, title), h('small', {}, detail));
  $(button).on('click', run);
  return h('li', {}, button);
}

/** @param {Page} page */
const robotItems = ({ opener, announce }) => [
  h('li', {}, h('h2', { class: 'dropdown-header' }, TEXT.bar.library)),
  ...Object.values(LIBRARY).map((robot) =>
    item(robot.name, TEXT.bar.degreesOfFreedom(robot.joints.length, typesOf(robot)), () => {
      opener.open(newDocument(robot));
      announce(TEXT.bar.chosen(robot.name));
    }),
  ),
];

/** @param {Files} files */
const fileItems = (files) => [
  item(TEXT.bar.open, TEXT.bar.openDetail, () => files.choose()),
  item(TEXT.bar.save, TEXT.bar.saveDetail, () => files.save()),
];
