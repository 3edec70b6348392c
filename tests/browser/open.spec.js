/** All that opens: each menu, dialog and fold, as axe-core sees it when it is open, in the dark, where contrast is harder. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

/** @typedef {import('@playwright/test').Page} Page */

test('every menu is accessible when it is open', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Colours: light or dark' }).click();
  await page.locator('.pose-panel [data-ask=form]').click(); // fetches the menus of its panel
  await expect(page.locator('.dropdown-menu.show')).toBeVisible();
  await page.keyboard.press('Escape');
  // One joint's menu is as another's.
  const toggles = await page.locator('[data-bs-toggle=dropdown]:visible:not(tr + tr *)').all();
  expect(toggles.length).toBeGreaterThan(9);
  for (const button of toggles) {
    await button.focus();
    await page.keyboard.press('Enter');
    const menu = page.locator('.dropdown-menu.show');
    await expect(menu).toHaveCount(1);
    await settled(page);
    await expectAccessible(page, { within: ':has(> .dropdown-menu.show)' });
    const box = await menu.boundingBox();
    const name = (await button.getAttribute('aria-label')) ?? (await button.textContent());
    expect(
      box && box.x >= 0 && box.y >= 0 && box.x + box.width <= 1366 && box.y + box.height <= 768,
      `${name} fits`,
    ).toBe(true);
    const isCut = await menu.evaluate((list) => {
      const { left, right, top, bottom } = list.getBoundingClientRect();
      return [top + 9, bottom - 9].some((y) => !list.contains(document.elementFromPoint((left + right) / 2, y)));
    });
    expect(isCut, `${name} is cut off`).toBe(false);
    await page.keyboard.press('Escape');
    await expect(menu).toHaveCount(0);
    await expect(button).toBeFocused();
  }
});

test('every fold and dialog is accessible when it is open', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'Colours: light or dark' }).click();
  const opened = await page.evaluate(() => {
    const folds = [...document.querySelectorAll('button[aria-expanded=false]:not([data-bs-toggle])')];
    for (const fold of folds) if (fold instanceof HTMLElement && fold.checkVisibility()) fold.click();
    return folds.length;
  });
  expect(opened).toBeGreaterThan(4);
  await page.getByRole('button', { name: 'Paste…' }).click();
  await page.getByRole('textbox', { name: 'A pose as text' }).fill('X 450 Y 100 Z 900 A 90 B 0 C 180');
  await expect(page.getByRole('group', { name: 'The target that comes of it' })).toContainText('450.00');
  await settled(page);
  await expect(page.locator('[aria-busy]')).toHaveCount(0);
  await expectAccessible(page);
  for (const form of ['Quaternion xyzw', '4 × 4 matrix']) {
    await page.locator('.aim-panel [data-ask=form]').click();
    await page.locator('.dropdown-menu.show').getByText(form, { exact: true }).click();
    await settled(page);
    await expectAccessible(page, { within: '.aim-panel' });
  }
  for (const name of ['Choose a robot', 'Help: keys, conventions, about', 'Paste table']) {
    await page.locator(`button[title="${name}"], button:text-is("${name}")`).first().click();
    await expect(page.getByRole('dialog')).toBeVisible();
    await expectAccessible(page, { within: '[role=dialog]' });
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toHaveCount(0);
  }
});
