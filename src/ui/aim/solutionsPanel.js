/**
 * All postures for the target, or for the pose that the tool has: looked at as a ghost in the scene by pointer or focus, taken by
 * a click or Enter. Rows keep their numbers as long as the pose is the same one. Fetched when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { AppState } from '../../model/session.js'
 * @import { FoundSolutions, Listed, SolutionDoc, SolvedAll } from '../../model/aim/solutions.js'
 */
import $ from 'jquery/slim';
import { aim, gapBetween, poseFromXyzwpr } from '../../model/aim/aim.js';
import { compileRobot } from '../../model/compile.js';
import {
  describeSolutions,
  inOrderOf,
  isOneList,
  needsSearch,
  questionFor,
  solveAll,
  solvePlace,
  travelBetween,
} from '../../model/aim/solutions.js';
import { tcpAt } from '../../model/aim/targetHelpers.js';
import { together } from '../../model/views.js';
import '../css/solutions.css';
import { fill, h, keepFocus } from '../parts/dom.js';
import { createFamilies } from './familySlider.js';
import { createSolveApart } from './solveApart.js';
import { figureScale, nameInWords, solutionRow } from './solutionsList.js';
import { travelTo } from '../travel.js';
import { SOLUTIONS } from '../words/solutions.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {(all: number, inside: number, lines: number) => void} onCount
 */
export function createSolutionsPanel(page, host, onCount) {
  const { store, addView, derived, announce, messages, clock } = page;
  const within = h('input', { type: 'checkbox', role: 'switch' });
  const top = h('div', { class: 'solutions-top' }, h('label', { class: 'switch' }, within, SOLUTIONS.withinOnly));
  const list = h('div', { role: 'listbox', 'aria-label': SOLUTIONS.list });
  const nameHead = h('span', {});
  const head = h(
    'div',
    { class: 'row-head', 'aria-hidden': 'true' },
    h('span', {}),
    h('span', {}),
    nameHead,
    h('span', { class: 'travel', title: SOLUTIONS.travelDetail }, SOLUTIONS.columns.travel),
    h('span', { class: 'margin', title: SOLUTIONS.marginDetail }, SOLUTIONS.columns.margin),
  );
  const table = h('div', { class: 'solutions' }, head, list);
  const lead = h('p', { class: 'soft sm solutions-note', role: 'status' });
  const note = h('p', { class: 'soft sm solutions-note' });
  const codes = h('dl', { class: 'solution-codes', 'aria-label': SOLUTIONS.codes });
  const families = createFamilies(page);
  fill(host, top, lead, table, note, families.element, codes);

  /** What the list is of. @type {{ robot: AppState['doc']['robot'], T: Float64Array } | null} */
  let goal = null;
  /** @type {FoundSolutions | null} */
  let found = null;
  /** What `found` is of: a search may be under way for another. @type {{ robot: AppState['doc']['robot'], T: Float64Array } | null} */
  let foundGoal = null;
  let isPartOnly = false;
  let isPlaceOnly = false;
  let looked = -1;
  let focused = 0;
  const apart = createSolveApart(messages.fault);
  let cancel = () => {};

  /** @param {AppState} state */
  const wanted = ({ doc, session }) => (session.target ? poseFromXyzwpr(doc.robot, session.target) : derived.tcp(doc));

  function refresh() {
    const { doc } = store.state;
    const chain = derived.chain(doc);
    const T = wanted(store.state);
    const isAsked = goal?.robot === doc.robot && gapBetween(goal.T, T).isClosed;
    if (!isAsked) goal = { robot: doc.robot, T };
    const asked = goal;
    if (!asked) return;
    const isSame = foundGoal === asked;
    cancel();
    apart.forget();
    if (!needsSearch(chain)) return take(solveAll(doc, chain, asked.T), isSame);
    if (isSame) return draw();
    lead.textContent = SOLUTIONS.searching;
    lead.hidden = false;
    cancel = clock.after(0.15, () =>
      apart.ask(questionFor(doc, compileRobot(doc.robot), asked.T), (all) => {
        if (goal === asked && store.state.doc.robot === asked.robot) take(all, isSame);
      }),
    );
  }

  /** @param {SolvedAll} answer @param {boolean} isSame */
  function take(answer, isSame) {
    if (!goal) return;
    const { doc, session } = store.state;
    const chain = derived.chain(doc);
    /** @type {[Listed, Float64Array]} */
    let [all, T] = [answer, goal.T];
    isPartOnly = false;
    const place = solvePlace(doc, chain, T);
    isPlaceOnly = place !== null && place.solutions.length > all.solutions.length;
    if (place && isPlaceOnly) all = place;
    else if (all.solutions.length + all.families.length === 0 && chain.dof < 6 && session.target) {
      const met = aim(doc, chain, T);
      if (met.status === 'subspace') {
        T = tcpAt(doc.robot, chain, met.posture);
        all = solveAll(doc, chain, T);
        isPartOnly = true;
      }
    }
    const next = describeSolutions(doc.robot, chain, doc.posture, all);
    // The arm that goes to another of these turns its tool, and what it goes on from is the same list.
    const isSameList =
      isSame || (isPlaceOnly && found !== null && isOneList(found.solutions, next.solutions, doc.robot));
    found = isSameList && found ? { ...next, solutions: inOrderOf(found.solutions, next.solutions, doc.robot) } : next;
    foundGoal = goal;
    families.show(doc.robot, chain, T, found.families, isSame);
    const total = found.solutions.length;
    onCount(total, found.solutions.filter(({ withinLimits }) => withinLimits).length, found.families.length);
    draw();
  }

  function draw() {
    if (!found || store.state.doc.robot !== goal?.robot) return;
    const { robot, posture } = store.state.doc;
    const chain = derived.chain(store.state.doc);
    const { solutions, complete } = found;
    const isNone = solutions.length + found.families.length === 0;
    lead.textContent = leadOf(isNone);
    lead.hidden = lead.textContent === '';
    const rows = solutions.map((solution, i) => ({
      solution,
      number: i + 1,
      travel: travelBetween(robot, chain, posture, solution.posture),
    }));
    const shown = rows.filter(({ solution }) => !within.checked || solution.withinLimits);
    const away = shown.filter(({ travel, solution }) => !travel.isHere && solution.withinLimits);
    const nearest = away.toSorted((a, b) => a.travel.way - b.travel.way)[0];
    const place = figureScale(solutions);
    const isNamed = solutions.some(({ name }) => name.shoulder !== null && name.wrist !== null);
    nameHead.textContent = isNamed ? SOLUTIONS.columns.name : SOLUTIONS.columnsOther;
    const elements = shown.map((row) =>
      solutionRow({ ...row, robot, place, isNearest: row === nearest && away.length > 1 }),
    );
    keepFocus(list, '[role=option]', () => fill(list, elements));
    table.hidden = shown.length === 0;
    rove();
    const hidden = rows.length - shown.length;
    const remarks = [hidden > 0 && SOLUTIONS.hidden(hidden), !complete && !isNone && SOLUTIONS.searched];
    note.textContent = remarks.filter(Boolean).join(' ');
    note.hidden = note.textContent === '';
    drawCodes();
  }

  function leadOf(/** @type {boolean} */ isNone) {
    if (isNone) return SOLUTIONS.none;
    return isPlaceOnly ? SOLUTIONS.places : isPartOnly ? SOLUTIONS.noneButOne : '';
  }

  const options = () => /** @type {HTMLElement[]} */ ([...list.children]);
  const indexOf = (/** @type {HTMLElement} */ option) => Number(option.dataset.index);

  /** One row is in the way of the tabulator: the one that had the focus, or where the arm stands. */
  function rove() {
    const all = options();
    const stop =
      all.find((option) => indexOf(option) === focused) ??
      all.find((option) => option.getAttribute('aria-selected') === 'true') ??
      all[0];
    for (const option of all) option.tabIndex = option === stop ? 0 : -1;
  }

  function drawCodes() {
    const solutions = found?.solutions ?? [];
    const here = options().find((option) => option.getAttribute('aria-selected') === 'true');
    const solution = solutions[looked] ?? solutions[here ? indexOf(here) : 0];
    if (!solution) return fill(codes);
    const { fanuc, kuka } = solution;
    fill(
      codes,
      h('dt', {}, SOLUTIONS.fanuc),
      h('dd', {}, fanuc.text ?? SOLUTIONS.noCode[fanuc.reason]),
      h('dt', {}, SOLUTIONS.kuka),
      h('dd', {}, kuka.status === null ? SOLUTIONS.noCode[kuka.reason] : SOLUTIONS.kukaCode(kuka.status, kuka.turn)),
    );
  }

  /** The ghost of a row in the scene, or none. @param {number} index */
  function look(index) {
    if (index === looked) return;
    looked = index;
    const at = found?.solutions[index];
    const { robot, posture } = store.state.doc;
    const solution =
      at && !travelBetween(robot, derived.chain(store.state.doc), posture, at.posture).isHere ? at : null; // it would hide in the arm
    for (const option of options()) option.classList.toggle('is-looked', indexOf(option) === index);
    store.dispatch({ type: 'show', change: { ghost: solution ? ghostOf(solution, index) : null } });
    drawCodes();
  }

  /** @param {SolutionDoc} solution @param {number} index */
  const ghostOf = ({ posture, name }, index) => ({ posture, label: SOLUTIONS.ghost(index + 1, nameInWords(name)) });

  /** @param {number} index */
  function go(index) {
    const solution = found?.solutions[index];
    if (!solution) return;
    look(-1);
    travelTo(page, solution.posture);
    announce(SOLUTIONS.went(index + 1, nameInWords(solution.name)));
  }

  $(list)
    .on('pointerover', '[role=option]', ({ currentTarget }) => look(indexOf(currentTarget)))
    .on('focusin', '[role=option]', ({ currentTarget }) => {
      focused = indexOf(currentTarget);
      if (currentTarget.matches(':focus-visible')) look(focused);
    })
    .on('focusout', () => look(-1))
    .on('click', '[role=option]', ({ currentTarget }) => go(indexOf(currentTarget)))
    .on('keydown', '[role=option]', (event) => {
      const all = options();
      const at = all.indexOf(event.currentTarget);
      const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: all.length - 1 }[event.key];
      if (next !== undefined) all[Math.max(0, Math.min(all.length - 1, next))].focus();
      else if (event.key === 'Enter' || event.key === ' ') go(indexOf(event.currentTarget));
      else return;
      event.preventDefault();
      rove();
    });
  list.addEventListener('pointerleave', () => look(-1));
  within.addEventListener('change', draw);

  addView(
    together(({ doc, session, gesture }) => [doc.robot, doc.posture, session.target, gesture]),
    () => {
      const isMoving = store.state.gesture !== null && store.state.session.target === null;
      if (isMoving) return; // the list is of where the arm rests
      refresh();
    },
  );
}
