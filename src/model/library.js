/**
 * The arms that come with the page, each with the source of its numbers. `home` is a posture to begin with: away from
 * singularities, tool in view; it is our choice. The page itself knows only the ids and its first arm (`shelf.js`); this
 * file, with all the tables, is loaded when another is asked for.
 *
 * @import { RobotDoc } from './document.js'
 */
import { deepFreeze } from './freeze.js';
import { FIRST_ROBOT, PUMA_560 } from './library/first.js';
import { INDUSTRIAL } from './library/industrial.js';
import { LIGHT } from './library/light.js';
import { STRAIGHT_LINES } from './library/straightLines.js';
import { TEXTBOOK } from './library/textbook.js';

export { FIRST_ROBOT } from './library/first.js';
export { newDocument } from './newDocument.js';

const FAMILIES = {
  textbook: TEXTBOOK,
  straightLines: STRAIGHT_LINES,
  industrial: { [FIRST_ROBOT]: PUMA_560, ...INDUSTRIAL },
  light: LIGHT,
};

/** @type {Readonly<Record<string, RobotDoc>>} keys are the ids that scripts and links use */
export const LIBRARY = deepFreeze({ [FIRST_ROBOT]: PUMA_560, ...LIGHT, ...STRAIGHT_LINES, ...TEXTBOOK, ...INDUSTRIAL });

/** @typedef {keyof typeof FAMILIES} Family */

/** The families of arms, with their ids, in the order in which a person is shown them. */
export const LIBRARY_FAMILIES = /** @type {[Family, string[]][]} */ (
  Object.entries(FAMILIES).map(([family, robots]) => [family, Object.keys(robots)])
);
