/**
 * Texts of the document that belong together on a controller, and what their certificates say.
 *
 * @import { ProgramDoc, RobotDoc } from '../document.js'
 * @import { CertificateStatus } from './certificate.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 */
import { includesOf, keyOf } from '../../karel/preprocess/files.js';
import { certificateStatus, setOf } from './certificate.js';

const EXTENSION = /** @type {const} */ ({ karel: '.kl', 'fanuc-tp': '.ls', krl: '.src' });
const DATA_LIST = /^\s*DEFDAT\s+(\w+)/im;
/** Headers and templates of ktransw: their ids end as their names do. */
const HEADER = /_(kl[htc])$/i;
const MODULE = /^\s*(?:GLOBAL\s+)?DEF(?:DAT)?\s+(\w+)/im;

/** As a controller wants to have it: a data list of KRL is called after its program. @param {ProgramDoc} program */
export function fileName({ id, language, text }) {
  if (language === 'krl') {
    const name = MODULE.exec(text)?.[1] ?? id;
    return `${name}${DATA_LIST.test(text) ? '.dat' : '.src'}`;
  }
  if (language === 'karel' && HEADER.test(id)) return id.toLowerCase().replace(HEADER, '.$1');
  return `${id.toLowerCase()}${EXTENSION[language]}`;
}

/** Line ends of controllers on DOS disks. @param {ProgramDoc} program */
const fileText = ({ language, text }) => (language === 'karel' ? text : text.replace(/\r\n?|\n/g, '\r\n'));

/**
 * A program with those that it needs: what it calls, its data list; or, of one that is called, with who calls it. The first is
 * the one to run.
 * @param {readonly ProgramDoc[]} programs
 * @param {ProgramDoc} chosen  one of them
 * @returns {{ program: ProgramDoc, file: CodeFile }[]}
 */
export function codeSet(programs, chosen) {
  const set = chosen.language === 'krl' ? krlSet(programs, chosen) : fanucSet(programs, chosen);
  return set.map((program) => ({
    program,
    file: { name: fileName(program), language: program.language, text: fileText(program) },
  }));
}

/** @param {readonly ProgramDoc[]} programs @param {ProgramDoc} chosen @returns {ProgramDoc[]} */
function krlSet(programs, chosen) {
  const name = (/** @type {ProgramDoc} */ { text, id }) => (MODULE.exec(text)?.[1] ?? id).toUpperCase();
  const all = programs.filter((one) => one.language === 'krl' && name(one) === name(chosen));
  const isData = ({ text = '' }) => DATA_LIST.test(text);
  const source = isData(chosen) ? all.find((one) => !isData(one)) : chosen;
  const data = isData(chosen) ? chosen : all.find(isData);
  return [source, data].flatMap((one) => (one ? [one] : []));
}

/** The program that a text is part of, by %INCLUDE. @param {readonly ProgramDoc[]} programs @param {ProgramDoc} part */
export const includerOf = (programs, part) =>
  programs.find((one) => one !== part && /^\s*PROGRAM\b/im.test(one.text) && includedBy(programs, one).includes(part));

/** The texts that one includes, and those that they include. @param {readonly ProgramDoc[]} programs @param {ProgramDoc} program @returns {ProgramDoc[]} */
export function includedBy(programs, program) {
  const ids = programs.map(({ id }) => id);
  const found = [program];
  for (const { language, text } of found)
    for (const { path } of language === 'karel' ? includesOf(text) : []) {
      const one = programs[ids.indexOf(keyOf(ids, path) ?? '')];
      if (one && !found.includes(one)) found.push(one);
    }
  return found.slice(1);
}

/** @param {readonly ProgramDoc[]} programs @param {ProgramDoc} chosen @returns {ProgramDoc[]} */
function fanucSet(programs, chosen) {
  const known = programs
    .filter(({ language }) => language !== 'krl')
    .map((program) => ({ program, name: nameIn(program) }));
  const calls = (/** @type {ProgramDoc} */ { text }, /** @type {string} */ name) =>
    new RegExp(`(?:FROM\\s+|(?:CALL_PROG(?:LIN)?|RUN_TASK)\\s*\\(\\s*'|CALL\\s+)${name}\\b`, 'i').test(text);
  const caller = known.find(({ program }) => program !== chosen && calls(program, nameIn(chosen)))?.program;
  const set = [caller ?? includerOf(programs, chosen) ?? chosen];
  for (const one of set) {
    const included = includedBy(programs, one);
    for (const { program, name } of known)
      if (!set.includes(program) && (calls(one, name) || included.includes(program))) set.push(program);
  }
  return set;
}

/** What a program says that it is called. @param {ProgramDoc} program */
const nameIn = ({ id, text }) => (/^\s*(?:PROGRAM\s+|\/PROG\s+)([A-Za-z]\w*)/im.exec(text)?.[1] ?? id).toUpperCase();

/** Of the one text, among those that came with it. @param {readonly ProgramDoc[]} programs @param {ProgramDoc} chosen @param {RobotDoc} robot @returns {CertificateStatus} */
export function statusOf(programs, chosen, robot) {
  const set = setOf(chosen.text);
  const own = set === null ? [chosen] : programs.filter(({ text }) => setOf(text) === set);
  return certificateStatus(own, robot)[own.indexOf(chosen)];
}
