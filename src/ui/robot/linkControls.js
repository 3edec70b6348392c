/**
 * How the link of a joint is drawn: its kind, its sizes where the kind has some, its colour. An empty size is the one that
 * the scene chooses by itself, which stands in the field as a hint.
 *
 * @import { Page } from '../page.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { LinkDoc, RobotDoc } from '../../model/document.js'
 * @import { RobotCommand } from '../../model/robot/robotCommands.js'
 *
 * @typedef {Extract<RobotCommand, { type: 'set-link' }>} SetLink
 */
import { LINK_KINDS } from '../../model/documentRules.js';
import { captioned, captionedSelect, select, textInput } from '../parts/captioned.js';
import { editCell } from './cellEditor.js';
import { h } from '../parts/dom.js';
import { compact, plain, unitSign } from '../parts/format.js';
import { attempt, newGesture } from '../page.js';
import { TEXT } from '../strings.js';
import { editText } from '../parts/textEditor.js';
import { readTypedLimit } from '../parts/typedNumber.js';
import { DETAILS } from '../words/robotDetails.js';

const SIZES = /** @type {const} */ (['radius', 'width', 'height']);
/** @typedef {typeof SIZES[number]} Size */

/** Which sizes a kind has. @type {Record<LinkDoc['kind'], readonly Size[]>} */
const SIZES_OF = { auto: ['radius'], cylinder: ['radius'], box: ['width', 'height'], none: [] };

/** How many characters of a number a field has room for, and of one that is only a hint. */
const WIDEST = 9;
const HINT_DIGITS = 3;

/** The picker wants some colour even where none is chosen: the links' own, in the light. */
const LINK_COLOUR = '#f1efe9';

/**
 * @param {Page} page
 * @param {number} index
 * @param {{ automaticRadii: (robot: RobotDoc) => readonly number[] }} scene
 * @param {Reasons['set']} onReason
 */
export function createLinkControls(page, index, scene, onReason) {
  const { store, announce } = page;
  const link = () => store.state.doc.robot.joints[index].link;
  /** @param {Partial<LinkDoc>} change @returns {SetLink} */
  const command = (change) => ({ type: 'set-link', joint: index, link: { ...link(), ...change } });
  const kind = select(DETAILS.linkOf(index + 1), LINK_KINDS, DETAILS.kind, (wanted) => {
    attempt(page, command({ kind: wanted }));
    announce(DETAILS.drawn(index + 1, DETAILS.kind[wanted]));
  });
  const hint = h('p', { class: 'soft sm' }, DETAILS.notDrawn);
  const unit = store.state.doc.robot.units.length;

  const sizes = SIZES.map((size) => {
    const input = textInput({
      'aria-label': DETAILS.field(index + 1, `${DETAILS.link}, ${DETAILS[size]}`, TEXT.table.unitName[unit]),
    });
    const text = () => (link()[size] === undefined ? '' : plain(Number(link()[size])));
    const measure = () => ({ quantity: /** @type {const} */ ('length'), units: store.state.doc.robot.units });
    const editor = editCell(page, input, {
      measure,
      read: (typed) => readTypedLimit(typed, measure()),
      command: (/** @type {number | undefined} */ value) => command(withSize(size, value)),
      onDone: () => DETAILS.set(DETAILS[size], text() || DETAILS.automatic),
      onReason: (reason, refused) => onReason(input, reason, refused, (way) => editor.settle(way)),
      text,
      resting: () => (link()[size] === undefined ? '' : compact(Number(link()[size]), WIDEST).text),
    });
    return { size, input, editor, element: captioned(DETAILS[size], input, unitSign(unit)) };
  });

  const colour = createColour(page, index, { link, command, onReason });
  return {
    element: h(
      'div',
      {},
      h(
        'div',
        { class: 'captioned-row' },
        captionedSelect(kind, DETAILS.link),
        sizes.map(({ element }) => element),
      ),
      hint,
      colour.element,
    ),
    editor: {
      refresh() {
        for (const { editor } of sizes) editor.refresh();
        colour.editor.refresh();
      },
      forget() {
        for (const { editor } of sizes) editor.forget();
        colour.editor.forget();
      },
    },
    /** @param {RobotDoc} robot */
    draw(robot) {
      const now = link();
      kind.value = now.kind;
      hint.hidden = now.kind !== 'none';
      const automatic = scene.automaticRadii(robot)[index];
      for (const { size, input, element } of sizes) {
        element.hidden = !SIZES_OF[now.kind].includes(size);
        const own = size === 'radius' ? automatic : 2 * (now.radius ?? automatic);
        input.placeholder = DETAILS.auto(plain(Number(own.toPrecision(HINT_DIGITS))));
      }
      colour.draw(now);
    },
  };
}

/** A size, or that there is none. @param {Size} size @param {number | undefined} value @returns {Partial<LinkDoc>} */
const withSize = (size, value) => /** @type {Partial<LinkDoc>} */ ({ [size]: value });

/**
 * By eye, or as six digits.
 * @param {Page} page
 * @param {number} index
 * @param {object} given
 * @param {() => LinkDoc} given.link
 * @param {(change: Partial<LinkDoc>) => SetLink} given.command
 * @param {Reasons['set']} given.onReason
 */
function createColour(page, index, { link, command, onReason }) {
  const { store, announce } = page;
  const swatch = h('input', { type: 'color', class: 'swatch', 'aria-label': DETAILS.swatch(index + 1) });
  const hex = textInput({ 'aria-label': DETAILS.hex(index + 1), placeholder: DETAILS.automatic, maxlength: 20 });
  const reset = h('button', { type: 'button', class: 'btn btn-small' }, DETAILS.automaticColour);
  const say = () => announce(DETAILS.coloured(index + 1, link().color ?? DETAILS.automatic));
  const none = () => /** @type {Partial<LinkDoc>} */ ({ color: undefined });

  /** @type {string | null} one pull through the picker's colours is one step to undo */
  let gesture = null;
  swatch.addEventListener('input', () => {
    gesture ??= newGesture();
    attempt(page, { ...command({ color: swatch.value }), gesture });
  });
  swatch.addEventListener('change', () => {
    gesture = null;
    store.dispatch({ type: 'end-gesture' });
    say();
  });
  const editor = editText(page, hex, {
    text: () => link().color ?? '',
    read: (text) => ({ command: command(text === '' ? none() : { color: text }) }),
    onReason: (reason) => onReason(hex, reason),
    onDone: () => DETAILS.coloured(index + 1, link().color ?? DETAILS.automatic),
  });
  reset.addEventListener('click', () => {
    attempt(page, command(none()));
    hex.focus(); // the button goes with the colour
    say();
  });

  return {
    element: h(
      'div',
      { class: 'captioned-row is-colour' },
      captioned(DETAILS.colour, hex, null, 'has-swatch'),
      swatch,
      reset,
    ),
    editor,
    /** @param {LinkDoc} now */
    draw(now) {
      swatch.value = (now.color ?? LINK_COLOUR).toLowerCase();
      swatch.classList.toggle('is-automatic', now.color === undefined);
      reset.hidden = now.color === undefined;
    },
  };
}
