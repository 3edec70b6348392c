/**
 * Code that is written from the model: in which language and of what, its options, what to know before using it, and its text.
 *
 * @import { CodeWriter } from './codeWriter.js'
 * @import { WrittenCode } from '../../model/controller/writeCode.js'
 * @import { CodeFormat, Doc } from '../../model/document.js'
 */
import { sourceWord } from '../../model/controller/codeOptions.js';
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
            option(sourceWord(one), sourceText(doc, one), now !== null && sourceWord(one) === sourceWord(now)),
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

/** @param {string} action @param {'copy' | 'close'} drawing @param {string} label */
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
