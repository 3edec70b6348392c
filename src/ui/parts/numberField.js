/**
 * A number with its unit, typed as a number or an expression: rounded where nobody edits it, with all its digits where
 * someone does. Those who use it put the field where it belongs.
 *
 * @import { Change, Page } from '../page.js'
 * @import { Reasons } from './reasons.js'
 */
import { textInput } from './captioned.js';
import { editCell } from '../robot/cellEditor.js';
import { compact, editable, plain } from './format.js';

const WIDEST = 9;

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {object} given
 * @param {'length' | 'angle'} given.quantity
 * @param {string} given.label
 * @param {() => number} given.value
 * @param {(value: number) => Change} given.command
 * @param {() => Change} given.again  what brings back what there is now
 * @param {(label: string, value: string) => string} given.done  the outcome in words
 * @param {(value: number) => string | null} [given.check]  a reason against it beyond the command's own
 * @param {() => string | null} [given.resting]  another text than the number itself, while nobody edits it
 */
export function numberField(
  page,
  reasons,
  { quantity, label, value, command, again, done, check, resting = () => null },
) {
  const input = textInput({ 'aria-label': label });
  const editor = editCell(page, input, {
    measure: () => ({ quantity, units: page.store.state.doc.robot.units }),
    command,
    ...(check && { check }),
    again,
    onDone: () => done(label, editable(value())),
    onReason: (reason, refused) => reasons.set(input, reason, refused, (way) => editor.settle(way)),
    text: () => editable(value()),
    resting() {
      const { text, isRounded } = compact(value(), WIDEST);
      input.title = isRounded ? plain(value()) : '';
      return resting() ?? text;
    },
  });
  return { input, editor };
}
