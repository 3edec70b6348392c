/**
 * A calm line below the picture: what stands in the tool's way while it is dragged, and what keys do to it once it is taken;
 * said aloud, too. Fetched with the first drag.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { Session } from '../../model/session.js'
 */
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { fixed, poseNumber, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { DRAG_LINE as words } from '../words/dragLine.js';

const DECIMALS = { mm: 0, cm: 1, m: 3, deg: 0, rad: 2 };

/**
 * What is short of a wish needs no hundredths, unless there is nothing else of it.
 * @param {RobotDoc} robot
 * @param {'length' | 'angle'} quantity
 * @param {number} value  metres or radians
 */
function roughly({ units }, quantity, value) {
  const unit = units[quantity];
  const number = fromKernel(quantity, value, units);
  const rough = fixed(number, DECIMALS[unit]);
  return withUnit(Number(rough) === 0 ? poseNumber(number, unit) : rough, unit);
}

/**
 * @param {RobotDoc} robot
 * @param {NonNullable<NonNullable<Session['drag']>['hindrance']>} hindrance
 */
export function hindranceInWords(robot, { kind, joint, metres, radians }) {
  const name = `J${(joint ?? 0) + 1}`;
  const turn = roughly(robot, 'angle', radians);
  // where the place is met, what is missing is a turn
  const short = metres > 1e-5 ? roughly(robot, 'length', metres) : turn;
  if (kind === 'limit') return words.limit(name);
  if (kind === 'singularity') return words.singularity(name);
  if (kind === 'orientation') return words.orientation(turn);
  if (kind === 'part') return words.part(turn);
  return robot.joints.length < 6 ? words.fewReach(short) : words.reach(short);
}

/**
 * @param {Page} page
 * @param {HTMLElement} bar  of the handle, which the line stands above
 * @param {() => string} poseInWords
 */
export function createHandleLine({ addView, announce }, bar, poseInWords) {
  const line = h('p', { class: 'float drag-line', hidden: true });
  bar.before(line);

  let said = ''; // of what stands in the way: once, however the numbers change
  addView(
    together(({ doc, session }) => [
      doc.robot,
      // a step by keys is over at once: what stopped it stays to be read for as long as the arm stays
      session.drag?.hindrance ??
        (session.toolKeys && session.dragEnd?.posture === doc.posture && session.dragEnd.hindrance),
      session.toolKeys,
      session.handle.across,
    ]),
    ([robot, hindrance, toolKeys, across]) => {
      const text = hindrance ? hindranceInWords(robot, hindrance) : toolKeys ? words.takenShort[toolKeys](across) : '';
      line.hidden = text === '';
      line.classList.toggle('is-stopped', Boolean(hindrance));
      fill(line, hindrance && icon('slash'), h('span', {}, text));
      const now = hindrance ? `${hindrance.kind} ${hindrance.joint}` : '';
      if (now !== said && hindrance) announce(text);
      said = now;
    },
  );
  /** @type {Session['toolKeys']} */
  let taken = null;
  addView(
    together(({ session }) => [session.toolKeys, session.handle.axes, session.handle.across]),
    ([toolKeys, axes, across]) => {
      if (toolKeys) announce(words.taken[toolKeys](words.inAxes[axes], across));
      else if (taken) announce(words.givenBack);
      taken = toolKeys;
    },
  );
  /** @type {readonly number[] | null} */
  let heard = null;
  addView(
    together(({ doc, session, gesture }) => [session.toolKeys, gesture === null, doc.posture]),
    ([toolKeys, isAtRest, posture]) => {
      if (toolKeys && !isAtRest) return;
      const isNew = toolKeys !== null && heard !== null && heard !== posture;
      heard = toolKeys ? posture : null;
      if (isNew) announce(poseInWords());
    },
  );
}
