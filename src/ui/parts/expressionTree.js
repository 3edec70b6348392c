/**
 * Text → a tree, by the parser of mathjs. The nodes are plain ones of our own: those of mathjs can also be computed, formatted and typeset,
 * which weighs many times what the parser does and is never asked for.
 *
 * @typedef {object} Node
 * @property {string} type
 * @property {unknown} [name]   of a SymbolNode
 * @property {unknown} [fn]     the name of an operation; the SymbolNode of a function
 * @property {unknown} [value]  of a ConstantNode
 * @property {Node} [content]   of a ParenthesisNode
 * @property {Node[]} [args]
 */
// @ts-expect-error mathjs exports the factories; its types do not name this one
import { createParse } from 'mathjs/number';

/** @param {string} type @param {...string} names  of what its constructor is given */
function nodeOf(type, ...names) {
  class PlainNode {
    /** @param {unknown[]} given */
    constructor(...given) {
      Object.assign(this, { type }, Object.fromEntries(names.map((name, i) => [name, given[i]])));
    }
  }
  // by these the parser tells its nodes apart
  Object.assign(PlainNode.prototype, { isNode: true, [`is${type}`]: true });
  return PlainNode;
}

/** That no text of known words becomes; who walks the tree refuses them. */
const OTHERS = [
  ...['AccessorNode', 'ArrayNode', 'AssignmentNode', 'BlockNode', 'ConditionalNode', 'FunctionAssignmentNode'],
  ...['IndexNode', 'ObjectNode', 'RangeNode', 'RelationalNode'],
];

/** A function of mathjs has a signature for each kind of argument: that of one text. @param {string} _ @param {{ string: unknown }} signatures */
const ofText = (_, { string }) => string;
ofText.addConversion = () => {};

/** Throws a SyntaxError where the text is no expression. @type {(text: string) => Node} */
export const parse = createParse({
  typed: ofText,
  numeric: Number,
  config: { number: 'number' },
  ...Object.fromEntries(OTHERS.map((type) => [type, nodeOf(type)])),
  ConstantNode: nodeOf('ConstantNode', 'value'),
  FunctionNode: nodeOf('FunctionNode', 'fn', 'args'),
  OperatorNode: nodeOf('OperatorNode', 'op', 'fn', 'args'),
  ParenthesisNode: nodeOf('ParenthesisNode', 'content'),
  SymbolNode: nodeOf('SymbolNode', 'name'),
});
