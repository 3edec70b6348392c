/**
 * The library in a dialog: every arm with its picture and facts, found by typing or by arrow keys; and robots of one's own
 * from so many joints. It is loaded, with the tables of all arms, when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { Family } from '../../model/library.js'
 *
 * @typedef {{ element: HTMLElement, words: string, robot: RobotDoc }} Option
 */
import { MAX_JOINTS, MIN_JOINTS } from '../../model/document.js';
import { LIBRARY, LIBRARY_FAMILIES } from '../../model/library.js';
import { newDocument } from '../../model/newDocument.js';
import { newRobot } from '../../model/robot/newRobot.js';
import { sketchRobot } from '../../model/robot/robotSketch.js';
import '../css/robotPicker.css';
import { closeButton, openDialog } from '../parts/dialog.js';
import { h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { typesOf } from './jointTypes.js';
import { robotPicture } from './robotPicture.js';
import { LIBRARY as WORDS } from '../words/library.js';

/** @param {Page} page */
export function openRobotPicker({ store, opener, announce }) {
  if (document.querySelector('.robot-picker')) return;
  const { name: openName } = store.state.doc.robot;
  const families = LIBRARY_FAMILIES.map(([family, ids]) => familyOf(family, ids, openName));
  const options = families.flatMap((family) => family.options);

  const search = h('input', {
    type: 'search',
    placeholder: WORDS.searchHint,
    'aria-label': WORDS.search,
    'aria-controls': 'robot-list',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const count = h('output', { class: 'soft sm picker-count' });
  const none = h('p', { class: 'soft picker-none', hidden: true });
  const list = h(
    'div',
    { id: 'robot-list', role: 'listbox', 'aria-label': WORDS.list, class: 'picker-list' },
    families.map(({ group }) => group),
  );

  /** @param {RobotDoc} robot */
  function open(robot) {
    dialog.hide();
    opener.open(newDocument(robot));
    announce(WORDS.chosen(robot.name));
  }

  /** One option can be reached by Tab; arrow keys lead from it to the others. @param {Option | undefined} active */
  function hold(active) {
    for (const { element } of options) element.tabIndex = element === active?.element ? 0 : -1;
  }
  const shown = () => options.filter(({ element }) => !element.hidden);

  function filter() {
    const words = search.value.toLowerCase().split(/\s+/);
    for (const { element, words: own } of options) element.hidden = !words.every((word) => own.includes(word));
    for (const { group, options: own } of families) group.hidden = own.every(({ element }) => element.hidden);
    const found = shown();
    hold(found.find(isOpen) ?? found[0]);
    count.textContent = WORDS.found(found.length);
    list.hidden = found.length === 0;
    none.hidden = found.length > 0;
    none.textContent = WORDS.none(search.value.trim());
  }

  search.addEventListener('input', filter);
  search.addEventListener('keydown', (event) => {
    const [first] = shown();
    if (!first) return;
    if (event.key === 'ArrowDown') first.element.focus();
    else if (event.key === 'Enter') open(first.robot);
    else return;
    event.preventDefault();
  });
  list.addEventListener('keydown', (event) => {
    const found = shown();
    const at = found.findIndex(({ element }) => element === event.target);
    if (at < 0 || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Enter' || event.key === ' ') open(found[at].robot);
    else if (isStep(event.key)) (neighbour(found, at, event.key)?.element ?? search).focus();
    else {
      if (event.key.length === 1) search.focus(); // and the browser types it there
      return;
    }
    event.preventDefault();
  });
  list.addEventListener('focusin', ({ target }) => hold(options.find(({ element }) => element === target)));
  list.addEventListener('click', ({ target }) => {
    const chosen = options.find(({ element }) => target instanceof Node && element.contains(target));
    if (chosen) open(chosen.robot);
  });
  filter();
  const dialog = openDialog({
    name: 'robot-picker',
    title: 'picker-title',
    fit: 'modal-dialog-centered modal-fullscreen-sm-down',
    content: [
      h(
        'div',
        { class: 'row-flex picker-head' },
        h('h2', { id: 'picker-title' }, WORDS.title),
        h('div', { class: 'field picker-search' }, search, count),
        closeButton(),
      ),
      list,
      none,
      newRobotButtons(open),
    ],
    onShown() {
      const here = options.find(isOpen);
      here?.element.scrollIntoView({ block: 'center' });
      // Under a finger the search field would bring its keyboard over the arms.
      if (matchMedia('(pointer: coarse)').matches) (here ?? options[0]).element.focus({ preventScroll: true });
      else search.focus();
    },
  });
}

/** @param {Option} option */
const isOpen = ({ element }) => element.getAttribute('aria-selected') === 'true';

/** @param {Family} family @param {readonly string[]} ids @param {string} openName */
function familyOf(family, ids, openName) {
  const title = WORDS.family[family];
  const heading = `robots-${family}`;
  const options = ids.map((id) => optionOf(id, LIBRARY[id], { title, isOpen: LIBRARY[id].name === openName }));
  const group = h(
    'div',
    { role: 'group', 'aria-labelledby': heading, class: 'picker-family' },
    h('div', { id: heading, class: 'picker-title' }, title),
    options.map(({ element }) => element),
  );
  return { group, options };
}

/**
 * @param {string} id
 * @param {RobotDoc} robot
 * @param {{ title: string, isOpen: boolean }} shown  title: of its family
 * @returns {Option}
 */
function optionOf(id, robot, { title, isOpen }) {
  const sketch = sketchRobot(robot);
  const reach = `${fixed(sketch.reach, 0)} ${robot.units.length}`;
  const facts = WORDS.facts(typesOf(robot), robot.joints.length, reach);
  const { source = '' } = robot.info;
  const element = h(
    'div',
    { role: 'option', class: 'picker-option', 'aria-selected': String(isOpen) },
    robotPicture(sketch),
    h(
      'div',
      {},
      h('div', { class: 'b' }, robot.name, ' ', isOpen && h('span', { class: 'open-now' }, WORDS.isOpen)),
      h('div', { class: 'facts' }, facts),
      h('div', { class: 'cite' }, source),
    ),
  );
  return { element, words: [id, robot.name, facts, title, source].join(' ').toLowerCase(), robot };
}

/** @param {(robot: RobotDoc) => void} open */
function newRobotButtons(open) {
  const counts = Array.from({ length: MAX_JOINTS - MIN_JOINTS + 1 }, (_, i) => MIN_JOINTS + i);
  const buttons = counts.map((joints) => {
    const label = WORDS.fresh(joints);
    const button = h(
      'button',
      { type: 'button', class: 'btn btn-outline', 'aria-label': label, title: label },
      `${joints}`,
    );
    button.addEventListener('click', () => open(newRobot(joints, WORDS.freshName)));
    return button;
  });
  return h(
    'div',
    { class: 'picker-new' },
    h('div', { class: 'grow' }, h('h3', {}, WORDS.freshTitle), h('p', { class: 'soft sm' }, WORDS.freshHint)),
    h(
      'div',
      { class: 'row-flex', role: 'group', 'aria-label': WORDS.freshTitle },
      h('span', { class: 'soft sm', 'aria-hidden': 'true' }, WORDS.joints),
      buttons,
    ),
  );
}

const STEPS = ['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Home', 'End'];
const isStep = (/** @type {string} */ key) => STEPS.includes(key);

/**
 * Where an arrow key leads: along the reading order, or to the nearest option of the next row.
 * @param {Option[]} found
 * @param {number} at
 * @param {string} key
 * @returns {Option | undefined} none above the first row: the search field is there
 */
function neighbour(found, at, key) {
  if (key === 'Home') return found[0];
  if (key === 'End') return found[found.length - 1];
  if (key === 'ArrowLeft') return found[Math.max(0, at - 1)];
  if (key === 'ArrowRight') return found[Math.min(found.length - 1, at + 1)];
  const places = found.map(({ element }) => element.getBoundingClientRect());
  const { left, top } = places[at];
  const isBeyond = (/** @type {DOMRect} */ place) => (key === 'ArrowDown' ? place.top > top + 1 : place.top < top - 1);
  const beyond = found.map((_, i) => i).filter((i) => isBeyond(places[i]));
  if (beyond.length === 0) return key === 'ArrowDown' ? found[at] : undefined;
  const row = Math.min(...beyond.map((i) => Math.abs(places[i].top - top)));
  const inRow = beyond.filter((i) => Math.abs(Math.abs(places[i].top - top) - row) < 1);
  const nearest = inRow.reduce((best, i) =>
    Math.abs(places[i].left - left) < Math.abs(places[best].left - left) ? i : best,
  );
  return found[nearest];
}
