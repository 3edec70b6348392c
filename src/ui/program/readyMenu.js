/**
 * Ready programs as choices of a menu. What makes one for the arm is fetched when one is chosen.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { ReadyId } from '../../model/program/readyPrograms.js'
 */
import { attempt } from '../page.js';
import { READY_WORDS } from '../words/ready.js';

/** @type {readonly ReadyId[]} */
const READY = ['pick-and-place', 'weld-seam', 'circle', 'lissajous', 'corners', 'laws', 'points'];

/**
 * @param {Page} page
 * @param {{ say: (text: string) => void, refuse: (reason: string | null) => void, choose: (program: string) => void }} acts
 * @returns {Choice[]}
 */
export const readyChoices = (page, { say, refuse, choose }) =>
  READY.map((id) => {
    const name = READY_WORDS.name[id];
    async function make() {
      const { store, clock, messages } = page;
      say(READY_WORDS.searching(name));
      try {
        const { readyProgram } = await import('../../model/program/readyPrograms.js');
        await new Promise((drawn) => clock.onFrame(() => drawn(null))); // the menu closes first
        const steps = readyProgram(store.state.doc, id, READY_WORDS.comments);
        if (steps === null) return refuse(READY_WORDS.notFound(name));
        const reason = attempt(page, { type: 'add-motion-program', name, steps });
        refuse(reason);
        if (reason !== null) return;
        choose(store.state.doc.motionPrograms[store.state.doc.motionPrograms.length - 1].id);
        say(READY_WORDS.made(name));
      } catch (error) {
        messages.fault(error);
      }
    }
    return { title: name, detail: READY_WORDS.detail[id], run: () => void make() };
  });
