/**
 * The options of code that is written, as a form; what is refused stays as it was typed, with the reason.
 *
 * @import { Page } from '../page.js'
 * @import { CodeWriter } from './codeWriter.js'
 * @import { WrittenCode } from '../../model/controller/writeCode.js'
 * @import { OptionField } from '../../model/controller/codeOptions.js'
 */
import { FIRST_SPEED } from '../../model/controller/codeSource.js';
import { keptOptions, readFrameNumber, readOption, sourceWord, WORLD } from '../../model/controller/codeOptions.js';
import { frameKey } from '../../model/controller/frameNumbers.js';
import { attempt } from '../page.js';
import { h } from '../parts/dom.js';
import { WRITE } from '../words/writeCode.js';

/** @param {Page} page @param {CodeWriter} writer */
export function optionsForm(page, writer) {
  const { doc } = page.store.state;
  const { userFrame } = keptOptions(doc);
  const options = writer.options();
  const written = writer.written();
  const now = writer.source();
  const isProgram = now?.kind === 'program';
  /** @param {string} key @param {string} label @param {string} value @param {(text: string) => string | null} take  the reason why not */
  function field(key, label, value, take) {
    const id = `write-${key.replace(/\W+/g, '-')}`;
    const reason = h('p', { class: 'write-reason', id: `${id}-reason`, role: 'alert', hidden: true });
    const input = h('input', {
      ...{ id, type: 'text', class: 'form-control', value, spellcheck: 'false', autocomplete: 'off' },
      ...{ 'aria-describedby': reason.id, 'data-action': 'option', 'data-index': key },
    });
    input.addEventListener('change', () => {
      const message = take(input.value) ?? '';
      reason.textContent = message;
      reason.hidden = message === '';
      input.setAttribute('aria-invalid', String(message !== ''));
    });
    return h('div', { class: 'write-field' }, h('label', { for: id }, label), input, reason);
  }
  /** @param {OptionField} key @param {string} label @param {string | number} value */
  const choice = (key, label, value) =>
    field(key, label, String(value), (text) => {
      const found = readOption(writer.format(), key, text);
      if ('message' in found) return found.message;
      const source = key === 'programName' && now ? { source: sourceWord(now) } : {}; // a name is of what is written
      return writer.choose({ ...source, [key]: found.value });
    });
  const numbers = written ? framesInUse(written) : [];
  const frame = h(
    'select',
    { id: 'write-frame', class: 'form-select form-select-sm', 'data-choice': 'frame' },
    h('option', { value: '', selected: options.userFrame === undefined }, WRITE.frames.own),
    h('option', { value: WORLD, selected: userFrame === WORLD }, WRITE.frames.world),
    doc.frames
      .filter(({ kind }) => kind === 'user')
      .map(({ id }) => h('option', { value: id, selected: userFrame === id }, id)),
  );
  return h(
    'form',
    { class: 'write-options', id: 'write-options', 'aria-label': WRITE.options },
    choice('programName', WRITE.programName, options.programName ?? nameOf(written)),
    writer.format() === 'pair' && choice('firstRegister', WRITE.firstRegister, options.firstRegister ?? 1),
    choice(
      'speed',
      isProgram ? WRITE.speedOfProgram : WRITE.speedOfJoints,
      options.speed ?? (isProgram ? 100 : FIRST_SPEED),
    ),
    h('div', { class: 'write-field' }, h('label', { for: frame.id }, WRITE.frame), frame),
    numbers.map(({ kind, name, number }) => {
      const others = numbers.filter((one) => one.kind === kind && one.name !== name).map((one) => one.number);
      const label = kind === 'user' ? WRITE.user(name) : WRITE.tool(name || WRITE.toolInUse);
      return field(frameKey(kind, name), label, String(number), (text) => {
        const found = readFrameNumber(text, others);
        if ('message' in found) return found.message;
        if (name === '') return writer.choose({ toolNumber: found.value });
        const index = page.store.state.doc.frames.findIndex((one) => one.kind === kind && one.id === name);
        return attempt(page, { type: 'number-frame', index, number: found.value });
      });
    }),
  );
}

/** @param {WrittenCode} written */
const framesInUse = ({ made }) =>
  made?.frames.numbered.filter(({ kind, number }) =>
    made.moves.some(({ move }) => (kind === 'user' ? move.userFrame : move.tool) === number),
  ) ?? [];

/** As the first file is called. @param {WrittenCode | null} written */
const nameOf = (written) => written?.files[0]?.name.replace(/\.[^.]*$/, '') ?? '';
