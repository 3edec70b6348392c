/** What shows how the arm moves: the trace of its tool. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { draws, open, settled, tool } from './page.js';

test('the trace is as long as the way of the tool, has gaps where it was not, and is cleared and switched off', async ({
  page,
}) => {
  await open(page, 'q=0,40,-150,0,30,0&trace=on');
  const line = page.getByRole('group', { name: 'Trace of the tool' });
  await expect(line).toContainText('move the arm');
  const [x, y] = await tool(page);
  const slider = page.getByRole('slider', { name: 'Joint 1', exact: true });
  await slider.focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowRight');
  const angle = await page.evaluate(() => window.denavit.joints()[0]);
  expect(angle).toBeGreaterThan(5);
  // an arc about the axis of joint 1
  const length = Math.hypot(x, y) * ((angle / 180) * Math.PI) * 1000;
  await expect(line).toContainText(`${length.toFixed(1)} mm`);
  await expect(page.locator('.trace-start')).toBeVisible();
  await page.getByRole('button', { name: 'Go to home', exact: true }).click();
  await slider.focus();
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(line).toContainText('in 2 strokes');
  await settled(page);
  const drawn = await draws(page);
  await settled(page);
  expect(await draws(page)).toBe(drawn); // at rest it costs nothing
  await expectAccessible(page, { within: '.trace-line' });

  await line.getByRole('button', { name: 'Clear', exact: true }).click();
  await expect(line).toContainText('move the arm');
  await expect(page.locator('.trace-start')).toBeHidden();
  await page.getByRole('button', { name: 'Frames', exact: true }).click();
  await page.getByRole('button', { name: 'No trace', exact: true }).click();
  await expect(line).toBeHidden();
  await expect(page.locator('canvas')).not.toHaveAttribute('aria-label', /trace/i);
});
