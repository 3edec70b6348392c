/**
 * Directives of the translator: `%NAME`, `%NAME = value`, `%ENVIRONMENT word`, `%INCLUDE path`. Whether one exists is for
 * the checker to say; here is only their form.
 *
 * @import { Directive } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { MAX_INTEGER } from '../tree.js';
import { isIncludePath } from '../words.js';

/** @param {Cursor} cursor @returns {Directive} */
export function readDirective(cursor) {
  const from = cursor.position();
  const token = cursor.advance();
  /** @type {Directive} */
  const directive = { kind: 'directive', name: token.upper };
  const rest = token.text;
  const fail = (/** @type {string} */ expected) =>
    cursor.report(
      'error',
      'directive',
      `Expected ${expected} after %${token.upper}, got ${rest ? JSON.stringify(rest) : 'nothing'}.`,
      token.start,
      token.end,
    );

  if (token.upper === 'INCLUDE') {
    const path = rest.replace(/^(['"])(.*)\1$/, '$2');
    if (isIncludePath(path)) directive.path = path;
    else fail('the name of a file');
  } else if (rest.startsWith('=')) {
    const value = rest.slice(1).trim();
    const text = /^'((?:[^']|'')*)'$/.exec(value);
    const numbers = value.split(',').map((part) => part.trim());
    const words = value.split('+').map((part) => part.trim());
    if (text) directive.value = { kind: 'string', value: text[1].replaceAll("''", "'") };
    else if (numbers.every((part) => /^\d+$/.test(part) && Number(part) <= MAX_INTEGER)) {
      const values = numbers.map(Number);
      directive.value = values.length > 1 ? { kind: 'integers', values } : { kind: 'integer', value: values[0] };
    } else if (words.every((part) => /^[A-Za-z][A-Za-z0-9_]*$/.test(part))) directive.value = { kind: 'words', words };
    else fail('a whole number, a string or words joined by +');
  } else if (/^[A-Za-z][A-Za-z0-9_]*$/.test(rest)) directive.word = rest;
  else if (rest !== '') fail('"=" and a value, or a word');
  return cursor.node(from, directive);
}
