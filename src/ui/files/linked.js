/**
 * The model in the address: what the page begins with, and what it opens when another link is put into its address.
 *
 * The address stays as it is: loading the page again begins with the link again, as whoever follows a link to a lesson
 * expects, and what was made of it meanwhile is offered as the work of an earlier visit is.
 *
 * @import { Page } from '../page.js'
 * @import { LinkAnswer } from '../../io/shareLink.js'
 */
import { writeRobotXml } from '../../io/robotXmlWriter.js';
import { readShareLink } from '../../io/shareLink.js';
import { applyLook } from './applyLook.js';
import { showNote } from '../parts/note.js';
import { TEXT } from '../strings.js';
import { LINKED } from '../words/linked.js';

/** Before the page stands. */
export function linkHere() {
  const answer = readShareLink(location.hash);
  return { doc: answer.doc, show: (/** @type {Page} */ page) => show(page, answer) };
}

/**
 * Another link is in the address now, or was pasted: one step that can be undone.
 * @param {Page} page
 * @param {string} [hash]
 */
export function followLink(page, hash = location.hash) {
  const answer = readShareLink(hash);
  const { doc } = answer;
  if (doc && writeRobotXml(doc) !== writeRobotXml(page.store.state.doc)) page.opener.open(doc);
  show(page, answer);
}

let forgetLast = () => {};

/** @param {Page} page @param {LinkAnswer} answer */
function show(page, { doc, issues, look }) {
  const errors = issues.filter(({ severity }) => severity === 'error');
  for (const { message } of errors) page.messages.warn(message);
  applyLook(page, look);
  const remarks = issues.filter(({ severity }) => severity !== 'error');
  if (!doc) return;
  forgetLast();
  const name = doc.robot.name || TEXT.unnamedRobot;
  const close = showNote(page, {
    text: LINKED.opened(name, remarks.length),
    actions: remarks.length === 0 ? [] : [{ name: LINKED.remarks, run: () => showRemarks() }],
    close: TEXT.close,
  });
  // Once it is worked on, everybody knows where it came from.
  const { doc: opened } = page.store.state;
  const stop = page.addView(
    (state) => state.doc !== opened,
    (isChanged) => isChanged && forgetLast(),
  );
  forgetLast = () => {
    close();
    stop();
  };

  async function showRemarks() {
    const { showReport } = await import('./fileReport.js');
    const { announce } = page;
    showReport({
      name: LINKED.name,
      robotName: name,
      isOpened: true,
      issues: remarks,
      text: null,
      again() {},
      announce,
    });
  }
}
