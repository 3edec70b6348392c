/** A page that dies without a word, at any moment: what the next visit offers is at most two seconds old. */
import { expect, test } from '@playwright/test';
import { createRandom } from '../../src/kinematics/random.js';
import { SEED } from '../helpers/property.js';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {{ what: 'jog' | 'type' | 'undo' | 'redo' | 'load', value: number, wait: number }} Step  wait: seconds until the next */
/** @typedef {{ at: number, file: string }} Moment  what the document was from then on */

const KILLS = process.env.DENAVIT_DEEP ? 100 : 10;
const SECONDS_LOST = 2;
const WORK = 'denavit.work.';

const random = createRandom(SEED);
const any = (/** @type {number} */ least, /** @type {number} */ most) => least + random() * (most - least);

/** @returns {Step[]} */
const session = () =>
  Array.from({ length: 16 }, () => {
    const what = /** @type {const} */ (['jog', 'jog', 'jog', 'type', 'type', 'undo', 'redo', 'load'])[
      Math.floor(any(0, 8))
    ];
    return { what, value: Math.round(any(-100, 100)), wait: random() < 0.7 ? any(0, 0.6) : any(0.6, 3) };
  });

/**
 * Does the steps in the page, as far as they come by the moment of its death.
 * @param {{ steps: Step[], until: number }} given  until: seconds of the page's clock
 */
async function live({ steps, until }) {
  const { denavit } = window;
  const { clock } = denavit;
  if (!clock) throw new Error('The clock is not the one of tests.');
  const end = clock.now() + until;
  /** @type {Moment[]} */
  const moments = [{ at: clock.now(), file: denavit.xml() }];
  for (const { what, value, wait } of steps) {
    if (what === 'jog') denavit.setJoints(denavit.joints().map((_, i) => value / (i + 1)));
    if (what === 'undo' || what === 'redo') denavit[what]();
    if (what === 'load') {
      await denavit.load(value < 0 ? 'ur5' : 'planar2r');
      await new Promise(requestAnimationFrame); // so that no two works are of the same millisecond
    }
    const cell = what === 'type' && document.querySelector('.grid input');
    if (cell instanceof HTMLInputElement) {
      cell.focus();
      cell.value = String(value);
      cell.dispatchEvent(new InputEvent('input', { bubbles: true })); // and not yet ended when the page dies
    }
    moments.push({ at: clock.now(), file: denavit.xml() });
    for (let left = wait; left > 0; left -= 0.2) {
      clock.tick(Math.min(left, 0.2, end - clock.now()));
      if (clock.now() >= end) return { moments, killed: end };
    }
  }
  return { moments, killed: clock.now() };
}

/** Opens the page, and what is offered in it. @param {Page} page @returns {Promise<string>} the document as it is then */
async function visit(page) {
  page.on('pageerror', (error) => expect.soft(error.message, 'an uncaught error').toBe(''));
  await page.goto('./?quality=low&theme=light&hint=off&clock=manual');
  return page.evaluate(async (prefix) => {
    const { denavit } = window;
    denavit.clock?.tick();
    denavit.clock?.tick();
    await denavit.ready;
    const kept = () => Object.keys(localStorage).filter((key) => key.startsWith(prefix));
    // What is kept is offered, or it is nothing but what is open and is forgotten.
    while (kept().length > 0 && !document.querySelector('.notice.note')) await new Promise(requestAnimationFrame);
    const earlier = kept();
    const [restore] = document.querySelectorAll('.notice.note button');
    if (restore instanceof HTMLElement) restore.click();
    for (const key of earlier) localStorage.removeItem(key); // other arms of the same session
    return denavit.xml();
  }, WORK);
}

test(`a page that is killed at ${KILLS} random moments loses two seconds of work at most`, async ({ context }) => {
  let lost = 0;
  // Without WebGL the page does all that it keeps, in half the time.
  await context.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null));
  let page = await context.newPage();
  await visit(page);
  for (let kill = 0; kill < KILLS; kill++) {
    const steps = session();
    const until = any(0, 12);
    const { moments, killed } = await page.evaluate(live, { steps, until });
    const browser = await context.newCDPSession(page);
    const dead = page.waitForEvent('crash');
    browser.send('Page.crash').catch(() => {}); // the dead do not answer
    await dead;
    await page.close();

    page = await context.newPage();
    const found = await visit(page);
    const recent = moments.filter((_, i) => (moments[i + 1]?.at ?? Infinity) >= killed - SECONDS_LOST);
    const where = recent.findIndex(({ file }) => file === found);
    expect(where, `what is found again after kill ${kill + 1} of seed ${SEED}`).toBeGreaterThanOrEqual(0);
    if (found !== moments.at(-1)?.file) lost++;
  }
  expect(lost).toBeGreaterThan(0); // a kill does fall between a change and its writing
  expect(lost).toBeLessThan(KILLS);
});
