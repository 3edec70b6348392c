/**
 * The KAREL syntax tree: plain data, one `kind` for each construct, and constructors for the numbers whose text has
 * rules of its own. A tree says what a program is, never how it looks: parentheses, line breaks and blank lines are the
 * printer's (`karel/printer.js`), which also says what a node may hold.
 *
 * @typedef {object} Program
 * @property {'program'} kind
 * @property {readonly Comment[]} comments  before PROGRAM
 * @property {string} name
 * @property {readonly Declaration[]} declarations  in any order, as the language allows
 * @property {readonly Statement[]} body
 *
 * @typedef {Comment | Directive | Constants | Variables | Routine} Declaration
 *
 * @typedef {object} Directive  `%NAME`, alone, `= value`, or with a word, as `%ENVIRONMENT REGOPE`
 * @property {'directive'} kind
 * @property {string} name      without %
 * @property {IntegerLiteral | StringLiteral | { kind: 'words', words: readonly string[] }} [value]
 * @property {string} [word]
 *
 * @typedef {object} Constants
 * @property {'constants'} kind
 * @property {readonly { name: string, value: Expression }[]} entries
 *
 * @typedef {object} Variables
 * @property {'variables'} kind
 * @property {readonly Declared[]} entries
 *
 * @typedef {{ names: readonly string[], type: TypeNode }} Declared  names that share a type
 *
 * @typedef {object} Routine  a body, or the program that has it: `ROUTINE move FROM other`
 * @property {'routine'} kind
 * @property {string} name
 * @property {readonly Declared[]} parameters
 * @property {TypeNode} [returns]
 * @property {string} [from]
 * @property {readonly (Comment | Constants | Variables)[]} [declarations]  its own
 * @property {readonly Statement[]} [body]
 *
 * @typedef {{ kind: 'type', name: string }} NamedType
 * @typedef {{ kind: 'string-type', length?: number }} StringType  a parameter has no length
 * @typedef {{ kind: 'array-type', sizes: readonly number[], of: NamedType | StringType }} ArrayType
 * @typedef {NamedType | StringType | ArrayType} TypeNode
 *
 * @typedef {{ kind: 'comment', text: string }} Comment
 * @typedef {{ kind: 'assign', target: Name | Index, value: Expression }} Assign
 * @typedef {{ kind: 'call', name: string, args: readonly Expression[] }} Call  as a statement, or a function's value
 * @typedef {{ kind: 'if', condition: Expression, then: readonly Statement[], else?: readonly Statement[] }} If
 * @typedef {{ kind: 'write', file?: string, items: readonly (Expression | NewLine)[] }} Write
 * @typedef {{ kind: 'new-line' }} NewLine  CR
 * @typedef {{ kind: 'return', value?: Expression }} Return
 * @typedef {{ kind: 'abort' }} Abort
 * @typedef {Comment | Assign | Call | If | Write | Return | Abort} Statement
 *
 * @typedef {{ kind: 'integer', value: number }} IntegerLiteral  0 or more, as in the language; use `integer`
 * @typedef {object} RealLiteral
 * @property {'real'} kind
 * @property {number} value       0 or more; use `real`
 * @property {number} [decimals]  at least so many digits after the point
 * @typedef {{ kind: 'string', value: string }} StringLiteral
 * @typedef {{ kind: 'name', name: string }} Name   a variable, a constant, or a function without arguments
 * @typedef {{ kind: 'index', target: Name, indices: readonly Expression[] }} Index
 * @typedef {{ kind: 'unary', operator: UnaryOperator, operand: Expression }} Unary
 * @typedef {{ kind: 'binary', operator: BinaryOperator, left: Expression, right: Expression }} Binary
 * @typedef {IntegerLiteral | RealLiteral | StringLiteral | Name | Index | Call | Unary | Binary} Expression
 *
 * @typedef {'NOT' | '+' | '-'} UnaryOperator
 * @typedef {':' | '@' | '#' | '*' | '/' | 'AND' | 'DIV' | 'MOD' | '+' | '-' | 'OR'
 *   | '<' | '>' | '=' | '<>' | '<=' | '>=' | '>=<'} BinaryOperator
 */

/** The largest INTEGER; the smallest is one further from zero. */
export const MAX_INTEGER = 2147483647;

/** @param {string} name @returns {Name} */
export const name = (name) => ({ kind: 'name', name });

/** @param {string} value @returns {StringLiteral} */
export const string = (value) => ({ kind: 'string', value });

/** @param {string} name @param {readonly Expression[]} args @returns {Call} */
export const call = (name, args = []) => ({ kind: 'call', name, args });

/** @param {UnaryOperator} operator @param {Expression} operand @returns {Unary} */
export const unary = (operator, operand) => ({ kind: 'unary', operator, operand });

/** @param {Expression} left @param {BinaryOperator} operator @param {Expression} right @returns {Binary} */
export const binary = (left, operator, right) => ({ kind: 'binary', operator, left, right });

/**
 * Any INTEGER as an expression. A literal has no sign, and the smallest has no literal even behind a minus, since 2147483648
 * does not fit: it becomes a difference.
 * @param {number} value
 * @returns {IntegerLiteral | Unary | Binary}
 */
export function integer(value) {
  if (value === -MAX_INTEGER - 1) return binary(integer(-MAX_INTEGER), '-', integer(1));
  return value < 0 ? unary('-', { kind: 'integer', value: -value }) : { kind: 'integer', value: value + 0 };
}

/**
 * Any REAL as an expression. Minus zero becomes zero.
 * @param {number} value
 * @param {number} [decimals]  at least so many digits after the point
 * @returns {RealLiteral | Unary}
 */
export function real(value, decimals) {
  const literal = /** @type {RealLiteral} */ ({ kind: 'real', value: Math.abs(value), ...(decimals && { decimals }) });
  return value < 0 ? unary('-', literal) : literal;
}
