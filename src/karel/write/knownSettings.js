/**
 * What is known of the settings of motion at each MOVE of a program: the number that was last put into each, where every way to the
 * statement puts the same one there, and no routine, label or handler comes between that may put another.
 *
 * @import { Designator, Expression, Move, Program, Routine, Statement } from '../tree.js'
 *
 * @typedef {'MOTYPE' | 'SPEED' | 'TERMTYPE' | 'DECELTOL' | 'UFRAME' | 'UTOOL'} SettingName
 * @typedef {number | 'chosen' | null} Known   of a frame its number, or that which is chosen; null: not known
 * @typedef {Readonly<Record<SettingName, Known | undefined>>} Settings   undefined: nothing has set it
 */
import { PREDEFINED } from '../check/constants.js';
import { expressionText } from '../expressionPrinter.js';

/** @type {readonly SettingName[]} */
const NAMES = ['MOTYPE', 'SPEED', 'TERMTYPE', 'DECELTOL', 'UFRAME', 'UTOOL'];
/** Built-ins that may set anything, or run what may. */
const SETTERS = ['SET_VAR', 'CALL_PROG', 'CALL_PROGLIN', 'RUN_TASK'];
const UNSET = /** @type {Settings} */ ({});
const BLOCKS = ['for', 'while', 'repeat'];

/** A setting by its name, with or without its group; of any other place what it is called. @param {Designator | Expression} place */
export function settingName(place) {
  if (!['system', 'field', 'index'].includes(place.kind)) return '';
  const text = plainText(place);
  return text.startsWith('$') ? text.replace(/^\$(GROUP\[1\]\.)?\$?/, '') : '';
}

/** @param {Expression} node */
const plainText = (node) =>
  expressionText(node)
    .toUpperCase()
    .replace(/[\s\0]/g, '');

/** @param {unknown} name @returns {name is SettingName} */
const isSetting = (name) => NAMES.includes(/** @type {SettingName} */ (name));

/** Nodes of a tree, the whole first. @param {unknown} node @returns {Generator<{ kind?: string }>} */
export function* nodesOf(node) {
  if (typeof node !== 'object' || node === null) return;
  if (!Array.isArray(node)) yield node;
  for (const [name, inner] of Object.entries(node)) if (name !== 'span') yield* nodesOf(inner);
}

/** @param {Program} program  with its included files in place @returns {Map<Move, Settings>} of those outside of handlers */
export function knownSettings(program) {
  const routines = new Map(
    [...program.declarations, ...(program.after ?? [])].flatMap((one) =>
      one.kind === 'routine' ? [[one.name.toUpperCase(), one]] : [],
    ),
  );
  /** @type {Map<Move, Settings>} */
  const found = new Map();
  /** @type {Map<Routine, Set<SettingName>>} */
  const known = new Map();

  /** What running it may set. @param {unknown} tree @returns {Set<SettingName>} */
  function setBy(tree) {
    const names = /** @type {Set<SettingName>} */ (new Set());
    for (const given of nodesOf(tree)) {
      const node = /** @type {Statement | Expression} */ (given);
      if (node.kind === 'label' || node.kind === 'goto') return new Set(NAMES);
      const places = node.kind === 'assign' ? [node.target] : node.kind === 'call' ? node.args : [];
      for (const place of places) {
        const name = settingName(place);
        if (isSetting(name)) names.add(name);
        // the frames' numbers, and what they stand for
        if (name.startsWith('MNUFRAME')) names.add('UFRAME');
        if (name.startsWith('MNUTOOL')) names.add('UTOOL');
      }
      if (node.kind !== 'call' && node.kind !== 'name') continue;
      const upper = node.name.toUpperCase();
      const routine = routines.get(upper);
      if ((routine && !routine.body) || SETTERS.includes(upper)) return new Set(NAMES);
      if (routine) for (const name of setByRoutine(routine)) names.add(name);
    }
    return names;
  }

  /** @param {Routine} routine */
  function setByRoutine(routine) {
    const before = known.get(routine);
    if (before) return before;
    known.set(routine, new Set(NAMES)); // while it is looked at: one that calls itself
    const names = setBy(routine.body);
    known.set(routine, names);
    return names;
  }

  const handlers = [...nodesOf(program)].filter(({ kind }) => kind === 'condition');
  const volatile = setBy(handlers.map((one) => /** @type {{ clauses?: unknown }} */ (one).clauses));
  const anywhere = setBy([program.body, [...routines.values()].map(({ body }) => body)]);

  /** @param {Settings} settings @param {Iterable<SettingName>} names @returns {Settings} */
  const without = (settings, names) => ({ ...settings, ...Object.fromEntries([...names].map((name) => [name, null])) });

  /** @param {readonly Statement[]} body @param {Settings} before @returns {Settings} */
  function flow(body, before) {
    let now = before;
    for (const statement of body) {
      if (statement.kind === 'move') found.set(statement, without(now, [...volatile, ...setBy(statement)]));
      if (statement.kind === 'if') {
        now = without(now, setBy(statement.condition));
        now = joined(flow(statement.then, now), flow(statement.else ?? [], now));
      } else if (statement.kind === 'select') {
        const start = without(now, setBy([statement.value, statement.cases.map(({ values }) => values)]));
        const ways = statement.cases.map((one) => flow(one.body, start));
        now = ways.reduce(joined, flow(statement.else ?? [], start));
      } else if (statement.kind === 'using') now = flow(statement.body, now);
      else if (statement.kind === 'condition') continue;
      else {
        now = without(now, setBy(statement));
        if (BLOCKS.includes(statement.kind) && 'body' in statement) flow(statement.body, now);
        const name = statement.kind === 'assign' ? settingName(statement.target) : '';
        if (statement.kind === 'assign' && isSetting(name)) now = { ...now, [name]: valueOf(statement.value, name) };
      }
    }
    return now;
  }
  flow(program.body, UNSET);
  for (const { body } of routines.values()) flow(body ?? [], without(UNSET, anywhere));
  return found;
}

/** @param {Settings} one @param {Settings} other @returns {Settings} */
const joined = (one, other) =>
  /** @type {Settings} */ (
    Object.fromEntries(NAMES.map((name) => [name, one[name] === other[name] ? one[name] : null]))
  );

/** @param {Expression} node @param {SettingName} name @returns {Known} */
export function valueOf(node, name) {
  if (name !== 'UFRAME' && name !== 'UTOOL') {
    const value = node.kind === 'name' ? PREDEFINED.get(node.name.toUpperCase())?.value : undefined;
    if (node.kind === 'integer' || node.kind === 'real') return node.value;
    return typeof value === 'number' ? value : null;
  }
  const text = plainText(node);
  if (text === '$MOR_GRP[1].$NILPOS') return 0;
  const table = name.replace('U', '$MNU');
  if (text === `${table}[1,${table}NUM[1]]`) return 'chosen';
  const [, number] = /^\[1,(\d+)\]$/.exec(text.startsWith(table) ? text.slice(table.length) : '') ?? [];
  return number === undefined ? null : Number(number);
}
