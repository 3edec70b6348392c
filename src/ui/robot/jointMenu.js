/**
 * What can be done with a joint as a whole: its type, its place, another one beside it. The menu hangs on the head of the
 * joint's row.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { Command } from '../../model/commands.js'
 * @import { JointType } from '../../model/document.js'
 */
import { isSliding } from '../../model/document.js';
import { refusal } from '../../model/refusals.js';
import { withChoices } from '../parts/choices.js';
import { h, spoken } from '../parts/dom.js';
import { jointIcon } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { openJointDetails } from './robotSections.js';
import { TEXT } from '../strings.js';

/** @type {readonly JointType[]} */
const TYPES = ['revolute', 'prismatic', 'continuous'];

/**
 * @param {Page} page
 * @param {number} row
 * @param {object} given
 * @param {(text: string) => void} given.say
 * @param {(row: number) => void} given.goTo  the row that the person is with after the command
 */
export function createJointMenu(page, row, { say, goTo }) {
  const { store } = page;
  const current = () => store.state.doc.robot.joints[row];
  const name = `J${row + 1}`;
  const words = TEXT.structure;

  /** @param {string} title @param {Command} command @param {number} to @param {string} done @returns {Choice} */
  const act = (title, command, to, done) => ({
    title,
    against: refusal(store.state.doc, command)?.message ?? null,
    run() {
      if (attempt(page, command) !== null) return;
      goTo(to);
      say(done);
    },
  });

  /** @param {JointType} type @returns {Choice} */
  function typeChoice(type) {
    const joint = current();
    const isOtherKind = isSliding({ type }) !== isSliding(joint);
    const losesLimits = type === 'continuous' && (joint.lower !== undefined || joint.upper !== undefined);
    const loss = isOtherKind ? words.clears : losesLimits ? words.clearsLimits : null;
    const done = [words.typed[type](name), loss].filter(Boolean).join(' ');
    return {
      ...act(words.type[type], { type: 'set-joint-type', joint: row, jointType: type }, row, done),
      detail: type === joint.type ? null : loss,
      isChosen: type === joint.type,
    };
  }

  function places() {
    const last = store.state.doc.robot.joints.length - 1;
    const up = act(words.up(name), { type: 'move-joint', joint: row, to: row - 1 }, row - 1, words.moved(name, row));
    const down = act(
      words.down(name),
      { type: 'move-joint', joint: row, to: row + 1 },
      row + 1,
      words.moved(name, row + 2),
    );
    return [...(row > 0 ? [up] : []), ...(row < last ? [down] : [])];
  }

  const button = h(
    'button',
    { type: 'button', class: 'joint-no', title: words.menu(name) },
    h('span', { 'aria-hidden': 'true' }, String(row + 1)),
    icon(jointIcon(current())),
    icon('dots', 'dots'),
    spoken(words.menuOf(row + 1, TEXT.table.jointType[current().type])),
  );
  const choices = () => {
    const last = store.state.doc.robot.joints.length - 1;
    return {
      groups: [
        [{ title: TEXT.robot.details(name), run: () => openJointDetails(page, row) }],
        TYPES.map(typeChoice),
        [
          act(words.addAfter(name), { type: 'add-joint', after: row }, row + 1, words.added(`J${row + 2}`)),
          act(
            words.duplicate(name),
            { type: 'duplicate-joint', joint: row },
            row + 1,
            words.duplicated(name, `J${row + 2}`),
          ),
          ...places(),
        ],
        [act(words.remove(name), { type: 'remove-joint', joint: row }, Math.min(row, last - 1), words.removed(name))],
      ],
    };
  };
  const element = withChoices(button, choices, { inset: 8 }); // the row begins at the edge of the screen
  return { element, button };
}
