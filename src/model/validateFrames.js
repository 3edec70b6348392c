/**
 * Whether the user frames and tools of a document are sound, and which of them are active.
 *
 * @import { Doc } from './document.js'
 * @import { FrameKind } from './frames/frames.js'
 * @import { Issues } from './validateValues.js'
 */
import { activeFrame, agree } from './frames/frames.js';
import { documentIssue } from './issues.js';
import { checkChoice, checkDifferentIds, checkId, checkNumber, checkPose, shownValue } from './validateValues.js';

const WORD = { user: 'user frame', tool: 'tool' };

/** @param {Doc} doc @returns {Issues} */
export function* framesIssues(doc) {
  const { frames, activeTool, activeUser, robot } = doc;
  for (const [i, frame] of frames.entries()) {
    const owner = `Frame ${shownValue(frame.id)}`;
    yield* checkId(`Frame ${i + 1}`, `frames.${i}.id`, frame.id);
    yield* checkChoice(owner, 'the kind', `frames.${i}.kind`, frame.kind, ['user', 'tool']);
    yield* checkPose(owner, `frames.${i}`, frame);
    if (frame.number === undefined) continue;
    yield* checkNumber(owner, 'the number', `frames.${i}.number`, frame.number);
    if (!Number.isInteger(frame.number) || frame.number < 1) {
      const message = `${owner} has the number ${shownValue(frame.number)}; expected a whole number above 0.`;
      yield documentIssue('number', `frames.${i}.number`, message);
    }
  }
  yield* checkDifferentIds('frames', 'frames', frames);
  yield* checkFrameId('The model', 'activeUser', activeUser, frames, 'user');
  yield* checkFrameId('The model', 'activeTool', activeTool, frames, 'tool');
  const inUse = activeFrame(doc, 'tool');
  if (inUse && !agree(inUse, robot.tool)) {
    const message = `The active tool ${shownValue(inUse.id)} and the tool of the robot have different numbers; expected the same.`;
    yield documentIssue('tool-differs', 'activeTool', message);
  }
}

/**
 * @param {string} owner @param {string} path @param {string | undefined} id @param {Doc['frames']} frames
 * @param {FrameKind} kind
 * @returns {Issues}
 */
export function* checkFrameId(owner, path, id, frames, kind) {
  if (id === undefined || frames.some((frame) => frame.kind === kind && frame.id === id)) return;
  const message = `${owner} refers to the ${WORD[kind]} ${shownValue(id)}; expected the id of one that is there.`;
  yield documentIssue('frame-unknown', path, message);
}
