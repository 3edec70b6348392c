/**
 * Copying the whole table: what the menu offers, and doing it. It is fetched when somebody comes near the button.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 */
import { dhTableMatlab, dhTablePython } from '../../model/robot/dhTableCode.js';
import { dhTableText } from '../../model/robot/dhTableText.js';
import { copyText } from '../parts/clipboard.js';
import { TEXT } from '../strings.js';
import { COPY_TABLE } from '../words/copyTable.js';

/**
 * @param {Page} page
 * @param {(text: string) => void} say
 * @returns {readonly Choice[][]}
 */
export function copyTableChoices({ store, messages }, say) {
  /** @param {keyof typeof COPY_TABLE.format} format @param {() => string} write @param {string | null} [detail] @returns {Choice} */
  const choice = (format, write, detail = null) => ({
    title: COPY_TABLE.format[format],
    detail,
    async run() {
      if (await copyText(write())) say(COPY_TABLE.copied(COPY_TABLE.format[format]));
      else messages.warn(TEXT.pose.copyFailed);
    },
  });
  const texts = /** @type {const} */ (['text', 'csv', 'markdown', 'latex']);
  return [
    texts.map((format) => choice(format, () => dhTableText(store.state.doc.robot, format))),
    [
      choice('python', () => dhTablePython(store.state.doc), COPY_TABLE.code),
      choice('matlab', () => dhTableMatlab(store.state.doc), COPY_TABLE.code),
      choice('json', () => dhTableText(store.state.doc.robot, 'json')),
    ],
  ];
}
