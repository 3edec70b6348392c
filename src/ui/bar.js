/**
 * The bar on top: which robot, its file, undo and redo, units, colours.
 * @import { Child } from './parts/dom.js'
 * @import { IconName } from './parts/icons.js'
 * @import { Page } from './page.js'
 * @import { Files } from './files/files.js'
 * @import { Theme } from './theme.js'
 */
import $ from 'jquery/slim';
import { together } from '../model/views.js';
import { fill, h, spoken } from './parts/dom.js';
import { icon } from './parts/icons.js';
import { typesOf } from './robot/jointTypes.js';
import { giveMenu } from './parts/menus.js';
import { step } from './page.js';
import { TEXT } from './strings.js';
import { createUnitsMenu } from './unitsMenu.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ files: Files, theme: Theme, openHelp: () => unknown }} tools
 */
export function createBar(page, host, { files, theme, openHelp }) {
  const { store, addView, announce } = page;
  const robotName = h('span', { class: 'b robot-name' });
  const robotTypes = h('span', { class: 'soft wide-only' });
  const units = createUnitsMenu(page, 'wide-only');
  const undo = iconButton('undo', TEXT.bar.undo);
  const redo = iconButton('redo', TEXT.bar.redo);
  const share = h('button', { type: 'button', class: 'btn wide-only', 'aria-haspopup': 'dialog' }, TEXT.bar.share);
  const openShare = async () => (await import('./files/share.js')).openShare(page, files); // messages.js says it when that fails
  const colours = iconButton('circleHalf', TEXT.bar.theme);
  const help = iconButton('question', TEXT.bar.help);

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
    robotButton(page, [robotName, robotTypes]),
    menu([TEXT.bar.file], fileItems(files, openShare)),
    h('span', { class: 'rule' }),
    undo,
    redo,
    h('span', { class: 'grow' }),
    units,
    share,
    h('span', { class: 'rule wide-only' }),
    colours,
    help,
  );

  $(share).on('click', openShare);
  $(help).on('click', openHelp);
  $(undo).on('click', () => step(page, 'undo'));
  $(redo).on('click', () => step(page, 'redo'));
  $(colours).on('click', () => announce(TEXT.bar.themeNow[theme.toggle()]));

  addView(
    ({ doc }) => doc.robot,
    (robot) => {
      robotName.textContent = robot.name || TEXT.unnamedRobot;
      robotTypes.textContent = typesOf(robot);
      document.title = TEXT.title(robot.name || TEXT.unnamedRobot);
    },
  );
  /** @type {typeof import('./stepName.js') | null} fetched when there is first something to undo */
  let names = null;
  for (const [button, type] of /** @type {const} */ ([
    [undo, 'undo'],
    [redo, 'redo'],
  ])) {
    addView(
      together(({ past, doc, future }) => [doc, (type === 'undo' ? past : future).length > 0]),
      async ([, isThere]) => {
        button.disabled = !isThere;
        if (isThere) names ??= await import('./stepName.js');
        button.title = names?.stepTitle(store.state, type) ?? TEXT.bar[type];
        button.setAttribute('aria-label', button.title);
      },
    );
  }
}

/** @param {IconName} name @param {string} label */
const iconButton = (name, label) =>
  h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': label, title: label }, icon(name));

/**
 * @param {Child[]} content
 * @param {HTMLElement[]} items
 */
function menu(content, items) {
  const button = h('button', { type: 'button', class: 'btn' }, content, icon('caret', 'caret'));
  const list = h('ul', { class: 'dropdown-menu menu' }, items);
  const dropdown = h('div', { class: 'dropdown' }, button, list); // Bootstrap looks for the list beside the button
  // What an item opens may take the focus; if nothing does, it goes back to where the menu was opened.
  list.addEventListener('click', () => button.focus());
  giveMenu(button);
  return dropdown;
}

/** @param {string} title @param {string} detail @param {() => void} run */
function item(title, detail, run) {
  const button = h('button', { type: 'button', class: 'dropdown-item' }, h('span', {}, title), h('small', {}, detail));
  $(button).on('click', run);
  return h('li', {}, button);
}

/** Which robot it is, and the way to the library. @param {Page} page @param {Child[]} content */
function robotButton(page, content) {
  const button = h(
    'button',
    { type: 'button', class: 'btn', 'aria-haspopup': 'dialog', title: TEXT.bar.chooseRobot },
    content,
    icon('caret', 'caret'),
  );
  $(button).on('click', async () => {
    try {
      const { openRobotPicker } = await import('./robot/robotPicker.js');
      openRobotPicker(page);
    } catch (error) {
      page.messages.fault(error);
    }
  });
  return button;
}

/** @param {Files} files @param {() => void} openShare */
const fileItems = (files, openShare) => [
  item(TEXT.bar.open, TEXT.bar.openDetail, () => files.choose()),
  item(TEXT.bar.save, TEXT.bar.saveDetail, () => files.save()),
  item(TEXT.bar.saveAs, TEXT.bar.saveAsDetail, () => void files.saveAs()),
  item(TEXT.bar.shareItem, TEXT.bar.shareDetail, openShare),
];
