/**
 * Inputs, outputs and flags that programs name or have set: what a person sees of them and sets.
 *
 * @import { ProgramDoc } from '../document.js'
 * @import { Memory } from '../../karel/tp/run/memory.js'
 *
 * @typedef {object} Signal
 * @property {string} port      as KAREL calls it, by which the controller keeps it
 * @property {number} index
 * @property {string} name      as the language that is looked at has it
 * @property {string} comment   what programs call it; empty if nothing
 * @property {boolean} isInput  set from outside; flags are set by both sides
 * @property {boolean | number} value
 */
import { BOOLEAN_PORTS, INTEGER_PORTS } from '../../karel/ports.js';
import { MAX_REGISTERS, PORTS } from '../../karel/tp/run/memory.js';

const TP_NAMES = new Map(Object.entries(PORTS).map(([short, port]) => [port, short]));
const INPUTS = /^(IN|DIN|RDI|UIN|OPIN|GIN|AIN|WDI|WDIN|TPIN|LDI|LAI|FLG|MRK)$/;
const KAREL_SIGNAL = new RegExp(`\\b(${[...BOOLEAN_PORTS, ...INTEGER_PORTS].join('|')})\\s*\\[\\s*(\\w+)\\s*\\]`, 'gi');
const TP_SIGNAL = new RegExp(`\\b(${Object.keys(PORTS).join('|')})\\[(\\d+)(?::([^\\]]*))?\\]`, 'g');
const REMARK = { karel: /--.*|'(?:[^']|'')*'/g, 'fanuc-tp': /^\s*\d+:\s*(?:!|--|\/\/).*/gm };

/** @param {readonly ProgramDoc[]} programs @returns {Map<string, Pick<Signal, 'port' | 'index' | 'comment'>>} by port and index */
export function signalsNamed(programs) {
  /** @type {Map<string, Pick<Signal, 'port' | 'index' | 'comment'>>} */
  const found = new Map();
  const add = (/** @type {string} */ port, /** @type {number} */ index, /** @type {string} */ comment) => {
    const key = `${port}[${index}]`;
    if (!found.get(key)?.comment) found.set(key, { port, index, comment });
  };
  for (const { language, text } of programs) {
    if (language === 'krl') {
      for (const [, port, index] of text.replace(/;.*/g, '').matchAll(/\$(IN|OUT)\[(\d+)\]/gi))
        add(port.toUpperCase(), Number(index), '');
      continue;
    }
    const code = text.replace(REMARK[language], '');
    if (language === 'fanuc-tp')
      for (const [, bank, index, comment = ''] of code.matchAll(TP_SIGNAL))
        add(PORTS[bank], Number(index), comment.trim());
    else {
      for (const [, port, place] of code.matchAll(KAREL_SIGNAL)) {
        const index = /^\d+$/.test(place) ? Number(place) : constantOf(code, place);
        if (index !== null) add(port.toUpperCase(), index, /^\d/.test(place) ? '' : place);
      }
    }
  }
  return found;
}

/** `gripper = 3` among the constants. @param {string} code @param {string} name @returns {number | null} */
function constantOf(code, name) {
  const declared = /\bCONST\b([\s\S]*?)\b(?:TYPE|VAR|ROUTINE|BEGIN)\b/i.exec(code)?.[1] ?? '';
  const value = new RegExp(`\\b${name}\\s*=\\s*(\\d+)\\b`, 'i').exec(declared)?.[1];
  return value === undefined ? null : Number(value);
}

/** By language. @type {Readonly<Record<ProgramDoc['language'], (port: string) => string>>} */
const NAMES = { karel: (port) => port, 'fanuc-tp': (port) => TP_NAMES.get(port) ?? port, krl: (port) => `$${port}` };

/**
 * What is named, and what a program has touched, in the order of their kinds.
 * @param {ReturnType<typeof signalsNamed>} named
 * @param {Memory['ports']} ports  of the controller
 * @param {ProgramDoc['language']} language  whose names they get
 * @returns {Signal[]}
 */
export function signalsOf(named, ports, language) {
  const all = new Map(named);
  for (const [port, values] of Object.entries(ports))
    for (const index of Object.keys(values))
      if (!all.has(`${port}[${index}]`)) all.set(`${port}[${index}]`, { port, index: Number(index), comment: '' });
  const rank = (/** @type {string} */ port) => [...TP_NAMES.keys()].indexOf(port);
  return [...all.values()]
    .filter(({ port }) => (language === 'krl') === (port === 'IN' || port === 'OUT'))
    .sort((a, b) => rank(a.port) - rank(b.port) || a.index - b.index)
    .map(({ port, index, comment }) => {
      const held = ports[port]?.[index];
      const isNumber = INTEGER_PORTS.has(port);
      return {
        ...{ port, index, comment, isInput: INPUTS.test(port) },
        name: `${NAMES[language](port)}[${index}]`,
        value: isNumber ? Number(held ?? 0) : held === true,
      };
    });
}

/** Registers that TP programs name by their numbers. @param {readonly ProgramDoc[]} programs @returns {{ bank: 'R' | 'PR', index: number }[]} */
export function registersNamed(programs) {
  const named = programs
    .filter(({ language }) => language === 'fanuc-tp')
    .flatMap(({ text }) => [...text.replace(REMARK['fanuc-tp'], '').matchAll(/\bP?R\[\d+/g)].map(([one]) => one));
  return [...new Set(named)].map((one) => {
    const [bank, index] = one.split('[');
    return { bank: /** @type {'R' | 'PR'} */ (bank), index: Number(index) };
  });
}

/**
 * A register as a person types it; null where it is none.
 * @example
 * registerTyped('pr 12') // → { bank: 'PR', index: 12 }
 * @param {string} text
 * @returns {{ bank: 'R' | 'PR', index: number } | null}
 */
export function registerTyped(text) {
  const [, bank, digits] = /^\s*(P?R)\s*\[?\s*(\d{1,5})\s*\]?\s*$/i.exec(text) ?? [];
  const index = Number(digits);
  if (!bank || index < 1 || index > MAX_REGISTERS) return null;
  return { bank: /** @type {'R' | 'PR'} */ (bank.toUpperCase()), index };
}

/** What programs call registers: `R[1:count]`. @param {readonly ProgramDoc[]} programs @returns {Map<string, string>} by bank and index */
export function registerComments(programs) {
  /** @type {Map<string, string>} */
  const found = new Map();
  for (const { language, text } of programs)
    if (language === 'fanuc-tp')
      for (const [, bank, index, comment] of text.matchAll(/\b(R|PR|SR)\[(\d+):([^\],]*)\]/g))
        if (!found.has(`${bank}[${index}]`)) found.set(`${bank}[${index}]`, comment.trim());
  return found;
}
