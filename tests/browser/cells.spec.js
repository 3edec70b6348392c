/** Cells of the DH table: expressions, questions and refusals, the keys of a spreadsheet, a pasted table. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled, tool } from './page.js';

/** @typedef {import('@playwright/test').Page} Page */

const A2 = 'Joint 2, link length a, millimetres';
const ALPHA4 = 'Joint 4, link twist α, degrees';
const ALPHA4_RAD = 'Joint 4, link twist α, radians';

/** @param {Page} page @param {number} index */
const joint = (page, index) => page.evaluate((i) => window.denavit.model().joints[i], index);

/** The names of scripts that the page has fetched. @param {Page} page */
const scripts = (page) =>
  page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name.replace(/.*\//, '')));

test('a length in inches and a root: text and value stand in the line, plain numbers fetch nothing', async ({
  page,
}) => {
  await open(page);
  const place = await tool(page);
  const cell = page.getByLabel(A2);
  const line = page.locator('#cell-line');
  await cell.fill('');
  await cell.pressSequentially('-5e2'); // key by key: what it begins with is no number yet
  await cell.fill('500');
  await cell.press('Enter');
  await settled(page);
  expect((await scripts(page)).filter((name) => /expression/i.test(name))).toEqual([]);

  await cell.fill('17 in');
  await expect(line).toContainText('17 in = 431.8 mm');
  (await tool(page)).forEach((value, i) => expect(value).toBeCloseTo(place[i], 12));
  await cell.press('Enter');
  expect((await scripts(page)).filter((name) => /expression/i.test(name))).not.toEqual([]);
  expect(await joint(page, 1)).toMatchObject({ a: 431.8, text: { a: '17 in' } });
  await expect(cell).toHaveValue('431.8');
  await cell.focus();
  await expect(cell).toHaveValue('17 in');
  await cell.fill('100√2');
  await expect(line).toContainText('100√2 ≈ 141.42135624 mm');
  await cell.fill('431.8');
  await cell.press('Enter');
  expect((await joint(page, 1)).text).toBeUndefined();
  for (let i = 0; i < 2; i++) await page.keyboard.press('Control+z');
  expect(await joint(page, 1)).toMatchObject({ a: 500 });
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('pi/2 among degrees asks which is meant, by keyboard too; in radians it is what it says', async ({ page }) => {
  await open(page);
  const cell = page.getByLabel(ALPHA4);
  const line = page.locator('#cell-line');
  const place = await tool(page);
  await cell.fill('-pi/2');
  await expect(line).toContainText('-pi/2 among degrees: which is meant?');
  await expect(line).toContainText('The arm waits with 90° until this is settled.');
  expect(await tool(page)).toEqual(place);
  await cell.press('Enter');
  await expect(line.getByRole('button', { name: '-π/2 rad = −90°' })).toBeFocused();
  await expectAccessible(page, { within: '#cell-line' });
  await page.keyboard.press('Enter');
  await expect(cell).toBeFocused();
  await expect(line).toContainText('-pi/2 rad = −90°');
  expect(await joint(page, 3)).toMatchObject({ alpha: -90, text: { alpha: '-pi/2 rad' } });
  await cell.fill('pi/2');
  await cell.blur();
  await line.getByRole('button', { name: '1.5708°' }).click();
  expect(await joint(page, 3)).toMatchObject({ alpha: Math.PI / 2, text: { alpha: 'pi/2 deg' } });

  const units = page.locator('.topbar').getByRole('button', { name: 'Units of the document' });
  await units.click();
  await page.getByRole('button', { name: 'Radians (rad)' }).click();
  const turned = page.getByLabel(ALPHA4_RAD);
  await turned.fill('pi/2');
  await turned.press('Enter');
  await expect(turned).toHaveValue('π/2');
  expect(await joint(page, 3)).toMatchObject({ alpha: Math.PI / 2, text: { alpha: 'pi/2' } });
});

test('a text that is none stays with its reason and its ways out, and the arm keeps its shape', async ({ page }) => {
  await open(page);
  const place = await tool(page);
  const cell = page.getByLabel(A2);
  const line = page.locator('#cell-line');
  await cell.fill('43l.8');
  await cell.blur();
  await expect(line).toContainText('“43l.8” is not a number');
  await expect(line).toContainText('Its letter l may be meant as 1. The arm keeps 431.8 mm.');
  await line.getByRole('button', { name: 'Use 431.8' }).click();
  await expect(cell).not.toHaveAttribute('aria-invalid');
  await cell.fill('90 deg');
  await cell.blur();
  await expect(cell).toHaveAttribute('aria-invalid', 'true');
  await expect(line).toContainText('This is an angle; a length is needed');
  expect(await tool(page)).toEqual(place);
  await page.getByLabel('Joint 2, link twist α, degrees').focus(); // the reason is told there, too
  await expect(line).toContainText('a2: “90 deg” is not a number');
  await line.getByRole('button', { name: 'To that cell' }).click({ delay: 120 }); // as slow as a hand
  await expect(cell).toBeFocused();
  await line.getByRole('button', { name: 'Take back' }).click({ delay: 120 });
  await expect(cell).toBeFocused();
  await expect(cell).toHaveValue('431.8');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  // of a joint that the next robot does not have
  const last = page.getByLabel('Joint 6, link length a, millimetres');
  await last.fill('90 deg');
  await last.blur();
  await expect(line).toContainText('This is an angle');
  await page.getByLabel('Joint 6, link offset d, millimetres').focus();
  await page.evaluate(() => window.denavit.load('planar2r'));
  await expect(line).not.toContainText('This is an angle');
  await expect(page.locator('#panel-robot [aria-invalid=true]')).toHaveCount(0);
});

test('the grid is walked, edited and left with keys alone; the pointer over a cell is told', async ({ page }) => {
  await open(page, 'robot=planar2r');
  const at = (/** @type {string} */ label) => expect(page.getByLabel(label)).toBeFocused();
  const { keyboard } = page;
  await page.getByLabel('Joint 1, link length a, millimetres').focus();
  await keyboard.press('Home');
  await at('Joint 1, joint angle θ, degrees');
  await keyboard.press('ArrowLeft');
  await expect(page.getByRole('button', { name: 'Joint 1, revolute: change or add' })).toBeFocused();
  await keyboard.press('Tab');
  await keyboard.press('End');
  await at('Joint 1, upper limit, degrees');
  await keyboard.press('Tab');
  await at('Joint 2, joint angle θ, degrees');
  await keyboard.press('Control+End');
  await at('Joint 2, upper limit, degrees');
  await keyboard.press('Control+Home');
  await keyboard.press('ArrowRight');
  await at('Joint 1, link offset d, millimetres');
  await keyboard.type('12');
  await keyboard.press('Enter');
  await at('Joint 2, link offset d, millimetres');
  await keyboard.press('F2');
  await keyboard.type('5');
  await keyboard.press('Home');
  await keyboard.press('ArrowLeft');
  await at('Joint 2, joint angle θ, degrees');
  await keyboard.press('ArrowRight');
  await keyboard.press('F2');
  await keyboard.type('.5');
  await keyboard.press('Shift+Enter');
  await at('Joint 1, link offset d, millimetres');
  expect([(await joint(page, 0)).d, (await joint(page, 1)).d]).toEqual([12, 5.5]);
  await keyboard.type('99');
  await keyboard.press('Escape');
  await expect(page.getByLabel('Joint 1, link offset d, millimetres')).toHaveValue('12');
  await keyboard.press('Control+End');
  await keyboard.press('Tab');
  await expect(page.getByRole('button', { name: 'Add joint' })).toBeFocused();
});

test('a pasted table is looked at, mended and fills the grid as one step; one number is pasted into its cell', async ({
  page,
}) => {
  await open(page);
  const cell = page.getByLabel(A2);
  const paste = (/** @type {string} */ text) =>
    cell.evaluate((input, given) => {
      const data = new DataTransfer();
      data.setData('text/plain', given);
      input.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
    }, text);
  await cell.focus();
  await paste('12 in');
  await paste('alpha\ta (m)\td (m)\ttheta\npi/2\t0\t0.3\tq1\n0\tL1\t0\tq2 + 90\n-90\t0\td3*\t0');
  const dialog = page.getByRole('dialog', { name: 'Paste a table' });
  await expect(dialog).toContainText('J2, a: “L1” has a symbol without a number.');
  const apply = dialog.getByRole('button', { name: 'Fill the table' });
  await expect(apply).toBeDisabled();
  const text = dialog.getByLabel('The table as text');
  await text.fill((await text.inputValue()).replace('L1', '0.25'));
  await expect(dialog).toContainText('6 joints become 3. J3: another type');
  await expect(dialog).toContainText('π is read in radians.');
  await expectAccessible(page, { within: '.paste-table' });
  await apply.click();
  await expect(dialog).toBeHidden();
  const joints = await page.evaluate(() => window.denavit.model().joints);
  expect(joints.map(({ type, theta, d, a, alpha }) => [type, theta, d, a, alpha])).toEqual([
    ['revolute', 0, 300, 0, 90],
    ['revolute', 90, 0, 250, 0],
    ['prismatic', 0, 0, 0, -90],
  ]);
  expect(joints[0].text).toEqual({ alpha: 'pi/2 rad' });
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  expect(await page.evaluate(() => window.denavit.model().joints.length)).toBe(6);
});
