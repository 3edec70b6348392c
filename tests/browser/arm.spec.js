/** The arm, its table and its joints: what a person changes is what the numbers and the picture show. */
import { expect, test } from '@playwright/test';
import { draws, expectPicture, open, picture, settled, shownPose, tool } from './page.js';

const A2 = 'Joint 2, link length a, millimetres';

test('a link length typed into the table changes the arm, its pose and its picture, and undo brings all back', async ({
  page,
}) => {
  await open(page);
  const [before, place] = [await picture(page), await tool(page)];
  await page.getByLabel(A2).fill('600');
  await page.keyboard.press('Enter');

  // The nominal posture of the Puma 560: q2 = 45°, so 168.2 mm of length move the tool by 118.93 mm forward and up.
  const longer = await tool(page);
  expect(longer[0] - place[0]).toBeCloseTo(0.1682 * Math.SQRT1_2, 9);
  expect(longer[2] - place[2]).toBeCloseTo(0.1682 * Math.SQRT1_2, 9);
  await expect(shownPose(page, 'X')).toHaveText('715.24');
  await expectPicture(page, before, false);

  await page.getByRole('button', { name: 'Undo: link length a of joint 2' }).click();
  await expect(page.getByRole('status').filter({ hasText: 'Undone: link length a of joint 2.' })).toBeAttached();
  expect(await tool(page)).toEqual(place);
  await expect(page.getByLabel(A2)).toHaveValue('431.8');
  await page.mouse.move(0, 0);
  await page.locator('canvas').evaluate((canvas) => canvas.blur());
  await expectPicture(page, before);
  await page.getByRole('button', { name: 'Redo' }).click();
  expect(await tool(page)).toEqual(longer);
});

/** Keys one by one with a frame between them, as hands do it. @param {import('@playwright/test').Page} page @param {string} text */
async function typeSlowly(page, text) {
  for (const key of text) {
    await page.keyboard.press(key);
    await settled(page);
  }
}

test('cells: typing moves the arm, Escape takes it back, and what is no number stays, marked, with its reason', async ({
  page,
}) => {
  await open(page);
  await test.step('the arm follows while a number is typed, and Escape leaves no trace', async () => {
    const place = await tool(page);
    await page.getByLabel(A2).click();
    await page.keyboard.type('500');
    expect((await tool(page))[0]).not.toBeCloseTo(place[0], 3);
    await page.keyboard.press('Escape');
    expect(await tool(page)).toEqual(place);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  });
  await test.step('a text that is no number stays, marked, with the reason beside it; the arm is as it was', async () => {
    const place = await tool(page);
    const cell = page.getByLabel(A2);
    await cell.fill('43l.8');
    await cell.blur();
    await expect(cell).toHaveAttribute('aria-invalid', 'true');
    await expect(cell).toHaveValue('43l.8');
    await expect(page.locator('#cell-line')).toContainText('“43l.8” is not a number');
    await expect(page.locator('#cell-line')).toContainText('The arm keeps 431.8 mm.');
    expect(await tool(page)).toEqual(place);
    await cell.fill('12,5');
    await cell.blur();
    await expect(page.locator('#cell-line')).toContainText('Decimals are written with a point: 12.5.');
    await cell.focus();
    await page.keyboard.press('Escape');
    await expect(cell).toHaveValue('431.8');
    await expect(cell).not.toHaveAttribute('aria-invalid');
  });
  await test.step('limits may not cross', async () => {
    const lower = page.getByLabel('Joint 1, lower limit, degrees');
    await lower.fill('170');
    await lower.blur();
    await expect(page.locator('#cell-line')).toContainText('The lower limit must not be above the upper one, 160.');
    expect(await page.evaluate(() => window.denavit.model().joints[0].lower)).toBe(-160);
  });
  await test.step('the table is walked with arrow keys, Enter and Tab', async () => {
    await page.getByLabel(A2).focus();
    await page.keyboard.press('ArrowDown');
    await expect(page.getByLabel('Joint 3, link length a, millimetres')).toBeFocused();
    await page.keyboard.press('ArrowLeft');
    await expect(page.getByLabel('Joint 3, link offset d, millimetres')).toBeFocused();
    await page.keyboard.type('160');
    await page.keyboard.press('Enter');
    await expect(page.getByLabel('Joint 4, link offset d, millimetres')).toBeFocused();
    await page.keyboard.press('Tab');
    await expect(page.getByLabel('Joint 4, link length a, millimetres')).toBeFocused();
    expect(await page.evaluate(() => window.denavit.model().joints[2].d)).toBe(160);
  });
});

test('a pull of a slider: one undo step, taken back by Escape', async ({ page }) => {
  await open(page);
  await test.step('Escape in the middle of a pull holds until the hand is off', async () => {
    const box = await page.getByLabel('Joint 1', { exact: true }).boundingBox();
    if (!box) throw new Error('The slider is not on the page.');
    const y = box.y + box.height / 2;
    await page.mouse.move(box.x + box.width / 2, y);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.7, y);
    await page.keyboard.press('Escape');
    await page.mouse.move(box.x + box.width * 0.8, y);
    await page.mouse.up();
    expect(await page.evaluate(() => window.denavit.joints())).toEqual([0, 45, -180, 0, 45, 0]);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  });
  await test.step('a pull of a slider moves the arm and is one undo step', async () => {
    const joints = () => page.evaluate(() => window.denavit.joints());
    const before = await joints();
    const place = await tool(page);
    const box = await page.getByLabel('Joint 1', { exact: true }).boundingBox();
    if (!box) throw new Error('The slider is not on the page.');
    const y = box.y + box.height / 2;
    await page.mouse.move(box.x + box.width / 2, y);
    await page.mouse.down();
    for (const part of [0.55, 0.6, 0.7]) await page.mouse.move(box.x + box.width * part, y);
    await expect(page.locator('.tag.dim')).toContainText('J1'); // the gauge with its value, while it is held
    await page.mouse.up();
    const [q1] = await joints();
    expect(q1).toBeGreaterThan(40);
    expect(await tool(page)).not.toEqual(place);
    await page.getByRole('button', { name: 'Undo' }).click();
    expect(await joints()).toEqual(before);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  });
});

test('joints by keys and numbers: a held key is one step, and a value beyond its stop is refused in words', async ({
  page,
}) => {
  await open(page);
  await test.step('home brings the arm home', async () => {
    const home = await page.evaluate(() => window.denavit.joints());
    await page.evaluate(() => window.denavit.setJoints([10, 20, 30, 40, 50, 60]));
    await page.getByRole('button', { name: 'Go to home' }).click();
    expect(await page.evaluate(() => window.denavit.joints())).toEqual(home);
  });
  await test.step('a held arrow key is one undo step, and the ends of the travel can be reached', async () => {
    const slider = page.getByLabel('Joint 1', { exact: true });
    await slider.focus();
    await page.keyboard.down('ArrowRight');
    for (let i = 0; i < 4; i++) await page.keyboard.down('ArrowRight'); // what the keyboard repeats while it is held
    await page.keyboard.up('ArrowRight');
    expect((await page.evaluate(() => window.denavit.joints()))[0]).toBeCloseTo(5, 9);
    await page.keyboard.press('Control+z');
    expect((await page.evaluate(() => window.denavit.joints()))[0]).toBe(0);
    await page.keyboard.press('End');
    expect((await page.evaluate(() => window.denavit.joints()))[0]).toBe(160);
  });
  await test.step('a joint is moved by keys alone, and a value beyond its stop is refused in words', async () => {
    await page.evaluate(() => window.denavit.setJoints([0, 45, -180, 0, 45, 0]));
    await page.getByLabel('Joint 1', { exact: true }).focus();
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
    expect((await page.evaluate(() => window.denavit.joints()))[0]).toBeCloseTo(5, 9);
    const field = page.getByLabel('Joint 2, degrees');
    await field.fill('226');
    await page.keyboard.press('Enter');
    await expect(page.locator('#jog-reason')).toHaveText('J2 stops at its limits: −45° to 225°.');
    expect((await page.evaluate(() => window.denavit.joints()))[1]).toBe(45);
    await page.keyboard.press('Escape');
    await expect(field).toHaveValue('45');

    await field.fill('pi/3');
    await page.keyboard.press('Enter');
    await expect(page.locator('#jog-reason')).toContainText('pi/3 among degrees: which is meant?');
    expect((await page.evaluate(() => window.denavit.joints()))[1]).toBe(45);
    await page.getByRole('button', { name: 'π/3 rad = 60°' }).click();
    await expect(field).toHaveValue('60');
    await expect(page.getByRole('button', { name: 'Undo: joint 2 moved' })).toBeEnabled();
  });
});

test('the view by keys, and no frames while nothing moves', async ({ page }) => {
  await open(page);
  await test.step('the view turns, moves and zooms by keys, and fits again', async () => {
    await page.locator('canvas').focus();
    const first = await picture(page);
    for (const key of ['ArrowLeft', '+', 'Shift+ArrowUp']) {
      const drawn = await draws(page);
      await page.keyboard.press(key);
      await settled(page);
      expect(await draws(page), key).toBe(drawn + 1);
    }
    await expectPicture(page, first, false);
    await page.keyboard.press('Home');
    await expectPicture(page, first);
  });
  await test.step('a still robot costs no frames', async () => {
    await settled(page);
    const drawn = await draws(page);
    for (let i = 0; i < 10; i++) await settled(page);
    expect(await draws(page)).toBe(drawn);
    await page.evaluate(() => window.denavit.setJoints([10, 45, -180, 0, 45, 0]));
    await settled(page);
    expect(await draws(page)).toBe(drawn + 1);
  });
});

test('what is being typed is left to the person who types it, whatever a script does', async ({ page }) => {
  await open(page);
  await test.step('a text that is no number on the way to one is left to the person who types it', async () => {
    const cell = page.getByLabel(A2);
    await cell.focus();
    await typeSlowly(page, '1e2');
    await expect(cell).toHaveValue('1e2');
    await page.keyboard.press('Enter');
    expect(await page.evaluate(() => window.denavit.model().joints[1].a)).toBe(100);

    const field = page.getByLabel('Joint 2, degrees');
    await field.focus();
    await typeSlowly(page, '230.5');
    await expect(field).toHaveValue('230.5');
    await page.keyboard.press('Enter');
    await expect(page.locator('#jog-reason')).toContainText('J2 stops at its limits: −45° to 225°.');
    expect((await page.evaluate(() => window.denavit.joints()))[1]).toBe(45);
  });
  await test.step('what was being typed for one arm never reaches the next', async () => {
    await page.getByLabel(A2).focus();
    await typeSlowly(page, '999');
    await page.evaluate(() => window.denavit.load('ur5'));
    await settled(page);
    expect(await page.evaluate(() => window.denavit.model().joints[1].a)).toBe(-425);
    await page.getByLabel('Joint 1, degrees').focus();
    await typeSlowly(page, '33');
    await page.evaluate(() => window.denavit.load('puma560'));
    await settled(page);
    expect((await page.evaluate(() => window.denavit.joints()))[0]).toBe(0);
  });
  await test.step('Escape takes a typed number back even if a script moved the arm in between', async () => {
    await page.getByLabel(A2).focus();
    await typeSlowly(page, '500');
    await page.evaluate(() => window.denavit.setJoints([1, 2, 3, 4, 5, 6]));
    await page.keyboard.press('Escape');
    expect(await page.evaluate(() => window.denavit.model().joints[1].a)).toBe(431.8);
  });
  await test.step('a limit is taken away by emptying its cell', async () => {
    await page.getByLabel('Joint 1, upper limit, degrees').fill('');
    await page.keyboard.press('Enter');
    expect(await page.evaluate(() => window.denavit.model().joints[0].upper)).toBeUndefined();
    await settled(page); // the row of the joint is made anew for its new limits
    await page.getByLabel('Joint 1, degrees').fill('300');
    await page.keyboard.press('Enter');
    expect((await page.evaluate(() => window.denavit.joints()))[0]).toBe(300);
  });
});
