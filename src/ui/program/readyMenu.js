/**
 * Ready programs as choices of a menu. What makes one for the arm is fetched when one is chosen, and whether it can be played where
 * it is tried is found out apart.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { ReadyId, ReadyQuestion, readyProgram } from '../../model/program/readyPrograms.js'
 */
import { attempt } from '../page.js';
import { READY_WORDS } from '../words/ready.js';
import { createPlanApart } from './planApart.js';

/** @type {readonly ReadyId[]} */
const READY = ['pick-and-place', 'weld-seam', 'circle', 'lissajous', 'corners', 'laws', 'points'];

/**
 * @param {Page} page
 * @param {{ say: (text: string) => void, refuse: (reason: string | null) => void, choose: (program: string) => void }} acts
 * @returns {Choice[]}
 */
export function readyChoices(page, { say, refuse, choose }) {
  const { store, messages } = page;
  /** The one that was asked for last. */
  let latest = 0;

  /** @param {ReadyId} id */
  async function make(id) {
    const mine = ++latest;
    const name = READY_WORDS.name[id];
    say(READY_WORDS.searching(name));
    const { readyProgram } = await import('../../model/program/readyPrograms.js');
    for (;;) {
      const { doc } = store.state;
      const isWanted = () => mine === latest && store.state.doc.robot === doc.robot;
      const steps = await searched(page, readyProgram(doc, id, READY_WORDS.comments), isWanted);
      if (mine !== latest) return;
      if (!isWanted()) continue; // the arm is another now
      if (steps === null) return refuse(READY_WORDS.notFound(name));
      const reason = attempt(page, { type: 'add-motion-program', name, steps });
      refuse(reason);
      if (reason !== null) return;
      choose(store.state.doc.motionPrograms[store.state.doc.motionPrograms.length - 1].id);
      return say(READY_WORDS.made(name));
    }
  }

  return READY.map((id) => ({
    title: READY_WORDS.name[id],
    detail: READY_WORDS.detail[id],
    run: () => void make(id).catch(messages.fault),
  }));
}

/**
 * Has the search's questions answered apart, and lets the page have its turn between any two.
 * @param {Page} page
 * @param {ReturnType<typeof readyProgram>} search
 * @param {() => boolean} isWanted
 */
async function searched({ clock }, search, isWanted) {
  /** @type {(error: unknown) => void} */
  let fail = () => {};
  const apart = createPlanApart((error) => fail(error));
  /** @param {ReadyQuestion} question @returns {Promise<boolean>} */
  const canBePlayed = (question) =>
    new Promise((answer, failed) => {
      fail = failed;
      apart.ask(
        question,
        () => {},
        ({ refused }) => answer(refused === null),
      );
    });
  const pause = () => new Promise((goOn) => clock.after(0, () => goOn(null)));
  try {
    await new Promise((drawn) => clock.onFrame(() => drawn(null))); // the menu closes first
    let turn = search.next();
    while (!turn.done && isWanted()) {
      if (turn.value === null) await pause();
      turn = search.next(turn.value !== null && (await canBePlayed(turn.value)));
    }
    return turn.done ? turn.value : null;
  } finally {
    apart.end();
  }
}
