/**
 * What a run shows below the code: variables and what is watched, registers, what it wrote, and beside them its signals.
 *
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { RunControl } from './runControl.js'
 */
import { fill, h } from '../parts/dom.js';
import { segments } from '../parts/segments.js';
import { CODE } from '../words/code.js';
import { createRegisterList } from './registerList.js';
import { createSignalList } from './signalList.js';
import { createVariableList } from './variableList.js';

const PARTS = /** @type {const} */ (['variables', 'registers', 'output']);

/** @param {HTMLElement} host @param {RunControl} control */
export function createRunView(host, control) {
  /** That a person has chosen. @type {typeof PARTS[number] | null} */
  let chosenPart = null;
  const stack = h('p', { class: 'code-stack', role: 'group', 'aria-label': CODE.stack });
  const choice = segments(CODE.shown, PARTS, CODE.parts, (part) => {
    chosenPart = part;
    open(part);
  });
  const variables = createVariableList(control);
  const registers = createRegisterList(control);
  const signals = createSignalList(control);
  const output = h('pre', { class: 'code-output', tabindex: 0, role: 'log', 'aria-label': CODE.parts.output });
  const answer = h('input', {
    type: 'text',
    class: 'form-control',
    'aria-label': CODE.answer,
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const form = h(
    'form',
    { class: 'code-answer', hidden: true },
    answer,
    h('button', { type: 'submit', class: 'btn btn-outline' }, CODE.send),
  );
  const bodies = { variables: variables.element, registers: registers.element, output: h('div', {}, output, form) };
  fill(
    host,
    h(
      'section',
      { class: 'code-part', 'aria-label': CODE.shown },
      h('div', { class: 'code-part-head' }, choice.element, stack),
      Object.values(bodies),
    ),
    signals.element,
  );
  open('variables');

  /** @param {typeof PARTS[number]} part */
  function open(part) {
    choice.draw(part);
    for (const name of PARTS) bodies[name].hidden = name !== part;
  }

  form.addEventListener('submit', (event) => {
    event.preventDefault();
    control.answer(answer.value);
    answer.value = '';
  });

  /** Drawn anew only when it is another: what is replaced cannot be pressed. */
  let drawnStack = '';
  function drawStack() {
    const frames = control.stack();
    const key = JSON.stringify(frames);
    if (key === drawnStack) return;
    drawnStack = key;
    fill(
      stack,
      frames.map(({ routine, line }) => h('span', {}, line > 0 ? `${routine} ${line}` : routine)),
    );
  }

  return {
    /** @param {readonly ProgramDoc[]} programs @param {ProgramDoc} program  that is open */
    draw(programs, program) {
      const run = control.run();
      host.hidden = run === null;
      if (!run) return;
      drawStack();
      // what it has written is what a program was run for; TP has no variables of its own
      const hasWritten = control.mode() === 'over' && run.output() !== '';
      if (!chosenPart) open(hasWritten ? 'output' : program.language === 'fanuc-tp' ? 'registers' : 'variables');
      variables.draw(run);
      registers.draw(run, programs, program.language);
      signals.draw(run, programs, program.language);
      const lines = [run.output(), ...control.said()].filter(Boolean).join('\n');
      if (output.textContent !== (lines || CODE.noOutput)) {
        output.textContent = lines || CODE.noOutput;
        output.scrollTop = output.scrollHeight;
      }
      const isAsked = control.mode() === 'asks';
      if (!isAsked && form.contains(document.activeElement)) output.focus({ preventScroll: true });
      form.hidden = !isAsked;
    },
    focusAnswer() {
      open((chosenPart = 'output'));
      answer.focus();
    },
  };
}
