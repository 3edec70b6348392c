/** Aiming: a typed pose, inverse kinematics, and the verdict in words. */
import { expect, test } from '@playwright/test';
import { open, tool } from './page.js';

/** @param {import('@playwright/test').Page} page @param {Record<string, number>} numbers */
async function aimAt(page, numbers) {
  for (const [name, value] of Object.entries(numbers)) {
    await page.getByLabel(new RegExp(`^Target ${name},`)).fill(String(value));
  }
  await page.getByRole('button', { name: 'Move there' }).click();
}

test('a target out of reach says by how much, leaves the arm, and offers the nearest', async ({ page }) => {
  await open(page);
  const place = await tool(page);
  await aimAt(page, { X: 3000 });
  await expect(page.locator('.verdict-line')).toContainText('Out of reach, by at least');
  expect(await tool(page)).toEqual(place);
  // drawn before it is done: the arm as near as it can be, and what is missing then
  await expect(page.locator('.tag.ghost')).toHaveText('as near as found');
  await expect(page.locator('.tag.miss')).toHaveText(/^\d+\.\d\d mm$/);
  const short = await page.locator('.tag.miss').textContent();
  await page.getByRole('button', { name: 'Go as near as found' }).click();
  await expect(page.locator('.tag.ghost')).toHaveCount(0);
  await expect(page.locator('.tag.miss').filter({ hasText: 'mm' })).toHaveText(short ?? '');
  expect((await tool(page))[0]).toBeGreaterThan(0.8);
  await expect(page.locator('.tag.miss').filter({ hasText: 'mm' })).toBeVisible();
  await expect(page.locator('.lost-line')).toContainText('Lost here: moving along X 1.00');
  await expect(page.locator('.tag.miss').filter({ hasText: 'no motion this way' })).toBeVisible();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.locator('.lost-line')).toBeHidden();
});

test('an arm with four joints meets what it can, and says what that is', async ({ page }) => {
  await open(page, 'robot=scara_cobra600');
  await aimAt(page, { X: 450, Y: 100, Z: 300, W: 150, P: 0, R: 40 });
  await expect(page.locator('.verdict-line')).toContainText(
    'Met as far as this arm can: the position and the turn about the arm’s first axis.',
  );
  const [x, y, z] = await tool(page);
  for (const [value, wanted] of [[x, 0.45], [y, 0.1], [z, 0.3]]) expect(value).toBeCloseTo(wanted, 8); // prettier-ignore
});

test('a field that holds no number is marked, and nothing moves', async ({ page }) => {
  await open(page);
  await aimAt(page, { X: 400 });
  const place = await tool(page);
  await page.getByLabel('Target Z, millimetres').fill('high');
  await page.keyboard.press('Enter');
  await expect(page.locator('#aim-reason')).toContainText('“high” is not a number');
  await expect(page.getByLabel('Target Z, millimetres')).toBeFocused();
  expect(await tool(page)).toEqual(place);
});

test('the fields of the target: they follow the tool until someone types, and texts in them wait to be mended', async ({
  page,
}) => {
  await open(page);
  await test.step('the fields follow the tool until someone types, and again when asked', async () => {
    const x = page.getByLabel('Target X, millimetres');
    await page.evaluate(() => window.denavit.setJoints([0, 0, 0, 0, 0, 0]));
    await expect(x).toHaveValue('452.10');
    await x.fill('400');
    await page.evaluate(() => window.denavit.setJoints([0, 45, -180, 0, 45, 0]));
    await expect(x).toHaveValue('400');
    await page.getByRole('button', { name: 'Take the tool pose' }).click();
    await expect(x).toHaveValue('596.30');
  });
  await test.step('texts in the target wait to be mended, and tabbing through changes nothing', async () => {
    const x = page.getByLabel('Target X, millimetres');
    await x.focus();
    for (let i = 0; i < 5; i++) await page.keyboard.press('Tab');
    await expect(x).toHaveValue('596.30');
    await x.fill('450,5');
    await page.keyboard.press('Tab');
    await expect(x).toHaveAttribute('aria-invalid', 'true');
    await page.getByLabel('Target Y, millimetres').fill('100');
    await page.keyboard.press('Tab');
    await expect(x).toHaveValue('450,5');
    await expect(page.locator('#aim-reason')).toContainText('Decimals are written with a point: 450.5.');
    await page.getByRole('button', { name: 'Move there' }).click();
    expect(await page.evaluate(() => window.denavit.joints())).toEqual([0, 45, -180, 0, 45, 0]);
  });
});

test('a typed pose takes the arm there, and by how much it would be past a limit', async ({ page }) => {
  await open(page);
  await test.step('undo after "Move there" by Enter takes the move back', async () => {
    await page.getByLabel('Target X, millimetres').fill('500');
    await page.keyboard.press('Enter');
    await expect(page.locator('.verdict-line')).toHaveText('Reached: 0.00 mm, 0.00° off.');
    await page.keyboard.press('Control+z');
    expect(await page.evaluate(() => window.denavit.joints())).toEqual([0, 45, -180, 0, 45, 0]);
  });
  await test.step('a typed pose takes the arm there', async () => {
    await aimAt(page, { X: 450, Y: 100, Z: 900, W: 180, P: 0, R: 30 });
    await expect(page.locator('.verdict-line')).toHaveText('Reached: 0.00 mm, 0.00° off.');
    const pose = await page.evaluate(() => window.denavit.pose());
    // Tool straight down, turned by 30° about the vertical, written out by hand.
    const [c, s] = [Math.cos(Math.PI / 6), 0.5];
    const expected = [[c, s, 0, 0.45], [s, -c, 0, 0.1], [0, 0, -1, 0.9], [0, 0, 0, 1]]; // prettier-ignore
    pose.forEach((row, i) => row.forEach((value, j) => expect(value).toBeCloseTo(expected[i][j], 8)));
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(page.locator('.verdict-line')).toContainText('to go.');
  });
  await test.step('a target that only a joint past its limit would reach says by how much, on the joint’s dial too', async () => {
    await aimAt(page, { X: -300, Y: -500, Z: 100, W: 0, P: 0, R: 0 });
    await expect(page.locator('.verdict-line')).toContainText(
      'Only outside the limits: J2 would have to go 22.1° past',
    );
    await expect(page.locator('.tag.miss').filter({ hasText: 'J2 +22.1°' })).toBeVisible();
  });
});

test('a pose pasted in KUKA’s way is looked at, aimed at, shown as a quaternion and turned straight down', async ({
  page,
}) => {
  await open(page);
  const x = page.getByLabel('Target X, millimetres');
  await x.focus();
  await x.evaluate((field) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text', '{X 450, Y 100, Z 900, A 90, B 0, C 180, S 2, T 35}');
    field.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  });
  await expect(page.getByRole('group', { name: 'The target that comes of it' })).toContainText('450.00');
  await expect(page.getByLabel('What the numbers are')).toHaveValue('abc');
  const text = page.getByLabel('A pose as text');
  await text.fill('450 100 900 0 0 3 4');
  await expect(page.locator('.aim-apart .reason')).toHaveText('A quaternion has the length 1; this one has 5.');
  await expect(page.getByRole('button', { name: 'Use as target' })).toBeDisabled();
  await page.getByRole('button', { name: 'Divide by its length' }).click();
  await page.getByRole('button', { name: 'Use as target' }).click();
  await page.locator('.aim-panel [data-ask=form]').click();
  await page.getByRole('button', { name: 'Quaternion xyzw' }).click();
  const turn = page.getByLabel('Target, Quaternion xyzw: x y z w');
  await expect(turn).toHaveValue('0  0  0.60000  0.80000');
  await page.locator('.aim-panel [data-ask=helpers]').click();
  await page.getByRole('button', { name: 'Straight down' }).click();
  await page.getByRole('button', { name: 'Move there' }).click();
  await expect(page.locator('.verdict-line')).toHaveText('Reached: 0.00 mm, 0.00° off.');
  const pose = await page.evaluate(() => window.denavit.pose());
  [0, 0, -1, 0].forEach((value, k) => expect(pose[k][2]).toBeCloseTo(value, 8));
  [0.45, 0.1, 0.9].forEach((value, k) => expect(pose[k][3]).toBeCloseTo(value, 8));
});
