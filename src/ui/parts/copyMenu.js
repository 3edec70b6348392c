/**
 * Copying what the panel shows, and what it does not: a press copies again as the last time, the menu beside it says as what.
 *
 * @import { Page } from '../page.js'
 * @import { CopySheet, CopyFormat } from '../../model/numbers/copyText.js'
 */
import { KERNEL_UNITS } from '../../model/numbers/copySheets.js';
import { COPY_FORMATS, copyText as writeCopy } from '../../model/numbers/copyText.js';
import { copyText } from './clipboard.js';
import { fill } from './dom.js';
import { unitSign } from './format.js';
import { icon } from './icons.js';
import { addMenu } from './poseMenu.js';
import { TEXT } from '../strings.js';
import { NUMBERS } from '../words/numbers.js';

/** So long the button says that it has copied. */
const DONE_SECONDS = 1.5;

/**
 * @template {string} Copied
 * @typedef {object} Copying
 * @property {(what: Copied) => CopySheet} sheetOf
 * @property {() => Copied} main           what a press copies
 * @property {readonly Copied[]} others    what the menu has besides; the main one is left out
 * @property {Record<Copied, string>} names   "the pose"
 * @property {Partial<Record<Copied, string>>} titles  "The pose"
 * @property {string} title                of the button
 */

/**
 * @template {string} Copied
 * @param {Page} page
 * @param {{ copy: HTMLButtonElement, copyMore: HTMLButtonElement }} parts
 * @param {Copying<Copied>} copying
 */
export function runCopyMenu({ store, announce, messages, clock }, { copy, copyMore }, copying) {
  const { sheetOf, main, others, names, titles, title } = copying;
  const numbers = () => store.state.session.numbers;
  /** @param {Partial<ReturnType<typeof numbers>>} change */
  const choose = (change) => store.dispatch({ type: 'show', change: { numbers: { ...numbers(), ...change } } });
  let cancel = () => {};

  /** @param {Copied} what */
  async function carryOut(what) {
    const { format } = numbers();
    const isDone = await copyText(writeCopy(sheetOf(what), format));
    if (!isDone) {
      messages.warn(TEXT.pose.copyFailed);
      return;
    }
    announce(NUMBERS.copied(names[what], NUMBERS.format[format]));
    fill(copy, icon('check'));
    copy.title = NUMBERS.copied(names[what], NUMBERS.format[format]);
    cancel();
    cancel = clock.after(DONE_SECONDS, () => {
      fill(copy, icon('copy'));
      copy.title = title;
    });
  }

  copy.addEventListener('click', () => void carryOut(main()));
  addMenu(copyMore, () => {
    const { format, isKernelUnits } = numbers();
    const first = main();
    const { length, angle } = store.state.doc.robot.units;
    return [
      {
        heading: NUMBERS.copyAs(names[first]),
        items: COPY_FORMATS.map((/** @type {CopyFormat} */ name) => ({
          title: NUMBERS.format[name],
          isChosen: name === format,
          run() {
            choose({ format: name });
            void carryOut(first);
          },
        })),
      },
      {
        heading: NUMBERS.copyAlso(NUMBERS.format[format]),
        items: others
          .filter((what) => what !== first)
          .map((what) => ({ title: titles[what] ?? names[what], run: () => void carryOut(what) })),
      },
      {
        heading: NUMBERS.unitsOf,
        items: [
          {
            title: NUMBERS.units(unitSign(length), angle),
            detail: NUMBERS.ownUnits,
            isChosen: !isKernelUnits,
            run: () => choose({ isKernelUnits: false }),
          },
          {
            title: NUMBERS.units(KERNEL_UNITS.length, KERNEL_UNITS.angle),
            detail: NUMBERS.kernelUnits,
            isChosen: isKernelUnits,
            run: () => choose({ isKernelUnits: true }),
          },
        ],
      },
    ];
  });
}
