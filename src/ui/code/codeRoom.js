/**
 * One program of the document, open: its text in the editor, what is wrong with it, and running it. Fetched when the first
 * program is opened.
 *
 * @import { Page } from '../page.js'
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { Problem } from '../../model/code/codeProblems.js'
 * @import { Place } from '../../model/code/codeRun.js'
 * @import { IconName } from '../parts/icons.js'
 */
import $ from 'jquery/slim';
import intoIcon from 'bootstrap-icons/icons/box-arrow-in-down.svg?raw';
import outIcon from 'bootstrap-icons/icons/box-arrow-up.svg?raw';
import overIcon from 'bootstrap-icons/icons/arrow-return-right.svg?raw';
import stopIcon from 'bootstrap-icons/icons/stop-fill.svg?raw';
import { namesOf, problemsOf } from '../../model/code/codeProblems.js';
import '../css/codeEditor.css';
import '../css/codeRun.css';
import { attempt, newGesture } from '../page.js';
import { fill, h } from '../parts/dom.js';
import { icon, iconOf } from '../parts/icons.js';
import { CODE } from '../words/code.js';
import { createEditor } from './editor.js';
import { createRunControl } from './runControl.js';
import { createRunView } from './runView.js';

/** s after the last key: the document has the text, and it is looked at. */
const IDLE = 0.4;

/** @param {Page} page @param {HTMLElement} host */
export function createCodeRoom(page, host) {
  const { store, clock } = page;
  /** @type {ProgramDoc | null} as the document has it */
  let open = null;
  /** @type {readonly Problem[]} */
  let problems = [];
  /** @type {Map<string, readonly number[]>} by program: lines */
  const stops = new Map();
  let gesture = '';
  let line = 1;
  /** @type {(() => void) | null} */
  let cancelIdle = null;

  const status = h('span', { class: 'code-status' });
  const controls = h('div', { class: 'code-controls', role: 'toolbar', 'aria-label': CODE.controls }, status);
  const editorHost = h('div', { class: 'code-editor' });
  const problemText = h('p', { class: 'code-problem', role: 'status' });
  const nextProblem = h('button', { type: 'button', class: 'btn btn-outline', hidden: true }, CODE.goToProblem);
  const problemLine = h('div', { class: 'code-problems' }, problemText, nextProblem);
  const runHost = h('div', { class: 'code-run', hidden: true });
  fill(host, controls, editorHost, problemLine, runHost, h('p', { class: 'code-limits' }, CODE.limits));

  const control = createRunControl(page, {
    onChange: () => drawRun(),
    isBreakpoint: ({ program, line: at }) => Boolean(open && (stops.get(idOf(program)) ?? []).includes(at)),
  });
  const runView = createRunView(runHost, control);
  const editor = createEditor(editorHost, {
    onText: typed,
    onLeave: commit,
    onStops(lines, at) {
      if (open) stops.set(open.id, lines);
      page.announce(lines.includes(at) ? CODE.stopSet(at) : CODE.stopCleared(at));
    },
    onLine: (at) => {
      line = at;
      drawProblems();
    },
    names: () => (open?.language === 'karel' ? namesOf(store.state.doc.programs, editor.text()) : []),
  });

  /** The document's name for a program: what stands behind PROGRAM may be another. @param {string} name */
  function idOf(name) {
    const upper = name.toUpperCase();
    const byText = store.state.doc.programs.find(({ text }) =>
      new RegExp(`^\\s*PROGRAM\\s+${upper}\\b`, 'im').test(text),
    );
    return byText?.id ?? open?.id ?? '';
  }

  function typed() {
    cancelIdle?.();
    cancelIdle = clock.after(IDLE, () => {
      save();
      check();
    });
  }

  /** The document has what is in the editor; all that is typed in one go is one undo step. */
  function save() {
    cancelIdle?.();
    cancelIdle = null;
    if (!open || editor.text() === open.text) return;
    gesture ||= newGesture();
    const reason = attempt(page, { type: 'edit-code', id: open.id, text: editor.text(), gesture });
    if (reason) return say(reason, true);
    open = store.state.doc.programs.find(({ id }) => id === open?.id) ?? null;
  }

  function commit() {
    save();
    if (gesture && store.state.gesture?.id === gesture) store.dispatch({ type: 'end-gesture' });
    gesture = '';
  }

  function check() {
    if (!open) return;
    problems = problemsOf(store.state.doc.programs, { ...open, text: editor.text() });
    editor.showProblems(problems);
    drawProblems();
  }

  /** @param {string} text @param {boolean} [isBad] */
  function say(text, isBad = false) {
    if (problemText.textContent !== text) problemText.textContent = text;
    problemLine.classList.toggle('is-bad', isBad);
  }

  function drawProblems() {
    nextProblem.hidden = problems.length === 0;
    if (!open) return;
    if (open.language !== 'karel') return say(CODE.notChecked);
    const here = problems.find((one) => one.line === line);
    if (here) return say(`${CODE.line(here.line)}: ${here.message}`, here.severity === 'error');
    const errors = problems.filter(({ severity }) => severity === 'error').length;
    if (problems.length === 0) return say(CODE.noProblems);
    const [first] = problems;
    return say(
      `${CODE.problems(errors, problems.length - errors)}. ${CODE.line(first.line)}: ${first.message}`,
      errors > 0,
    );
  }

  nextProblem.addEventListener('click', () => {
    const next = problems.find((one) => one.line > line) ?? problems[0];
    if (next) editor.goTo(next.line);
  });

  /** @param {string} action @param {string} label @param {SVGElement} drawing @param {boolean} [isOff] @param {string} [look] */
  const button = (action, label, drawing, isOff = false, look = 'btn-icon') =>
    h(
      'button',
      {
        ...{ type: 'button', class: `btn ${look}`, 'data-run': action, 'aria-label': label, title: label },
        'aria-disabled': isOff ? 'true' : null,
      },
      drawing,
    );

  function drawControls() {
    const mode = control.mode();
    const isRunning = mode === 'running';
    const isOff = mode === 'running' || mode === 'asks';
    const had = document.activeElement instanceof HTMLElement ? document.activeElement.dataset.run : undefined;
    const hadFocus = controls.contains(document.activeElement);
    fill(
      controls,
      isRunning
        ? button('pause', CODE.pause, icon('pause'), false, 'btn-primary btn-icon')
        : button('run', CODE.run, icon('play'), mode === 'asks', 'btn-primary btn-icon'),
      button('back', CODE.back, icon('skipBack'), !control.canGoBack()),
      button('into', CODE.into, iconOf(intoIcon), isOff),
      button('over', CODE.over, iconOf(overIcon), isOff),
      button('out', CODE.out, iconOf(outIcon), isOff || mode !== 'paused'),
      button('stop', CODE.stop, iconOf(stopIcon), mode === 'idle'),
      status,
    );
    if (!hadFocus) return;
    const again = controls.querySelector(
      `[data-run=${had === 'run' && isRunning ? 'pause' : had === 'pause' && !isRunning ? 'run' : had}]`,
    );
    if (again instanceof HTMLElement) again.focus();
  }

  let drawn = '';
  function drawRun() {
    const key = `${control.mode()} ${control.canGoBack()}`;
    if (key !== drawn) drawControls();
    drawn = key;
    if (status.textContent !== control.status()) status.textContent = control.status();
    const place = control.place();
    const isHere = place !== null && open !== null && idOf(place.program) === open.id;
    editor.showNext(isHere && control.mode() !== 'running' ? /** @type {Place} */ (place).line : null);
    runView.draw(editor.text());
    if (control.mode() === 'asks') runView.focusAnswer();
  }

  $(controls).on('click', '[data-run]', ({ currentTarget }) => {
    if (currentTarget.getAttribute('aria-disabled') === 'true' || !open) return;
    const { run: action } = currentTarget.dataset;
    if (action === 'pause') return control.pause();
    if (action === 'stop') return control.stop();
    if (action === 'back') return control.back();
    commit();
    check();
    const { id } = open;
    const faults = control.go(/** @type {'run'} */ (action), () => [store.state.doc.programs, id]);
    if (faults.length > 0) editor.goTo(faults[0].line);
  });

  return {
    /** @param {ProgramDoc | null} program  null: another thing is shown */
    show(program) {
      if (program === null) {
        commit();
        open = null;
        host.hidden = true;
        return;
      }
      host.hidden = false;
      if (open?.id !== program.id) {
        commit();
        open = program;
        line = 1;
        editor.open(program, stops.get(program.id) ?? []);
        controls.hidden = program.language !== 'karel';
        check();
        drawn = '';
        drawRun();
      } else if (open.text !== program.text) {
        open = program;
        editor.replace(program.text);
        gesture = '';
        check();
      }
    },
    /** What is in the editor is in the document. */
    commit,
  };
}

/** @typedef {ReturnType<typeof createCodeRoom>} CodeRoom */
