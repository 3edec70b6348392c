/**
 * Code that is written from the model: in which language and of what, its options, what to know before using it, and its text.
 *
 * @import { CodeWriter } from './codeWriter.js'
 * @import { CodeFormat, CodeOptions, WrittenCode } from '../../model/controller/writeCode.js'
 * @import { Doc } from '../../model/document.js'
 */
import { frameKey } from '../../model/controller/frameNumbers.js';
import { FIRST_SPEED, sourceKey } from '../../model/controller/codeSource.js';
import { readFrameNumber, readOption } from '../../model/controller/codeOptions.js';
import { FORMATS } from '../../model/controller/writeCode.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { CODE } from '../words/code.js';
import { VERIFY, WRITE } from '../words/writeCode.js';

/**
 * The choices above the text.
 * @param {Doc} doc
 * @param {CodeWriter} writer
 * @param {boolean} isOpen   whether the options are shown
 */
export function writtenHead(doc, writer, isOpen) {
  const now = writer.source();
  const select = (
    /** @type {string} */ name,
    /** @type {string} */ label,
    /** @type {readonly HTMLElement[]} */ choices,
  ) =>
    h(
      'select',
      { class: 'form-select form-select-sm', 'data-choice': name, 'aria-label': label, title: label },
      choices,
    );
  const option = (/** @type {string} */ value, /** @type {string} */ text, /** @type {boolean} */ selected) =>
    h('option', { value, selected }, text);
  const file = writer.written()?.files.length;
  return h(
    'div',
    { class: 'write-head' },
    h(
      'div',
      { class: 'write-row' },
      select(
        'format',
        WRITE.format,
        /** @type {CodeFormat[]} */ (Object.keys(FORMATS)).map((id) =>
          option(id, WRITE.formats[id], id === writer.format()),
        ),
      ),
      select(
        'source',
        WRITE.source,
        writer
          .sources()
          .map((one) =>
            option(sourceKey(one), sourceText(doc, one), now !== null && sourceKey(one) === sourceKey(now)),
          ),
      ),
    ),
    h(
      'div',
      { class: 'write-row' },
      h(
        'button',
        {
          ...{ type: 'button', class: 'btn', 'data-action': 'options' },
          ...{ 'aria-expanded': String(isOpen), 'aria-controls': 'write-options' },
        },
        icon('sliders'),
        WRITE.options,
      ),
      h('span', { class: 'grow' }),
      file ? iconButton('copy', 'copy', CODE.copy) : null,
      file ? h('button', { type: 'button', class: 'btn', 'data-action': 'edit' }, icon('codeSlash'), WRITE.edit) : null,
      file ? h('button', { type: 'button', class: 'btn btn-primary', 'data-action': 'verify' }, VERIFY.save) : null,
    ),
  );
}

/** @param {string} action @param {'copy' | 'download'} drawing @param {string} label */
export const iconButton = (action, drawing, label) =>
  h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'data-action': action, 'aria-label': label, title: label },
    icon(drawing),
  );

/** @param {Doc} doc @param {ReturnType<CodeWriter['sources']>[number]} source */
function sourceText({ motionPrograms, postures, targets }, source) {
  if (source.kind === 'postures') return WRITE.sources.postures(postures.length);
  if (source.kind === 'targets') return WRITE.sources.targets(targets.length);
  return WRITE.sources.program(motionPrograms.find(({ id }) => id === source.id)?.name ?? '');
}

/**
 * The options, as a form; what is refused stays as it was typed, with the reason.
 * @param {Doc} doc
 * @param {CodeWriter} writer
 * @param {(text: string) => void} say
 */
export function optionsForm(doc, writer, say) {
  const format = writer.format();
  const options = writer.options();
  const written = writer.written();
  const isProgram = writer.source()?.kind === 'program';
  /** @param {string} key @param {string} label @param {string} value @param {(text: string) => { change: CodeOptions } | { message: string }} read */
  function field(key, label, value, read) {
    const id = `write-${key.replace(/\W+/g, '-')}`;
    const reason = h('p', { class: 'write-reason', id: `${id}-reason`, role: 'alert', hidden: true });
    const input = h('input', {
      ...{ id, type: 'text', class: 'form-control', value, spellcheck: 'false', autocomplete: 'off' },
      ...{ 'aria-describedby': reason.id, 'data-action': 'option', 'data-index': key },
    });
    input.addEventListener('change', () => {
      const found = read(input.value);
      const message = 'message' in found ? found.message : '';
      reason.textContent = message;
      reason.hidden = message === '';
      input.setAttribute('aria-invalid', String(message !== ''));
      if ('change' in found) writer.setOptions(found.change);
      else say(message);
    });
    return h('div', { class: 'write-field' }, h('label', { for: id }, label), input, reason);
  }
  const numbers = written ? framesInUse(written) : [];
  const frame = h(
    'select',
    { id: 'write-frame', class: 'form-select form-select-sm', 'data-choice': 'frame' },
    h('option', { value: 'own', selected: options.userFrame === undefined }, WRITE.frames.own),
    h('option', { value: 'user ', selected: options.userFrame === '' }, WRITE.frames.world),
    doc.frames
      .filter(({ kind }) => kind === 'user')
      .map(({ id }) => h('option', { value: `user ${id}`, selected: options.userFrame === id }, id)),
  );
  return h(
    'form',
    { class: 'write-options', id: 'write-options', 'aria-label': WRITE.options },
    field('programName', WRITE.programName, options.programName ?? namesOf(written), (text) =>
      read(readOption(format, 'programName', text), (value) => ({ programName: String(value) })),
    ),
    format === 'pair' &&
      field('firstRegister', WRITE.firstRegister, String(options.firstRegister ?? 1), (text) =>
        read(readOption(format, 'firstRegister', text), (value) => ({ firstRegister: Number(value) })),
      ),
    field(
      'speed',
      isProgram ? WRITE.speedOfProgram : WRITE.speedOfJoints,
      String(options.speed ?? (isProgram ? 100 : FIRST_SPEED)),
      (text) => read(readOption(format, 'speed', text), (value) => ({ speed: Number(value) })),
    ),
    h('div', { class: 'write-field' }, h('label', { for: frame.id }, WRITE.frame), frame),
    numbers.map(({ kind, name, number }) => {
      const others = numbers.filter((one) => one.kind === kind && one.name !== name).map((one) => one.number);
      const label = kind === 'user' ? WRITE.user(name) : WRITE.tool(name || WRITE.toolInUse);
      return field(frameKey(kind, name), label, String(number), (text) =>
        read(readFrameNumber(text, others), (value) => ({
          numbers: { ...writer.options().numbers, [frameKey(kind, name)]: Number(value) },
        })),
      );
    }),
  );
}

/** @param {{ value: string | number } | { message: string }} found @param {(value: string | number) => CodeOptions} change */
const read = (found, change) => ('message' in found ? found : { change: change(found.value) });

/** @param {WrittenCode} written */
const framesInUse = ({ made }) =>
  made?.frames.numbered.filter(({ kind, number }) =>
    made.moves.some(({ move }) => (kind === 'user' ? move.userFrame : move.tool) === number),
  ) ?? [];

/** As the first file is called. @param {WrittenCode | null} written */
const namesOf = (written) => written?.files[0]?.name.replace(/\.[^.]*$/, '') ?? '';

/** What is against the code, or what to know of it. @param {WrittenCode} written @param {boolean} isOpen */
export function writtenNotes({ issues, notes, files }, isOpen) {
  if (files.length === 0)
    return h(
      'div',
      { class: 'cellbar bad-n', role: 'alert' },
      icon('octagon'),
      h(
        'div',
        {},
        h('b', {}, WRITE.none),
        issues.map(({ message }) => h('p', {}, message)),
      ),
    );
  const all = [...issues, ...notes].map(({ severity, message }) => ({ isWarning: severity === 'warning', message }));
  if (all.length === 0) return null;
  const sorted = [...all.filter(({ isWarning }) => isWarning), ...all.filter(({ isWarning }) => !isWarning)];
  return h(
    'details',
    { class: 'write-notes', open: isOpen },
    h('summary', {}, icon(sorted[0].isWarning ? 'exclamation' : 'question'), WRITE.notes(all.length)),
    h(
      'ul',
      {},
      sorted.map(({ message }) => h('li', {}, message)),
    ),
  );
}

/** Each line an element of its own, so that the stylesheet can number them. @param {string} text */
export const codeLines = (text) =>
  text
    .replace(/\r?\n$/, '')
    .split(/\r?\n/)
    .map((line) => h('span', { class: 'code-line' }, `${line}\n`));
