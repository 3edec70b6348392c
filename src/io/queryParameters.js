/**
 * Every query parameter the page understands, from one schema. A bad or unknown one is a warning, never a broken page.
 *
 * @template T
 * @typedef {object} Parameter
 * @property {T} initial
 * @property {(text: string) => T | undefined} read  undefined when the text is not acceptable
 * @property {string} help
 */
import { FIRST_ROBOT, LIBRARY_IDS } from '../model/shelf.js';

/**
 * @template {string} Value
 * @param {readonly Value[]} values
 * @returns {(text: string) => Value | undefined}
 */
const oneOf = (values) => (text) => values.find((value) => value === text);

export const SCHEMA = {
  robot: { initial: FIRST_ROBOT, read: oneOf(LIBRARY_IDS), help: 'The robot to begin with, by its id.' },
  theme: {
    initial: /** @type {'auto' | 'light' | 'dark' | null} */ (null),
    read: oneOf(/** @type {const} */ (['auto', 'light', 'dark'])),
    help: 'Colours; auto follows the system, none the last choice.',
  },
  quality: {
    initial: /** @type {'high' | 'low'} */ ('high'),
    read: oneOf(/** @type {const} */ (['high', 'low'])),
    help: 'low draws without shadows and antialiasing: for slow machines and tests.',
  },
  clock: {
    initial: /** @type {'browser' | 'manual'} */ ('browser'),
    read: oneOf(/** @type {const} */ (['browser', 'manual'])),
    help: 'manual: nothing moves until denavit.clock.tick(seconds) is called. For tests.',
  },
};

/**
 * @template {Record<string, Parameter<unknown>>} Schema
 * @param {string} search  as in location.search
 * @param {Schema} schema
 * @returns {{
 *   values: { [K in keyof Schema]: Schema[K]['initial'] },
 *   refused: { name: string, text: string, initial: string | null }[],
 * }} `refused` has the parameters that were not understood; `initial` is null where there is no such parameter
 */
export function readQueryParameters(search, schema) {
  /** @type {{ name: string, text: string, initial: string | null }[]} */
  const refused = [];
  const given = new URLSearchParams(search);
  const values = Object.fromEntries(
    Object.entries(schema).map(([name, { initial, read }]) => {
      const text = given.get(name);
      const value = text === null ? initial : read(text);
      if (value === undefined) refused.push({ name, text: text ?? '', initial: String(initial) });
      return [name, value ?? initial];
    }),
  );
  for (const [name, text] of given) {
    if (!Object.hasOwn(schema, name)) refused.push({ name, text, initial: null });
  }
  return { values: /** @type {{ [K in keyof Schema]: Schema[K]['initial'] }} */ (values), refused };
}
