/** The tool is dragged in the scene, with real pointer events. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled, tool } from './page.js';

/** The farthest that a joint may go in one frame, degrees: 0.25 rad. */
const RATE = 14.33;

/** @typedef {import('@playwright/test').Page} Page */

const undo = (/** @type {Page} */ page) => page.getByRole('button', { name: 'Undo' });
const joints = (/** @type {Page} */ page) => page.evaluate(() => window.denavit.joints());

/** The middle of an element over the picture. @param {Page} page @param {string} selector */
async function middle(page, selector) {
  const box = await page.locator(selector).first().boundingBox();
  if (!box) throw new Error(`${selector} is not in the picture.`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Brings the pointer over the view, so that the handle is there. @param {Page} page */
async function showHandle(page) {
  const box = await page.locator('canvas').boundingBox();
  if (!box) throw new Error('There is no picture.');
  await page.mouse.move(box.x + 20, box.y + box.height / 2);
  await expect(page.locator('.stage .of-handle:visible')).toHaveText(['X', 'Y', 'Z']);
  await settled(page);
}

/**
 * Takes hold of an arrow, and answers with the unit vector along it on the screen and where it was taken.
 * @param {Page} page
 * @param {'x' | 'y' | 'z'} axis
 */
async function takeArrow(page, axis) {
  await showHandle(page);
  const from = await middle(page, '.stage .tag.dot:visible');
  const to = await middle(page, `.stage .axis-${axis}.of-handle:visible`);
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const [x, y] = [from.x + 0.6 * dx, from.y + 0.6 * dy];
  await page.mouse.move(x, y);
  await page.mouse.down();
  const length = Math.hypot(dx, dy);
  /** @param {number} pixels along the arrow */
  const to_ = (pixels) => page.mouse.move(x + (dx / length) * pixels, y + (dy / length) * pixels);
  return { moveTo: to_ };
}

test('200 mm along an axis and back: the posture returns, and a drag is one undo step', async ({ page }) => {
  await open(page);
  const [before, place] = [await joints(page), await tool(page)];
  const { moveTo } = await takeArrow(page, 'z');
  await page.keyboard.down('Shift'); // whole centimetres
  let [pixels, z] = [0, place[2]];
  while (z < place[2] + 0.2 - 1e-6 && pixels < 400) {
    await moveTo((pixels += 5));
    await settled(page);
    z = (await tool(page))[2];
  }
  const there = await tool(page);
  expect(there[0]).toBeCloseTo(place[0], 8);
  expect(there[1]).toBeCloseTo(place[1], 8);
  expect(there[2]).toBeCloseTo(place[2] + 0.2, 8);
  await moveTo(0);
  await settled(page);
  await page.keyboard.up('Shift');
  (await joints(page)).forEach((value, i) => expect(value).toBeCloseTo(before[i], 6));
  await moveTo(60);
  await page.mouse.up();
  await settled(page);
  expect((await tool(page))[2]).toBeGreaterThan(place[2] + 0.05);
  await undo(page).click();
  expect(await joints(page)).toEqual(before);
  await expect(undo(page)).toBeDisabled();
});

/**
 * A page whose frames the test drives.
 * @param {Page} page
 */
async function openDriven(page) {
  page.on('pageerror', (error) => expect.soft(error.message, 'an uncaught error').toBe(''));
  await page.goto('./?quality=low&theme=light&hint=off&clock=manual');
  await page.waitForFunction(() => window.denavit?.clock && document.querySelector('canvas'));
  const tick = (count = 1) =>
    page.evaluate((n) => {
      for (let i = 0; i < n; i++) window.denavit.clock?.tick();
      return window.denavit.joints();
    }, count);
  await page.evaluate(async () => {
    for (let i = 0; i < 6; i++) window.denavit.clock?.tick();
    await window.denavit.ready;
  });
  /** Frame by frame until the arm rests; no joint may go faster than the rate. */
  async function follow() {
    let [last, frames] = [await joints(page), 0];
    for (let still = 0; still < 3 && frames < 200; frames++) {
      const next = await tick();
      const farthest = Math.max(...next.map((value, i) => Math.abs(value - last[i])));
      expect(farthest).toBeLessThan(RATE);
      still = farthest === 0 ? still + 1 : 0;
      last = next;
    }
    return { q: last, frames };
  }
  const box = await page.locator('canvas').boundingBox();
  await page.mouse.move((box?.x ?? 0) + 20, 400);
  await expect
    .poll(async () => {
      await tick(2);
      return page.locator('.stage .of-handle:visible').count();
    })
    .toBe(3);
  return { tick, follow };
}

test('out of reach the arm goes as near as it can and the view says so; nothing jumps on the way back', async ({
  page,
}) => {
  const { tick, follow } = await openDriven(page);
  const before = await joints(page);
  const { moveTo } = await takeArrow(page, 'x');
  await moveTo(20);
  const inside = (await follow()).q;
  await moveTo(330);
  await follow();
  await expect(page.locator('.drag-line span')).toHaveText(/^Edge of the reach: \d+ mm short\.$/);
  await expect(page.locator('.tag.miss', { hasText: 'mm' })).toBeVisible();
  await moveTo(20);
  const back = (await follow()).q;
  back.forEach((value, i) => expect(value).toBeCloseTo(inside[i], 6));
  await expect(page.locator('.drag-line')).toBeHidden();
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await tick(3);
  expect(await joints(page)).toEqual(before);
});

test('a drag through a wrist singularity: no joint goes faster than the rate in a frame, and the tool arrives', async ({
  page,
}) => {
  const { tick, follow } = await openDriven(page);
  // Axes 4 and 6 are nearly in line: a turn of the tool to the other side of that takes both of them a half turn.
  await page.evaluate(() => window.denavit.setJoints([0, 45, -180, 20, 8, 0]));
  await tick(4);
  const [x, y] = await tool(page);
  const { moveTo } = await takeArrow(page, 'z');
  let turned = 0;
  for (const pixels of [30, 60, -30, -60]) {
    await moveTo(pixels);
    turned = Math.max(turned, Math.abs((await follow()).q[3] - 20));
  }
  expect(turned).toBeGreaterThan(90);
  const [atX, atY] = await tool(page);
  for (const [value, wanted] of [[atX, x], [atY, y]]) expect(value).toBeCloseTo(wanted, 7); // prettier-ignore
  await page.mouse.up();
});

test('keys alone take the tool, move it, turn it and give it back; a step is one undo step', async ({ page }) => {
  await open(page);
  const [before, place] = [await joints(page), await tool(page)];
  await page.locator('canvas').focus();
  await expect(page.locator('canvas')).toBeFocused();
  await expect(async () => {
    await page.keyboard.press('t');
    await expect(page.locator('.drag-line')).toBeVisible({ timeout: 500 });
  }).toPass();
  await expectAccessible(page, { within: '.handle-bar' });
  await page.keyboard.press('ArrowRight');
  await settled(page);
  const moved = await tool(page);
  expect(moved[0]).toBeCloseTo(place[0] + 0.01, 8);
  expect(moved[2]).toBeCloseTo(place[2], 8);
  await page.keyboard.press('r');
  await page.keyboard.press('PageUp');
  await settled(page);
  (await tool(page)).forEach((value, i) => expect(value).toBeCloseTo(moved[i], 8));
  const turned = await joints(page);
  await page.keyboard.press('r');
  await page.evaluate(() => window.denavit.setJoints([0, 0, -90, 0, 40, 0])); // an elbow that is almost straight
  for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
  await expect(page.locator('.drag-line span')).toHaveText(/^Edge of the reach: \d+ mm short\.$/); // and stays to be read
  await page.evaluate(() => window.denavit.undo());
  await expect(page.locator('.drag-line')).not.toContainText('Edge');
  while (!(await joints(page)).every((value, i) => Math.abs(value - turned[i]) < 1e-9)) await page.evaluate(() => window.denavit.undo()); // prettier-ignore
  await page.keyboard.press('Escape');
  await expect(page.locator('.drag-line')).toBeHidden();
  await page.keyboard.press('ArrowRight'); // goes round the arm again
  await settled(page);
  await undo(page).click();
  await undo(page).click();
  expect(await joints(page)).toEqual(before);
  await expect(undo(page)).toBeDisabled();
});

test('a link that is dragged turns its joint, stops at the limit and says so', async ({ page }) => {
  await open(page);
  await showHandle(page);
  const before = await joints(page);
  const base = await middle(page, '.stage .axis-z:not(.strong)');
  const [x, y] = [base.x + 35, base.y - 230]; // the upper arm, half way up
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y - 20);
  await page.mouse.move(x + 40, y - 30);
  await expect(page.locator('.tag.dim')).toContainText('J2');
  await page.mouse.move(x + 150, y + 250);
  await expect(page.locator('.drag-line span')).toHaveText('J2 is at its limit.');
  await page.mouse.up();
  const after = await joints(page);
  expect(after[1]).toBe(-45);
  expect(after.with(1, before[1])).toEqual(before);
  await undo(page).click();
  expect(await joints(page)).toEqual(before);
});

test('Escape in mid-drag leaves no trace, redo included', async ({ page }) => {
  await open(page);
  await page.evaluate(() => window.denavit.setJoints([10, 40, -170, 5, 50, 5]));
  await undo(page).click();
  const redo = page.getByRole('button', { name: 'Redo' });
  await expect(redo).toBeEnabled();
  const before = await joints(page);
  const { moveTo } = await takeArrow(page, 'z');
  await moveTo(30);
  await moveTo(60);
  await settled(page);
  expect(await joints(page)).not.toEqual(before);
  await expect(redo).toBeDisabled();
  await page.keyboard.press('Escape');
  await moveTo(90); // the hand is still down, and moves nothing
  await page.mouse.up();
  await settled(page);
  expect(await joints(page)).toEqual(before);
  await expect(undo(page)).toBeDisabled();
  await redo.click();
  expect(await joints(page)).toEqual([10, 40, -170, 5, 50, 5]);
});
