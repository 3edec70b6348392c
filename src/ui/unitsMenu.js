/**
 * The units of the document, as a menu: the numbers convert, the robot stays.
 *
 * @import { Choice } from './parts/choices.js'
 * @import { Page } from './page.js'
 * @import { AngleUnit, LengthUnit, Units } from '../model/document.js'
 */
import { refusal } from '../model/refusals.js';
import { withChoices } from './parts/choices.js';
import { fill, h, spoken } from './parts/dom.js';
import { icon } from './parts/icons.js';
import { attempt } from './page.js';
import { TEXT } from './strings.js';

/** @type {readonly LengthUnit[]} */
const LENGTHS = ['mm', 'cm', 'm'];
/** @type {readonly AngleUnit[]} */
const ANGLES = ['deg', 'rad'];

/**
 * @param {Page} page
 * @param {string} className
 */
export function createUnitsMenu(page, className) {
  const { store, addView, announce } = page;
  const button = h('button', { type: 'button', class: 'btn units' });

  /** @param {LengthUnit | AngleUnit} unit @param {Units} units @returns {Choice} */
  function choice(unit, units) {
    const isChosen = unit === store.state.doc.robot.units.length || unit === store.state.doc.robot.units.angle;
    const command = /** @type {const} */ ({ type: 'convert-units', units });
    return {
      title: TEXT.structure.unit(TEXT.table.unitName[unit], unit),
      isChosen,
      against: isChosen ? null : (refusal(store.state.doc, command)?.message ?? null),
      run() {
        if (attempt(page, command) === null) announce(TEXT.structure.converted(TEXT.table.unitName[unit]));
      },
    };
  }

  addView(
    ({ doc }) => doc.robot.units,
    ({ length, angle }) =>
      fill(button, spoken(TEXT.bar.unitsLabel), ' ', TEXT.bar.unitsOf(length, angle), icon('caret', 'caret')),
  );
  return withChoices(
    button,
    () => {
      const { length, angle } = store.state.doc.robot.units;
      return {
        head: TEXT.structure.unitsHint,
        groups: [
          LENGTHS.map((unit) => choice(unit, { length: unit, angle })),
          ANGLES.map((unit) => choice(unit, { length, angle: unit })),
        ],
      };
    },
    { className },
  );
}
