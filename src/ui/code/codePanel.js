/**
 * Controller code: the programs of the document, edited and run (codeRoom.js), and what is written from the recorded postures,
 * shown, copied, saved.
 *
 * @import { IconName } from '../parts/icons.js'
 * @import { Page } from '../page.js'
 * @import { CodeRoom } from './codeRoom.js'
 * @import { Doc } from '../../model/document.js'
 * @import { controllerCode } from '../../model/controller/controllerCode.js'
 */
import $ from 'jquery/slim';
import { memo } from '../../model/memo.js';
import { together } from '../../model/views.js';
import '../css/code.css';
import { copyText } from '../parts/clipboard.js';
import { fill, h, keepFocus } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { emptyState } from '../parts/emptyState.js';
import { icon } from '../parts/icons.js';
import { attempt, openPanel } from '../page.js';
import { TEXT } from '../strings.js';
import { CODE } from '../words/code.js';
import { createFileMenu, fileName, fileTabs, ownFiles } from './codeFiles.js';

/** @typedef {ReturnType<typeof controllerCode>} Written */

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
  /** @type {CodeRoom | null} */
  let room = null;
  /** Of the file that is shown. @type {string | null} */
  let chosen = null;
  let isRenaming = false;
  let refusal = '';

  const top = h('div', { class: 'code-top' });
  const listing = h('div', { class: 'code-listing' });
  const roomHost = h('div', { class: 'code-room', hidden: true });
  fill(host, top, listing, roomHost);

  const write = memo((/** @type {Doc['robot']} */ robot, /** @type {Doc['postures']} */ postures) =>
    /** @type {NonNullable<typeof writer>} */ (writer).controllerCode(
      { ...store.state.doc, robot, postures },
      { version, generatedAt: today() },
    ),
  );
  /** @param {Doc} doc @returns {Written | null} null: there is nothing to write, or not yet what writes it */
  const writtenOf = (doc) => (writer && doc.postures.length > 1 ? write(doc.robot, doc.postures) : null);

  const ownChosen = () => store.state.doc.programs.find(({ id }) => `own ${id}` === chosen) ?? null;
  const menu = createFileMenu(page, {
    choose: (id) => choose(`own ${id}`),
    chosen: () => ownChosen()?.id ?? null,
    refuse(text) {
      refusal = text;
      announce(text);
      redraw();
    },
    rename() {
      isRenaming = true;
      redraw();
      top.querySelector('input')?.focus();
    },
  });

  /** @param {string} key */
  function choose(key) {
    room?.commit();
    [chosen, isRenaming, refusal] = [key, false, ''];
    redraw();
  }

  /** @param {Doc} doc */
  function draw(doc) {
    const written = writtenOf(doc);
    const files = [
      ...ownFiles(doc),
      ...(written?.files ?? []).map(({ name }) => ({ key: `written ${name}`, name, hint: CODE.written })),
    ];
    if (!files.some(({ key }) => key === chosen)) [chosen, isRenaming] = [files[0]?.key ?? null, false];
    const isEmpty =
      files.length === 0 && (!written || written.issues.length === 0) && (doc.postures.length < 2 || writer !== null);
    fill(
      top,
      !isEmpty &&
        h(
          'div',
          { class: 'files', role: 'group', 'aria-label': CODE.files },
          fileTabs(files, chosen),
          h('span', { class: 'grow' }),
          h(
            'div',
            { class: 'files-ways' },
            ownChosen() && actionButton('save', 'download', CODE.saveOne),
            ownChosen() && actionButton('copy', 'copy', CODE.copy),
            menu.element,
          ),
        ),
      isRenaming && nameForm(),
      refusal && h('p', { class: 'code-refusal', role: 'alert' }, refusal),
    );
    drawOwn();
    const file = written?.files.find(({ name }) => `written ${name}` === chosen);
    fill(listing, isEmpty ? empty() : !ownChosen() && written && drawWritten(written, file));
  }

  const empty = () =>
    emptyState(
      CODE.empty,
      CODE.emptyDetail,
      h(
        'div',
        { class: 'row-flex empty-ways' },
        h('button', { type: 'button', class: 'btn btn-primary', 'data-action': 'new' }, CODE.newKarel),
        h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'program' }, CODE.toProgram),
        h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'open' }, CODE.openFile),
        refusal && menu.element,
      ),
    );

  function nameForm() {
    const own = ownChosen();
    if (!own) return null;
    const input = h('input', {
      type: 'text',
      class: 'form-control',
      value: own.id,
      'aria-label': CODE.nameLabel,
      spellcheck: 'false',
    });
    const form = h(
      'form',
      { class: 'code-answer' },
      input,
      h('button', { type: 'submit', class: 'btn btn-outline' }, CODE.keepName),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      room?.commit();
      const to = input.value.trim();
      const reason = attempt(page, { type: 'rename-code', id: own.id, to });
      if (reason) {
        refusal = reason;
        input.setAttribute('aria-invalid', 'true');
        return void redraw();
      }
      choose(`own ${to}`);
    });
    form.addEventListener('keydown', ({ key }) => {
      if (key === 'Escape') choose(`own ${own.id}`);
    });
    return form;
  }

  /** The program of the document that is chosen, in its room. */
  function drawOwn() {
    const own = ownChosen();
    if (own && !room) loadRoom();
    room?.show(own);
  }

  let isLoading = false;
  async function loadRoom() {
    if (isLoading) return;
    isLoading = true;
    try {
      const { createCodeRoom } = await import('./codeRoom.js');
      room = createCodeRoom(page, roomHost);
      redraw();
    } catch (error) {
      messages.fault(error);
    }
    isLoading = false;
  }

  /** @param {Written} written @param {Written['files'][number] | undefined} file */
  const drawWritten = (written, file) => [
    h(
      'div',
      { class: 'table-head' },
      h('h2', {}, CODE.title),
      h('span', { class: 'grow' }),
      file && actionButton('edit', 'codeSlash', CODE.edit, 'btn-outline'),
      file && actionButton('save', 'download', CODE.save, 'btn-primary'),
      file && actionButton('copy', 'copy', CODE.copy),
    ),
    notes(written.issues.map(({ message }) => message)),
    file &&
      h('pre', { class: 'code', tabindex: 0, role: 'region', 'aria-label': CODE.text(file.name) }, lines(file.text)),
  ];

  /** The file that is shown, as a file. */
  function fileShown() {
    room?.commit();
    const own = ownChosen();
    if (own) return { name: fileName(own), text: own.text };
    return writtenOf(store.state.doc)?.files.find(({ name }) => `written ${name}` === chosen);
  }

  $(host)
    .on('click', '[data-action=program]', () => openPanel(page, 'program'))
    .on('click', '[data-action=new]', () => menu.addKarel())
    .on('click', '[data-action=open]', () => menu.openFile())
    .on('click', '[data-file]', ({ currentTarget }) => choose(currentTarget.dataset.file))
    .on('click', '[data-action=edit]', () => {
      for (const { name, text } of writtenOf(store.state.doc)?.files.toReversed() ?? []) {
        const isTp = name.toLowerCase().endsWith('.ls');
        menu.add(name.replace(/\.[^.]*$/, '').toLowerCase(), isTp ? 'fanuc-tp' : 'karel', () => text);
      }
    })
    .on('click', '[data-action=copy]', async () => {
      const file = fileShown();
      if (file) announce((await copyText(file.text)) ? CODE.copied(file.name) : TEXT.pose.copyFailed);
    })
    .on('click', '[data-action=save]', () => {
      const own = ownChosen() && fileShown();
      const files = own ? [own] : (writtenOf(store.state.doc)?.files ?? []);
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
    together(({ doc, session }) => [session.tab === 'code', doc.robot, doc.postures, doc.programs]),
    ([isOpen, , postures]) => {
      if (!isOpen) return;
      redraw();
      if (!writer && postures.length > 1) loading ??= load();
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
