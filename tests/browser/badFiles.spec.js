/** Bad and odd files come in by the page as they do in Node: each as its manifest says, and a refusal leaves everything as it was. */
import { readFileSync } from 'node:fs';
import { expect, test } from '@playwright/test';
import { open } from './page.js';

/** @typedef {{ file: string, expect: 'reject' | 'accept' | 'accept_warn' | 'any' }} Entry */

const folder = (/** @type {string} */ format) => new URL(`../fixtures/${format}/bad/`, import.meta.url);

/** All of them in test:deep, else a spread over formats and kinds of fault. */
const EVERY = process.env.DENAVIT_DEEP ? 1 : 15;

const files = ['xml', 'urdf', 'rlkin'].flatMap((format) => {
  /** @type {Entry[]} */
  const manifest = JSON.parse(readFileSync(new URL('manifest.json', folder(format)), 'utf8'));
  return manifest.map((entry) => ({ ...entry, buffer: readFileSync(new URL(entry.file, folder(format))) }));
});

test('files of the bad collection have the outcome that their manifest states', async ({ page }) => {
  await open(page, 'robot=planar2r');
  const dialog = page.getByRole('dialog');
  for (const { file, buffer, expect: stated } of files.filter((_, i) => i % EVERY === 0)) {
    await page.evaluate(() => window.denavit.load('planar2r'));
    const before = await page.evaluate(() => window.denavit.xml());
    await page.locator('.file-input').setInputFiles({ name: file, mimeType: 'text/xml', buffer });
    // Something is to be seen of each: another model, or a dialog.
    await page.waitForFunction(
      (xml) => window.denavit.xml() !== xml || document.querySelector('[role=dialog]')?.checkVisibility(),
      before,
    );
    const isOpened = (await page.evaluate(() => window.denavit.xml())) !== before;
    const isSaid = await dialog.isVisible();
    // Where another chain of the file may be chosen, its dialog says why this one cannot be.
    if (stated === 'reject') await expect(dialog, file).toContainText(/ was not opened|Line \d+: the joint/);
    const outcome = isOpened ? (isSaid ? 'accept_warn' : 'accept') : 'reject';
    if (stated !== 'any') expect([file, outcome]).toEqual([file, stated]);
    if (!isSaid) continue;
    await page.keyboard.press('Escape');
    await expect(dialog).toHaveCount(0);
  }
});
