/**
 * Controller code for the recorded postures: shown, copied, saved. The writer is loaded when the panel is first opened.
 *
 * @import { IconName } from '../parts/icons.js'
 * @import { Page } from '../page.js'
 * @import { Doc } from '../../model/document.js'
 */
import $ from 'jquery/slim';
import { memo } from '../../model/memo.js';
import { together } from '../../model/views.js';
import { copyText } from '../parts/clipboard.js';
import '../css/program.css';
import { fill, h, keepFocus } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { emptyState } from '../parts/emptyState.js';
import { icon } from '../parts/icons.js';
import { openPanel } from '../page.js';
import { TEXT } from '../strings.js';
import { CODE } from '../words/code.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {object} given
 * @param {string} given.version   of this program, for the files' heads
 * @param {() => string} given.today  ISO 8601
 */
export function createCodePanel(page, host, { version, today }) {
  const { store, addView, announce, clock, messages } = page;
  /** @type {typeof import('../../model/controller/controllerCode.js') | null} */
  let writer = null;
  let chosen = 0;

  const write = memo((/** @type {Doc['robot']} */ robot, /** @type {Doc['postures']} */ postures) =>
    /** @type {NonNullable<typeof writer>} */ (writer).controllerCode(
      { ...store.state.doc, robot, postures },
      { version, generatedAt: today() },
    ),
  );
  const codeOf = (/** @type {Doc} */ doc) => (writer ? write(doc.robot, doc.postures) : null);

  /** @param {Doc} doc */
  function draw(doc) {
    if (doc.postures.length < 2) {
      const action = h(
        'button',
        { type: 'button', class: 'btn btn-primary', 'data-action': 'program' },
        CODE.toProgram,
      );
      fill(host, emptyState(CODE.empty, CODE.emptyDetail, action));
      return;
    }
    const code = codeOf(doc);
    if (!code) return;
    chosen = Math.min(chosen, Math.max(0, code.files.length - 1));
    const file = code.files[chosen];
    fill(
      host,
      h(
        'div',
        { class: 'table-head' },
        h('h2', {}, CODE.title),
        h('span', { class: 'grow' }),
        file && actionButton('save', 'download', CODE.save, 'btn-primary'),
      ),
      notes(code.issues.map(({ message }) => message)),
      file && [
        h(
          'div',
          { class: 'files', role: 'group', 'aria-label': CODE.files },
          code.files.map(({ name }, i) =>
            h(
              'button',
              {
                type: 'button',
                'data-action': 'file',
                'data-index': i,
                'data-file': i,
                'aria-pressed': String(i === chosen),
              },
              name,
            ),
          ),
          h('span', { class: 'grow' }),
          actionButton('copy', 'copy', CODE.copy),
        ),
        h('pre', { class: 'code', tabindex: 0, role: 'region', 'aria-label': CODE.text(file.name) }, lines(file.text)),
      ],
    );
  }

  $(host)
    .on('click', '[data-action=program]', () => openPanel(page, 'program'))
    .on('click', '[data-file]', ({ currentTarget }) => {
      chosen = Number(currentTarget.dataset.file);
      redraw();
    })
    .on('click', '[data-action=copy]', async () => {
      const file = codeOf(store.state.doc)?.files[chosen];
      if (file) announce((await copyText(file.text)) ? CODE.copied(file.name) : TEXT.pose.copyFailed);
    })
    .on('click', '[data-action=save]', () => {
      const files = codeOf(store.state.doc)?.files ?? [];
      for (const { name, text } of files) download(name, text, 'text/plain', clock);
      announce(CODE.saved(files.map(({ name }) => name).join(', ')));
    });

  const redraw = () => keepFocus(host, '[data-action]', () => draw(store.state.doc));
  /** @type {Promise<void> | null} */
  let loading = null;
  const load = () =>
    import('../../model/controller/controllerCode.js')
      .then((module) => {
        writer = module;
        redraw();
      })
      .catch((error) => {
        loading = null;
        messages.fault(error);
      });

  addView(
    together(({ doc, session }) => [session.tab === 'code', doc.robot, doc.postures]),
    ([isOpen]) => {
      if (!isOpen) return;
      redraw();
      if (!writer) loading ??= load();
    },
  );
}

/** @param {string} action @param {IconName} name @param {string} label @param {string} [look] */
const actionButton = (action, name, label, look) =>
  look
    ? h('button', { type: 'button', class: `btn ${look}`, 'data-action': action }, icon(name), label)
    : h(
        'button',
        { type: 'button', class: 'btn btn-icon', 'data-action': action, 'aria-label': label, title: label },
        icon(name),
      );

/** @param {string[]} messages */
const notes = (messages) =>
  messages.length > 0 &&
  h(
    'div',
    { class: 'cellbar ask' },
    icon('exclamation'),
    h(
      'div',
      {},
      h('b', {}, CODE.notes),
      messages.map((message) => h('p', {}, message)),
    ),
  );

/** Each line an element of its own, so that the stylesheet can number them. @param {string} text */
const lines = (text) =>
  text
    .replace(/\n$/, '')
    .split('\n')
    .map((line) => h('span', { class: 'code-line' }, `${line}\n`));
