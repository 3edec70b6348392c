/** A model in the address, and work that outlives its tab. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

/** @typedef {import('@playwright/test').Page} Page */

const PLAIN = '?quality=low&theme=light&hint=off';

/** Opens an address with links and kept work as they are for everybody. @param {Page} page @param {string} [address] */
async function visit(page, address = './') {
  page.on('pageerror', (error) => expect.soft(error.message, 'an uncaught error').toBe(''));
  await page.goto(address.includes('?') ? address : address.replace(/(?=#|$)/, PLAIN));
  await page.evaluate(() => window.denavit.ready);
}

/** @param {Page} page @returns {Promise<string>} the document as a file */
const xml = (page) => page.evaluate(() => window.denavit.xml());
/** @param {Page} page */
const note = (page) => page.locator('.notice');

/** Closes a tab as a person does, and waits until it is closed. @param {Page} page */
const leave = (page) => Promise.all([page.waitForEvent('close'), page.close({ runBeforeUnload: true })]);

/** The numbers of the camera, as a link has them. @param {Page} page */
const camera = (page) =>
  page.evaluate(async () => {
    const link = await window.denavit.link({ view: true });
    return (new URLSearchParams(link.split('#')[1]).get('camera') ?? '').split(',').map(Number);
  });

test('a link brings robot, posture, camera and panels to another browser; it is undone, changed and loaded again', async ({
  page,
  browser,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page);
  await page.getByLabel('Joint 2, link length a, millimetres').fill('440.5');
  await page.keyboard.press('Enter');
  await page.evaluate(() => window.denavit.setJoints([12.5, 30, -150, 7, 33.25, -8]));
  await page.getByRole('tab', { name: 'Code' }).click();
  await page.locator('canvas').focus();
  for (const key of ['ArrowLeft', 'ArrowLeft', 'ArrowUp', '+']) await page.keyboard.press(key);
  await settled(page);
  const seen = await camera(page);
  await page.getByRole('button', { name: 'Share', exact: true }).click();
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('switch', { name: 'With the panels that are open' }).check();
  await expect(dialog.locator('.share-length')).toHaveText(/^\d{3} characters\.$/);
  await expectAccessible(page, { within: '.share' });
  await dialog.getByRole('button', { name: 'Copy the link' }).click();
  await expect(dialog.getByRole('button', { name: 'The link is copied' })).toBeVisible();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toBe(await dialog.getByRole('textbox').inputValue());

  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, reducedMotion: 'reduce' });
  const other = await context.newPage();
  await visit(other, link.replace('#', `${PLAIN}#`));
  expect(await xml(other)).toBe(await xml(page));
  await expect(note(other)).toContainText('Opened from the link: “Puma 560”.');
  await expect(other.getByRole('tab', { name: 'Code' })).toHaveAttribute('aria-selected', 'true');
  await settled(other);
  (await camera(other)).forEach((value, i) => expect(value).toBeCloseTo(seen[i], 4));
  await expect(other.getByRole('button', { name: 'Undo' })).toBeDisabled();
  await other.evaluate(() => window.denavit.setJoints([0, 0, 0, 0, 0, 0]));
  await expect(note(other)).toHaveCount(0);
  // Loaded again, the link is what is open, and what was made of it is offered.
  await other.reload();
  await other.evaluate(() => window.denavit.ready);
  expect(await xml(other)).toBe(await xml(page));
  await expect(note(other).filter({ hasText: 'Your work of' })).toBeVisible();
  await context.close();
});

test('a link put into the address of an open page is one step; a broken one leaves all as it is', async ({ page }) => {
  await open(page, 'robot=planar2r&q=20,40');
  const first = await xml(page);
  expect(await page.evaluate(() => window.denavit.link())).toMatch(/\/\?robot=planar2r&q=20,40$/);
  const link = await page.evaluate(async () => {
    const { denavit } = window;
    await denavit.load(denavit.xml().replace('Planar 2R', '&lt;img src=x onerror=alert(1)>'));
    const address = await denavit.link();
    denavit.undo();
    return address.split('#')[1];
  });
  await page.evaluate((hash) => void (location.hash = hash), link);
  await expect(note(page)).toContainText('Opened from the link: “<img src=x onerror=alert(1)>”.');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(note(page)).toHaveCount(0);
  expect(await xml(page)).toBe(first);

  for (const [hash, words] of [
    [link.slice(0, -20), 'The link is cut off'],
    [link.replace('model=1', 'model=7'), 'made by a newer Denavit'],
    [link.replace(/.{9}$/, '.00000000'), 'The link is damaged'],
  ]) {
    await page.evaluate((broken) => void (location.hash = broken), hash);
    await expect(note(page).filter({ hasText: words })).toBeVisible();
    expect(await xml(page)).toBe(first);
  }
  await page.evaluate((pasted) => {
    const data = new DataTransfer();
    data.setData('text/plain', `https://example.org/denavit/${pasted}`);
    document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true }));
  }, `#${link}`);
  await expect(note(page).filter({ hasText: 'Opened from the link' })).toBeVisible();
  await page.evaluate(() => window.denavit.undo());
  await page.reload(); // begins with the broken one
  await page.evaluate(() => window.denavit.ready);
  await expect(note(page)).toContainText('The link is damaged');
  expect(await xml(page)).toBe(first);
});

test('work outlives its tab: it is offered, restored as it was, and discarded', async ({ context, page }) => {
  await visit(page);
  await page.getByLabel('Joint 2, link length a, millimetres').fill('440.5');
  await page.keyboard.press('Enter');
  await page.evaluate(() => window.denavit.setJoints([12.5, 30, -150, 7, 33.25, -8]));
  await page.getByRole('tab', { name: 'Program' }).click();

  // A second tab: the work of the first, which is open, is not offered there, nor written over.
  const second = await context.newPage();
  await visit(second, `./${PLAIN}&robot=ur5`);
  await settled(second);
  await expect(note(second)).toHaveCount(0);
  await second.evaluate(() => window.denavit.setJoints([1, 2, 3, 4, 5, 6]));
  await leave(second);
  await page.evaluate(() => window.denavit.setJoints([12.5, 30, -150, 7, 33.25, 8])); // and closed at once
  const work = await xml(page);
  await leave(page);

  const third = await context.newPage();
  await visit(third);
  const offer = note(third);
  await expect(offer).toContainText(/^Your work of \d\d:\d\d on “Puma 560” is still here \(1 of 2\)\./);
  await expectAccessible(third, { within: '.notice' });
  await offer.getByRole('button', { name: 'Restore' }).click();
  await expect(note(third)).toHaveCount(0);
  expect(await xml(third)).toBe(work);
  await expect(third.getByRole('tab', { name: 'Program' })).toHaveAttribute('aria-selected', 'true');
  await third.getByRole('button', { name: 'Undo' }).click();
  expect(await third.evaluate(() => window.denavit.model().joints[1].a)).toBe(431.8);
  await third.evaluate(() => window.denavit.redo());
  await third.reload();
  await third.evaluate(() => window.denavit.ready);
  await expect(offer).toContainText('“Puma 560” is still here (1 of 2).');
  await offer.getByRole('button', { name: 'Discard' }).click();
  await expect(offer).toContainText('“UR5” is still here.');
  await offer.getByRole('button', { name: 'Discard' }).click();
  await expect(note(third)).toHaveCount(0);
  expect(
    await third.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith('denavit.work.'))),
  ).toEqual([]);
});

test('work that cannot be read is said, and stays until it is discarded; where nothing is kept, a file is offered', async ({
  page,
}) => {
  await page.addInitScript(() => {
    if (location.search.includes('full')) {
      Storage.prototype.setItem = () => {
        throw new DOMException('full', 'QuotaExceededError');
      };
    } else if (location.search.includes('forbidden')) {
      Object.defineProperty(window, 'localStorage', {
        get() {
          throw new DOMException('forbidden', 'SecurityError');
        },
      });
    } else {
      localStorage.setItem('denavit.work.x.0', 'denavit-work 1 00000000\n{"at":"x"}\n<b>what is left');
    }
  });
  await visit(page);
  await expect(note(page)).toContainText('is damaged and cannot be opened here');
  const saved = page.waitForEvent('download');
  await note(page).getByRole('button', { name: 'Save as a file' }).click();
  expect((await saved).suggestedFilename()).toBe('kept-work.xml');
  await note(page).getByRole('button', { name: 'Discard' }).click();
  await expect(note(page)).toHaveCount(0);
  expect(await page.evaluate(() => localStorage.getItem('denavit.work.x.0'))).toBeNull();

  for (const trouble of ['full', 'forbidden']) {
    await visit(page, `./${PLAIN}&panels=view,jog&${trouble}`);
    await page.locator('.notice').getByRole('button', { name: 'Close' }).click(); // of the unknown parameter
    await page.evaluate(() => window.denavit.setJoints([1, 2, 3, 4, 5, 6]));
    await expect(note(page)).toContainText('keeps no work for this page');
    await page.evaluate(() => window.denavit.setJoints([6, 5, 4, 3, 2, 1]));
    await page.evaluate(() => dispatchEvent(new Event('pagehide')));
    await expect(note(page)).toHaveCount(1);
    const file = page.waitForEvent('download');
    await note(page).getByRole('button', { name: 'Save as a file' }).click();
    expect((await file).suggestedFilename()).toBe('Puma-560.xml');
  }
});
