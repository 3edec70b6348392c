/**
 * Inputs, outputs and flags of a run: what a person sets is a switch or a field, everything else is seen.
 *
 * @import { Signal } from '../../model/code/codeSignals.js'
 * @import { CodeRun } from '../../model/code/codeDebugger.js'
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { RunControl } from './runControl.js'
 */
import { signalsNamed, signalsOf } from '../../model/code/codeSignals.js';
import { memo } from '../../model/memo.js';
import { fill, h, keepFocus } from '../parts/dom.js';
import { CODE } from '../words/code.js';

/** @param {RunControl} control */
export function createSignalList(control) {
  const list = h('ul', { class: 'code-signals' });
  const element = h(
    'section',
    { class: 'code-part code-signal-part', 'aria-label': CODE.signals, hidden: true },
    h('h2', {}, CODE.signals),
    list,
  );
  const named = memo(signalsNamed);

  list.addEventListener('change', ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    const { port = '', place = '0' } = target.dataset;
    if (target.type === 'checkbox') return control.setPort(port, Number(place), target.checked);
    const value = Number(target.value);
    const isWrong = target.value.trim() === '' || !Number.isFinite(value);
    target.setAttribute('aria-invalid', String(isWrong));
    if (!isWrong) control.setPort(port, Number(place), value);
  });

  let drawn = '';
  return {
    element,
    /** @param {CodeRun} run @param {readonly ProgramDoc[]} programs @param {ProgramDoc['language']} language  whose names they have */
    draw(run, programs, language) {
      const shown = signalsOf(named(programs), run.state().ports, language);
      const key = JSON.stringify(shown);
      if (key === drawn) return;
      drawn = key;
      element.hidden = shown.length === 0;
      keepFocus(list, '[data-port]', () => fill(list, shown.map(row)));
    },
  };
}

/** @param {Signal} signal */
function row({ name, comment, port, index, isInput, value }) {
  const state = value === true ? CODE.on : value === false ? CODE.off : String(value);
  const label = CODE.input(comment === '' ? name : `${name} ${comment}`);
  const control = {
    ...(typeof value === 'number'
      ? { type: 'text', inputmode: 'decimal', class: 'form-control', value: state }
      : { type: 'checkbox', role: 'switch', checked: value }),
    ...{ 'aria-label': label, 'data-action': 'port', 'data-index': name, 'data-port': port, 'data-place': index },
  };
  return h(
    'li',
    {},
    h('span', { class: 'mono' }, name),
    h('span', { class: 'code-comment' }, comment),
    h('span', { class: 'code-signal-state' }, typeof value === 'number' && isInput ? '' : state),
    isInput
      ? h('span', { class: typeof value === 'number' ? 'code-numbers' : 'switch' }, h('input', control))
      : typeof value === 'boolean' && h('span', { class: `code-lamp ${value ? 'is-on' : ''}`, 'aria-hidden': 'true' }),
  );
}
