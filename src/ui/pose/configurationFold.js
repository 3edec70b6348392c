/**
 * Below the tool's pose: what controllers call the posture, folded. It is fetched when it is first opened, and opens with the
 * pendant's numbers.
 *
 * @import { Page } from '../page.js'
 */
import { hasPendant } from '../../model/controller/controllerData.js';
import { foldMaker } from '../parts/fold.js';
import { TEXT } from '../strings.js';

/** @param {Page} page @param {boolean} isWanted  not without the pose that it is about */
export function createConfigurationFold(page, isWanted) {
  const fold = foldMaker(page.clock, page.messages.fault)('fold-configuration', async (body) =>
    (await import('./configurationLine.js')).createConfigurationLine(page, body),
  );
  fold.setHead(TEXT.pose.configuration);
  page.addView(
    ({ doc }) => hasPendant(doc.robot),
    (isOffered) => (fold.element.hidden = !isWanted || !isOffered),
  );
  page.addView(
    ({ session }) => session.numbers.isPendant,
    (isPendant) => {
      if (isPendant) void fold.set(true, false); // the hand is at the switch
    },
  );
  return fold.element;
}
