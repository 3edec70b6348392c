/** Choosing among the postures for a pose, and accepting the nearest where there is none. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled, tool } from './page.js';

const HERE = 'q=-32,58,-168,24,52,-18';
const rows = (/** @type {import('@playwright/test').Page} */ page) =>
  page.getByRole('listbox', { name: 'Solutions of the target' }).getByRole('option');
const joints = (/** @type {import('@playwright/test').Page} */ page) => page.evaluate(() => window.denavit.joints());

test.use({ reducedMotion: 'reduce' });

test('the third of eight solutions: a ghost while it is looked at, and the arm goes there with the tool in its place', async ({
  page,
}) => {
  await open(page, HERE);
  const place = await tool(page);
  await page.getByRole('button', { name: /^Solutions/ }).click();
  await expect(rows(page)).toHaveCount(8);
  await rows(page).nth(2).hover();
  await expect(page.locator('.tag.ghost')).toHaveText('3 front, down, no flip');
  await rows(page).nth(2).click();
  await expect(rows(page).nth(2)).toHaveAttribute('aria-selected', 'true');
  const now = await tool(page);
  now.forEach((value, i) => expect(value).toBeCloseTo(place[i], 9));
  expect((await joints(page))[2]).not.toBeCloseTo(-168, 0);
  await expectAccessible(page, { within: '.aim-panel' });
  await page.keyboard.press('Control+z');
  expect(await joints(page)).toEqual([-32, 58, -168, 24, 52, -18]);
});

test('by keys alone: open, look, filter, go', async ({ page }) => {
  await open(page, HERE);
  await page.getByRole('button', { name: /^Solutions/ }).focus();
  await page.keyboard.press('Enter');
  await expect(rows(page)).toHaveCount(8);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Space');
  await expect(rows(page)).toHaveCount(5);
  await page.keyboard.press('Tab');
  await expect(rows(page).first()).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await expect(page.locator('.tag.ghost')).toContainText('2 ');
  await page.keyboard.press('Enter');
  await expect(rows(page).nth(1)).toHaveAttribute('aria-selected', 'true');
  await expect(page.locator('.tag.ghost')).toHaveCount(0);
});

test('a target out of reach has no solutions, and the nearest pose is one click away', async ({ page }) => {
  await open(page, HERE);
  await page.getByRole('button', { name: /^Solutions/ }).click();
  await expect(rows(page)).toHaveCount(8);
  await page.getByLabel('Target X, millimetres').fill('3000');
  await page.keyboard.press('Enter');
  await expect(page.locator('.aim-panel')).toContainText('No posture takes the tool to this pose.');
  await page.getByRole('button', { name: 'Go as near as found' }).click();
  await expect(page.locator('.tag.miss').filter({ hasText: 'mm' })).toBeVisible();

  // an arm whose solutions are searched for, which takes a while: what stands there is not what was found before
  const joints = [1, 2, 3, 4, 5].map(
    (i) => `<joint id="j${i}" type="revolute"><dh theta="0" d="0" a="100" alpha="0"/></joint>`,
  );
  await page.evaluate(
    (chain) =>
      window.denavit.load(
        `<robotModel xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="mm" angleUnit="deg" convention="standard"><chain>${chain}</chain></robotModel>`,
      ),
    joints.join(''),
  );
  const head = page.getByRole('button', { name: /^Solutions/ });
  await page.evaluate(() => window.denavit.setJoints([10, 60, 50, 40, 30]));
  await expect(head).toContainText('a line');
  await page.getByLabel('Target Z, millimetres').fill('50');
  await settled(page); // the search has begun
  await page.keyboard.press('Enter');
  await expect(head).toContainText('none for this pose');
});
