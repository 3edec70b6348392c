/**
 * Below the joints: the plot of what moves, folded. It is fetched when it is first opened, and records only while it is open.
 *
 * @import { Page } from '../page.js'
 */
import { foldMaker } from '../parts/fold.js';
import { TEXT } from '../strings.js';

/** @param {Page} page */
export function createMotionFold(page) {
  let isOpen = false;
  /** @type {{ setOpen: (isOpen: boolean) => void } | null} */
  let plot = null;
  const fold = foldMaker(page.clock, page.messages.fault)(
    'fold-motion',
    async (body) => {
      plot = (await import('./motionPlot.js')).createMotionPlot(page, body);
      plot.setOpen(isOpen);
    },
    (wanted) => {
      isOpen = wanted;
      plot?.setOpen(wanted);
      void fold.set(wanted);
    },
  );
  fold.setHead(TEXT.jog.plot, TEXT.jog.plotSummary);
  return fold.element;
}
