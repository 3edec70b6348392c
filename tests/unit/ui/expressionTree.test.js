/** The trees of expressions, against those that mathjs makes with nodes of its own. */
import fc from 'fast-check';
import { create, parseDependencies } from 'mathjs/number';
import { expect, test } from 'vitest';
import { parse } from '../../../src/ui/parts/expressionTree.js';
import { SEED, runs } from '../../helpers/property.js';

const theirs = /** @type {typeof parse} */ (/** @type {unknown} */ (create(parseDependencies, {}).parse));
const WORDS = ['1', '2.5', '.5', '1e3', 'pi', 'sin', 'mm', 'in', 'm', '+', '-', '*', '/', '^', '(', ')', '(', ')'];

/** @param {unknown} node @returns {unknown} what is read of it */
function plain(node) {
  if (typeof node !== 'object' || node === null) return node;
  const { type, name, fn, value, content, args } =
    /** @type {import('../../../src/ui/parts/expressionTree.js').Node} */ (node);
  switch (type) {
    case 'OperatorNode':
      return { type, fn, args: args?.map(plain) };
    case 'FunctionNode':
      return { type, fn: plain(fn), args: args?.map(plain) };
    default:
      return { type, name, value, content: plain(content) };
  }
}

/** @param {typeof parse} read @param {string} text */
function outcome(read, text) {
  try {
    return plain(read(text));
  } catch (error) {
    return error instanceof SyntaxError ? 'no expression' : error;
  }
}

test('a text of known words becomes the tree that mathjs would make, or none where that makes none', () =>
  fc.assert(
    fc.property(fc.array(fc.constantFrom(...WORDS), { minLength: 1, maxLength: 9 }), (words) => {
      const text = words.join(' ');
      expect(outcome(parse, text)).toEqual(outcome(theirs, text));
    }),
    { seed: SEED, numRuns: runs(500) },
  ));
