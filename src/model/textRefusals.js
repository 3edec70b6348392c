/**
 * What can be said against a text that is to be kept beside a number.
 * @import { Issue } from './issues.js'
 */
import { characterCount, MAX_LABEL_LENGTH } from './documentRules.js';
import { keepsText } from './robot/jointFields.js';
import { issue, shown } from './refusalParts.js';

/** What a robot file cannot hold, or gives back otherwise than it was. */
// eslint-disable-next-line no-control-regex -- these are what is looked for
const UNFIT = /[\u0000-\u001f\u007f-\u009f\ufffe\uffff\p{Cs}]/u;

/**
 * @param {string} what  'link twist'
 * @param {{ field: string, text?: unknown }} command
 * @returns {Issue | null}
 */
export function badText(what, { field, text }) {
  if (text === undefined) return null;
  if (!keepsText(field)) return issue('text', field, `No text is kept for a ${what}; got ${shown(text)}.`);
  if (typeof text === 'string' && text !== '' && characterCount(text) <= MAX_LABEL_LENGTH && !UNFIT.test(text)) {
    return null;
  }
  const came = typeof text === 'string' && characterCount(text) > MAX_LABEL_LENGTH ? 'a longer one' : shown(text);
  return issue(
    'text',
    field,
    `What was typed for a ${what} is a line of at most ${MAX_LABEL_LENGTH} characters; got ${came}.`,
  );
}
