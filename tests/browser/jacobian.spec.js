/** The Jacobian panel: two ways to the matrix, the step between them, how near the arm is to losing a motion, and torques. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { expectAccessible } from './accessible.js';
import { expectPicture, open, picture } from './page.js';

test.use({ reducedMotion: 'reduce' });

const panel = (/** @type {import('@playwright/test').Page} */ page) => page.locator('[data-room=jacobian]');
const joints = (/** @type {import('@playwright/test').Page} */ page) => page.evaluate(() => window.denavit.joints());

test('the step decides how far the difference is from the geometry, and the default is marked', async ({ page }) => {
  await open(page, 'q=-32,58,-168,24,52,-18');
  await page.getByRole('tab', { name: 'Jacobian' }).click();
  const geometry = page.getByRole('table', { name: 'By geometry' });
  await expect(geometry.locator('tbody tr').first().locator('td')).toHaveText([
    '459.85',
    '−169.12',
    '141.42',
    '0',
    '0',
    '0',
  ]);
  await expect(page.getByRole('table', { name: 'By forward difference, h = 1e−7 rad' })).toBeVisible();
  const plot = panel(page).getByRole('img');
  await expect(plot).toHaveAccessibleName(/At h = 1e−7 rad the largest difference is \d\.\de−8\./);
  const step = page.getByRole('textbox', { name: 'Step of the difference, radians' });
  await step.fill('1e-3');
  await step.press('Enter');
  await expect(plot).toHaveAccessibleName(/At h = 0\.001 rad the largest difference is \d\.\de−4\./);
  await panel(page).getByRole('button', { name: 'Central' }).click();
  await expect(plot).toHaveAccessibleName(/At h = 1e−5 rad the largest difference is \d\.\de−1\d\./);
  await step.fill('0');
  await step.press('Enter');
  await expect(panel(page)).toContainText('A step from 1e−15 to 1 rad, please');
  await step.fill('1e-4');
  await step.press('Enter');
  await panel(page).getByRole('button', { name: 'Default 1e−5' }).click();
  await panel(page).getByRole('group', { name: 'Along the axes of' }).getByRole('button', { name: 'Tool' }).click();
  await expect(geometry.locator('tbody tr').first().locator('td').first()).not.toHaveText('459.85');
  await panel(page).getByText('The plot as a table').click();
  await expect(panel(page).getByRole('row', { name: /^10⁻⁵/ })).toBeVisible();
  await expectAccessible(page, { within: '[data-room=jacobian]' });

  const files = [];
  for (const kind of ['SVG', 'PNG']) {
    const coming = page.waitForEvent('download');
    await panel(page)
      .getByRole('button', { name: `Save ${kind}` })
      .click();
    const download = await coming;
    expect(download.suggestedFilename()).toBe(`jacobian-error.${kind.toLowerCase()}`);
    files.push(await readFile(await download.path()));
  }
  const drawing = files[0].toString('utf8');
  expect(drawing).toMatch(/^<svg [^>]*xmlns="http:\/\/www\.w3\.org\/2000\/svg"/);
  expect(drawing).toMatch(/<polyline [^>]*stroke-dasharray="6px, 3px"/); // its own styles, not the page's
  expect(drawing).not.toContain('class=');
  const { width, height, data } = PNG.sync.read(files[1]);
  expect([width, height]).toEqual([3 * 372, 3 * 224]);
  expect(new Set(Array.from({ length: width * height }, (_, i) => data.readUInt32BE(4 * i))).size).toBeGreaterThan(20);
});

test('the gauge leads to the wrist singularity, the ellipsoid goes flat, and torques follow a typed force', async ({
  page,
}) => {
  await open(page, 'q=-32,58,-168,24,52,-18');
  await page.getByRole('tab', { name: 'Jacobian' }).click();
  await expect(page.getByRole('meter')).toHaveAttribute('aria-valuetext', 'wrist singularity 52.0° away');
  const before = await picture(page);
  await panel(page)
    .getByRole('group', { name: 'Ellipsoid in the scene' })
    .getByRole('button', { name: 'Velocity' })
    .click();
  await expectPicture(page, before, false);
  await expect(panel(page)).toContainText('Drawn: 1 m/s as 200 mm.');
  await panel(page).getByRole('button', { name: 'Go there' }).focus();
  await page.keyboard.press('Enter');
  await expect(panel(page)).toContainText('Singular here: wrist singularity.');
  await expect(panel(page)).toContainText('Lost here:');
  await expect(panel(page)).toContainText(/Joint rates that move nothing: J[46]\s[+−]0\.71, J[46]\s[+−]0\.71\./);
  expect((await joints(page))[4]).toBeCloseTo(0, 9);
  await page.keyboard.press('Control+z');
  expect((await joints(page))[4]).toBe(52);
  await page.getByRole('textbox', { name: 'Force along z, newtons, base axes' }).fill('-100');
  await page.keyboard.press('Enter');
  // the z column entry of joint 2 is 627.64 mm per radian
  await expect(panel(page).locator('.loads dd').nth(1)).toHaveText('−62.76 N·m');
});
