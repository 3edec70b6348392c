/**
 * Controller code: the programs of the document, edited and run (codeRoom.js), and what is written from the model
 * (codeWriter.js), each verified before it is saved.
 *
 * @import { Page } from '../page.js'
 * @import { CodeRoom } from './codeRoom.js'
 * @import { CodeFormat } from '../../model/document.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 */
import $ from 'jquery/slim';
import { fileName } from '../../model/controller/codeSets.js';
import { together } from '../../model/views.js';
import '../css/code.css';
import '../css/writeCode.css';
import { copyText } from '../parts/clipboard.js';
import { fill, h, keepFocus } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { attempt, openPanel } from '../page.js';
import { createPressGate } from '../parts/pressed.js';
import { TEXT } from '../strings.js';
import { CODE } from '../words/code.js';
import { WRITE } from '../words/writeCode.js';
import { codeEmpty, createFileMenu, fileTabs, nameForm, ownFiles, showChosen } from './codeFiles.js';
import { createCodeWriter } from './codeWriter.js';
import { optionsForm } from './optionsForm.js';
import { ownLine } from './ownLine.js';
import { createVerifyPart } from './verifyPart.js';
import { createWrittenListing } from './writtenListing.js';
import { writtenHead, writtenNotes } from './writtenView.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {object} given
 * @param {string} given.version   of this program, for the files' heads
 * @param {() => string} given.today  ISO 8601
 */
export function createCodePanel(page, host, { version, today }) {
  const { store, addView, announce, messages } = page;
  const whenLetGo = createPressGate(host, page.clock);
  const drawAnew = () => keepFocus(host, '[data-action]', draw);
  const redraw = () => whenLetGo(drawAnew);
  const writer = createCodeWriter(page, { version, today, onChange: redraw, onProgress: () => showProgress() });
  /** @type {CodeRoom | null} */
  let room = null;
  /** Of the file that is shown. @type {string | null} */
  let chosen = null;
  /** The programs that have been here. @type {ReadonlySet<string>} */
  let known = new Set();
  let isRenaming = false;
  let areOptionsOpen = false;
  let refusal = '';
  /** To be gone to in what is shown. @type {number | null} */
  let line = null;

  const top = h('div', { class: 'code-top' });
  const listing = h('div', { class: 'code-listing' });
  const roomHost = h('div', { class: 'code-room', hidden: true });
  const ownChosen = () => store.state.doc.programs.find(({ id }) => `own ${id}` === chosen) ?? null;
  const found = createVerifyPart(page, {
    ...{ writer, ownChosen, redraw, version, today },
    given: () => room?.given() ?? [],
  });
  fill(host, top, listing, roomHost, found.element);
  const writtenFiles = () => found.filesSaved() ?? writer.written()?.files ?? [];
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

  function draw() {
    const { doc } = store.state;
    const hasSource = writer.source() !== null;
    const tabs = writtenFiles().map(({ name }, i) => ({ key: `written ${i}`, name, hint: WRITE.written }));
    if (hasSource && tabs.length === 0)
      tabs.push({ key: 'written 0', name: WRITE.formats[writer.format()], hint: WRITE.written });
    const files = [...ownFiles(doc), ...tabs];
    if (!files.some(({ key }) => key === chosen)) [chosen, isRenaming] = [files[0]?.key ?? null, false];
    const own = ownChosen();
    fill(
      top,
      files.length > 0 &&
        h(
          'div',
          { class: 'files', role: 'group', 'aria-label': CODE.files },
          fileTabs(files, chosen),
          h('span', { class: 'grow' }),
          h('div', { class: 'files-ways' }, menu.element),
        ),
      isRenaming && own && nameForm(page, own, { room, choose, refuse }),
      refusal && h('p', { class: 'code-refusal', role: 'alert' }, refusal),
      own && ownLine(doc, own),
    );
    if (files.length > 0) page.clock.onFrame(() => showChosen(top));
    drawOwn();
    drawListing(files.length === 0);
    found.draw();
  }

  /** @param {string} reason */
  function refuse(reason) {
    refusal = reason;
    redraw();
  }

  /** A long text is made once. @type {{ file: CodeFile, listing: ReturnType<typeof createWrittenListing> } | null} */
  let listed = null;
  /** @param {CodeFile} file */
  function listingOf(file) {
    if (listed?.file !== file) listed = { file, listing: createWrittenListing(page, file) };
    return listed.listing;
  }

  /** What stands above the text: in an element of its own, so that a long text stays where it is. */
  const above = h('div', { class: 'write-above' });
  const underWay = h('p', { class: 'verify-note', role: 'status', hidden: true });
  /** A list of choices that is open stays so while code is being written. */
  let head = h('div');
  /** The options' form stays while somebody types in it. @type {{ key: string, element: HTMLElement } | null} */
  let form = null;
  /** @param {boolean} isEmpty */
  function drawListing(isEmpty) {
    const { doc } = store.state;
    if (ownChosen()) return fill(listing);
    if (isEmpty) return fill(listing, codeEmpty(doc.postures.length, refusal ? menu.element : null));
    const written = writer.written();
    const key = JSON.stringify([
      writer.format(),
      writer.source(),
      doc.codeOptions,
      doc.frames,
      written?.files[0]?.name,
    ]);
    if (!areOptionsOpen) form = null;
    else if (form?.key !== key) form = { key, element: optionsForm(page, writer) };
    const areNotesOpen = listing.querySelector('.write-notes')?.hasAttribute('open') ?? false;
    const file = writtenFiles()[Number(chosen?.split(' ')[1])];
    const nextHead = writtenHead(doc, writer, areOptionsOpen);
    if (!head.isEqualNode(nextHead)) head = nextHead;
    fill(above, head, form?.element, written && writtenNotes(written, areNotesOpen), !file && underWay);
    const before = listing.querySelector('pre');
    const text = file ? listingOf(file) : null;
    if (text?.element !== before || above.parentElement !== listing) {
      const { scrollTop } = before ?? { scrollTop: 0 };
      fill(listing, above, text?.element);
      if (text) text.element.scrollTop = scrollTop;
    }
    text?.mark(line);
    showProgress();
  }

  /** What is being written: only this is another while it goes on. */
  function showProgress() {
    const progress = writer.progress();
    underWay.hidden = progress === null;
    if (progress !== null) underWay.textContent = WRITE.isWriting(fixed(100 * progress, 0));
  }

  /** The program of the document that is chosen, in its room. */
  function drawOwn() {
    const own = ownChosen();
    if (own && !room) loadRoom();
    room?.show(own);
    if (own && room && line !== null) {
      room.goTo(line);
      line = null;
    }
  }

  let isLoading = false;
  async function loadRoom() {
    if (isLoading) return;
    isLoading = true;
    try {
      const { createCodeRoom } = await import('./codeRoom.js');
      room = createCodeRoom(page, roomHost, {
        openProgram: (id) => choose(`own ${id}`),
        onAdded: () => void (known = new Set(store.state.doc.programs.map(({ id }) => id))),
        version,
        today,
      });
      redraw();
    } catch (error) {
      messages.fault(error);
    }
    isLoading = false;
  }

  /** The file that is shown, as a file. */
  function fileShown() {
    room?.commit();
    const own = ownChosen();
    return own ? { name: fileName(own), text: own.text } : writtenFiles()[Number(chosen?.split(' ')[1])];
  }

  /** @param {string} file @param {number} at */
  function goTo(file, at) {
    const { programs } = store.state.doc;
    line = at;
    if (ownChosen()) return choose(`own ${programs.find((program) => fileName(program) === file)?.id}`);
    choose(`written ${writtenFiles().findIndex(({ name }) => name === file)}`);
    if (line === null) return;
    const text = listing.querySelector('pre');
    text?.focus({ preventScroll: true });
  }

  $(host)
    .on('click', '[data-action=program]', () => openPanel(page, 'program'))
    .on('click', '[data-action=record]', () => {
      const reason = attempt(page, { type: 'record-posture' });
      if (reason) return refuse(reason);
      announce(CODE.recorded(store.state.doc.postures.length));
    })
    .on('click', '[data-action=new]', () => menu.addKarel())
    .on('click', '[data-action=new-tp]', () => menu.addTp())
    .on('click', '[data-action=open]', () => menu.openFile())
    .on('click', '[data-file]', ({ currentTarget }) => {
      line = null;
      choose(currentTarget.dataset.file);
    })
    .on('click', '[data-action=options]', () => {
      areOptionsOpen = !areOptionsOpen;
      redraw();
    })
    .on('change', '[data-choice]', ({ currentTarget }) => {
      const { value, dataset } = currentTarget;
      if (dataset.choice === 'format') writer.setFormat(/** @type {CodeFormat} */ (value));
      else if (dataset.choice === 'source') writer.setSource(value);
      else writer.choose({ userFrame: value || undefined });
      redraw();
    })
    .on('submit', '.write-options', (event) => event.preventDefault())
    .on('click', '[data-action=verify]', () => {
      room?.commit();
      line = null;
      found.verify();
    })
    .on('click', '[data-at-line]', ({ currentTarget }) =>
      goTo(currentTarget.dataset.atFile, Number(currentTarget.dataset.atLine)),
    )
    .on('click', '[data-action=edit]', () =>
      writer.whenWritten(() => {
        menu.add(
          writtenFiles().map(({ name, language, text }) => ({
            name: name.replace(/\.(\w+)$/, (_, end) => (end === 'dat' ? '_dat' : '')),
            language,
            text: () => text.replaceAll('\r\n', '\n'),
          })),
        );
      }),
    )
    .on('click', '[data-action=copy]', async () => {
      const file = fileShown();
      if (file) announce((await copyText(file.text)) ? CODE.copied(file.name) : TEXT.pose.copyFailed);
    });

  // a point of the path in the scene was pressed
  addView(
    ({ session }) => session.code.asked,
    (asked) => asked && ownChosen() && room?.goTo(asked.line),
  );
  addView(
    together(({ doc, session, gesture }) => [
      ...[session.tab === 'code', gesture === null, doc.robot, doc.postures, doc.programs],
      ...[doc.motionPrograms, doc.targets, doc.frames, doc.codeOptions, session.playback?.program],
    ]),
    ([isOpen]) => {
      if (!isOpen) return;
      // what was dropped on the page, or what an undo brings back
      const { programs } = store.state.doc;
      const fresh = programs.find(({ id }) => !known.has(id));
      if (fresh && known.size > 0) [chosen, refusal] = [`own ${fresh.id}`, ''];
      known = new Set(programs.map(({ id }) => id));
      writer.update();
      redraw();
    },
  );
}
