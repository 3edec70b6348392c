/**
 * The files of the Code panel: those of the document, those that are written from the recorded postures, and the menu that adds,
 * opens, renames and removes.
 *
 * @import { Page } from '../page.js'
 * @import { Doc, ProgramDoc } from '../../model/document.js'
 */
import { freeCodeId } from '../../model/code/codeCommands.js';
import { attempt } from '../page.js';
import { withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { CODE } from '../words/code.js';

export const EXTENSION = /** @type {const} */ ({ karel: '.kl', 'fanuc-tp': '.ls', krl: '.src' });

/** @param {ProgramDoc} program */
export const fileName = ({ id, language }) => `${id.toLowerCase()}${EXTENSION[language]}`;

/** By the end of a file's name. @type {Readonly<Record<string, ProgramDoc['language']>>} */
const LANGUAGE_OF = { kl: 'karel', ls: 'fanuc-tp', src: 'krl', dat: 'krl' };
const LARGEST = 1_000_000;

/** @param {string} name  of a file, or what a person typed @returns {string} as a program can be called */
const idFrom = (name) =>
  name
    .replace(/\.[^.]*$/, '')
    .replace(/[^A-Za-z0-9_]+/g, '_')
    .replace(/^(?=\d|$)/, '_')
    .slice(0, 60);

/** Programs of controllers are often older than UTF-8. @param {ArrayBuffer} bytes */
function textOf(bytes) {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder('windows-1252').decode(bytes);
  }
}

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

  /** @param {string} name @param {ProgramDoc['language']} language @param {(id: string) => string} text */
  function add(name, language, text) {
    const id = freeCodeId(store.state.doc, name);
    const reason = attempt(page, { type: 'add-code', id, language, text: text(id) });
    if (reason) return refuse(reason);
    choose(id);
    announce(CODE.added(id));
  }

  const input = h('input', { type: 'file', accept: '.kl,.ls,.src,.dat,.txt' }); // stands nowhere: it is only asked
  input.addEventListener('change', async () => {
    const [file] = input.files ?? [];
    input.value = '';
    if (!file) return;
    if (file.size > LARGEST) return refuse(CODE.tooLarge(file.name));
    const text = textOf(await file.arrayBuffer()).replace(/\r\n?/g, '\n');
    if (/(?![\t\n])\p{Cc}/u.test(text)) return refuse(CODE.notText(file.name));
    add(idFrom(file.name), LANGUAGE_OF[file.name.toLowerCase().split('.').at(-1) ?? ''] ?? 'karel', () => text);
  });

  const button = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': CODE.more, title: CODE.more, 'data-action': 'files' },
    icon('plus'),
  );
  const news = [
    { title: CODE.newKarel, detail: CODE.newKarelDetail, run: () => add('main', 'karel', CODE.template) },
    { title: CODE.newTp, detail: CODE.onlyEdited, run: () => add('tp_main', 'fanuc-tp', () => '') },
    { title: CODE.newKrl, detail: CODE.onlyEdited, run: () => add('krl_main', 'krl', () => '') },
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
    addKarel: news[0].run,
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

/** @param {Doc} doc */
export const ownFiles = ({ programs }) =>
  programs.map((program) => ({ key: `own ${program.id}`, name: fileName(program) }));
