/**
 * The text of a written file in its colours, with its lines' numbers. It is made some lines at a time, and the browser lays out only what is
 * looked at: programs of thousands of lines hold nobody up.
 *
 * @import { CodeFile } from '../../karel/write/neutral.js'
 * @import { Page } from '../page.js'
 * @import { Token } from './codeTokens.js'
 */
import { inSlices } from '../../model/inSlices.js';
import { h } from '../parts/dom.js';
import { CODE } from '../words/code.js';
import { piecesOf } from './codeTokens.js';

/** Lines of a piece. */
const PIECE = 100;

/** @param {Page} page @param {CodeFile} file */
export function createWrittenListing({ clock, messages }, { name, language, text }) {
  const lines = text.replace(/\r?\n$/, '').split(/\r?\n/);
  const element = h('pre', { class: 'code', tabindex: 0, role: 'region', 'aria-label': CODE.text(name) });
  const making = pieces();
  making.next(); // what is seen at once
  inSlices(making, clock, { onDone() {}, onFault: messages.fault });
  /** @type {Element | null} */
  let marked = null;

  function* pieces() {
    for (let first = 0; first < lines.length; first += PIECE) {
      const piece = h(
        'span',
        { class: 'code-piece' },
        lines
          .slice(first, first + PIECE)
          .map((line, i) =>
            h('span', { class: 'code-line', 'data-line': first + i + 1 }, coloured(language, line), '\n'),
          ),
      );
      element.append(piece);
      yield first / lines.length;
    }
  }

  return {
    element,
    /** The line that was asked for, in sight; null: none. @param {number | null} line  from 1 */
    mark(line) {
      marked?.classList.remove('is-at');
      marked?.removeAttribute('aria-current');
      marked = null;
      if (line === null) return;
      while (!making.next().done);
      marked = element.children[Math.floor((line - 1) / PIECE)]?.children[(line - 1) % PIECE] ?? null;
      marked?.classList.add('is-at');
      marked?.setAttribute('aria-current', 'true');
      marked?.scrollIntoView({ block: 'nearest' });
    },
  };
}

/** By token: what has a colour. @type {Readonly<Partial<Record<Token, string>>>} */
const CLASSES = {
  ...{ keyword: 'is-key', typeName: 'is-type', meta: 'is-type', 'variableName.standard': 'is-fn' },
  ...{ number: 'is-num', string: 'is-str', comment: 'is-note', lineNumber: 'is-note' },
};

/** @param {CodeFile['language']} language @param {string} line @returns {(string | HTMLElement)[]} */
function coloured(language, line) {
  /** @type {(string | HTMLElement)[]} */
  const parts = [];
  let plain = '';
  for (const { text, token } of piecesOf(language, line)) {
    const name = token && CLASSES[token];
    if (!name) plain += text;
    else {
      parts.push(plain, h('span', { class: name }, text));
      plain = '';
    }
  }
  return [...parts, plain];
}
