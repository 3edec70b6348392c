/**
 * What a robot file of ours will not hold of a document: only characters that XML cannot hold, which no keyboard has.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 */
import { fileIssue } from './fileIssues.js';
import { forbiddenCharacterAt } from './xmlText.js';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export const robotXmlLosses = (doc) =>
  [...textsOf(doc, '')].flatMap(({ text, path }) => {
    const at = forbiddenCharacterAt(text);
    if (at === -1) return [];
    const code = text.codePointAt(at)?.toString(16).toUpperCase().padStart(4, '0');
    const message = `XML has no place for the character U+${code} in ${path}; the replacement character U+FFFD stands for it.`;
    return [fileIssue('not-kept', message, { path })];
  });

/** @param {unknown} value @param {string} path @returns {Generator<{ text: string, path: string }>} */
function* textsOf(value, path) {
  if (typeof value === 'string') yield { text: value, path };
  if (typeof value !== 'object' || value === null) return;
  for (const [key, part] of Object.entries(value)) yield* textsOf(part, path === '' ? key : `${path}.${key}`);
}
