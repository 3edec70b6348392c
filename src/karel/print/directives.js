/**
 * Directives as lines of text.
 *
 * @import { Directive } from '../tree.js'
 */
import { integerText } from '../numberText.js';
import { includePath, quoted, word } from '../words.js';

/** @param {Directive} directive */
export function directiveText({ name, value, word: argument, path }) {
  if (path !== undefined) return `%${word(name)} ${includePath(path)}`;
  if (argument !== undefined) return `%${word(name)} ${word(argument)}`;
  if (value === undefined) return `%${word(name)}`;
  if (value.kind === 'integer') return `%${word(name)} = ${integerText(value.value)}`;
  if (value.kind === 'integers') return `%${word(name)} = ${value.values.map(integerText).join(', ')}`;
  if (value.kind === 'string') return `%${word(name)} = ${quoted(value.value)}`;
  return `%${word(name)} = ${value.words.map(word).join(' + ')}`;
}
