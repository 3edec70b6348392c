/**
 * What a run shows below the code: where it is, its variables, its signals, and what it wrote.
 *
 * @import { CodeRun } from '../../model/code/codeRun.js'
 * @import { RunControl } from './runControl.js'
 */
import $ from 'jquery/slim';
import { fill, h, keepFocus } from '../parts/dom.js';
import { CODE } from '../words/code.js';

/** Signals that a person sets, and those that the program sets; what a text names is listed. */
const SIGNALS = /\b(DIN|DOUT|RDI|RDO|OPIN|OPOUT|FLG|WDI|WDO)\s*\[\s*(\d{1,4})\s*\]/gi;
const IS_INPUT = /^(DIN|RDI|OPIN|WDI)$/;

/** @param {HTMLElement} host @param {RunControl} control */
export function createRunView(host, control) {
  const stack = h('p', { class: 'code-stack', 'aria-label': CODE.stack });
  const body = h('tbody');
  const variables = h(
    'section',
    { class: 'code-part', 'aria-label': CODE.variables },
    h('div', { class: 'code-part-head' }, h('h2', {}, CODE.variables), stack),
    h(
      'div',
      { class: 'code-scroll', tabindex: 0, role: 'group', 'aria-label': CODE.variables },
      h(
        'table',
        { class: 'code-table' },
        h(
          'thead',
          { class: 'visually-hidden' },
          h(
            'tr',
            {},
            ['name', 'type', 'value'].map((key) =>
              h('th', { scope: 'col' }, CODE.variable[/** @type {'name'} */ (key)]),
            ),
          ),
        ),
        body,
      ),
    ),
  );
  const signalList = h('ul', { class: 'code-signals' });
  const signals = h(
    'section',
    { class: 'code-part', 'aria-label': CODE.signals, hidden: true },
    h('h2', {}, CODE.signals),
    signalList,
  );
  const output = h('pre', { class: 'code-output', tabindex: 0, role: 'log', 'aria-label': CODE.output });
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
  const written = h(
    'section',
    { class: 'code-part', 'aria-label': CODE.output },
    h('h2', {}, CODE.output),
    output,
    form,
  );
  fill(host, variables, signals, written);

  form.addEventListener('submit', (event) => {
    event.preventDefault();
    control.answer(answer.value);
    answer.value = '';
  });
  $(signalList).on('click', '[data-port]', ({ currentTarget }) => {
    const { port = '', place = '0' } = currentTarget.dataset;
    control.setPort(port, Number(place), currentTarget.getAttribute('aria-checked') !== 'true');
  });

  /** Drawn anew only when it is another: what is replaced cannot be pressed. @type {Map<string, string>} */
  const drawn = new Map();
  /** @param {string} part @param {unknown} shown */
  function isOther(part, shown) {
    const key = JSON.stringify(shown);
    if (drawn.get(part) === key) return false;
    drawn.set(part, key);
    return true;
  }

  /** @param {CodeRun} run */
  function drawVariables(run) {
    const [frames, list] = [run.stack(), run.variables()];
    if (!isOther('variables', [frames, list])) return;
    fill(
      stack,
      frames.map(({ routine, line }) => h('span', {}, `${routine} ${line}`)),
    );
    fill(
      body,
      list.map(({ name, type, value, owner }) =>
        h(
          'tr',
          { class: owner && 'is-local' },
          h('th', { scope: 'row' }, name),
          h('td', {}, type),
          h('td', { class: 'value' }, value),
        ),
      ),
    );
  }

  /** @param {CodeRun} run @param {string} text */
  function drawSignals(run, text) {
    const named = new Map(
      [...text.matchAll(SIGNALS)].map(([, port, index]) => [
        `${port.toUpperCase()}[${Number(index)}]`,
        { port: port.toUpperCase(), index: Number(index) },
      ]),
    );
    const { ports } = run.state();
    const shown = [...named].map(([name, at]) => ({ name, ...at, isOn: ports[at.port]?.[at.index] === true }));
    if (!isOther('signals', shown)) return;
    signals.hidden = shown.length === 0;
    keepFocus(signalList, '[data-port]', () =>
      fill(
        signalList,
        shown.map(({ name, port, index, isOn }) => {
          const state = isOn ? CODE.on : CODE.off;
          const lamp = h('span', { class: `code-lamp ${isOn ? 'is-on' : ''}`, 'aria-hidden': 'true' });
          return h(
            'li',
            {},
            h('span', { class: 'mono' }, name),
            h('span', { class: 'grow' }),
            IS_INPUT.test(port)
              ? h(
                  'button',
                  {
                    ...{ type: 'button', role: 'switch', class: 'btn btn-outline', 'aria-checked': String(isOn) },
                    ...{ 'data-action': 'port', 'data-index': name, 'aria-label': CODE.input(name) },
                    ...{ 'data-port': port, 'data-place': index },
                  },
                  lamp,
                  state,
                )
              : h('span', { class: 'code-signal-state' }, lamp, state),
          );
        }),
      ),
    );
  }

  return {
    /** @param {string} text  of the program that is open: which signals it names */
    draw(text) {
      const run = control.run();
      host.hidden = run === null;
      if (!run) return;
      drawVariables(run);
      drawSignals(run, text);
      const lines = [run.output(), ...control.said()].filter(Boolean).join('\n');
      if (output.textContent !== (lines || CODE.noOutput)) {
        output.textContent = lines || CODE.noOutput;
        output.scrollTop = output.scrollHeight;
      }
      form.hidden = control.mode() !== 'asks';
    },
    focusAnswer: () => answer.focus(),
  };
}
