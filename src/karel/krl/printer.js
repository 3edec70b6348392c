/**
 * KRL module → the texts of its `.src` and `.dat`. A tree that has no text is a RangeError.
 *
 * @import { KrlDatum, KrlModule, KrlStatement } from './tree.js'
 */
import { INI_FOLD, INTERRUPTS, MAX_NAME_LENGTH } from './tree.js';

const NAME = new RegExp(`^[A-Za-z_][A-Za-z0-9_]{0,${MAX_NAME_LENGTH - 1}}$`);
const VARIABLE = /^\$[A-Z0-9_]+(\[\d+\])?(\.[A-Z0-9_]+)?$/;
const COMMENT = /^[ -~]*$/;
const DECIMALS = 3;

/** @param {KrlModule} module @returns {{ src: string, dat: string }} */
export function printKrl({ name, comments, statements, data }) {
  const own = identifier(name);
  const source = [
    ...['&ACCESS RVP', '&REL 1', `DEF ${own} ( )`],
    ...comments.map(commentText),
    ...statements.map(statementText),
    'END',
  ];
  const list = [
    '&ACCESS RVP',
    '&REL 1',
    `DEFDAT ${own}`,
    ...comments.map(commentText),
    ...data.map(datumText),
    'ENDDAT',
  ];
  const text = (/** @type {string[]} */ lines) => lines.map((line) => `${line}\r\n`).join('');
  return { src: text(source), dat: text(list) };
}

/** @param {string} text */
function commentText(text) {
  if (COMMENT.test(text)) return text === '' || INI_FOLD.includes(text) ? `;${text}` : `; ${text}`;
  throw new RangeError(`Expected a comment of plain ASCII in one line, got ${JSON.stringify(text)}.`);
}

/** @param {string} name */
function identifier(name) {
  if (NAME.test(name)) return name;
  throw new RangeError(
    `Expected a name of at most ${MAX_NAME_LENGTH} letters, digits and _, got ${JSON.stringify(name)}.`,
  );
}

/** @param {KrlStatement} node @returns {string} */
function statementText(node) {
  switch (node.kind) {
    case 'comment':
      return commentText(node.text);
    case 'motion': {
      const points = [...(node.via ? [node.via] : []), node.target]
        .map((name) => placeText(name, node.places))
        .join(',');
      const ways = node.approximation.map((way) => (/^C_(PTP|DIS|VEL|ORI)$/.test(way) ? ` ${way}` : wrongWay(way)));
      return `${node.motion} ${points}${ways.join('')}`;
    }
    case 'assign': {
      if (!VARIABLE.test(node.target))
        throw new RangeError(`Expected a system variable, got ${JSON.stringify(node.target)}.`);
      const { value } = node;
      return `${node.target}=${typeof value === 'boolean' ? String(value).toUpperCase() : numberText(value)}`;
    }
    case 'bas':
      return `BAS (#${identifier(node.what)},${numberText(node.value)})`;
    case 'wait':
      return `WAIT SEC ${numberText(node.seconds)}`;
    case 'wait-for':
      return `WAIT FOR $IN[${node.input}]==${node.value ? 'TRUE' : 'FALSE'}`;
    case 'call':
      return `${identifier(node.program)} ( )`;
    case 'interrupt':
      if (INTERRUPTS.includes(node.text)) return node.text;
      throw new RangeError(`Expected one of the INI fold's interrupts, got ${JSON.stringify(node.text)}.`);
  }
}

/** @param {string} name @param {readonly KrlDatum[]} [places]  that stand here themselves */
function placeText(name, places) {
  const place = places?.find((one) => one.name === name);
  return place ? membersText(place) : identifier(name);
}

/** @param {string} way @returns {never} */
function wrongWay(way) {
  throw new RangeError(`Expected C_PTP, C_DIS, C_VEL or C_ORI, got ${JSON.stringify(way)}.`);
}

/** @param {KrlDatum} datum */
const datumText = (datum) => `DECL ${datum.type} ${identifier(datum.name)}=${membersText(datum)}`;

/** @param {KrlDatum} datum */
function membersText({ members }) {
  const list = Object.entries(members).map(([member, value]) => {
    if (member === 'S' || member === 'T') return `${member} 'B${binaryText(value)}'`;
    return `${identifier(member)} ${memberText(value)}`;
  });
  return `{${list.join(',')}}`;
}

/** @param {number} value */
function binaryText(value) {
  if (Number.isInteger(value) && value >= 0 && value < 4096) return value.toString(2).padStart(3, '0');
  throw new RangeError(`Expected S or T from 0 to 4095, a whole number, got ${value}.`);
}

/** @param {number} value */
function memberText(value) {
  if (!(Math.abs(value) < 1e6)) throw new RangeError(`Expected a value within ±1e6, got ${value}.`);
  const text = value.toFixed(DECIMALS);
  return Number(text) === 0 ? text.replace('-', '') : text;
}

/** @param {number} value */
function numberText(value) {
  if (!Number.isFinite(value) || Math.abs(value) >= 1e6)
    throw new RangeError(`Expected a number within ±1e6, got ${value}.`);
  return String(Number(value.toFixed(6)) + 0);
}
