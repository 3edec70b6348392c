/** The page's own manners: what is fetched when it is needed, and what is said when it cannot be. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open } from './page.js';

test('a panel that cannot be fetched says so, and comes when it is asked for again', async ({ page, context }) => {
  await open(page);
  page.removeAllListeners('console'); // the refused request is an error there
  await context.route(/\/program-[^/]*\.js/, (route) => route.abort());
  await page.getByRole('tab', { name: 'Program' }).click();
  const panel = page.getByRole('tabpanel', { name: 'Program' });
  await expect(panel.getByRole('heading')).toHaveText('This part of the page could not be fetched');
  await context.unroute(/\/program-[^/]*\.js/);
  await panel.getByRole('button', { name: 'Try again' }).click();
  await expect(panel.getByRole('button', { name: 'Record here' })).toBeVisible();
});

test('the address says where the arm stands, in which units, and what stands beside it', async ({ page }) => {
  await open(page, 'robot=ur5&q=0.1,-1,1,0,0.5,0&units=m,rad&panels=view,jog,pose');
  expect(await page.evaluate(() => window.denavit.joints())).toEqual([0.1, -1, 1, 0, 0.5, 0]);
  await expect(page.getByLabel('Joint 2, radians')).toHaveValue('−1.000');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await expect(page.getByRole('tab')).toHaveCount(0);
  await expect(page.locator('.aim-panel')).toBeHidden();
  await page.setViewportSize({ width: 390, height: 700 });
  await expect(page.locator('.pose-panel')).toBeVisible();
  expect((await page.locator('.view').boundingBox())?.width).toBe(390);

  await open(page, 'panels=none&q=1,2');
  await expect(page.getByRole('alert')).toHaveText('?q was left out: it has 2 values, and Puma 560 has 6 joints.');
  await expect(page.getByRole('banner')).toBeHidden();
  expect(await page.locator('.view').boundingBox()).toEqual({ x: 0, y: 0, width: 390, height: 700 });
  await expect(page.getByRole('link', { name: 'Open in Denavit' })).toHaveAttribute('href', /q=1/);
});

test('the hint of the first visit goes at the first key and does not come back', async ({ page }) => {
  await page.goto('./?quality=low');
  const hint = page.getByRole('complementary', { name: 'Three ways to move this arm' });
  await expect(hint).toBeVisible();
  await expectAccessible(page, { within: '.hint' });
  await page.keyboard.press('Tab');
  await expect(hint).toBeVisible();
  await page.getByLabel('Joint 1', { exact: true }).focus();
  await page.keyboard.press('ArrowRight');
  await expect(hint).toHaveCount(0);
  await page.reload();
  await page.evaluate(() => window.denavit.ready);
  await expect(hint).toHaveCount(0);
});

test('the question mark opens the help, which gives the focus back', async ({ page }) => {
  await open(page);
  const first = page.getByLabel('Joint 1', { exact: true });
  await first.focus();
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help and about' });
  await expect(help).toContainText('right-handed');
  await expect(help).toContainText('was not run on a controller');
  await expect(help).toContainText('CtrlZ');
  await expectAccessible(page, { within: '.help' });
  await page.keyboard.press('Escape');
  await expect(help).toHaveCount(0);
  await expect(first).toBeFocused();
  await page.getByRole('button', { name: 'Help: keys, conventions, about' }).click();
  await expect(help).toBeVisible();
});
