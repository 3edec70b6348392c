/** Files and code: what leaves the page, and what may come in. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { open, openPostures, settled, tool } from './page.js';

/** @param {import('@playwright/test').Page} page @param {string} name @param {string | Buffer} content */
const choose = (page, name, content) =>
  page.locator('input[type=file]').setInputFiles({ name, mimeType: 'application/xml', buffer: Buffer.from(content) });

/** @param {import('@playwright/test').Page} page @param {() => Promise<void>} act */
async function saved(page, act) {
  const coming = page.waitForEvent('download');
  await act();
  const download = await coming;
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), 'utf8') };
}

/** @param {import('@playwright/test').Page} page */
const save = (page) =>
  saved(page, async () => {
    await page.getByRole('button', { name: 'File' }).click();
    await page.getByRole('button', { name: /^Save the robot/ }).click();
  });

test('a model is saved, opened on a fresh page, and saved again as the same bytes', async ({ page }) => {
  await open(page);
  await page.getByLabel('Joint 2, link length a, millimetres').fill('440.5');
  await page.keyboard.press('Enter');
  await page.evaluate(() => window.denavit.setJoints([12.5, 30, -150, 7, 33.25, -8]));
  await openPostures(page);
  await page.getByRole('button', { name: 'Keep this posture' }).click();
  const first = await save(page);
  expect(first.name).toBe('Puma-560.xml');
  const place = await tool(page);

  await open(page, 'robot=planar2r');
  await choose(page, first.name, first.text);
  await expect(page.getByRole('button', { name: /^Puma 560/ })).toBeVisible();
  expect(await page.evaluate(() => window.denavit.model().joints[1].a)).toBe(440.5);
  expect(await page.evaluate(() => window.denavit.joints())).toEqual([12.5, 30, -150, 7, 33.25, -8]);
  expect(await tool(page)).toEqual(place);
  expect((await save(page)).text).toBe(first.text);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('button', { name: /^Planar 2R/ })).toBeVisible();
});

test('a URDF is opened as the same arm, and goes out as one and in other formats, with what they lose', async ({
  page,
}) => {
  await open(page);
  const urdf = await readFile(new URL('../fixtures/urdf/kuka_kr6r900sixx.urdf', import.meta.url), 'utf8');
  await choose(page, 'kr6.urdf', urdf);
  await expect(page.getByRole('button', { name: /^kuka_kr6r900sixx/ })).toBeVisible();
  const place = await tool(page);
  const [x, y, z] = place; // upper arm and forearm stretched out along x
  expect([x, y, z]).toEqual([expect.closeTo(0.98, 9), expect.closeTo(0, 9), expect.closeTo(0.435, 9)]);
  await page.evaluate(() => window.denavit.load(window.denavit.urdf()));
  (await tool(page)).forEach((value, i) => expect(value).toBeCloseTo(place[i], 9));
  const said = await page.evaluate(async () => {
    const { denavit } = window;
    const files = await Promise.all(['denavit', 'urdf', 'sdf', 'mjcf', 'rlkin'].map((id) => denavit.file(id)));
    const losses = await denavit.losses('sdf');
    await denavit.load(files[4]);
    const other = await denavit.file('docx').catch((/** @type {Error} */ error) => error.message);
    return { files, losses, other };
  });
  expect(said.files.map((text) => /<(\w+)[ >]/.exec(text)?.[1])).toEqual([
    'robotModel',
    'robot',
    'sdf',
    'mujoco',
    'rlkin',
  ]);
  expect(said.losses[0]).toMatch(/^SDFormat has frames in m and rad and no table; the 6 rows/);
  expect(said.other).toBe('Expected one of denavit, urdf, sdf, mjcf, rlkin, got "docx".');
  (await tool(page)).forEach((value, i) => expect(value).toBeCloseTo(place[i], 9));
});

test('files that are refused, each in a sentence, with the open model as it was', async ({ page }) => {
  await open(page);
  await test.step('a bad file is refused in a sentence with its line, and the open model stays', async () => {
    const good = await page.evaluate(() => window.denavit.xml());
    const model = await page.evaluate(() => JSON.stringify(window.denavit.model()));
    await choose(page, 'my <b>arm</b>.xml', good.replace('a="431.8"', 'a="431,8"'));
    const dialog = page.getByRole('dialog');
    await expect(dialog).toContainText('my <b>arm</b>.xml was not opened');
    await expect(dialog).toContainText('Puma 560 is still here, unchanged.');
    await expect(dialog.locator('.issue-text')).toHaveText(/^Line \d+: .*431,8.*\.$/);
    await expect(dialog.locator('.snippet .here')).toContainText('a="431,8"');
    await dialog.getByRole('button', { name: 'Close' }).last().click();
    await expect(dialog).toBeHidden();
    expect(await page.evaluate(() => JSON.stringify(window.denavit.model()))).toBe(model);
    await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  });
  await test.step('a file that is no text, and one that is too large, are refused', async () => {
    await choose(page, 'photo.xml', Buffer.from([0x89, 0x50, 0x4e, 0x47, 0, 255, 254]));
    await expect(page.getByRole('dialog')).toContainText('photo.xml was not opened');
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden();
    await choose(page, 'huge.xml', Buffer.alloc(3_000_000, ' '));
    await expect(page.getByRole('dialog')).toContainText('expected at most');
  });
});

test('two recorded postures become a FANUC pair', async ({ page }) => {
  await open(page);
  await openPostures(page);
  await page.getByRole('button', { name: 'Keep this posture' }).click();
  await page.evaluate(() => window.denavit.setJoints([-30, 60, -170, 20, 40, 10]));
  await page.getByRole('button', { name: 'Keep this posture' }).click();
  await page.getByLabel('Name of posture 2').fill('pick');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'See the controller code' }).click();
  await expect(page.locator('.code')).toContainText('SET_JPOS_REG');
  const texts = /** @type {Record<string, string>} */ ({});
  page.on('download', async (download) => {
    texts[download.suggestedFilename()] = await readFile(await download.path(), 'utf8');
  });
  await page.getByRole('button', { name: 'Verify and save' }).click();
  await expect.poll(() => Object.keys(texts).length).toBe(2);
  const [karel, tp] = ['.kl', '.ls'].map(
    (end) => Object.entries(texts).find(([name]) => name.endsWith(end))?.[1] ?? '',
  );
  expect(karel).toMatch(/^PROGRAM /m);
  for (const value of ['-30.0', '60.0', '-170.0', '20.0', '40.0', '10.0']) expect(karel).toContain(`= ${value}`);
  expect(tp).toMatch(/:J PR\[1.*\] +\d+% FINE/);
  expect(tp).toMatch(/:J PR\[2.*\] +\d+% FINE/);
  await page.locator('.files').getByRole('button', { name: /\.ls$/i }).click();
  await expect(page.locator('.code')).toContainText('/PROG');
});

test('postures are renamed, gone to and deleted; a name that is taken is refused', async ({ page }) => {
  await open(page);
  await openPostures(page);
  await expect(page.getByText('Nothing recorded yet')).toBeVisible();
  await page.getByRole('button', { name: 'Keep this posture' }).click();
  const home = await page.evaluate(() => window.denavit.joints());
  await page.evaluate(() => window.denavit.setJoints([1, 2, 3, 4, 5, 6]));
  await page.getByRole('button', { name: 'Keep this posture' }).click();
  await page.getByLabel('Name of posture 2').fill('p1');
  await page.keyboard.press('Enter');
  await expect(page.locator('#program-reason')).toHaveText('Another posture is called "p1" already.');
  await page.getByRole('button', { name: 'Move the arm to p1' }).click();
  expect(await page.evaluate(() => window.denavit.joints())).toEqual(home);
  await page.getByRole('button', { name: 'Delete p2' }).click();
  await expect(page.getByLabel('Name of posture 2')).toHaveCount(0);
  await settled(page);
});

test('of two documents on their way the one asked for last wins', async ({ page }) => {
  await open(page);
  const name = await page.evaluate(async () => {
    const { denavit } = window;
    const slow = denavit.load(denavit.xml()).catch((error) => error.message);
    await denavit.load('ur5');
    return [await slow, denavit.model().name];
  });
  expect(name).toEqual(['Another document was opened in the meantime.', 'UR5']);
});

test('a press that ends the typing of a name is not lost', async ({ page }) => {
  await open(page);
  await openPostures(page);
  for (let i = 0; i < 2; i++) await page.getByRole('button', { name: 'Keep this posture' }).click();
  await page.getByLabel('Name of posture 1').fill('home');
  const button = page.getByRole('button', { name: 'See the controller code' });
  await button.hover();
  await page.mouse.down();
  await settled(page);
  await page.mouse.up();
  await expect(page.getByRole('tab', { name: 'Code' })).toBeFocused();
  await expect(page.locator('.code')).toContainText('PR[1]: home');
});
