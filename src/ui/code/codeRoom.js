/**
 * One program of the document, open: its text in the editor, what is wrong with it, where it would take the arm, and running it.
 * Fetched when the first program is opened.
 *
 * @import { Page } from '../page.js'
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { Problem } from '../../model/code/codeProblems.js'
 */
import { inSlicesFromNow } from '../../model/inSlices.js';
import { formatted } from '../../model/code/codeFormat.js';
import { namesFor } from '../../model/code/codeNames.js';
import { problemsInSlices } from '../../model/code/codeProblems.js';
import { together } from '../../model/views.js';
import '../css/codeEditor.css';
import '../css/codeRun.css';
import { attempt, newGesture } from '../page.js';
import { fill, h } from '../parts/dom.js';
import { createPressGate } from '../parts/pressed.js';
import { CODE } from '../words/code.js';
import { createCodeControls } from './codeControls.js';
import { createEditor } from './editor.js';
import { createPreviewer } from './previewer.js';
import { createRunControl } from './runControl.js';
import { createRunView } from './runView.js';
import { createTpCallButton } from './tpCallButton.js';

/** s after the last key: the document has the text, and it is looked at. */
const IDLE = 0.4;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {object} given
 * @param {(id: string) => void} given.openProgram  another one is to be shown
 * @param {() => void} given.onAdded   programs have come that are not to be shown
 * @param {string} given.version       of this program, for the files' heads
 * @param {() => string} given.today   ISO 8601
 */
export function createCodeRoom(page, host, { openProgram, onAdded, version, today }) {
  const { store, clock, messages } = page;
  const whenLetGo = createPressGate(host, clock);
  /** @type {ProgramDoc | null} as the document has it */
  let open = null;
  /** @type {readonly Problem[]} of the text */
  let found = [];
  /** @type {readonly Problem[]} and of where it leads */
  let problems = [];
  /** @type {Map<string, readonly number[]>} by program: lines */
  const stops = new Map();
  let gesture = '';
  let line = 1;
  /** @type {number | null} under the pointer */
  let pointed = null;
  /** @type {(() => void) | null} */
  let cancelIdle = null;
  let cancelCheck = () => {};
  let isChecking = false;

  const editorHost = h('div', { class: 'code-editor' });
  const problemText = h('p', { class: 'code-problem', role: 'status' });
  const nextProblem = h('button', { type: 'button', class: 'btn btn-outline', hidden: true }, CODE.goToProblem);
  const tpCalls = createTpCallButton(page, { version, today }, () => {
    onAdded();
    editor.focus();
  });
  const problemLine = h('div', { class: 'code-problems' }, problemText, tpCalls.button, nextProblem, tpCalls.reason);
  const runHost = h('div', { class: 'code-run', hidden: true });
  const limits = h('p', {}, CODE.limits);
  const simulated = h('details', { class: 'code-limits' }, h('summary', {}, CODE.simulated), limits);

  const control = createRunControl(page, {
    onChange: () => whenLetGo(drawRun),
    onGiven: check,
    isBreakpoint: ({ id, line: at }) => (stops.get(id) ?? []).includes(at),
  });
  const controls = createCodeControls(control, press);
  fill(host, controls.element, editorHost, problemLine, runHost, simulated);
  const runView = createRunView(runHost, control);
  const previewer = createPreviewer(page, control.given, () => {
    showProblems();
    showGhost();
  });
  const editor = createEditor(editorHost, {
    onText: typed,
    onLeave: commit,
    onStops(lines, at) {
      if (open) stops.set(open.id, lines);
      page.announce(lines.includes(at) ? CODE.stopSet(at) : CODE.stopCleared(at));
    },
    onLine(at) {
      line = at;
      drawProblems();
      showGhost();
    },
    onPoint(at) {
      pointed = at;
      showGhost();
    },
    names: () => (open ? namesFor(store.state.doc.programs, { ...open, text: editor.text() }) : []),
  });

  function showGhost() {
    previewer.ghost(control.mode() === 'running' ? null : (pointed ?? (editor.hasFocus() ? line : null)));
  }

  function typed() {
    previewer.ghost(null);
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
    showGhost();
  }

  function check() {
    cancelCheck();
    if (!open) return;
    const { id } = open;
    isChecking = true;
    cancelCheck = inSlicesFromNow(problemsInSlices(store.state.doc.programs, { ...open, text: editor.text() }), clock, {
      onDone(problemsNow) {
        isChecking = false;
        found = problemsNow;
        showProblems();
        const isSound = !found.some(({ severity }) => severity === 'error');
        previewer.ask(isSound ? id : null);
      },
      onFault(error) {
        isChecking = false;
        messages.fault(error);
      },
    });
    if (isChecking) drawProblems();
  }

  function showProblems() {
    const led = previewer.faults().map(({ line: at, message }) => ({
      ...editor.placeOf(at),
      ...{ line: at, severity: /** @type {const} */ ('warning'), message: CODE.leadsNowhere(message) },
    }));
    problems = [...found, ...led].sort((a, b) => a.from - b.from);
    editor.showProblems(problems);
    drawProblems();
  }

  /** @param {string} text @param {boolean} [isBad] */
  function say(text, isBad = false) {
    if (problemText.textContent !== text) problemText.textContent = text;
    problemLine.classList.toggle('is-bad', isBad);
  }

  function drawProblems() {
    const isNone = problems.length === 0;
    if (isNone && document.activeElement === nextProblem) editor.focus();
    nextProblem.hidden = isNone;
    if (!open) return tpCalls.show(null);
    const here = problems.find((one) => one.line === line);
    tpCalls.show((here ?? problems[0])?.isMove ? { ...open, text: editor.text() } : null);
    if (here) return say(`${CODE.line(here.line)}: ${here.message}`, here.severity === 'error');
    const errors = problems.filter(({ severity }) => severity === 'error').length;
    if (isChecking && problems.length === 0) return say(CODE.checking);
    if (problems.length === 0) return say(open.language === 'krl' ? CODE.noProblemsKrl : CODE.noProblems);
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

  function format() {
    if (!open) return;
    commit();
    const text = formatted({ language: open.language, text: editor.text() });
    const isOther = text !== editor.text();
    if (isOther) editor.rewrite(text);
    commit();
    check();
    page.announce(isOther ? CODE.formatted : CODE.inOrder);
  }

  let wasRunning = false;
  function drawRun() {
    controls.draw();
    const isRunning = control.mode() === 'running';
    const place = control.place();
    // what stops in another program is shown there
    const stoppedIn = (place ?? (control.alarmLine() ? control.stack().at(-1) : null))?.id;
    if (wasRunning && !isRunning && open && stoppedIn && stoppedIn !== open.id) openProgram(stoppedIn);
    wasRunning = isRunning;
    const here = place && control.stack().findLast(({ id }) => id === open?.id);
    const isHere = control.stack().at(-1)?.id === open?.id;
    const stopped = isHere ? control.alarmLine() : null;
    editor.showNext(here && (!isRunning || control.isHolding()) ? here.line : stopped);
    if (open) runView.draw(store.state.doc.programs, open);
    limits.textContent = open?.language === 'krl' ? CODE.limitsKrl : CODE.limits;
    if (control.mode() === 'asks') runView.focusAnswer();
    if (isRunning) showGhost();
  }

  /** @param {string} action */
  function press(action) {
    if (!open) return;
    if (action === 'format') return format();
    if (action === 'pause') return control.pause();
    if (action === 'stop') return control.stop();
    if (action === 'back') return control.back();
    commit();
    if (control.place() === null) check();
    const { id } = open;
    const faults = control.go(/** @type {'run'} */ (action), () => [store.state.doc.programs, id]);
    if (faults.length > 0) editor.goTo(faults[0].line);
  }

  page.addView(
    together(({ doc, session }) => [doc.robot, doc.frames, doc.activeTool, doc.activeUser, session.tab === 'code']),
    ([, , , , isShown]) => {
      if (!isShown) return previewer.ghost(null);
      if (open) check();
    },
  );

  return {
    /** @param {ProgramDoc | null} program  null: another thing is shown */
    show(program) {
      if (program === null) {
        commit();
        cancelCheck();
        isChecking = false;
        open = null;
        host.hidden = true;
        previewer.ask(null);
        return;
      }
      host.hidden = false;
      if (open?.id !== program.id) {
        commit();
        open = program;
        line = 1;
        editor.open(program, stops.get(program.id) ?? []);
        [found, problems] = [[], []];
        check();
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
    given: control.given,
    goTo: editor.goTo,
  };
}

/** @typedef {ReturnType<typeof createCodeRoom>} CodeRoom */
