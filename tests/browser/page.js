/**
 * What the journeys share: opening the page, and looking at the picture.
 * @import { Page } from '@playwright/test'
 */
import { expect } from '@playwright/test';
import { PNG } from 'pngjs';

/**
 * Opens the production build. Anything said on the console as an error, and any uncaught one, fails the test. Nothing is kept
 * for a next visit (links.spec.js has that), so a second opening begins as the first.
 * @param {Page} page
 * @param {string} [query]  without the question mark
 */
export async function open(page, query = '') {
  page.on('pageerror', (error) => expect.soft(error.message, 'an uncaught error').toBe(''));
  page.on('console', (message) => {
    if (message.type() === 'error') expect.soft(message.text(), 'an error on the console').toBe('');
  });
  await page.goto(`./?quality=low&theme=light&hint=off&autosave=off&${query}`);
  await page.evaluate(() => window.denavit.ready);
}

/** The recorded postures, which are folded away in the Program panel. @param {Page} page */
export async function openPostures(page) {
  await page.getByRole('tab', { name: 'Program' }).click();
  await page.getByRole('button', { name: /^Recorded postures/ }).click();
}

/**
 * The scene's pixels, once two looks in a row see the same: a slow machine shows a frame a while after it was drawn.
 * @param {Page} page
 */
export async function picture(page) {
  await settled(page);
  const canvas = page.locator('canvas');
  let last = await canvas.screenshot();
  for (let looks = 0; looks < 20; looks++) {
    const now = await canvas.screenshot();
    if (now.equals(last)) return now;
    last = now;
  }
  throw new Error('The picture does not come to rest.');
}

/** So many pixels may differ between pictures that are the same, as for those that are kept (playwright.config.js). */
const SAME = 20;

/** How many pixels of two pictures of one size differ. @param {Buffer} a @param {Buffer} b */
function pixelsApart(a, b) {
  const [one, other] = [PNG.sync.read(a), PNG.sync.read(b)];
  if (one.width !== other.width || one.height !== other.height) return Infinity;
  let apart = 0;
  for (let i = 0; i < one.data.length; i += 4) {
    if ([0, 1, 2].some((k) => one.data[i + k] !== other.data[i + k])) apart++;
  }
  return apart;
}

/**
 * The scene comes to look as it did, or to look otherwise. A loaded machine may show an old frame twice before the new one.
 * @param {Page} page
 * @param {Buffer} before
 * @param {boolean} [isSame]
 */
export const expectPicture = (page, before, isSame = true) =>
  expect.poll(async () => pixelsApart(await picture(page), before) <= SAME, { timeout: 20_000 }).toBe(isSame);

/** Lets some frames pass, and the last picture with them. @param {Page} page */
export const settled = (page) =>
  page.evaluate(async () => {
    for (let i = 0; i < 4; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
  });

/** How often the scene was drawn so far. @param {Page} page */
export const draws = (page) => page.locator('canvas').evaluate((canvas) => Number(canvas.dataset.draws));

/** The tool's place: x, y, z in metres. @param {Page} page */
export const tool = (page) =>
  page.evaluate(() =>
    window.denavit
      .pose()
      .slice(0, 3)
      .map((row) => row[3]),
  );

/** A number of the tool's pose as the panel shows it. @param {Page} page @param {string} name X Y Z W P R */
export const shownPose = (page, name) =>
  page.locator('.pose-panel .pose > div', { has: page.getByText(name, { exact: true }) }).locator('output');
