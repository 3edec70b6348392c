/** Points, lines and critical postures of the workspace, as they are asked for. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled, tool } from './page.js';

test.use({ reducedMotion: 'reduce' });

test('a list of points, a line that stops, and a critical posture that the arm moves to', async ({ page }) => {
  await open(page);
  await page.getByRole('tab', { name: 'Workspace' }).click();
  await page.getByRole('button', { name: /^Volume/ }).click();
  await page.getByRole('button', { name: /^Points and lines/ }).click();
  const points = page.getByRole('textbox', { name: /^Points, one in a line/ });
  await points.fill('A 300 200 400\nB 300 two 400');
  await page.getByRole('button', { name: 'Ask', exact: true }).click();
  await expect(page.getByText('Line 2 is not three numbers', { exact: false })).toBeVisible();
  await points.fill('A 300 200 400\nfar 3000 0 0');
  await page.getByRole('button', { name: 'Ask', exact: true }).click();
  const list = page.getByRole('table', { name: 'Points that were asked for' });
  await expect(list.getByRole('row')).toHaveCount(3);
  await expect(page.getByText(/^It stops after \d+\.\d %, at .*out of reach\.$/)).toBeVisible();
  await page.getByRole('button', { name: /^Move to posture 1: / }).click();
  await expect.poll(async () => (await tool(page)).map((value) => Math.round(value * 1e3))).toEqual([300, 200, 400]);
  await page.getByRole('button', { name: 'Show the answer for far' }).click();
  await expect(page.getByText(/^far is out of reach: [\d.]+ mm are missing/)).toBeVisible();

  // a press in the view is a point, as long as it is picked there; later it chooses the point that is pressed
  await page.getByRole('button', { name: 'Pick in the view' }).click();
  const canvas = page.locator('canvas');
  await canvas.click({ position: { x: 330, y: 250 }, delay: 120 });
  await expect(list.getByRole('row')).toHaveCount(4);
  await page.keyboard.press('Escape');
  await canvas.click({ position: { x: 200, y: 250 } });
  await page.getByRole('button', { name: 'Show the answer for A' }).click();
  await canvas.click({ position: { x: 330, y: 250 } });
  await expect(list.getByRole('row')).toHaveCount(4);
  await expect(list.locator('[aria-current]')).toContainText('3');

  await page.getByRole('button', { name: /^One joint at a time/ }).click();
  await page.getByRole('button', { name: 'Draw all that J3 does from here' }).click();
  const stretched = page.getByRole('button', { name: /^Go to critical posture \d+: J2 and J3 stretched/ });
  await stretched.focus();
  await page.keyboard.press('Enter');
  // The elbow is straight with J3 at a right angle, but for its small offset.
  await expect.poll(async () => Math.abs((await page.evaluate(() => window.denavit.joints()))[2] + 90) < 5).toBe(true);

  // a number in the drawing is pressed, though the arm moves meanwhile and the drawing with it
  await page.locator('#fold-reach-teach-body .figure-dot').first().hover();
  await page.mouse.down();
  await page.evaluate(() => window.denavit.setJoints([0, 0, 0, 0, 0, 0]));
  await settled(page);
  await page.mouse.up();
  await expect.poll(() => page.evaluate(() => window.denavit.joints().some((value) => Math.abs(value) > 1))).toBe(true);
  await expectAccessible(page);
});
