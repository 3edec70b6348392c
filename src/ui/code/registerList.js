/**
 * The registers that have a value or are named, to be set while the program stands still.
 *
 * @import { ShownRegister } from '../../model/code/codeShown.js'
 * @import { CodeRun } from '../../model/code/codeDebugger.js'
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { RunControl } from './runControl.js'
 *
 * @typedef {Omit<ShownRegister, 'numbers'> & { numbers: readonly (number | null)[] }} Shown  null: no value
 */
import { registerComments, registersNamed } from '../../model/code/codeSignals.js';
import { memo } from '../../model/memo.js';
import { fill, h, keepFocus } from '../parts/dom.js';
import { CODE } from '../words/code.js';

const CARTESIAN = ['X', 'Y', 'Z', 'W', 'P', 'R'];
const SIX = CARTESIAN.length;

/** @param {RunControl} control */
export function createRegisterList(control) {
  const list = h('ul', { class: 'code-registers' });
  const element = h(
    'div',
    { class: 'code-scroll', tabindex: 0, role: 'group', 'aria-label': CODE.parts.registers },
    list,
  );
  const commentsOf = memo(registerComments);
  const namedIn = memo(registersNamed);

  list.addEventListener('change', ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    const { bank, number, slot } = target.dataset;
    const value = Number(target.value.replace('−', '-').replace(',', '.'));
    const isWrong = target.value.trim() === '' || !Number.isFinite(value) || Math.abs(value) > 1e9;
    target.setAttribute('aria-invalid', String(isWrong));
    if (!isWrong) control.setRegister(bank === 'R' ? 'R' : 'PR', Number(number), Number(slot), value);
  });

  let drawn = '';
  return {
    element,
    /** @param {CodeRun} run @param {readonly ProgramDoc[]} programs */
    draw(run, programs) {
      const registers = withUnset(run.registers(), namedIn(programs));
      const isLocked = control.mode() === 'running';
      const key = JSON.stringify([registers, isLocked]);
      if (key === drawn) return;
      drawn = key;
      const comments = commentsOf(programs);
      keepFocus(list, 'input', () =>
        fill(
          list,
          registers.length === 0 && h('li', { class: 'soft' }, CODE.noRegisters),
          registers.map((one) => row(one, comments.get(`${one.bank}[${one.index}]`) ?? '', isLocked)),
        ),
      );
    },
  };
}

const BANKS = ['R', 'PR', 'SR'];

/** With those that programs name, and that have no value yet. @param {readonly ShownRegister[]} held @param {ReturnType<typeof registersNamed>} named @returns {Shown[]} */
function withUnset(held, named) {
  const unset = named.filter(({ bank, index }) => !held.some((one) => one.bank === bank && one.index === index));
  const empty = { value: '', configuration: '' };
  return [
    ...held,
    ...unset.map((one) => ({ ...empty, ...one, numbers: Array(one.bank === 'R' ? 1 : SIX).fill(null) })),
  ].sort((a, b) => BANKS.indexOf(a.bank) - BANKS.indexOf(b.bank) || a.index - b.index);
}

/** As a pendant has it: three decimals; what is not touched keeps all of them. @param {number | null} number */
const shown = (number) => (number === null ? '' : String(Number(number.toFixed(3))));

/** @param {Shown} register @param {string} comment @param {boolean} isLocked */
function row({ bank, index, value, numbers, configuration }, comment, isLocked) {
  const name = `${bank}[${index}]`;
  const isJoints = bank === 'PR' && configuration === null;
  const label = (/** @type {number} */ slot) =>
    bank === 'R' ? '' : isJoints ? `J${slot + 1}` : (CARTESIAN[slot] ?? `E${slot - SIX + 1}`);
  return h(
    'li',
    {},
    h('span', { class: 'mono' }, name),
    h('span', { class: 'code-comment' }, comment),
    numbers.length === 0
      ? h('span', { class: 'value' }, value)
      : h(
          'span',
          { class: 'code-numbers' },
          numbers.map((number, slot) =>
            h(
              'label',
              {},
              label(slot) && h('span', {}, label(slot)),
              h('input', {
                ...{ type: 'text', inputmode: 'decimal', class: 'form-control', value: shown(number) },
                placeholder: CODE.unset,
                ...{ 'aria-label': `${name} ${label(slot)}`.trim(), 'data-action': 'register', disabled: isLocked },
                ...{ 'data-index': `${name} ${slot}`, 'data-bank': bank, 'data-number': index, 'data-slot': slot },
              }),
            ),
          ),
          configuration !== null && h('span', { class: 'mono' }, configuration),
        ),
  );
}
