/** The ways in and out: drop, paste, and what is said of what cannot be opened. */
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { open, tool } from './page.js';

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
