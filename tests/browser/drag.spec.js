/** The tool is dragged in the scene, with real pointer events. */
import { expect, test } from '@playwright/test';
import { open, settled, tool } from './page.js';

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
  await expect(page.locator('.stage .axis.strong:visible')).toHaveText(['X', 'Y', 'Z']);
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
  const to = await middle(page, `.stage .axis-${axis}.strong:visible`);
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
