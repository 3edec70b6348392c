/**
 * The variables of the routine and the program where a run is, and expressions that a person watches.
 *
 * @import { CodeRun } from '../../model/code/codeDebugger.js'
 * @import { RunControl } from './runControl.js'
 */
import $ from 'jquery/slim';
import { fill, h, keepFocus } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { CODE } from '../words/code.js';

/** @param {RunControl} control */
export function createVariableList(control) {
  /** @type {string[]} */
  let watched = [];
  const body = h('tbody');
  const input = h('input', {
    type: 'text',
    class: 'form-control',
    'aria-label': CODE.watch,
    placeholder: CODE.watch,
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const form = h(
    'form',
    { class: 'code-watch' },
    input,
    h('button', { type: 'submit', class: 'btn btn-outline' }, CODE.addWatch),
  );
  const heads = ['name', 'type', 'value'].map((key) =>
    h('th', { scope: 'col' }, CODE.variable[/** @type {'name'} */ (key)]),
  );
  const table = h('table', { class: 'code-table' }, h('thead', { class: 'visually-hidden' }, h('tr', {}, heads)), body);
  const element = h(
    'div',
    {},
    h('div', { class: 'code-scroll', tabindex: 0, role: 'group', 'aria-label': CODE.parts.variables }, table),
    form,
  );

  let drawn = '';
  /** @param {CodeRun} run */
  function draw(run) {
    const list = run.variables();
    const values = watched.map((text) => ({ text, found: run.watch(text) }));
    const key = JSON.stringify([list, values]);
    if (key === drawn) return;
    drawn = key;
    keepFocus(body, '[data-action]', () =>
      fill(
        body,
        values.map(({ text, found }, i) =>
          h(
            'tr',
            { class: 'is-watched' },
            h('th', { scope: 'row' }, text),
            h('td', {}, removal(text, i)),
            'value' in found
              ? h('td', { class: 'value' }, found.value)
              : h('td', { class: 'value is-fault' }, found.fault),
          ),
        ),
        list.map(({ name, type, value, owner }) =>
          h(
            'tr',
            { class: owner && 'is-local' },
            h('th', { scope: 'row' }, name),
            h('td', {}, type),
            h('td', { class: 'value' }, value),
          ),
        ),
      ),
    );
  }

  /** @param {string} text @param {number} index */
  const removal = (text, index) =>
    h(
      'button',
      {
        ...{ type: 'button', class: 'btn btn-icon', 'data-action': 'unwatch', 'data-index': index },
        ...{ 'aria-label': CODE.unwatch(text), title: CODE.unwatch(text) },
      },
      icon('close'),
    );

  function redraw() {
    const run = control.run();
    if (run) draw(run);
  }
  $(body).on('click', '[data-action=unwatch]', ({ currentTarget }) => {
    watched = watched.toSpliced(Number(currentTarget.dataset.index), 1);
    redraw();
  });
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const text = input.value.trim();
    if (text === '' || watched.includes(text)) return;
    watched = [...watched, text];
    input.value = '';
    redraw();
  });
  return { element, draw };
}
