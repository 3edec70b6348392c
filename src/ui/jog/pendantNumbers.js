/**
 * The pendant's numbers for the jog panel, and the note on how they differ from the model's.
 *
 * @import { JointNumbers } from '../../model/numbers/jointNumbers.js'
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 */
import '../css/controller.css';
import { hasControllerData } from '../../model/controller/controllerData.js';
import {
  coupledTo,
  coupledWith,
  onPendant,
  pendantUnit,
  withPendantValue,
  zeroOnPendant,
} from '../../model/controller/pendantNumbers.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, withUnit } from '../parts/format.js';
import { pendantLine } from './pendantLine.js';
import { CONTROLLER } from '../words/controller.js';

const nameOf = (/** @type {number} */ joint) => `J${joint + 1}`;

/** @type {JointNumbers} */
export const PENDANT_NUMBERS = {
  robot: ({ robot, posture }) => onPendant(robot, posture).robot,
  values: ({ robot, posture }) => onPendant(robot, posture).values,
  command: ({ robot, posture }, joint, value) => ({
    type: 'set-posture',
    posture: withPendantValue(robot, posture, joint, value),
  }),
  zero: zeroOnPendant,
  condition({ robot, posture }, joint) {
    const { values, limits } = onPendant(robot, posture);
    const other = coupledWith(robot, joint);
    if (other >= 0) {
      const unit = pendantUnit(robot, other);
      return CONTROLLER.while(nameOf(other), withUnit(jointNumber(values[other], unit), unit));
    }
    const { stoppedBy } = limits[joint];
    return stoppedBy.length === 0 ? '' : CONTROLLER.stoppedBy(stoppedBy.map(nameOf));
  },
};

/**
 * The note on these numbers.
 * @param {Page} page
 * @param {HTMLElement} note  its room
 */
export function createPendantNote(page, note) {
  note.className = 'controller-note';
  page.addView(
    ({ doc }) => doc.robot,
    (robot) => fill(note, noteOn(robot)),
  );
}

/** @param {Page} page @param {boolean} isPendant */
export function showPendant({ store, announce }, isPendant) {
  const { numbers } = store.state.session;
  store.dispatch({ type: 'show', change: { numbers: { ...numbers, isPendant } } });
  announce(isPendant ? CONTROLLER.isShown : CONTROLLER.isNotShown);
}

/** @param {RobotDoc} robot */
function noteOn(robot) {
  if (!hasControllerData(robot)) return [h('p', { class: 'soft sm' }, CONTROLLER.noData)];
  const lines = robot.joints.map((_, i) => pendantLine(robot, i));
  const coupled = robot.joints.flatMap((_, i) =>
    coupledTo(robot, i).map((k) => CONTROLLER.coupled(nameOf(k), nameOf(i))),
  );
  return [
    h('p', { class: 'soft sm' }, [CONTROLLER.about, ...coupled].join(' ')),
    h(
      'ul',
      { class: 'controller-lines sm', 'aria-label': CONTROLLER.lines },
      lines.map((line) => h('li', {}, line)),
    ),
  ];
}
