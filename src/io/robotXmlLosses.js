/**
 * What a robot file of ours will not hold of a document: only characters that XML cannot hold, which no keyboard has.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 */
import { characterLosses } from './losses.js';

/**
 * @param {Doc} doc
 * @returns {Issue[]} warnings
 */
export const robotXmlLosses = (doc) => [...textsOf(doc, '')].flatMap(({ text, path }) => characterLosses(text, path));

/** @param {unknown} value @param {string} path @returns {Generator<{ text: string, path: string }>} */
function* textsOf(value, path) {
  if (typeof value === 'string') yield { text: value, path };
  if (typeof value !== 'object' || value === null) return;
  for (const [key, part] of Object.entries(value)) yield* textsOf(part, path === '' ? key : `${path}.${key}`);
}
