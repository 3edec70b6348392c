/**
 * The files of the Code panel: those of the document, those that are written from the model, and the menu that adds, opens,
 * renames and removes.
 *
 * @import { Page } from '../page.js'
 * @import { CodeRoom } from './codeRoom.js'
 * @import { Doc, ProgramDoc } from '../../model/document.js'
 * @import { NewProgram } from './openCode.js'
 */
import { freeCodeId } from '../../model/code/codeCommands.js';
import { firstWay } from '../../model/code/firstWay.js';
import { fileName } from '../../model/controller/codeSets.js';
import { attempt } from '../page.js';
import { withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { CODE } from '../words/code.js';
import { addPrograms, openCode } from './openCode.js';

/**
 * @param {Page} page
 * @param {object} acts
 * @param {(id: string) => void} acts.choose
 * @param {() => string | null} acts.chosen   the program that is open
 * @param {(text: string) => void} acts.refuse
 * @param {() => void} acts.rename
 */
export function createFileMenu(page, { choose, chosen, refuse, rename }) {
  const { store, announce } = page;

  /** @param {Awaited<ReturnType<typeof openCode>>} done  the first of them to be shown */
  const shown = (done) => ('ids' in done ? done.ids[0] && choose(done.ids[0]) : refuse(done.reason));
  /** @param {readonly NewProgram[]} added */
  const add = (added) => void shown(addPrograms(page, added));

  /** @param {string} name @param {ProgramDoc['language']} language @param {(id: string) => string} text */
  const one = (name, language, text) => () => add([{ name, language, text }]);

  const way = () => firstWay(store.state.doc, CODE.newWay);

  /** KAREL is not to move the arm itself; with it comes a TP program that does, unless one is there. */
  function addKarel() {
    const { programs } = store.state.doc;
    const there = programs.find(({ id, language }) => /^go_lin/.test(id) && language === 'fanuc-tp')?.id;
    const mover = there ?? freeCodeId(store.state.doc, 'go_lin');
    add([
      { name: 'main', language: 'karel', text: (id) => CODE.template(id, way(), mover) },
      ...(there ? [] : [{ name: mover, language: /** @type {const} */ ('fanuc-tp'), text: CODE.moverTemplate }]),
    ]);
  }

  const input = h('input', { type: 'file', multiple: true, accept: '.kl,.klh,.klt,.klc,.ls,.src,.dat,.txt' }); // stands nowhere: it is only asked
  input.addEventListener('change', async () => {
    const files = [...(input.files ?? [])];
    input.value = '';
    shown(await openCode(page, files));
  });

  const button = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': CODE.more, title: CODE.more, 'data-action': 'files' },
    icon('plus'),
  );
  const news = [
    { title: CODE.newKarel, detail: CODE.newKarelDetail, run: addKarel },
    {
      title: CODE.newTp,
      detail: CODE.newTpDetail,
      run: one('tp_main', 'fanuc-tp', (id) => CODE.tpTemplate(id, way())),
    },
    { title: CODE.newKrl, detail: CODE.krlDetail, run: one('krl_main', 'krl', CODE.krlTemplate) },
  ];
  const menu = withChoices(button, () => {
    const id = chosen();
    return {
      groups: [
        news,
        [{ title: CODE.openFile, detail: CODE.openDetail, run: () => input.click() }],
        ...(id === null
          ? []
          : [
              [
                { title: CODE.rename(id), run: rename },
                {
                  title: CODE.remove(id),
                  run: () => {
                    attempt(page, { type: 'remove-code', id });
                    announce(CODE.removed(id));
                  },
                },
              ],
            ]),
      ],
    };
  });
  return {
    element: menu,
    addKarel,
    addTp: news[1].run,
    openFile: () => input.click(),
    add,
  };
}

/**
 * A tab for each file; arrow keys are not needed: they are few, and buttons.
 * @param {readonly { key: string, name: string, hint?: string }[]} files
 * @param {string | null} chosen
 */
export const fileTabs = (files, chosen) =>
  files.map(({ key, name, hint }) =>
    h(
      'button',
      {
        ...{ type: 'button', 'data-action': 'file', 'data-index': key, 'data-file': key },
        ...{ 'aria-pressed': String(key === chosen), class: hint ? 'is-written' : null, title: hint },
      },
      name,
    ),
  );

/** Of more files than there is room for, the chosen one is in sight. @param {Element} host */
export function showChosen(host) {
  const strip = host.querySelector('.files');
  const box = strip?.querySelector('[aria-pressed=true]')?.getBoundingClientRect();
  if (!strip || !box) return;
  const { left } = strip.getBoundingClientRect();
  const right = strip.querySelector('.files-ways')?.getBoundingClientRect().left ?? 0;
  strip.scrollLeft += Math.max(0, box.right - right) || Math.min(0, box.left - left);
}

/** @param {Doc} doc */
export const ownFiles = ({ programs }) =>
  programs.map((program) => ({ key: `own ${program.id}`, name: fileName(program) }));

/** @param {number} postures  recorded @param {HTMLElement | null} menu  where a file was refused */
export const codeEmpty = (postures, menu) =>
  h(
    'div',
    { class: 'empty' },
    h('h2', {}, CODE.empty),
    way(CODE.ways.own, CODE.ways.own.detail, [
      h('button', { type: 'button', class: 'btn btn-primary', 'data-action': 'new' }, CODE.newKarel),
      h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'new-tp' }, CODE.newTp),
      h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'open' }, CODE.openFile),
      menu,
    ]),
    way(CODE.ways.written, `${CODE.ways.written.detail} ${CODE.recorded(postures)}`, [
      h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'record' }, CODE.record),
      h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'program' }, CODE.toProgram),
    ]),
  );

/** @param {{ title: string }} words @param {string} detail @param {(HTMLElement | null)[]} buttons */
const way = ({ title }, detail, buttons) =>
  h(
    'section',
    { class: 'empty-way' },
    h('h3', {}, title),
    h('p', {}, detail),
    h('div', { class: 'row-flex empty-ways' }, buttons),
  );

/**
 * @param {Page} page
 * @param {ProgramDoc} own
 * @param {{ room: CodeRoom | null, choose: (key: string) => void, refuse: (reason: string) => void }} acts
 */
export function nameForm(page, own, { room, choose, refuse }) {
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
    if (reason) return refuse(reason);
    choose(`own ${to}`);
  });
  form.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') choose(`own ${own.id}`);
  });
  return form;
}
