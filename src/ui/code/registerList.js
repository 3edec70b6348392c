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
import { registerComments, registersNamed, registerTyped } from '../../model/code/codeSignals.js';
import { memo } from '../../model/memo.js';
import { fill, h, keepFocus } from '../parts/dom.js';
import { CODE } from '../words/code.js';

const CARTESIAN = ['X', 'Y', 'Z', 'W', 'P', 'R'];
const SIX = CARTESIAN.length;

/** @param {RunControl} control */
export function createRegisterList(control) {
  const list = h('ul', { class: 'code-registers' });
  const input = h('input', {
    ...{ type: 'text', class: 'form-control', 'aria-label': CODE.otherRegister, placeholder: CODE.otherRegister },
    ...{ autocomplete: 'off', spellcheck: 'false' },
  });
  const reason = h('p', { class: 'reason', role: 'status', hidden: true });
  const form = h(
    'form',
    { class: 'code-watch', novalidate: '' },
    input,
    h('button', { type: 'submit', class: 'btn btn-outline' }, CODE.showRegister),
  );
  const element = h(
    'div',
    {},
    h('div', { class: 'code-scroll', tabindex: 0, role: 'group', 'aria-label': CODE.parts.registers }, list),
    reason,
    form,
  );
  const commentsOf = memo(registerComments);
  const namedIn = memo(registersNamed);
  /** Those that no program names by its number, and that a person wants to see. @type {ReturnType<typeof registersNamed>} */
  let wanted = [];
  /** @type {[readonly ProgramDoc[], ProgramDoc['language']]} */
  let drawnFor = [[], 'fanuc-tp'];

  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const run = control.run();
    const found = registerTyped(input.value);
    const isWrong = found === null && input.value.trim() !== '';
    input.setAttribute('aria-invalid', String(isWrong));
    reason.hidden = !isWrong;
    reason.textContent = isWrong ? CODE.noSuchRegister(input.value.trim().slice(0, 40)) : '';
    if (isWrong) form.scrollIntoView({ block: 'nearest' });
    if (!found || !run) return;
    wanted = [...wanted, found];
    input.value = '';
    draw(run, ...drawnFor);
    list.querySelector(`[data-index="${found.bank}[${found.index}] 0"]`)?.scrollIntoView({ block: 'nearest' });
  });

  list.addEventListener('change', ({ target }) => {
    if (!(target instanceof HTMLInputElement)) return;
    const { bank, number, slot } = target.dataset;
    const value = Number(target.value.replace('−', '-').replace(',', '.'));
    const isWrong = target.value.trim() === '' || !Number.isFinite(value) || Math.abs(value) > 1e9;
    target.setAttribute('aria-invalid', String(isWrong));
    if (!isWrong) control.setRegister(bank === 'R' ? 'R' : 'PR', Number(number), Number(slot), value);
  });

  let drawn = '';
  /** @param {CodeRun} run @param {readonly ProgramDoc[]} programs @param {ProgramDoc['language']} language */
  function draw(run, programs, language) {
    drawnFor = [programs, language];
    const hasNone = language === 'krl';
    form.hidden = hasNone;
    const registers = hasNone ? [] : withUnset(run.registers(), [...namedIn(programs), ...wanted]);
    const isLocked = control.mode() === 'running';
    const key = JSON.stringify([registers, isLocked, hasNone]);
    if (key === drawn) return;
    drawn = key;
    const comments = commentsOf(programs);
    keepFocus(list, 'input', () =>
      fill(
        list,
        registers.length === 0 && h('li', { class: 'soft' }, hasNone ? CODE.noRegistersKrl : CODE.noRegisters),
        registers.map((one) => row(one, comments.get(`${one.bank}[${one.index}]`) ?? '', isLocked)),
      ),
    );
  }
  return { element, draw };
}

const BANKS = ['R', 'PR', 'SR'];

/** With those that programs name, and that have no value yet. @param {readonly ShownRegister[]} held @param {ReturnType<typeof registersNamed>} named @returns {Shown[]} */
function withUnset(held, named) {
  const isSame = (/** @type {{ bank: string, index: number }} */ a, /** @type {{ bank: string, index: number }} */ b) =>
    a.bank === b.bank && a.index === b.index;
  const unset = named.filter(
    (one, i) => !held.some((other) => isSame(one, other)) && named.findIndex((other) => isSame(one, other)) === i,
  );
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
