/** The ways in and out: drop, paste, and what is said of what cannot be opened. */
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { PNG } from 'pngjs';
import { open, openPostures, tool } from './page.js';

const fixture = (/** @type {string} */ name) => fileURLToPath(new URL(`../fixtures/${name}`, import.meta.url));

/** Files held over the middle of the page, by the browser itself. @param {import('@playwright/test').Page} page */
async function dragging(page) {
  const browser = await page.context().newCDPSession(page);
  /** @param {'dragEnter' | 'dragOver' | 'dragCancel' | 'drop'} type @param {string[]} files */
  return (type, files) =>
    browser.send('Input.dispatchDragEvent', {
      type,
      x: 600,
      y: 300,
      data: { items: [], files, dragOperationsMask: 1 },
    });
}

/** @param {import('@playwright/test').Page} page @param {Record<string, string>} data  text by type */
const paste = (page, data) =>
  page.evaluate((all) => {
    const clipboardData = new DataTransfer();
    for (const [type, text] of Object.entries(all)) clipboardData.setData(type, text);
    (document.activeElement ?? document.body).dispatchEvent(
      new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
    );
  }, data);

test('a URDF is dropped on the page and opens as one change; a folder, two files and a bomb are refused in a sentence', async ({
  page,
}) => {
  await open(page);
  const drag = await dragging(page);
  const kuka = [fixture('urdf/kuka_kr6r900sixx.urdf')];
  await drag('dragEnter', kuka);
  await drag('dragOver', kuka);
  await expect(page.locator('.drop-target')).toContainText('Drop the file to open it');
  await drag('dragCancel', kuka);
  await expect(page.locator('.drop-target')).toHaveCount(0);
  await drag('dragEnter', kuka);
  await drag('drop', kuka);
  await expect(page.getByRole('button', { name: /^kuka_kr6r900sixx/ })).toBeVisible();
  expect((await tool(page))[0]).toBeCloseTo(0.98, 9);
  await expect(page.locator('.drop-target')).toHaveCount(0);

  const model = await page.evaluate(() => JSON.stringify(window.denavit.model()));
  const dialog = page.getByRole('dialog');
  for (const [files, title, sentence] of /** @type {const} */ ([
    [[fixture('urdf')], 'urdf was not opened', 'This is a folder; expected one robot file.'],
    [[...kuka, fixture('urdf/ur5.urdf')], 'A set of 2 files was not opened', /^2 files came at once; expected one/],
    [
      [fixture('urdf/bad/0177_dtd_billion-laughs_urdf2.urdf')],
      '0177_dtd_billion-laughs_urdf2.urdf was not opened',
      /^Line \d+: the file has a document type declaration, <!DOCTYPE; expected none, .*\.$/,
    ],
  ])) {
    await drag('dragEnter', [...files]);
    await drag('drop', [...files]); // on the dialog of the one before, which makes room
    await expect(dialog.getByRole('heading')).toHaveText(title);
    await expect(dialog.locator('.issue-text')).toHaveText(sentence);
  }
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  expect(await page.evaluate(() => JSON.stringify(window.denavit.model()))).toBe(model);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('button', { name: /^Puma 560/ })).toBeVisible();
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('a robot file is pasted as text where no field has the focus; other drags and pastes are left alone', async ({
  page,
}) => {
  await open(page);
  const ur5 = await readFile(fixture('urdf/ur5.urdf'), 'utf8');
  await page.getByRole('textbox', { name: 'Joint 2, link length a, millimetres' }).focus();
  await paste(page, { 'text/plain': 'no robot' });
  const a2 = await page.evaluate(() => window.denavit.model().joints[1].a);
  await paste(page, { 'text/plain': ur5 }); // into the cell, where it may be a slip of the hand
  await expect(page.locator('.notice')).toContainText('What was pasted is a robot file; the field is as it was.');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  expect(await page.evaluate(() => window.denavit.model().joints[1].a)).toBe(a2);
  await page.getByRole('button', { name: 'Open it', exact: true }).click();
  await expect(page.getByRole('button', { name: /^ur5/ })).toBeVisible();
  await page.evaluate(() => window.denavit.undo());
  await page.evaluate(() => document.activeElement instanceof HTMLElement && document.activeElement.blur());
  await paste(page, { 'text/plain': '12.5' });
  await paste(page, { 'text/plain': '<robot name="nothing"/>' });
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByRole('heading')).toHaveText('The pasted text was not opened');
  await paste(page, { 'text/plain': ur5 });
  await expect(page.getByRole('button', { name: /^ur5/ })).toBeVisible();
  await expect(dialog).toHaveCount(0);

  const taken = await page.evaluate(() => {
    /** @param {string} type @param {Record<string, string>} data @param {EventTarget} [target] */
    const send = (type, data, target = document.body) => {
      const dataTransfer = new DataTransfer();
      for (const [kind, text] of Object.entries(data)) dataTransfer.setData(kind, text);
      return !target.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    };
    const text = { 'text/plain': 'https://example.org/robot.urdf' };
    const field = document.querySelector('.grid input') ?? document.body;
    send('dragstart', text);
    const own = send('dragover', text);
    send('dragend', text);
    return [own, send('dragover', text, field), send('dragover', { 'text/x-own': 'a row' }), send('drop', text)];
  });
  expect(taken).toEqual([false, false, false, true]);
  await expect(dialog.locator('.issue-text')).toHaveText(/^This is the address of something, .*\.$/);
});

test('a URDF or an SDFormat file with a choice is asked about: base, tip and nearly parallel axes, with what results; Escape changes nothing', async ({
  page,
}) => {
  await open(page);
  /** @param {string} name @param {string} content */
  const choose = (name, content) =>
    page.locator('input[type=file]').setInputFiles({ name, mimeType: '', buffer: Buffer.from(content) });
  const scara = await readFile(fixture('urdf/yguel_scara.urdf'), 'utf8');
  const dialog = page.getByRole('dialog');
  await choose('scara.urdf', scara);
  await expect(dialog).toContainText(
    /Axes 2 and 3 are 0\.091° from parallel; treating them as parallel moves the tool by at most 0\.48 mm/,
  );
  await expect(dialog.getByRole('cell', { name: 'joint2', exact: true })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(dialog).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await expect(page.getByRole('button', { name: /^Puma 560/ })).toBeVisible();

  await choose('scara.urdf', scara);
  await dialog.getByRole('button', { name: 'Snap' }).click();
  await expect(dialog).toContainText('With the axes made parallel.');
  await dialog.getByRole('button', { name: 'Open' }).click();
  await expect(dialog).toHaveCount(0);
  const longest = () => page.evaluate(() => Math.max(...window.denavit.model().joints.map(({ d }) => Math.abs(d))));
  expect(await longest()).toBeLessThan(2);

  // seven joints: no table has them; a part of them has
  const link = (/** @type {number} */ i) =>
    `<joint name="j${i}" type="continuous"><parent link="l${i - 1}"/><child link="l${i}"/><origin xyz="0.1 0 0.3"/><axis xyz="0 ${i % 2} ${1 - (i % 2)}"/></joint><link name="l${i}"/>`;
  await choose(
    'seven.urdf',
    `<robot name="seven"><link name="l0"/>${[1, 2, 3, 4, 5, 6, 7].map(link).join('')}</robot>`,
  );
  await expect(dialog).toContainText('7 joints move; expected 2 to 6');
  await expect(dialog.getByRole('button', { name: 'Open' })).toBeDisabled();
  await dialog.getByLabel('Base').selectOption('l1');
  await expect(dialog.getByLabel('Tip')).toHaveValue('l7');
  await dialog.getByRole('button', { name: 'Open' }).click();
  await expect(page.getByRole('button', { name: /^seven/ })).toBeVisible();
  expect(await page.evaluate(() => window.denavit.model().info.source)).toBe('URDF, l1 to l7');

  // two arms on one body, in SDFormat: either may be meant
  const arm = (/** @type {string} */ side) =>
    [1, 2]
      .map(
        (i) => `<link name="${side}${i}"><pose>0 0 ${i} 0 0 0</pose></link><joint name="${side}_${i}" type="revolute">
<parent>${i === 1 ? 'body' : `${side}1`}</parent><child>${side}${i}</child><axis><xyz>0 1 0</xyz></axis></joint>`,
      )
      .join('');
  await choose(
    'twins.sdf',
    `<sdf version="1.9"><model name="twins"><link name="body"/>${arm('left')}${arm('right')}</model></sdf>`,
  );
  await expect(dialog.getByLabel('Tip')).toHaveValue('left2');
  await dialog.getByLabel('Tip').selectOption('right2');
  await dialog.getByRole('button', { name: 'Open' }).click();
  await expect(page.getByRole('button', { name: /^twins/ })).toBeVisible();
  expect(await page.evaluate(() => window.denavit.model().info.source)).toBe('SDFormat, body to right2');
  for (const name of [/^seven/, /^yguel_scara|^scara/, /^Puma 560/]) {
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(page.getByRole('button', { name })).toBeVisible();
  }
});

test('what a format does not hold is listed before it is saved; postures leave as CSV and come back as one change', async ({
  page,
}) => {
  await open(page, 'robot=planar2r');
  await openPostures(page);
  await page.getByRole('button', { name: 'Keep this posture' }).click();
  const saveAs = async () => {
    await page.getByRole('button', { name: 'File' }).click();
    await page.getByRole('button', { name: /^Save as…/ }).click();
  };
  const dialog = page.getByRole('dialog');
  await saveAs();
  await expect(dialog.locator('.save-file')).toHaveText('Planar-2R.xml');
  await expect(dialog).toContainText('Everything in the document is kept.');
  await dialog.getByRole('radio', { name: /^URDF/ }).check();
  await expect(dialog.locator('.save-file')).toHaveText('Planar-2R.urdf');
  await expect(dialog.locator('.issue-text').filter({ hasText: '1 recorded posture (p1)' })).toHaveCount(1);
  await dialog.getByRole('radio', { name: /^Postures as CSV/ }).check();
  const coming = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('Planar-2R.csv');
  const csv = await readFile(await download.path(), 'utf8');
  const again = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save as CSV', exact: true }).click(); // below the postures
  expect(await readFile(await (await again).path(), 'utf8')).toBe(csv);
  expect(csv).toMatch(/^name,[^,]+ \(deg\),[^,]+ \(deg\)\r\ncurrent,.*\r\np1,/);
  await expect(dialog).toHaveCount(0);

  const more = `${csv}pick,10,-20\r\nno name,1,2\r\nhalf,1\r\n`.replace(/current,[^\r]*/, 'current,30,45');
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open CSV…', exact: true }).click();
  await (await chooser).setFiles({ name: 'p.csv', mimeType: '', buffer: Buffer.from(more) });
  const rows = dialog.getByRole('row');
  await expect(rows.filter({ hasText: 'p1' })).toContainText('stays as it is');
  await expect(rows.filter({ hasText: 'pick' })).toContainText('is added');
  await expect(rows.filter({ hasText: 'Joint 2 has nothing; expected a number.' })).toHaveCount(1);
  await dialog.getByRole('button', { name: 'Take 3 rows' }).click();
  await expect(page.getByLabel('Name of posture 2')).toHaveValue('pick');
  expect(await page.evaluate(() => window.denavit.joints())).toEqual([30, 45]);
  await page.getByRole('button', { name: /^Undo/ }).click();
  await expect(page.getByLabel('Name of posture 2')).toHaveCount(0);
  expect(await page.evaluate(() => window.denavit.joints())).not.toEqual([30, 45]);
});

test('the scene is saved as a picture, with its labels, on a ground or on none', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: 'File' }).click();
  await page.getByRole('button', { name: /^Save as…/ }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('radio', { name: /^Picture of the scene/ }).check();
  await expect(dialog.locator('.dialog-foot')).toContainText(/\d+ × \d+ pixels/);
  await dialog.getByLabel('Background').uncheck();
  await dialog.getByLabel('Floor').uncheck();
  const coming = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('Puma-560.png');
  const { width, height, data } = PNG.sync.read(await readFile(await download.path()));
  const size = await page
    .locator('canvas')
    .evaluate((/** @type {HTMLCanvasElement} */ canvas) => canvas.width * canvas.height);
  expect(width * height).toBe(size);
  const opaque = Array.from({ length: size }, (_, i) => data[4 * i + 3]).filter((alpha) => alpha > 250).length;
  expect(opaque / size).toBeGreaterThan(0.02); // the arm
  expect(opaque / size).toBeLessThan(0.5);
  expect([data[3], data[data.length - 1]]).toEqual([0, 0]); // nothing behind it
});
