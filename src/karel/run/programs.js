/**
 * Programs that are at hand, with what their variables hold at first: linked when they are first asked for.
 *
 * @import { Analysis } from '../check/analysis.js'
 * @import { Host, Machine } from './machine.js'
 */
import { unsetValue } from './values.js';

/** What the variables of a program hold before it runs. @param {Analysis} analysis @param {Host} host */
export function firstGlobals({ scope }, { variables = {} }) {
  const values = new Array(scope.globalSlots);
  const given = named(variables, scope.program) ?? {};
  for (const symbol of scope.globals.values()) {
    if (symbol.kind !== 'variable' || symbol.from) continue;
    values[symbol.slot] = named(given, symbol.name) ?? unsetValue(symbol.type);
  }
  return values;
}

/** Whatever the case of its letters. @template T @param {Readonly<Record<string, T>>} list @param {string} name */
function named(list, name) {
  const key = Object.keys(list).find((one) => one.toUpperCase() === name.toUpperCase());
  return key === undefined ? undefined : list[key];
}

/** @param {Machine} machine @param {string} name @returns {number} its index; −1 if it is not at hand */
export function linkedProgram({ linker, state, host }, name) {
  const index = linker.programNamed(name);
  while (state.globals.length < linker.analyses.length)
    state.globals.push(firstGlobals(linker.analyses[state.globals.length], host));
  return index;
}
