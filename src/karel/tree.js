/**
 * The KAREL syntax tree: plain data, one `kind` for each construct, and constructors for the numbers whose text has
 * rules of its own. A tree says what a program is, never how it looks: parentheses, line breaks and blank lines are the
 * printer's (`karel/printer.js`), which also says what a node may hold. Where a tree was read from text, its nodes say
 * where they stood (`span`); nothing else differs between a tree that was read and one that was built.
 *
 * @typedef {object} Span
 * @property {number} start   offset of the first character
 * @property {number} end     offset behind the last
 * @property {number} line    from 1
 * @property {number} column  from 1
 * @property {string} [file]  the included file, if it was in one
 *
 * @typedef {{ span?: Span }} Spanned
 *
 * @typedef {object} ProgramParts
 * @property {'program'} kind
 * @property {readonly Comment[]} comments  before PROGRAM
 * @property {string} name
 * @property {readonly Declaration[]} declarations  in any order, as the language allows
 * @property {readonly Statement[]} body
 * @property {readonly Declaration[]} [after]       routines that follow END
 * @typedef {Spanned & ProgramParts} Program
 *
 * @typedef {Spanned & { kind: 'fragment', parts: readonly (Declaration | Statement)[] }} Fragment
 *   the text of a file that is included
 *
 * @typedef {Comment | Directive | Constants | Types | Variables | Routine} Declaration
 *
 * @typedef {object} DirectiveParts  `%NAME`, alone, `= value`, with a word, as `%ENVIRONMENT REGOPE`, or with a path
 * @property {'directive'} kind
 * @property {string} name      without %
 * @property {IntegerLiteral | StringLiteral | Words | Integers} [value]
 * @property {string} [word]
 * @property {string} [path]    of %INCLUDE
 * @typedef {Spanned & DirectiveParts} Directive
 * @typedef {{ kind: 'words', words: readonly string[] }} Words  joined by +
 * @typedef {{ kind: 'integers', values: readonly number[] }} Integers  a list of two or more
 *
 * @typedef {object} ConstantsParts
 * @property {'constants'} kind
 * @property {readonly (Constant | Comment | Directive)[]} entries
 * @property {true} [bare]      in a fragment: without the word CONST
 * @typedef {Spanned & ConstantsParts} Constants
 * @typedef {Spanned & { name: string, value: Expression }} Constant
 *
 * @typedef {object} TypesParts
 * @property {'types'} kind
 * @property {readonly (TypeDefinition | Comment | Directive)[]} entries
 * @property {true} [bare]
 * @typedef {Spanned & TypesParts} Types
 * @typedef {Spanned & { name: string, from?: string, definition: Structure | TypeNode, group?: number }} TypeDefinition
 * @typedef {Spanned & { kind: 'structure', fields: readonly (Declared | Comment | Directive)[] }} Structure
 * @typedef {Spanned & { kind: 'path-type', node?: string, header?: string }} PathType
 *
 * @typedef {object} VariablesParts
 * @property {'variables'} kind
 * @property {readonly (Declared | Comment | Directive)[]} entries
 * @property {true} [bare]
 * @typedef {Spanned & VariablesParts} Variables
 *
 * @typedef {object} DeclaredParts  names that share a type
 * @property {readonly string[]} names
 * @property {TypeNode} type
 * @property {'CMOS' | 'SHADOW' | 'DRAM'} [storage]
 * @property {string} [from]    the program that has them
 * @property {number} [group]   `IN GROUP[2]`
 * @property {readonly Span[]} [nameSpans]
 * @typedef {Spanned & DeclaredParts} Declared
 *
 * @typedef {object} RoutineParts  a body, or the program that has it: `ROUTINE move FROM other`
 * @property {'routine'} kind
 * @property {string} name
 * @property {readonly Declared[]} parameters
 * @property {TypeNode} [returns]
 * @property {string} [from]
 * @property {readonly (Comment | Constants | Types | Variables | Directive)[]} [declarations]  its own
 * @property {readonly Statement[]} [body]
 * @typedef {Spanned & RoutineParts} Routine
 *
 * @typedef {Spanned & { kind: 'type', name: string }} NamedType
 * @typedef {Spanned & { kind: 'string-type', length?: number | Expression }} StringType  a parameter has no length
 * @typedef {Spanned & { kind: 'array-type', sizes: readonly (number | '*' | Expression)[], of: NamedType | StringType }} ArrayType
 *   without sizes: `ARRAY OF`
 * @typedef {NamedType | StringType | ArrayType | PathType} TypeNode
 *
 * @typedef {Spanned & { kind: 'comment', text: string, trailing?: true }} Comment  trailing: behind what stands before it
 *
 * @typedef {Spanned & { kind: 'assign', target: Designator, value: Expression }} Assign
 * @typedef {Spanned & { kind: 'call', name: string, args: readonly Expression[], byValue?: readonly number[] }} Call  as a
 *   statement, or a function's value; by value: which arguments are variables in parentheses, of which the routine gets a copy
 * @typedef {Spanned & { kind: 'if', condition: Expression, then: Body, else?: Body }} If
 * @typedef {Spanned & { kind: 'select', value: Expression, cases: readonly Case[], else?: Body }} Select
 * @typedef {Spanned & { values: readonly Expression[], body: Body }} Case
 * @typedef {Spanned & { kind: 'for', variable: Designator, from: Expression, down?: true, to: Expression, body: Body }} For
 * @typedef {Spanned & { kind: 'while', condition: Expression, body: Body }} While
 * @typedef {Spanned & { kind: 'repeat', body: Body, until: Expression }} Repeat
 * @typedef {Spanned & { kind: 'label', name: string }} Label
 * @typedef {Spanned & { kind: 'goto', label: string }} Goto
 * @typedef {Spanned & { kind: 'return', value?: Expression }} Return
 * @typedef {Spanned & { kind: 'abort' | 'pause', task?: Expression }} Halt  task: `ABORT PROGRAM[n]`
 * @typedef {Spanned & { kind: 'delay', milliseconds: Expression }} Delay
 * @typedef {Spanned & { kind: 'wait', conditions: Conditions }} Wait
 * @typedef {Spanned & { kind: 'pulse', port: Designator, milliseconds: Expression, nowait?: true }} Pulse
 * @typedef {Spanned & { kind: 'open-file', file: Designator, usage: Expression, path: Expression }} OpenFile
 * @typedef {Spanned & { kind: 'close-file' | 'cancel-file', file: Designator }} CloseFile
 * @typedef {Spanned & { kind: 'write' | 'read', file?: string | Designator, items: readonly Item[] }} Transfer
 * @typedef {Spanned & { kind: 'new-line' }} NewLine  CR
 * @typedef {Spanned & { kind: 'format', value: Expression, formats: readonly Expression[] }} Formatted  `x::8::3`
 * @typedef {Expression | NewLine | Formatted} Item
 * @typedef {Spanned & { kind: 'using', variables: readonly Designator[], body: Body }} Using
 *
 * @typedef {object} HandlerParts
 * @property {'condition'} kind
 * @property {Expression} number
 * @property {readonly Setting[]} [settings]     `WITH $SCAN_TIME = 30`
 * @property {readonly Clause[]} clauses
 * @typedef {Spanned & HandlerParts} Handler     a global condition handler
 * @typedef {Spanned & { conditions: Conditions, actions: Body }} Clause  WHEN … DO …
 * @typedef {{ variable: Designator, value: Expression }} Setting
 * @typedef {{ operator?: 'AND' | 'OR', terms: readonly Term[] }} Conditions  the operator, where there are two or more
 * @typedef {Expression | Edge | Occurrence} Term
 * @typedef {Spanned & { kind: 'edge', port: Index, rising: boolean }} Edge  `DIN[1]+`
 * @typedef {Spanned & { kind: 'occurrence', name: string, argument?: Expression | '*' }} Occurrence  `ERROR[*]`, `ABORT`
 *
 * @typedef {Spanned & { kind: 'handler-control', action: 'ENABLE' | 'DISABLE' | 'PURGE', number: Expression }} HandlerControl
 * @typedef {Spanned & { kind: 'signal', what: 'EVENT' | 'SEMAPHORE', number: Expression }} Signal
 * @typedef {Spanned & { kind: 'timer', action: 'CONNECT' | 'DISCONNECT', variable: Designator }} Timer
 * @typedef {Spanned & { kind: 'motion-control', action: MotionAction, groups?: readonly Expression[] }} MotionControl
 * @typedef {'CANCEL' | 'STOP' | 'RESUME' | 'HOLD' | 'UNHOLD' | 'ATTACH' | 'RELEASE'} MotionAction
 * @typedef {Spanned & { kind: 'action', action: 'NOABORT' | 'NOPAUSE' | 'NOMESSAGE' | 'UNPAUSE' | 'CONTINUE' | 'RESTORE' }} Action
 * @typedef {Spanned & { kind: 'hand', action: 'OPEN' | 'CLOSE' | 'RELAX', number: Expression }} Hand
 *
 * @typedef {object} MoveParts
 * @property {'move'} kind
 * @property {readonly Setting[]} [settings]
 * @property {MoveTarget} target
 * @property {true} [nowait]
 * @property {readonly Clause[]} [when]          local condition handlers, up to ENDMOVE
 * @property {readonly Conditions[]} [until]
 * @typedef {Spanned & MoveParts} Move
 * @typedef {{ to: 'TO', position: Expression, via?: Expression }
 *   | { to: 'NEAR', position: Expression, by: Expression }
 *   | { to: 'AWAY' | 'RELATIVE', by: Expression }
 *   | { to: 'ABOUT', vector: Expression, by: Expression }
 *   | { to: 'AXIS', axis: Expression, by: Expression }
 *   | { to: 'ALONG', path: Designator | Range }} MoveTarget
 *
 * @typedef {readonly Statement[]} Body
 * @typedef {Comment | Directive | Assign | Call | If | Select | For | While | Repeat | Label | Goto | Return | Halt | Delay
 *   | Wait | Pulse | OpenFile | CloseFile | Transfer | Using | Handler | HandlerControl | Signal | Timer | MotionControl
 *   | Action | Hand | Move} Statement
 *
 * @typedef {Spanned & { kind: 'integer', value: number }} IntegerLiteral  0 or more, as in the language; use `integer`
 * @typedef {object} RealParts
 * @property {'real'} kind
 * @property {number} value       0 or more; use `real`
 * @property {number} [decimals]  at least so many digits after the point
 * @typedef {Spanned & RealParts} RealLiteral
 * @typedef {Spanned & { kind: 'string', value: string }} StringLiteral
 * @typedef {Spanned & { kind: 'name', name: string }} Name   a variable, a constant, or a function without arguments
 * @typedef {Spanned & { kind: 'system', name: string }} SystemName  `$SPEED`, without $; so are its fields
 * @typedef {Spanned & { kind: 'index', target: Designator | Call, indices: readonly Expression[] }} Index
 * @typedef {Spanned & { kind: 'field', target: Designator | Call, name: string, system?: true }} Field
 * @typedef {Spanned & { kind: 'range', target: Designator, from: Expression, to: Expression }} Range  `path[2..5]`
 * @typedef {Name | SystemName | Index | Field} Designator   what can be assigned to
 * @typedef {Spanned & { kind: 'unary', operator: UnaryOperator, operand: Expression }} Unary
 * @typedef {Spanned & { kind: 'binary', operator: BinaryOperator, left: Expression, right: Expression }} Binary
 * @typedef {IntegerLiteral | RealLiteral | StringLiteral | Designator | Call | Unary | Binary} Expression
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
