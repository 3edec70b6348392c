/**
 * Copying what the panel shows, and what it does not: a press copies again as the last time, the menu beside it says as what.
 *
 * @import { Page } from './page.js'
 * @import { PoseParts } from './poseParts.js'
 * @import { CopySheet, CopyFormat } from '../model/copyText.js'
 */
import { KERNEL_UNITS } from '../model/copySheets.js';
import { COPY_FORMATS, copyText as writeCopy } from '../model/copyText.js';
import { copyText } from './clipboard.js';
import { fill } from './dom.js';
import { unitSign } from './format.js';
import { icon } from './icons.js';
import { addMenu } from './poseMenu.js';
import { TEXT } from './strings.js';
import { NUMBERS } from './words/numbers.js';

/** So long the button says that it has copied. */
const DONE_SECONDS = 1.5;

/** @typedef {'pose' | 'matrix' | 'links' | 'allLinks' | 'joints'} Copied */

/**
 * @param {Page} page
 * @param {PoseParts} parts
 * @param {(what: Copied) => CopySheet} sheetOf
 */
export function runCopyMenu({ store, announce, messages, clock }, { copy, copyMore }, sheetOf) {
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
    announce(NUMBERS.copied(NUMBERS.what[what], NUMBERS.format[format]));
    fill(copy, icon('check'));
    copy.title = NUMBERS.copied(NUMBERS.what[what], NUMBERS.format[format]);
    cancel();
    cancel = clock.after(DONE_SECONDS, () => {
      fill(copy, icon('copy'));
      copy.title = TEXT.pose.copy;
    });
  }

  copy.addEventListener('click', () => void carryOut(numbers().tab));
  addMenu(copyMore, () => {
    const { tab, format, isKernelUnits } = numbers();
    const { length, angle } = store.state.doc.robot.units;
    const others = /** @type {const} */ (['pose', 'matrix', 'joints', 'allLinks']).filter((what) => what !== tab);
    return [
      {
        heading: NUMBERS.copyAs(NUMBERS.what[tab]),
        items: COPY_FORMATS.map((/** @type {CopyFormat} */ name) => ({
          title: NUMBERS.format[name],
          isChosen: name === format,
          run() {
            choose({ format: name });
            void carryOut(tab);
          },
        })),
      },
      {
        heading: NUMBERS.copyAlso(NUMBERS.format[format]),
        items: others.map((what) => ({ title: NUMBERS.also[what], run: () => void carryOut(what) })),
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
