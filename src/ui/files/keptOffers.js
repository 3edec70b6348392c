/**
 * Work of an earlier visit, offered in a quiet bar; work that cannot be read any more, said and handed out as a file; and the
 * word that nothing can be kept here. Fetched when there is any of it.
 *
 * @import { Note } from '../parts/note.js'
 * @import { Page } from '../page.js'
 * @import { KeptWork, SpoiltWork } from '../../io/readKeptWork.js'
 */
import { KEPT } from '../../io/keptWork.js';
import { sortKeptWork } from '../../io/readKeptWork.js';
import { writeRobotXml } from '../../io/robotXmlWriter.js';
import { applyLook } from './applyLook.js';
import { dateOf, today } from '../browserClock.js';
import { forget, keysFrom, recall } from '../browserStorage.js';
import { download } from '../parts/download.js';
import { fileNameOf } from './files.js';
import { showNote } from '../parts/note.js';
import { TEXT } from '../strings.js';
import { KEPT_WORK } from '../words/keptWork.js';

/**
 * @param {Page} page
 * @param {() => boolean} keep  the work of this visit, now
 */
export async function offerKeptWork(page, keep) {
  const held = await heldVisits();
  const all = keysFrom(KEPT)
    .filter((key) => !held.has(key.slice(0, key.lastIndexOf('.'))))
    .map((key) => ({ key, text: recall(key) ?? '' }));
  const { works, spoilt, idle } = sortKeptWork(all, page.store.state.doc);
  idle.forEach(forget);
  offerNext(page, works, keep);
  sayNext(page, spoilt);
}

/** The visits that are going on, where the browser can tell. */
async function heldVisits() {
  try {
    const { held = [] } = await navigator.locks.query();
    return new Set(held.map(({ name }) => name));
  } catch {
    return new Set();
  }
}

/** @param {Page} page @param {readonly KeptWork[]} works @param {() => boolean} keep */
function offerNext(page, works, keep) {
  const [work, ...more] = works;
  if (!work) return;
  const name = work.doc.robot.name || TEXT.unnamedRobot;
  showNote(page, {
    text: KEPT_WORK.offer(whenSaid(work.at), name, more.length),
    actions: [
      {
        name: KEPT_WORK.restore,
        isUsual: true,
        run() {
          page.opener.open(work.doc);
          applyLook(page, work.look);
          page.announce(KEPT_WORK.restored(name));
          if (keep()) forget(work.key); // it is this visit's now
        },
      },
      {
        name: KEPT_WORK.discard,
        run() {
          forget(work.key);
          page.announce(KEPT_WORK.discarded(name));
          offerNext(page, more, keep);
        },
      },
    ],
    close: KEPT_WORK.later,
  });
}

/** @param {Page} page @param {readonly SpoiltWork[]} all */
function sayNext(page, all) {
  const [work, ...more] = all;
  if (!work) return;
  /** @type {Note} */
  const note = {
    isWarning: true,
    text: KEPT_WORK[work.state],
    actions: [
      {
        name: KEPT_WORK.saveFile,
        stays: true, // a download may fail
        run: () => download(KEPT_WORK.spoiltFile, work.file, 'application/xml', page.clock),
      },
      {
        name: KEPT_WORK.discard,
        run() {
          forget(work.key);
          sayNext(page, more);
        },
      },
    ],
    close: KEPT_WORK.later,
  };
  showNote(page, note);
}

/** Nothing can be kept here: said once, with the way out. @param {Page} page */
export function sayNotKept(page) {
  showNote(page, {
    isWarning: true,
    text: KEPT_WORK.notKept,
    actions: [
      {
        name: KEPT_WORK.saveFile,
        run() {
          const { doc } = page.store.state;
          download(`${fileNameOf(doc.robot.name)}.xml`, writeRobotXml(doc), 'application/xml', page.clock);
        },
      },
    ],
    close: TEXT.close,
  });
}

/** "14:02" of today, "21 November, 14:02" of another day. @param {string} at  ISO 8601 */
function whenSaid(at) {
  const then = dateOf(at);
  const isToday = then.toDateString() === dateOf(today()).toDateString();
  /** @type {Intl.DateTimeFormatOptions} */
  const day = isToday ? {} : { day: 'numeric', month: 'long' };
  return Number.isNaN(then.getTime())
    ? KEPT_WORK.someTime
    : then.toLocaleString('en-GB', { ...day, hour: '2-digit', minute: '2-digit' }).replace(' at ', ', ');
}
