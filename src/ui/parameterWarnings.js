/**
 * What the address asked for and did not get, in sentences. An address can be of any length, a warning not.
 *
 * @import { Refused } from '../io/queryParameters.js'
 * @import { StartFault } from '../model/startDocument.js'
 */
import { PARAMETER } from './words/parameters.js';

const LONGEST_TEXT = 60;
const MOST_NAMES = 4;

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
    const expected = kind && PARAMETER.expected[kind](values);
    const using = initial && PARAMETER.using(initial);
    return [[PARAMETER.notUnderstood(name, short(text)), expected, using].filter(Boolean).join(' ')];
  });
  if (unknown.length === 0) return sentences;
  return [...sentences, PARAMETER.unknown(unknown.slice(0, MOST_NAMES), Math.max(0, unknown.length - MOST_NAMES))];
}

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
