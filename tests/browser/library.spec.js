/** The library: found by keys and by typing, at home on a phone, and a way to a robot of one's own. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open } from './page.js';

test('an arm is found by typing and chosen by keys, and undo brings the other back', async ({ page }) => {
  await open(page, 'robot=ur3');
  expect(await page.evaluate(() => window.denavit.model().name)).toBe('UR3'); // fetched for the address
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();

  await page.getByRole('button', { name: /^UR3/ }).focus();
  await page.keyboard.press('Enter');
  const dialog = page.getByRole('dialog', { name: 'Choose a robot' });
  const search = dialog.getByLabel('Search by name, type or source');
  await expect(search).toBeFocused();
  await expect(dialog.getByRole('option')).toHaveCount(26);
  await expect(dialog.getByRole('option', { name: /^UR3/, selected: true })).toContainText('open now');
  await expectAccessible(page, { within: '.robot-picker' });
  const cut = await dialog
    .getByRole('option')
    .evaluateAll((options) => options.filter((option) => option.scrollWidth > option.clientWidth).length);
  expect(cut).toBe(0);

  await page.keyboard.type('no such arm');
  await expect(dialog).toContainText('No robot matches “no such arm”.');
  await search.fill('universal');
  await expect(dialog.getByRole('option')).toHaveCount(3);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await expect(dialog.getByRole('option', { name: /^UR10/ })).toBeFocused();
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowRight');
  await expect(dialog.getByRole('option', { name: /^UR5/ })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(dialog).toBeHidden();
  await expect(page.getByRole('button', { name: /^UR5/ })).toBeFocused();
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('button', { name: /^UR3/ })).toBeFocused();
  await page.keyboard.press('Control+Shift+z');
  await expect(page.getByRole('button', { name: /^UR5/ })).toBeFocused();

  await page.keyboard.press('Enter');
  await expect(search).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
  await expect(page.getByRole('button', { name: /^UR5/ })).toBeFocused();
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a robot of one’s own begins with so many joints, and one undo brings the old one back', async ({ page }) => {
    await open(page);
    const before = await page.evaluate(() => window.denavit.xml());
    await page.getByRole('button', { name: /Puma 560/ }).tap();
    const dialog = page.getByRole('dialog', { name: 'Choose a robot' });
    await expect(dialog.getByRole('option', { name: /^Puma 560/ })).toBeInViewport();
    await expectAccessible(page, { within: '.robot-picker' });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await dialog.getByRole('button', { name: 'New robot with 4 joints' }).tap();
    await expect(dialog).toBeHidden();
    await expect(page.getByRole('button', { name: /^New robot/ })).toBeVisible();
    expect(await page.evaluate(() => window.denavit.joints().length)).toBe(4);
    await page.getByRole('button', { name: 'Undo' }).tap();
    expect(await page.evaluate(() => window.denavit.xml())).toBe(before);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  });
});
