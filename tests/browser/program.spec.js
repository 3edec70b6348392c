/** Motion programs: recorded, put in order, edited, undone, saved and opened again; with the keyboard alone. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

/** The steps' names, in their order. @param {import('@playwright/test').Page} page */
const names = (page) => page.locator('.steps .step-name b');

test('four targets are recorded, put in order, edited, undone, saved and opened again', async ({ page }) => {
  await open(page);
  await page.getByRole('tab', { name: 'Program' }).click();
  const panel = page.locator('#panel-program');
  const record = panel.getByRole('button', { name: 'Record here' });
  await expect(panel.getByText('No moves yet')).toBeVisible();
  await record.click();
  await expect(names(page)).toHaveText(['home']);
  const go = (/** @type {number[]} */ q) => page.evaluate((values) => window.denavit.setJoints(values), q);
  await go([10, 45, -160, 0, 40, 0]);
  await record.click();
  await panel.getByRole('button', { name: 'Line', exact: true }).click();
  await go([20, 45, -160, 0, 40, 0]);
  await record.click();
  await panel.getByRole('button', { name: 'Arc', exact: true }).click();
  await panel.getByRole('button', { name: 'Record the way point' }).click();
  await go([40, 45, -160, 0, 40, 0]);
  await panel.getByRole('button', { name: 'Record the end' }).click();
  await expect(names(page)).toHaveCount(4);
  await expect(names(page).nth(3)).toContainText('via →');
  expect(await page.evaluate(() => window.denavit.xml())).toContain('<circularMove id="s4"');

  // a speed in the table, with a key to the next; the card shows the same
  const speed = page.getByLabel('Step 3, speed, millimetres per second');
  await speed.fill('120');
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Speed', { exact: true })).toHaveValue('250'); // step 4 is chosen now
  await page.getByLabel('End', { exact: true }).selectOption('CNT (share)');
  await expect(page.locator('.steps .step-end').last()).toHaveText('CNT 50');
  await page.getByLabel('Speed', { exact: true }).fill('-3');
  await page.keyboard.press('Enter');
  await expect(panel.getByText('expected a number above 0')).toBeVisible();
  await page.keyboard.press('Escape');

  // dragged by its number, and back by undo
  const before = await names(page).allTextContents();
  await page.locator('.steps [data-grip]').nth(3).dragTo(page.locator('.steps [data-grip]').nth(0));
  await expect(names(page).first()).toContainText('via →');
  await page.getByRole('button', { name: /^Undo: step/ }).click();
  await expect(names(page)).toHaveText(before);

  await page.getByRole('button', { name: 'File' }).click();
  const coming = page.waitForEvent('download');
  await page.getByRole('button', { name: /^Save the robot/ }).click();
  const text = await readFile(await (await coming).path(), 'utf8');
  await page.evaluate(() => window.denavit.load('planar2r'));
  await expect(panel.getByText('No moves yet')).toBeVisible();
  await page.evaluate((xml) => window.denavit.load(xml), text);
  await expect(names(page)).toHaveText(before);
  expect(await page.evaluate(() => window.denavit.xml())).toBe(text);
  await expectAccessible(page, { within: '#panel-program' });
});

test('with the keyboard alone: an example is opened, its steps are gone through, moved, gone to and deleted', async ({
  page,
}) => {
  await open(page);
  await page.getByRole('tab', { name: 'Program' }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Open an example' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: /^Pick and place/ })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(names(page)).toHaveCount(12);
  await page.getByRole('button', { name: /^1, joint move, home/ }).focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: /^3, linear move/ })).toHaveAttribute('aria-current', 'true');
  await expect(page.getByText('Step 3', { exact: true }).first()).toBeVisible(); // the ghost, and the card below
  const third = await names(page).nth(2).textContent();
  await page.keyboard.press('Alt+ArrowUp');
  await expect(names(page).nth(1)).toHaveText(third ?? '');
  await expect(page.getByRole('button', { name: /^2, linear move/ })).toBeFocused();
  await page.keyboard.press('Delete');
  await expect(names(page)).toHaveCount(11);
  await page.getByRole('button', { name: 'Go there' }).focus();
  const from = await page.evaluate(() => window.denavit.joints());
  await page.keyboard.press('Enter');
  await expect.poll(() => page.evaluate(() => window.denavit.joints())).not.toEqual(from);
  await page.getByRole('button', { name: /^Pass over: step/ }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: /^Carry out again: step/ })).toBeFocused();
  await settled(page);
});
