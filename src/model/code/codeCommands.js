/**
 * Controller code that the document keeps: texts with a name and a language.
 *
 * @import { Doc, ProgramDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { Issues } from '../validateValues.js'
 *
 * @typedef {{ type: 'set-code', programs: readonly ProgramDoc[] }
 *   | { type: 'edit-code', id: string, text: string }
 *   | { type: 'rename-code', id: string, to: string }
 *   | { type: 'remove-code', id: string }
 *   | CodeOptionsCommand} CodeCommand
 *
 * @typedef {{ type: 'set-code-options', text: string }} CodeOptionsCommand  how code is written of the model
 */
import { MAX_DESCRIPTION_LENGTH, MAX_PROGRAMS, PROGRAM_LANGUAGES } from '../documentRules.js';
import { documentIssue } from '../issues.js';
import { issue, shown } from '../refusalParts.js';
import { checkChoice, checkDifferentIds, checkId, checkText, shownValue } from '../validateValues.js';

/**
 * What can be wrong with the code of a document.
 * @param {Pick<Doc, 'programs' | 'codeOptions'>} doc @returns {Issues}
 */
export function* codeFaults({ programs, codeOptions = '' }) {
  yield* checkText('The code', 'options', 'codeOptions', codeOptions, MAX_DESCRIPTION_LENGTH);
  if (programs.length > MAX_PROGRAMS) {
    const message = `The model has ${programs.length} programs; expected at most ${MAX_PROGRAMS}.`;
    yield documentIssue('too-many-programs', 'programs', message);
  }
  for (const [i, { id, language, text }] of programs.entries()) {
    const owner = `Program ${shownValue(id)}`;
    yield* checkId(`Program ${i + 1}`, `programs.${i}.id`, id);
    yield* checkChoice(owner, 'the language', `programs.${i}.language`, language, PROGRAM_LANGUAGES);
    yield* checkText(owner, 'a text', `programs.${i}.text`, text, Infinity);
  }
  yield* checkDifferentIds('programs', 'programs', programs);
}

/** @param {Doc} doc @param {CodeCommand} command @returns {Issue | null} */
export function codeRefusal(doc, command) {
  if (command.type === 'set-code-options') return [...codeFaults({ ...doc, codeOptions: command.text })][0] ?? null;
  if (command.type !== 'set-code' && !doc.programs.some(({ id }) => id === command.id))
    return issue('id', 'programs', `Expected the name of a program, got ${shown(command.id)}.`);
  if (command.type === 'remove-code') return null;
  for (const fault of codeFaults({ programs: changed(doc.programs, command) })) return fault;
  return null;
}

/**
 * @param {Doc} doc
 * @param {CodeCommand} command  that `codeRefusal` has nothing against
 * @returns {Doc} the same object when nothing changed
 */
export function applyCodeCommand(doc, command) {
  if (command.type === 'set-code-options') {
    const { codeOptions = '', ...others } = doc;
    if (codeOptions === command.text) return doc;
    return command.text === '' ? others : { ...others, codeOptions: command.text };
  }
  const programs = changed(doc.programs, command);
  return programs === doc.programs ? doc : { ...doc, programs };
}

/** @param {Doc['programs']} programs @param {Exclude<CodeCommand, CodeOptionsCommand>} command @returns {Doc['programs']} */
function changed(programs, command) {
  if (command.type === 'set-code') {
    const isSame =
      command.programs.length === programs.length && programs.every((one, i) => one === command.programs[i]);
    return isSame ? programs : command.programs;
  }
  const index = programs.findIndex(({ id }) => id === command.id);
  const old = programs[index];
  switch (command.type) {
    case 'edit-code':
      return old.text === command.text ? programs : programs.with(index, { ...old, text: command.text });
    case 'rename-code':
      return old.id === command.to ? programs : programs.with(index, { ...old, id: command.to });
    case 'remove-code':
      return programs.toSpliced(index, 1);
    default: {
      /** @type {never} */
      const unknown = command;
      throw new TypeError(`Unknown command: ${JSON.stringify(unknown)}`);
    }
  }
}

/** The first of name, name_2, name_3, … that no program has. @param {Pick<Doc, 'programs'>} doc @param {string} name */
export function freeCodeId({ programs }, name) {
  const taken = new Set(programs.map(({ id }) => id.toUpperCase()));
  let id = name;
  for (let number = 2; taken.has(id.toUpperCase()); number++) id = `${name}_${number}`;
  return id;
}
