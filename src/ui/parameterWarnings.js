/**
 * What the address asked for and did not get, in sentences. An address can be of any length, a warning not.
 *
 * @import { Refused } from '../io/queryParameters.js'
 * @import { StartFault } from '../model/startDocument.js'
 * @import { Page } from './page.js'
 */
import { nearestNames } from './nearestNames.js';
import { showNote } from './parts/note.js';
import { TEXT } from './strings.js';
import { PARAMETER } from './words/parameters.js';

const LONGEST_TEXT = 60;
const MOST_NAMES = 4;

/** More that might be written are not listed: only what is near to what was. */
const MOST_VALUES = 12;

/** @param {string} text */
const short = (text) => (text.length > LONGEST_TEXT ? `${text.slice(0, LONGEST_TEXT)}…` : text);

/**
 * @param {readonly Refused[]} refused
 * @returns {string[]} one for each parameter, and one for all that do not exist
 */
export function refusedInWords(refused) {
  const unknown = refused.filter(({ why }) => why === 'unknown').map(({ name }) => short(name));
  const sentences = refused.flatMap(({ why, name, text, kind, values = [], initial }) => {
    if (why === 'unknown') return [];
    if (why === 'twice') return [PARAMETER.twice(name, short(text))];
    const using = initial && PARAMETER.using(initial);
    return [
      [PARAMETER.notUnderstood(name, short(text)), expected(kind, text, values), using].filter(Boolean).join(' '),
    ];
  });
  if (unknown.length === 0) return sentences;
  return [...sentences, PARAMETER.unknown(unknown.slice(0, MOST_NAMES), Math.max(0, unknown.length - MOST_NAMES))];
}

/** @param {Refused['kind']} kind @param {string} text @param {readonly string[]} values */
function expected(kind, text, values) {
  if (kind === undefined) return '';
  if (kind !== 'one' || values.length <= MOST_VALUES) return PARAMETER.expected[kind](values);
  const near = nearestNames(text, values);
  return near.length > 0 && PARAMETER.nearest(near);
}

/**
 * All of it in one note: a screen is small.
 * @param {Page} page
 * @param {readonly Refused[]} refused
 * @param {readonly StartFault[]} faults
 */
export function warnOfParameters(page, refused, faults) {
  const { name } = page.store.state.doc.robot;
  const sentences = [...refusedInWords(refused), ...faults.map((fault) => startFaultInWords(fault, name))];
  const run = async () => (await import('./robot/robotPicker.js')).openRobotPicker(page); // messages.js says it when that fails
  showNote(page, {
    text: sentences.length === 1 ? sentences[0] : sentences,
    close: TEXT.close,
    isWarning: true,
    actions: refused.some(isOtherRobot) ? [{ name: PARAMETER.seeAll, run }] : [],
  });
}

/** A robot was asked for that is none of the library. @param {Refused} refused */
const isOtherRobot = ({ why, name }) => name === 'robot' && why === 'not-understood';

/** @param {StartFault} fault @param {string} robot its name */
export function startFaultInWords(fault, robot) {
  switch (fault.code) {
    case 'units':
      return PARAMETER.units(fault.reason);
    case 'count':
      return PARAMETER.count(fault.given, fault.joints, robot);
    case 'other-robot':
      return PARAMETER.otherRobot;
    case 'outside':
      return PARAMETER.outside(fault.joints.map((joint) => `J${joint + 1}`).join(', '));
    default: {
      /** @type {never} */
      const unknown = fault;
      throw new TypeError(`Unknown fault: ${JSON.stringify(unknown)}`);
    }
  }
}
