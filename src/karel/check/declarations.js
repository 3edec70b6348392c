/**
 * What a program declares: constants, types, variables and routines by name, in the order of the text.
 *
 * @import { Constant, Declaration, Declared, Expression, PathType, Routine, Span, TypeDefinition, TypeNode } from '../tree.js'
 * @import { Diagnostic } from '../parse/cursor.js'
 * @import { Type } from './types.js'
 *
 * @typedef {object} VariableSymbol
 * @property {'variable'} kind
 * @property {string} name
 * @property {Type} type
 * @property {boolean} isGlobal
 * @property {boolean} isParameter
 * @property {number} slot           where its value is, among the globals or the locals
 * @property {string} [from]         the program that has it
 * @property {Span} span
 * @property {boolean} isUsed
 * @property {boolean} isSet
 *
 * @typedef {object} ConstantSymbol
 * @property {'constant'} kind
 * @property {string} name
 * @property {Type} type
 * @property {number | string | boolean} value
 *
 * @typedef {object} RoutineSymbol
 * @property {'routine'} kind
 * @property {string} name
 * @property {VariableSymbol[]} parameters
 * @property {Type} returns
 * @property {string} [from]
 * @property {Routine} [node]        with its body
 * @property {Map<string, Symbol>} locals
 * @property {number} slots
 *
 * @typedef {VariableSymbol | ConstantSymbol | RoutineSymbol} Symbol
 *
 * @typedef {{ most: number, left: number }} Room
 * @typedef {object} Scope
 * @property {string} program
 * @property {Map<string, Symbol>} globals
 * @property {Map<string, Type>} types
 * @property {number} globalSlots
 * @property {Room} room             for values of its variables
 * @property {(code: string, message: string, span: Span | undefined, severity?: Diagnostic['severity']) => void} report
 * @property {boolean} hasGaps       files are missing
 */
import { PREDEFINED } from './constants.js';
import * as types from './types.js';

/** Names up to so many characters are safe on every controller; longer ones are met, and taken. */
const LONGEST_NAME = 12;
/** More than a controller has room for, and less than would freeze a page. */
export const MOST_VALUES = 1_000_000;
const MOST_OWN_VALUES = 20_000;
export const roomFor = (/** @type {number} */ most) => ({ most, left: most });
const HALF_RANGE = 2 ** 31;
export const NOWHERE = { start: 0, end: 0, line: 1, column: 1 };

/** @param {readonly Declaration[]} declarations @param {Scope} scope */
export function declareAll(declarations, scope) {
  for (const declaration of declarations) {
    if (declaration.kind === 'constants')
      eachEntry(declaration.entries, (entry) => declareConstant(/** @type {Constant} */ (entry), scope, scope.globals));
    if (declaration.kind === 'types')
      eachEntry(declaration.entries, (entry) => declareType(/** @type {TypeDefinition} */ (entry), scope));
    if (declaration.kind === 'variables') {
      eachEntry(declaration.entries, (entry) =>
        declareVariables(/** @type {Declared} */ (entry), scope, scope.globals, {
          isGlobal: true,
          room: scope.room,
          next: () => scope.globalSlots++,
        }),
      );
    }
    if (declaration.kind === 'routine') declareRoutine(declaration, scope);
  }
}

/** @param {readonly object[]} entries @param {(entry: object) => void} declare */
function eachEntry(entries, declare) {
  for (const entry of entries) if (!('kind' in entry)) declare(entry);
}

/** @param {string} name @param {Scope} scope @param {Map<string, Symbol>} names @param {Span | undefined} span */
function checkNew(name, scope, names, span) {
  if (names.has(name.toUpperCase())) scope.report('declared-twice', `"${name}" is declared already.`, span);
  else if (name.length > LONGEST_NAME) {
    scope.report(
      'long-name',
      `Expected a name of at most ${LONGEST_NAME} characters for every controller, got the ${name.length} of "${name}".`,
      span,
      'warning',
    );
  }
}

/** @param {Constant} constant @param {Scope} scope @param {Map<string, Symbol>} names */
export function declareConstant({ name, value, span }, scope, names) {
  checkNew(name, scope, names, span);
  const folded = constantValue(value, names, scope.globals);
  if (folded === null && !scope.hasGaps)
    scope.report('constant', `Expected a number, a string or another constant for "${name}".`, value.span ?? span);
  const number = typeof folded?.value === 'number' ? folded.value : 0;
  const isFit = folded?.type === types.REAL ? Number.isFinite(number) : Math.abs(number + 0.5) < HALF_RANGE;
  if (!isFit)
    scope.report(
      'constant',
      `Expected a constant that fits into ${types.typeText(folded?.type ?? types.INTEGER)}, got ${number}.`,
      value.span ?? span,
    );
  const symbol = isFit && folded ? folded : { type: types.UNKNOWN, value: 0 };
  names.set(name.toUpperCase(), { kind: 'constant', name, ...symbol });
}

/** @param {Expression} node @param {Map<string, Symbol>[]} scopes @returns {{ type: Type, value: number | string | boolean } | null} */
export function constantValue(node, ...scopes) {
  switch (node.kind) {
    case 'integer':
      return { type: types.INTEGER, value: node.value };
    case 'real':
      return { type: types.REAL, value: Math.fround(node.value) };
    case 'string':
      return { type: types.STRING, value: node.value };
    case 'name': {
      const upper = node.name.toUpperCase();
      for (const names of scopes) {
        const symbol = names.get(upper);
        if (symbol) return symbol.kind === 'constant' ? symbol : null;
      }
      return PREDEFINED.get(upper) ?? null;
    }
    case 'unary': {
      const operand = constantValue(node.operand, ...scopes);
      if (!operand || typeof operand.value !== 'number' || node.operator === 'NOT') return null;
      return { type: operand.type, value: node.operator === '-' ? -operand.value : operand.value };
    }
    case 'binary': {
      const [left, right] = [node.left, node.right].map((side) => constantValue(side, ...scopes));
      if (!left || !right || typeof left.value !== 'number' || typeof right.value !== 'number') return null;
      const type = left.type === types.REAL || right.type === types.REAL ? types.REAL : types.INTEGER;
      const held = (/** @type {number} */ value) => ({ type, value: type === types.REAL ? Math.fround(value) : value });
      if (node.operator === '+') return held(left.value + right.value);
      if (node.operator === '-') return held(left.value - right.value);
      return node.operator === '*' ? held(left.value * right.value) : null;
    }
    default:
      return null;
  }
}

/** @param {TypeDefinition} entry @param {Scope} scope */
function declareType({ name, definition, span }, scope) {
  const upper = name.toUpperCase();
  if (scope.types.has(upper)) scope.report('declared-twice', `The type "${name}" is declared already.`, span);
  if (definition.kind !== 'structure') {
    scope.types.set(upper, resolveType(definition, scope, true));
    return;
  }
  /** @type {Map<string, Type>} */
  const fields = new Map();
  scope.types.set(upper, { kind: 'STRUCTURE', name: upper, fields });
  eachEntry(definition.fields, (entry) => {
    const { names, type } = /** @type {Declared} */ (entry);
    const resolved = resolveType(type, scope, true);
    for (const field of names) {
      if (fields.has(field.toUpperCase()))
        scope.report('declared-twice', `The field "${field}" is declared already.`, span);
      fields.set(field.toUpperCase(), resolved);
    }
  });
}

/** @param {PathType} definition @param {Scope} scope @returns {Type} */
const pathType = ({ node, header, span }, scope) => ({
  kind: 'PATH',
  node: node === undefined ? null : namedType(node, scope, span),
  header: header === undefined ? null : namedType(header, scope, span),
});

/** @param {string} name @param {Scope} scope @param {Span} [span] @returns {Type} */
function namedType(name, scope, span) {
  const upper = name.toUpperCase();
  const type = scope.types.get(upper) ?? types.NAMED_TYPES[upper];
  if (type) return type;
  if (types.OPAQUE_TYPES.has(upper)) return { kind: 'OPAQUE', name: upper };
  // Types of the controller end so; which there are is not on record.
  if (/_T$/.test(upper) || scope.hasGaps) return types.UNKNOWN;
  scope.report('unknown-type', `Expected a type, got "${name}", which is not declared.`, span);
  return types.UNKNOWN;
}

/** @param {TypeNode} node @param {Scope} scope @param {boolean} [inStructure] @returns {Type} */
export function resolveType(node, scope, inStructure = false) {
  if (node.kind === 'path-type') return pathType(node, scope);
  if (node.kind === 'string-type') {
    if (node.length === undefined) return types.STRING;
    const length = sizeOf(node.length, scope);
    if (length !== null && (length < 1 || length > 254))
      scope.report('string-length', `Expected a length from 1 to 254, got ${length}.`, node.span);
    return { kind: 'STRING', length: length ?? 254 };
  }
  if (node.kind === 'type') {
    const type = namedType(node.name, scope, node.span);
    if (!inStructure && (type.kind === 'BYTE' || type.kind === 'SHORT')) {
      scope.report('small-type', `${type.kind} may stand in an array or a structure only.`, node.span);
    }
    return type;
  }
  const sizes = node.sizes.map((size) => (size === '*' ? 0 : (sizeOf(size, scope) ?? 0)));
  for (const [i, size] of node.sizes.entries()) {
    if (size !== '*' && sizes[i] < 1 && !scope.hasGaps)
      scope.report('array-size', 'Expected a whole number above 0, or a constant, as the size of an array.', node.span);
  }
  return { kind: 'ARRAY', sizes, of: resolveType(node.of, scope, true) };
}

/** @param {number | Expression} size @param {Scope} scope */
function sizeOf(size, scope) {
  if (typeof size === 'number') return size;
  const folded = constantValue(size, scope.globals);
  return typeof folded?.value === 'number' ? folded.value : null;
}

/** @param {Declared} declared @param {Scope} scope @param {Map<string, Symbol>} names @param {{ isGlobal?: boolean, isParameter?: boolean, room: Room, next: () => number }} how */
export function declareVariables(
  { names: list, type, from, span, nameSpans },
  scope,
  names,
  { isGlobal = false, isParameter = false, room, next },
) {
  const resolved = resolveType(type, scope);
  const count = isParameter ? 0 : types.countOf(resolved) * list.length;
  const isRoom = count <= room.left;
  if (isRoom) room.left -= count;
  else {
    const expected =
      count === Infinity ? 'a type that does not hold itself' : `variables of at most ${room.most} values together`;
    scope.report('too-large', `Expected ${expected}, got ${types.typeText(resolved)}.`, span);
  }
  return list.map((name, i) => {
    const place = nameSpans?.[i] ?? span ?? NOWHERE;
    checkNew(name, scope, names, place);
    /** @type {VariableSymbol} */
    const symbol = {
      kind: 'variable',
      name,
      type: isRoom ? resolved : types.UNKNOWN,
      isGlobal,
      isParameter,
      slot: next(),
      ...(from && from.toUpperCase() !== scope.program && { from }),
      span: place,
      isUsed: false,
      isSet: isParameter,
    };
    names.set(name.toUpperCase(), symbol);
    return symbol;
  });
}

/** @param {Routine} node @param {Scope} scope */
function declareRoutine(node, scope) {
  const upper = node.name.toUpperCase();
  const before = scope.globals.get(upper);
  if (before && (before.kind !== 'routine' || (before.node && node.body)))
    scope.report('declared-twice', `"${node.name}" is declared already.`, node.span);
  /** @type {RoutineSymbol} */
  const routine =
    before?.kind === 'routine'
      ? before
      : { kind: 'routine', name: node.name, parameters: [], returns: types.NOTHING, locals: new Map(), slots: 0 };
  const repeats = before?.kind === 'routine' && node.body && node.parameters.length === 0 && !node.returns;
  const room = roomFor(MOST_OWN_VALUES);
  if (!repeats) {
    routine.locals = new Map();
    routine.slots = 0;
    routine.parameters = node.parameters.flatMap((one) =>
      declareVariables(one, scope, routine.locals, { isParameter: true, room, next: () => routine.slots++ }),
    );
    routine.returns = node.returns ? resolveType(node.returns, scope) : types.NOTHING;
  }
  if (node.from && node.from.toUpperCase() !== scope.program) routine.from = node.from;
  if (node.body) {
    routine.node = node;
    delete routine.from;
    for (const own of node.declarations ?? []) {
      if (own.kind === 'constants')
        eachEntry(own.entries, (entry) => declareConstant(/** @type {Constant} */ (entry), scope, routine.locals));
      if (own.kind === 'variables')
        eachEntry(own.entries, (entry) =>
          declareVariables(/** @type {Declared} */ (entry), scope, routine.locals, {
            room,
            next: () => routine.slots++,
          }),
        );
    }
  }
  scope.globals.set(upper, routine);
}
