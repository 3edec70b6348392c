/** User frames and tools: added, named, typed, chosen, used for jogging and targets, changed with either end kept, undone. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, tool } from './page.js';

/** @typedef {import('@playwright/test').Page} Page */

/** @param {Page} page */
async function openFrames(page) {
  await page.locator('#fold-frames').click();
  await expect(page.getByRole('radio', { name: 'Use the world, no user frame' })).toBeChecked();
}

/** Adds one by a way of the menu, and calls it so. @param {Page} page @param {string} what @param {string} way @param {string} name */
async function add(page, what, way, name) {
  await page.getByRole('button', { name: `Add a ${what}` }).click();
  await page.getByRole('button', { name: way }).click();
  const field = page.getByRole('textbox', { name: new RegExp(`^Name of ${what}`) }).last();
  await expect(field).toBeFocused();
  await field.fill(name);
  await field.press('Enter');
  await expect(page.getByRole('radio', { name: `Use the ${what} ${name}` })).toBeVisible();
}

/** @param {Page} page @param {string} label @param {string} value */
async function type(page, label, value) {
  const field = page.getByRole('textbox', { name: label });
  await field.fill(value);
  await field.press('Enter');
}

test('a tool is made and chosen; another keeps the flange or the TCP, and undo takes it back', async ({ page }) => {
  await open(page);
  await openFrames(page);
  await add(page, 'tool', 'By numbers', 'gripper');
  await type(page, 'gripper, Z, millimetres', '120');
  const [x, y, z] = await tool(page);
  await page.getByRole('radio', { name: 'Use the tool gripper' }).check();
  // the flange of the home posture looks along the world's x
  await expect.poll(async () => (await tool(page))[0]).toBeCloseTo(x + 0.12, 9);
  await expect(page.locator('#fold-tool')).toContainText('z 120 mm');

  await page.getByRole('button', { name: 'keeps the TCP' }).click();
  const tip = await tool(page);
  const posture = await page.evaluate(() => window.denavit.joints());
  await page.getByRole('radio', { name: 'Use no tool, the flange itself' }).check();
  await expect.poll(() => page.evaluate(() => window.denavit.joints())).not.toEqual(posture);
  (await tool(page)).forEach((value, k) => expect(value).toBeCloseTo(tip[k], 5));
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('radio', { name: 'Use the tool gripper' })).toBeChecked();
  expect(await page.evaluate(() => window.denavit.joints())).toEqual(posture);

  await page.getByRole('button', { name: 'Remove gripper' }).click();
  await expect(page.locator('#fold-tool')).toContainText('none; the flange itself');
  (await tool(page)).forEach((value, k) => expect(value).toBeCloseTo([x, y, z][k], 9));
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('radio', { name: 'Use the tool gripper' })).toBeChecked();
  await expectAccessible(page, { within: '#fold-frames-body' });
});

test('a user frame is offered where axes are chosen, and its targets move with it', async ({ page }) => {
  await open(page);
  await openFrames(page);
  await expect(page.getByRole('button', { name: 'User', exact: true })).toBeHidden();
  await add(page, 'user frame', 'At the tool', 'part');
  await page.getByRole('radio', { name: 'Use the user frame part' }).check();
  await expect(page.getByRole('button', { name: 'User', exact: true })).toBeVisible(); // of the handle
  await expect(page.locator('.tag.frame-name')).toHaveText('part');
  await page.locator('#fold-targets').click();
  await page.getByRole('button', { name: 'Keep this target' }).click();
  await expect(page.locator('.targets li')).toContainText('part');
  await type(page, 'part, X, millimetres', '500');
  await page.getByRole('button', { name: 'Aim at aim_1' }).click();
  await expect(page.getByLabel(/^Target X,/)).toHaveValue('500');
  // a helper finds the kept target where it stands in the world
  await page.getByLabel(/^Target X,/).fill('450');
  await page.locator('.aim-panel [data-ask=helpers]').click();
  const places = page.getByRole('group', { name: 'The orientation stays; at the place of' });
  await places.getByRole('button', { name: 'aim_1', exact: true }).click();
  await expect(page.getByLabel(/^Target X,/)).toHaveValue('500');

  // the same target, told as a controller tells it in its user frame
  await page.locator('.aim-panel').getByRole('button', { name: 'in world' }).click();
  await page.getByRole('button', { name: 'in part the active user frame' }).click();
  await expect(page.getByLabel(/^Target X,/)).toHaveValue('0');
  await page.getByLabel(/^Target Z,/).fill('-40');
  await page.getByRole('button', { name: 'Move there' }).click();
  await expect(page.locator('.verdict-line')).toContainText('Reached');
  await expect(page.getByLabel(/^Target Z,/)).toHaveValue('−40');

  const name = page.getByRole('textbox', { name: 'Name of user frame part' });
  await name.fill('a part');
  await name.press('Enter');
  await expect(page.locator('#frames-reason')).toContainText('A name is a letter');
  await name.press('Escape');

  await page.getByRole('button', { name: 'Add a user frame' }).click();
  await page.getByRole('button', { name: 'By three points' }).click();
  await expect(page.getByRole('button', { name: 'Take the TCP as: Origin' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(page.locator('.tag.taught')).toHaveText(['1']);
  await page.getByRole('button', { name: 'Make the frame' }).click();
  await expect(page.getByText('Not taken yet: On the X axis.', { exact: true }).first()).toBeVisible();
  await expectAccessible(page, { within: '#fold-frames-body' });
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.locator('.tag.taught')).toHaveCount(0);

  // on the pendant: the tool and the user frame are chosen beside the buttons, by keys
  const jog = page.locator('.jog-panel');
  await jog.getByRole('button', { name: 'Tool', exact: true }).click();
  await jog.getByRole('button', { name: 'User frame 1 part' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: 'World the world’s own axes' })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(jog.getByRole('button', { name: 'User frame world' })).toBeFocused();
  await expect(page.getByRole('radio', { name: 'Use the world, no user frame' })).toBeChecked();
  await expect(page.locator('.aim-panel').getByRole('button', { name: /^in / })).toHaveCount(0);
  await page.keyboard.press('Control+z');
  await expect(jog.getByRole('button', { name: 'User frame 1 part' })).toBeVisible();
});
