/**
 * Variables of routines that are read where no way through the routine has set them: certain faults, told as warnings. A
 * variable counts as set as soon as one way may have done so, also the next round of a loop, a jump, or a routine that got it
 * by reference; so nothing is told that might be right.
 *
 * @import { Call, Expression, Statement } from '../tree.js'
 * @import { Context } from './context.js'
 * @import { VariableSymbol } from './declarations.js'
 *
 * @typedef {{ set: Set<VariableSymbol>, isOver: boolean }} Way   over: no way comes to this place
 * @typedef {object} Walk
 * @property {Context} context
 * @property {ReadonlySet<VariableSymbol>} everything   that is set anywhere, for whoever comes by a jump
 * @property {Set<VariableSymbol>} collected            whatever was set during the walk
 * @property {((symbol: VariableSymbol, node: Expression) => void) | null} tell
 */
import { BUILTINS } from './builtins.js';
import { isDesignator } from './context.js';

/** Of others, whether they are set cannot be told by looking: files are opened, paths have lengths without being set. */
const KINDS = new Set([
  'INTEGER',
  'REAL',
  'BOOLEAN',
  'STRING',
  'VECTOR',
  'POSITION',
  'XYZWPR',
  'XYZWPREXT',
  'JOINTPOS',
]);

/** @param {readonly Statement[]} body  of a routine @param {Context} context */
export function checkUnset(body, context) {
  const everything = setIn(body, { context, everything: new Set(), collected: new Set(), tell: null });
  /** @type {Set<VariableSymbol>} */
  const told = new Set();
  const tell = (/** @type {VariableSymbol} */ symbol, /** @type {Expression} */ node) => {
    if (told.has(symbol) || !everything.has(symbol)) return;
    told.add(symbol);
    context.scope.report('uninitialised', `"${symbol.name}" is used before it is set.`, node.span, 'warning');
  };
  walkBody(body, { set: new Set(), isOver: false }, { context, everything, collected: new Set(), tell });
}

/** What a body may set. @param {readonly Statement[]} body @param {Walk} walk */
function setIn(body, walk) {
  const collected = /** @type {Set<VariableSymbol>} */ (new Set());
  walkBody(body, { set: new Set(), isOver: false }, { ...walk, collected, tell: null });
  return collected;
}

/** @param {readonly Statement[]} body @param {Way} way @param {Walk} walk @returns {Way} */
const walkBody = (body, way, walk) => body.reduce((before, statement) => walkStatement(statement, before, walk), way);

/** @param {...Way} ways @returns {Way} */
function joined(...ways) {
  const open = ways.filter(({ isOver }) => !isOver);
  return { set: new Set(open.flatMap(({ set }) => [...set])), isOver: open.length === 0 };
}

/** @param {Way} way @param {Iterable<VariableSymbol>} more @returns {Way} */
const withMore = ({ set, isOver }, more) => ({ set: new Set([...set, ...more]), isOver });

/** @param {Statement} statement @param {Way} way @param {Walk} walk @returns {Way} */
function walkStatement(statement, way, walk) {
  const read = (/** @type {unknown} */ node) => readAll(node, way, walk);
  switch (statement.kind) {
    case 'assign':
      read(statement.value);
      put(statement.target, way, walk);
      return way;
    case 'if':
      read(statement.condition);
      return joined(
        walkBody(statement.then, withMore(way, []), walk),
        walkBody(statement.else ?? [], withMore(way, []), walk),
      );
    case 'select': {
      read(statement.value);
      const bodies = [...statement.cases.map(({ body }) => body), statement.else ?? []];
      return joined(...bodies.map((body) => walkBody(body, withMore(way, []), walk)));
    }
    case 'for':
      read([statement.from, statement.to]);
      put(statement.variable, way, walk);
      return joined(way, walkBody(statement.body, withMore(way, setIn(statement.body, walk)), walk));
    case 'while':
      read(statement.condition);
      return joined(way, walkBody(statement.body, withMore(way, setIn(statement.body, walk)), walk));
    case 'repeat': {
      const after = walkBody(statement.body, withMore(way, setIn(statement.body, walk)), walk);
      readAll(statement.until, after, walk);
      return after;
    }
    case 'using':
      for (const variable of statement.variables) put(variable, way, walk);
      return walkBody(statement.body, way, walk);
    case 'label':
      return { set: new Set([...way.set, ...walk.everything]), isOver: false };
    case 'goto':
      return { set: way.set, isOver: true };
    case 'return':
      read(statement.value);
      return { set: way.set, isOver: true };
    case 'timer':
      put(statement.variable, way, walk);
      return way;
    case 'read':
      for (const item of statement.items)
        if (item.kind !== 'new-line') put(item.kind === 'format' ? item.value : item, way, walk);
      return way;
    case 'condition':
    case 'move':
      // What their actions do, they do at some other time.
      for (const { actions } of (statement.kind === 'move' ? statement.when : statement.clauses) ?? [])
        walkBody(actions, way, { ...walk, tell: null });
      return way;
    case 'comment':
    case 'directive':
      return way;
    default:
      read(statement);
      return way;
  }
}

/** A variable, or a part of it, gets a value. @param {Expression} node @param {Way} way @param {Walk} walk */
function put(node, way, walk) {
  let inner = node;
  while (inner.kind === 'index' || inner.kind === 'field') {
    if (inner.kind === 'index') readAll(inner.indices, way, walk);
    inner = inner.target;
  }
  const symbol = walk.context.symbolOf.get(inner);
  if (symbol?.kind !== 'variable') return readAll(inner.kind === 'name' ? null : inner, way, walk);
  way.set.add(symbol);
  walk.collected.add(symbol);
}

/** Whatever expressions there are in a node. @param {unknown} node @param {Way} way @param {Walk} walk */
function readAll(node, way, walk) {
  if (typeof node !== 'object' || node === null) return;
  if (Array.isArray(node)) {
    for (const one of node) readAll(one, way, walk);
    return;
  }
  const expression = /** @type {Expression} */ (node);
  if (expression.kind === 'call') return readCall(expression, way, walk);
  if (expression.kind === 'name') return readName(expression, way, walk);
  for (const [key, inner] of Object.entries(node)) if (key !== 'span') readAll(inner, way, walk);
}

/** @param {Extract<Expression, { kind: 'name' }>} node @param {Way} way @param {Walk} walk */
function readName(node, way, { context, tell }) {
  const symbol = context.symbolOf.get(node);
  if (way.isOver || !tell || symbol?.kind !== 'variable' || symbol.isGlobal || symbol.isParameter) return;
  const { kind } = symbol.type.kind === 'ARRAY' ? (symbol.type.of ?? symbol.type) : symbol.type;
  if (KINDS.has(kind) && !way.set.has(symbol)) tell(symbol, node);
}

/** A routine may set what it gets by reference. @param {Call} call @param {Way} way @param {Walk} walk */
function readCall({ name, args, byValue = [] }, way, walk) {
  const upper = name.toUpperCase();
  const isOwn = walk.context.scope.globals.get(upper)?.kind === 'routine';
  const builtin = isOwn ? undefined : BUILTINS.get(upper);
  for (const [i, arg] of args.entries()) {
    const parameter = builtin?.parameters[i];
    const isRead = builtin
      ? parameter && !parameter.isSet && !parameter.isKept && !/^[AHFLX]$/.test(parameter.type)
      : byValue.includes(i);
    if (isRead || !isDesignator(arg)) readAll(arg, way, walk);
    else put(arg, way, walk);
  }
}
