/**
 * What was wrong with a file, in a dialog: what was not done; that the work is as it was; line and reason; what to do.
 *
 * @import { Announce } from '../announce.js'
 * @import { Issue } from '../../model/issues.js'
 */
import { copyText } from '../parts/clipboard.js';
import { DISMISSES, dialogFoot, dialogHead, openDialog } from '../parts/dialog.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';
import { ARRIVAL } from '../words/arrival.js';

const CONTEXT_LINES = 1;

/**
 * @param {object} report
 * @param {string} report.name        of the file
 * @param {string} report.robotName   the robot that is open now
 * @param {boolean} report.isOpened   with remarks, or not at all
 * @param {readonly Issue[]} report.issues
 * @param {string | null} report.text of the file, for the lines around a fault
 * @param {() => void} report.again   choose another file
 * @param {Announce} report.announce
 */
export function showReport({ name, robotName, isOpened, issues, text, again, announce }) {
  const title = isOpened ? ARRIVAL.openedWith(name) : ARRIVAL.notOpened(name);
  const copy = h('button', { type: 'button', class: 'btn' }, icon('copy'), ARRIVAL.copyReport);
  const another = h('button', { ...DISMISSES, class: 'btn btn-primary' }, icon('folder'), ARRIVAL.another);
  const done = h('button', { ...DISMISSES, class: 'btn' }, TEXT.close);
  copy.addEventListener('click', async () => {
    announce(
      (await copyText([title, ...issues.map(({ message }) => message)].join('\n')))
        ? ARRIVAL.reportCopied
        : TEXT.pose.copyFailed,
    );
  });
  another.addEventListener('click', again);
  return openDialog({
    name: 'file-report takes-files',
    title: 'report-title',
    content: [
      dialogHead('report-title', title, {
        mark: icon(isOpened ? 'exclamation' : 'fileX', isOpened ? 'i-l warn' : 'i-l bad'),
        below: isOpened ? null : h('p', { class: 'soft' }, ARRIVAL.stillHere(robotName)),
      }),
      h(
        'ul',
        { class: 'issues' },
        issues.map((issue) => issueItem(issue, text)),
      ),
      dialogFoot(copy, h('span', { class: 'grow' }), done, isOpened ? null : another),
    ],
  });
}

/** @param {Issue} issue @param {string | null} text */
const issueItem = ({ severity, line, message }, text) =>
  h(
    'li',
    {},
    icon(severity === 'error' ? 'octagon' : 'exclamation', severity === 'error' ? 'bad' : 'warn'),
    h('div', {}, h('p', { class: 'issue-text' }, message), line && text !== null ? snippet(text, line) : null),
  );

/** The line at fault between its neighbours. @param {string} text @param {number} line */
function snippet(text, line) {
  const all = text.split(/\r\n|\r|\n/);
  const from = Math.max(1, line - CONTEXT_LINES);
  const rows = all
    .slice(from - 1, line + CONTEXT_LINES)
    .map((content, i) =>
      h(
        'div',
        { class: from + i === line ? 'here' : null },
        h('span', {}, String(from + i)),
        h('span', { class: 'content' }, content.slice(0, 200)),
      ),
    );
  return h('div', { class: 'snippet' }, rows);
}
