/** The table as a whole: joints added, moved and retyped, other units, the other convention; each is one step to undo. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled, tool } from './page.js';

/** @param {import('@playwright/test').Page} page */
const table = (page) => page.evaluate(() => window.denavit.model().joints.map(({ id, type }) => `${id} ${type}`));

test('joints are added, moved, made to slide and removed by keys from the head of a row', async ({ page }) => {
  await open(page, 'robot=planar2r');
  const place = await tool(page);
  const note = page.locator('.table-foot .note');
  /** @param {string} joint @param {string} choice */
  const choose = async (joint, choice) => {
    await page.getByRole('button', { name: new RegExp(`^Joint ${joint},`) }).focus();
    await page.keyboard.press('Enter');
    await expect(page.getByRole('button', { name: choice })).toBeVisible();
    if (choice === 'Add a joint after J1') {
      await expectAccessible(page);
    }
    await page.getByRole('button', { name: choice }).focus();
    await page.keyboard.press('Enter');
    await settled(page); // the grid stands again
  };

  await choose('1', 'Add a joint after J1');
  await expect(note).toHaveText('J2 is added. Its zeros do not move the arm yet.');
  await expect(page.getByRole('button', { name: /^Joint 2,/ })).toBeFocused();
  expect(await table(page)).toEqual(['joint_1 revolute', 'joint_3 revolute', 'joint_2 revolute']);
  (await tool(page)).forEach((value, i) => expect(value).toBeCloseTo(place[i], 12));
  await expect(page.locator('.jog')).toHaveCount(3);

  await choose('2', 'Move J2 down');
  await choose('3', 'Slides (prismatic)');
  await expect(note).toHaveText('J3 slides now. Its limits, home and controller values are cleared.');
  expect(await table(page)).toEqual(['joint_1 revolute', 'joint_2 revolute', 'joint_3 prismatic']);
  await expect(page.getByLabel('Joint 3, lower limit, millimetres')).toHaveValue('');

  const add = page.getByRole('button', { name: 'Add joint' });
  for (let i = 0; i < 3; i++) await add.click();
  await expect(add).toBeDisabled();
  await expect(add).toHaveAccessibleDescription('A robot has at most six joints.');
  await choose('6', 'Remove J6');
  await expect(page.getByRole('button', { name: /^Joint 5,/ })).toBeFocused();
  for (let i = 0; i < 7; i++) await page.keyboard.press('Control+z');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  expect(await table(page)).toEqual(['joint_1 revolute', 'joint_2 revolute']);
  await page.getByRole('button', { name: /^Joint 1,/ }).click();
  const remove = page.getByRole('button', { name: 'Remove J1' });
  await expect(remove).toBeDisabled();
  await expect(remove).toContainText('A robot has at least two joints.');
});

test('units and convention convert the numbers and keep the robot; reading them otherwise says how far the tool moves', async ({
  page,
}) => {
  await open(page);
  const place = await tool(page);
  const same = async () => (await tool(page)).forEach((value, i) => expect(value).toBeCloseTo(place[i], 12));
  const units = page.locator('.topbar').getByRole('button', { name: 'Units of the document' });
  await units.click();
  await page.getByRole('button', { name: 'Metres (m)' }).click();
  await units.click();
  await page.getByRole('button', { name: 'Radians (rad)' }).click();
  await expect(units).toHaveText(/m · rad/);
  await expect(page.getByLabel('Joint 2, link length a, metres')).toHaveValue('0.4318');
  expect(await page.evaluate(() => window.denavit.model().joints[0].text)).toEqual({ alpha: 'pi/2' });
  await same();

  const convention = page.getByRole('button', { name: /^Convention:/ });
  await convention.click();
  await page.getByRole('button', { name: 'Convert to modified' }).click();
  await expect(convention).toHaveText(/Modified DH/);
  await expect(page.getByLabel('Joint 3, link length a, metres')).toHaveValue('0.4318');
  await expect(page.locator('.table-foot .note')).toContainText('the arm has not moved');
  await same();

  await page.keyboard.press('Control+z');
  await convention.click();
  await page.getByRole('button', { name: 'Read the numbers as modified' }).click();
  await expect(page.locator('.table-foot .note')).toContainText('The tool moved by 0.60179 m.');
  await settled(page);
  const [before, now] = [place, await tool(page)];
  expect(Math.hypot(...now.map((value, i) => value - before[i]))).toBeCloseTo(0.60179, 5);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  expect(await tool(page)).toEqual(place);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});
