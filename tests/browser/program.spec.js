/** Motion programs: recorded, put in order, edited, undone, saved and opened again; with the keyboard alone. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

/** The steps' names, in their order. @param {import('@playwright/test').Page} page */
const names = (page) => page.locator('.steps .step-name b');

test('four targets are recorded, put in order, edited, undone, saved and opened again', async ({ page }) => {
  await open(page);
  await page.getByRole('tab', { name: 'Program' }).click();
  const panel = page.locator('#panel-program');
  const record = panel.getByRole('button', { name: 'Record here' });
  await expect(panel.getByText('No moves yet')).toBeVisible();
  await record.click();
  await expect(names(page)).toHaveText(['home']);
  const go = (/** @type {number[]} */ q) => page.evaluate((values) => window.denavit.setJoints(values), q);
  await go([10, 45, -160, 0, 40, 0]);
  await record.click();
  await panel.getByRole('button', { name: 'Line', exact: true }).click();
  await go([20, 45, -160, 0, 40, 0]);
  await record.click();
  await panel.getByRole('button', { name: 'Arc', exact: true }).click();
  await panel.getByRole('button', { name: 'Record the way point' }).click();
  await go([40, 45, -160, 0, 40, 0]);
  await panel.getByRole('button', { name: 'Record the end' }).click();
  await expect(names(page)).toHaveCount(4);
  await expect(names(page).nth(3)).toContainText('via →');
  expect(await page.evaluate(() => window.denavit.xml())).toContain('<circularMove id="s4"');

  // a speed in the table, with a key to the next; the card shows the same
  const speed = page.getByLabel('Step 3, speed, millimetres per second');
  await speed.fill('120');
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Speed', { exact: true })).toHaveValue('250'); // step 4 is chosen now
  await page.getByLabel('End', { exact: true }).selectOption('CNT (share)');
  await expect(page.locator('.steps .step-end').last()).toHaveText('CNT 50');
  // the place that the arc goes through, by its numbers
  await page.getByText('Numbers of the place on the way', { exact: true }).click();
  await page.getByLabel('Z of the place on the way', { exact: true }).fill('512.5');
  await page.keyboard.press('Enter');
  expect(await page.evaluate(() => window.denavit.xml())).toMatch(/viaXyz="\S+ \S+ 512\.5"/);
  await expectAccessible(page, { within: '#panel-program' }); // with a step's card
  await page.getByLabel('Speed', { exact: true }).fill('-3');
  await page.keyboard.press('Enter');
  await expect(panel.getByText('expected a number above 0')).toBeVisible();
  await page.keyboard.press('Escape');

  // dragged by its number, and back by undo
  const before = await names(page).allTextContents();
  await page.locator('.steps [data-grip]').nth(3).dragTo(page.locator('.steps [data-grip]').nth(0));
  await expect(names(page).first()).toContainText('via →');
  await page.getByRole('button', { name: /^Undo: step/ }).click();
  await expect(names(page)).toHaveText(before);

  await page.getByRole('button', { name: 'File' }).click();
  const coming = page.waitForEvent('download');
  await page.getByRole('button', { name: /^Save the robot/ }).click();
  const text = await readFile(await (await coming).path(), 'utf8');
  await page.evaluate(() => window.denavit.load('planar2r'));
  await expect(panel.getByText('No moves yet')).toBeVisible();
  await page.evaluate((xml) => window.denavit.load(xml), text);
  await expect(names(page)).toHaveText(before);
  expect(await page.evaluate(() => window.denavit.xml())).toBe(text);

  // by the textbook: joint moves that go on through their targets, by the laws that go by those names
  await names(page).nth(0).click();
  const law = page.getByLabel('Time law', { exact: true });
  for (const [name, value] of [
    ['cubic spline through points', 'cubicSpline'],
    ['LSPB past points', 'parabolicBlends'],
    ['time-optimal', 'timeOptimal'],
  ]) {
    await law.selectOption(name);
    await expect.poll(() => page.evaluate(() => window.denavit.xml())).toContain(`law="${value}"`);
  }
  // the numbers of where it ends
  await page.getByText('Numbers of the target', { exact: true }).click();
  await page.getByLabel('J1 of the target', { exact: true }).fill('5');
  await page.keyboard.press('Enter');
  await expect(names(page).first()).not.toHaveText('home');
  expect(await page.evaluate(() => window.denavit.xml())).toContain('q="5 ');
});

test('with the keyboard alone: an example is opened, its steps are gone through, moved, copied, passed over and deleted, one and several', async ({
  page,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page);
  await page.getByRole('tab', { name: 'Program' }).focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Open an example' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: /^Pick and place/ })).toBeFocused();
  await page.keyboard.press('Enter');
  await expect(names(page)).toHaveCount(12);
  await page.getByRole('button', { name: /^1, joint move, home/ }).focus();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: /^3, linear move/ })).toHaveAttribute('aria-current', 'true');
  await expect(page.getByText('Step 3', { exact: true }).first()).toBeVisible(); // the ghost, and the card below
  const third = await names(page).nth(2).textContent();
  await page.keyboard.press('Alt+ArrowUp');
  await expect(names(page).nth(1)).toHaveText(third ?? '');
  await expect(page.getByRole('button', { name: /^2, linear move/ })).toBeFocused();
  await page.keyboard.press('Delete');
  await expect(names(page)).toHaveCount(11);
  await page.getByRole('button', { name: 'Go there' }).focus();
  const from = await page.evaluate(() => window.denavit.joints());
  await page.keyboard.press('Enter');
  await expect.poll(() => page.evaluate(() => window.denavit.joints())).not.toEqual(from);
  await page.getByRole('button', { name: /^Pass over: step/ }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('button', { name: /^Carry out again: step/ })).toBeFocused();

  // several at once: chosen with Shift, copied, pasted, moved, passed over, deleted
  await page.getByRole('button', { name: /^3, / }).focus();
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Shift+ArrowDown');
  await expect(page.getByRole('heading', { name: 'Steps 3 to 5' })).toBeVisible();
  await expect(page.locator('.steps tr.is-chosen')).toHaveCount(3);
  const all = await names(page).allTextContents();
  await page.keyboard.press('Control+c');
  await page.keyboard.press('Control+v');
  await expect(names(page)).toHaveText([...all.slice(0, 5), ...all.slice(2, 5), ...all.slice(5)]);
  await expect(page.getByRole('button', { name: /^8, .*, chosen/ })).toBeFocused();
  await page.keyboard.press('Alt+ArrowUp');
  await expect(page.getByRole('heading', { name: 'Steps 5 to 7' })).toBeVisible();
  await expect(page.getByRole('button', { name: /^7, / })).toBeFocused();
  await page.getByRole('button', { name: 'Pass over: steps 5 to 7' }).press('Enter');
  await expect(page.getByRole('button', { name: 'Carry out again: steps 5 to 7' })).toBeFocused();
  await page.getByRole('button', { name: /^7, .*passed over/ }).focus();
  await page.keyboard.press('Delete');
  await expect(names(page)).toHaveText(all);
  // where fingers choose: the first, the button, the last
  await names(page).nth(1).click();
  await page.getByRole('button', { name: 'Choose several steps' }).click();
  await names(page).nth(3).click();
  await expect(page.getByRole('heading', { name: 'Steps 2 to 4' })).toBeVisible();
  await settled(page);
});
