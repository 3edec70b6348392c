/**
 * The direction that a singularity takes, in a line: along what the tool cannot move, about what it cannot turn.
 *
 * @import { Page } from '../page.js'
 * @import { LostDirection } from '../../model/aim/lostDirection.js'
 */
import { lostDirectionAt } from '../../model/aim/lostDirection.js';
import { lostWanted } from '../../model/aim/lostShown.js';
import { together } from '../../model/views.js';
import { fixed } from '../parts/format.js';
import { LOST } from '../words/lost.js';

const NOTHING = 0.005; // which two decimals would show as 0.00

/** @param {readonly number[]} direction */
const axesInWords = (direction) =>
  direction.flatMap((value, k) => (Math.abs(value) < NOTHING ? [] : [`${'XYZ'[k]} ${fixed(value, 2)}`])).join(', ');

/** @param {LostDirection} lost */
export function lostInWords({ along, about }) {
  if (along && about) return LOST.both(axesInWords(along), axesInWords(about));
  return along ? LOST.along(axesInWords(along)) : about ? LOST.about(axesInWords(about)) : '';
}

/** @param {Page} page @param {HTMLElement} line */
export function runLostLine({ addView, derived, announce, store }, line) {
  let isSaid = false;
  addView(
    together((state) => [lostWanted(state), state.doc.robot, state.doc.posture]),
    ([wanted]) => {
      const { doc } = store.state;
      const lost = wanted && lostDirectionAt(derived.chain(doc), derived.posture(doc), wanted === 'stopped');
      line.textContent = lost ? lostInWords(lost) : '';
      line.hidden = line.textContent === '';
      if (!line.hidden && !isSaid) announce(line.textContent);
      isSaid = !line.hidden;
    },
  );
}
