/** The page's own manners: what is fetched when it is needed, and what is said when it cannot be. */
import { expect, test } from '@playwright/test';
import { open } from './page.js';

test('a panel that cannot be fetched says so, and comes when it is asked for again', async ({ page, context }) => {
  await open(page);
  page.removeAllListeners('console'); // the refused request is an error there
  await context.route(/programPanel/, (route) => route.abort());
  await page.getByRole('tab', { name: 'Program' }).click();
  const panel = page.getByRole('tabpanel', { name: 'Program' });
  await expect(panel.getByRole('heading')).toHaveText('This part of the page could not be fetched');
  await context.unroute(/programPanel/);
  await panel.getByRole('button', { name: 'Try again' }).click();
  await expect(panel.getByRole('button', { name: 'Record here' })).toBeVisible();
});
