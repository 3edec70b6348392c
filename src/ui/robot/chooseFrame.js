/**
 * Another tool or user frame is chosen, in the frames panel or on the pendant: carried out and said, or why not.
 *
 * @import { Page } from '../page.js'
 * @import { FrameKind } from '../../model/frames/frames.js'
 * @import { ToolKeeps } from '../../model/frames/toolChange.js'
 *
 * @typedef {object} Refused
 * @property {string} reason
 * @property {boolean} isStuck  only because the arm cannot keep the TCP: it could keep the flange
 */
import { toolChange } from '../../model/frames/toolChange.js';
import { attempt } from '../page.js';
import { verdictInWords } from '../aim/verdict.js';
import { FRAMES } from '../words/frames.js';

/**
 * @param {Page} page
 * @param {FrameKind} kind
 * @param {number | null} index  in the document's list; null: the flange itself, the world
 * @param {ToolKeeps} [keeps]  what stays where it is when it is a tool, if not as the person chose
 * @returns {Refused | null} null: it is chosen
 */
export function chooseFrame(page, kind, index, keeps = page.store.state.session.toolKeeps) {
  const { doc } = page.store.state;
  const id = index === null ? null : doc.frames[index].id;
  const { command, answer } =
    kind === 'tool'
      ? toolChange(doc, index, keeps)
      : { command: /** @type {const} */ ({ type: 'choose-user', index }), answer: null };
  const reason = command
    ? attempt(page, command)
    : FRAMES.cannotKeep(id ?? FRAMES.noTool, verdictInWords(doc.robot, answer));
  page.announce(reason ?? (id === null ? FRAMES.chosenNone[kind] : FRAMES.chosen(kind, id)));
  return reason === null ? null : { reason, isStuck: answer !== null };
}
