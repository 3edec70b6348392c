/** Fingers: the keys above the on-screen keyboard, on a phone. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open } from './page.js';

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

test('signs and units stand in a row above the keyboard, and what is typed stays in sight', async ({ page }) => {
  await page.addInitScript(() => {
    // A keyboard of 330 px, which no browser under test has.
    Reflect.set(window, 'covered', 0);
    Object.defineProperty(VisualViewport.prototype, 'height', {
      get: () => window.innerHeight - Reflect.get(window, 'covered'),
    });
  });
  await open(page);
  await page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name: 'Robot' }).tap();
  const cell = page.getByLabel('Joint 6, link length a, millimetres');
  await cell.tap();
  const keys = page.getByRole('toolbar', { name: 'Keys for numbers and units' });
  await keys.getByRole('button', { name: 'Square root' }).tap();
  await page.keyboard.type('4');
  await keys.getByRole('button', { name: 'Inches' }).tap();
  await expect(cell).toHaveValue('√4 in');
  await expect(cell).toBeFocused();
  await expect(page.locator('.cellbar')).toContainText('√4 in = 50.8 mm');
  await expectAccessible(page, { within: '.app' });

  await page.evaluate(() => {
    Reflect.set(window, 'covered', 330);
    visualViewport?.dispatchEvent(new Event('resize'));
  });
  for (const part of [cell, page.locator('.cellbar'), keys]) await expect(part).toBeInViewport({ ratio: 1 });
  expect((await keys.boundingBox())?.y).toBeCloseTo(844 - 330 - 57, -1);
  const small = await keys
    .getByRole('button')
    .evaluateAll((buttons) => buttons.filter((button) => button.getBoundingClientRect().height < 44).length);
  expect(small).toBe(0);

  await page.getByLabel('Joint 6, link twist α, degrees').tap();
  await expect(keys.getByRole('button', { name: 'Radians' })).toBeVisible();
  await keys.getByRole('button', { name: 'Done' }).tap();
  await expect(keys).toBeHidden();
  expect(await page.evaluate(() => window.denavit.model().joints[5].a)).toBe(50.8);
  await expect(page.getByRole('navigation', { name: 'Panels' })).toBeInViewport();
});
