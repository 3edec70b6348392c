/**
 * Help in one dialog: the keys, and what a person must know to trust a number: conventions, limits of the tool, sources.
 * Loaded when it is first opened.
 *
 * @import { Shortcut } from './shortcuts.js'
 */
import './css/help.css';
import { dialogHead, openDialog } from './parts/dialog.js';
import { h } from './parts/dom.js';
import { HELP } from './words/help.js';

/**
 * @param {object} given
 * @param {string} given.version  of this program
 * @param {readonly Shortcut[]} given.shortcuts  the keys that the page listens to
 */
export function showHelp({ version, shortcuts }) {
  if (document.querySelector('.help')) return;
  openDialog({
    name: 'help',
    title: 'help-title',
    fit: 'modal-fullscreen-sm-down',
    content: [
      dialogHead('help-title', HELP.title),
      h(
        'div',
        { class: 'help-text', tabindex: 0, role: 'region', 'aria-label': HELP.title },
        h('h3', {}, HELP.keysTitle),
        keyList(inRows(shortcuts)),
        HELP.places.map(({ title, keys }) => [h('h4', {}, title), keyList(keys)]).flat(),
        HELP.sections.flatMap(({ title, points }) => [
          h('h3', {}, title),
          h(
            'ul',
            {},
            points.map((point) => h('li', {}, point)),
          ),
        ]),
        h('p', { class: 'soft' }, HELP.version(version)),
      ),
    ],
  });
}

/** One row for what can be done, with every way to press it. @param {readonly Shortcut[]} all @returns {[string[][], string][]} */
const inRows = (all) =>
  [...new Set(all.map(({ id }) => id))].map((id) => [
    all.filter((shortcut) => shortcut.id === id).map(keysOf),
    HELP.shortcut[id],
  ]);

/** @param {Shortcut} shortcut @returns {string[]} */
const keysOf = ({ key, hasControl, hasShift }) => [
  ...(hasControl ? [HELP.control] : []),
  ...(hasShift ? [HELP.shift] : []),
  key.toUpperCase(),
];

/** @param {readonly (readonly [readonly (readonly string[])[], string])[]} rows  ways to press, what they do */
const keyList = (rows) =>
  h(
    'dl',
    { class: 'keys' },
    rows.flatMap(([ways, what]) => [
      h(
        'dt',
        {},
        ways.flatMap((keys, i) => [
          i > 0 && ` ${HELP.or} `,
          ...keys.map((key) => (key === HELP.upTo ? ` ${key} ` : h('kbd', {}, key))),
        ]),
      ),
      h('dd', {}, what),
    ]),
  );
