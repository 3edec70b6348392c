/** Every number in every convention: the pose in another frame and another form, copied, and joints beyond their limits. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled, shownPose } from './page.js';

/** @typedef {import('@playwright/test').Page} Page */

/** @param {Page} page @param {string} button @param {string | RegExp} choice */
async function choose(page, button, choice) {
  await page.locator(`.pose-panel [data-ask=${button}]`).click();
  await page.locator('.dropdown-menu.show').getByRole('button', { name: choice }).first().click();
  await settled(page);
}

/** What was copied last; the clipboard of a test is a variable. @param {Page} page */
const copied = (page) => page.evaluate(() => Reflect.get(window, 'copied'));

test.beforeEach(({ page }) =>
  page.addInitScript(() => {
    Object.defineProperty(navigator, 'clipboard', {
      value: { writeText: async (/** @type {string} */ text) => void Reflect.set(window, 'copied', text) },
    });
  }),
);

test('the same orientation by other names, with the free angle named at gimbal lock', async ({ page }) => {
  await open(page);
  const note = page.locator('.pose-note');
  await expect(note).toHaveText('W and R turn about one axis here; R is 0.');
  await page.locator('.pose-panel [data-ask=form]').click();
  await expect(page.locator('.dropdown-menu.show')).toBeVisible();
  await expectAccessible(page, { within: '.right' });
  await page.getByRole('button', { name: /^KUKA ABC/ }).click();
  await expect(page.locator('.pose-panel [data-ask=form]')).toHaveText('KUKA ABC');
  await expect(note).toHaveText('A and C turn about one axis here; A is 0.');
  await page.evaluate(() => window.denavit.setJoints([10, 45, -180, 0, 35, 30]));
  await expect(note).toBeHidden();
  await choose(page, 'form', /^Quaternion wxyz/);
  const parts = await Promise.all(['w', 'x', 'y', 'z'].map((name) => shownPose(page, name).textContent()));
  const length = Math.hypot(...parts.map((text) => Number(text?.replace('−', '-'))));
  expect(length).toBeCloseTo(1, 4);
  await choose(page, 'frames', 'frame 3');
  await expect(page.locator('.pose-panel [data-ask=frames]')).toHaveText('Frame 3 pose in world');
});

test('what is seen is what is copied, in the language that was chosen last', async ({ page }) => {
  await open(page);
  await page.evaluate(() => window.denavit.setJoints([10, 45, -170, 20, 35, 30]));
  await settled(page);
  await page.getByRole('button', { name: 'Copy the pose' }).click();
  await expect.poll(() => copied(page)).toContain('orientation FANUC WPR: W, P, R in deg, R = Rz(R) · Ry(P) · Rx(W)');
  await page.getByRole('button', { name: 'Matrix', exact: true }).click();
  await choose(page, 'copyMore', 'JSON');
  await expect.poll(() => copied(page)).toMatch(/^\{/);
  const { T_world_tool: rows } = JSON.parse(await copied(page));
  const pose = await page.evaluate(() => window.denavit.pose());
  rows.forEach((/** @type {number[]} */ row, /** @type {number} */ i) =>
    row.forEach((value, j) => expect(value).toBeCloseTo(pose[i][j] * (j === 3 && i < 3 ? 1000 : 1), 10)),
  );
  await expect(page.getByRole('table', { name: 'Matrix of the tool in world' })).toContainText(
    pose[0][0].toFixed(4).replace('-', '−'),
  );
  await choose(page, 'copyMore', 'The joint values');
  await expect.poll(async () => JSON.parse(await copied(page)).q?.values).toEqual([10, 45, -170, 20, 35, 30]);
  await page.getByRole('button', { name: 'Copy table' }).click();
  await page.getByRole('button', { name: 'Markdown' }).click();
  await expect(page.locator('.table-foot .note')).toHaveText('Copied the table as Markdown.');
  expect(await copied(page)).toContain('| 2 | q2 | 0 | 431.8 | 0 | -45 deg | 225 deg |');
  await page.getByRole('button', { name: 'Link transforms', exact: true }).click();
  await page.getByRole('group', { name: 'Link' }).getByRole('button').nth(1).click();
  await expect(page.locator('.link-values')).toContainText('431.80 mm');
  await expectAccessible(page, { within: '.right' });
});

test('a joint goes beyond its limits when told so, and the row, the page and the gauge say that it stands outside', async ({
  page,
}) => {
  await open(page);
  const q1 = () => page.evaluate(() => window.denavit.joints()[0]);
  const slider = page.getByLabel('Joint 1', { exact: true });
  await slider.focus();
  await page.keyboard.press('End');
  await page.keyboard.press('Shift+ArrowRight');
  expect(await q1()).toBe(160);
  await page.getByRole('switch', { name: 'Stop at limits' }).uncheck();
  await slider.focus();
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Alt+ArrowRight');
  expect(await q1()).toBeCloseTo(170.1, 9);
  await expect(slider).toHaveAttribute('aria-valuetext', '170.1°, outside');
  await expect(page.locator('.tag.dim')).toHaveText('J1 170.1°, outside');
  await expect(page.locator('#jog-reason')).toHaveText('J1 stands outside its limits, −160° to 160°.');
  await page.keyboard.press('Home');
  expect(await q1()).toBe(0);
  await page.getByRole('button', { name: 'Zero' }).click();
  expect(await page.evaluate(() => window.denavit.joints())).toEqual([0, 0, 0, 0, 0, 0]);
});

test('a screen reader hears the pose once the arm rests, not while it moves', async ({ page }) => {
  await open(page);
  const spoken = page.locator('[role=status]', { hasText: 'The tool is at' });
  await page.getByLabel('Joint 1', { exact: true }).focus();
  await page.keyboard.down('ArrowRight');
  await settled(page);
  await expect(spoken).toHaveCount(0);
  await page.keyboard.up('ArrowRight');
  await page.keyboard.press('Tab');
  await expect(spoken).toHaveText(/^The tool is at X 5\d\d\.\d\d mm, .*R -?\d/);
});
