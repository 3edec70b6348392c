/** The page's own manners: every screen, keyboard, assistive technology, and what happens when something is missing. */
import { chromium, expect, test } from '@playwright/test';
import { LAUNCH_ARGUMENTS } from '../../scripts/browserLaunch.mjs';
import { expectAccessible } from './accessible.js';
import { open, settled, tool } from './page.js';

/** @param {import('@playwright/test').Page} page */
const recordTwo = (page) =>
  page.evaluate(async () => {
    const xml = window.denavit
      .xml()
      .replace('</postures>', '<posture id="p1" q="0 45 -180 0 45 0"/><posture id="p2" q="9 9 9 9 9 9"/></postures>');
    await window.denavit.load(xml);
  });

for (const theme of ['light', 'dark']) {
  test(`axe finds nothing on any panel, ${theme}`, async ({ page }) => {
    await open(page);
    if (theme === 'dark') await page.getByRole('button', { name: 'Colours: light or dark' }).click();
    await page.getByLabel('Joint 2, link length a, millimetres').fill('x');
    await page.getByLabel('Target X, millimetres').fill('9000');
    await page.keyboard.press('Enter');
    await expectAccessible(page);
    // From here on only what has changed: the rest of the page was looked at.
    for (const tab of ['program', 'code']) {
      await page.locator(`#tab-${tab}`).click();
      await expectAccessible(page, { within: `:has(> #panel-${tab})` });
    }
    await recordTwo(page);
    await expect(page.locator('.code')).toContainText('PROGRAM');
    await expectAccessible(page, { within: '#panel-code' });
    await page.getByRole('tab', { name: 'Program' }).click();
    await expectAccessible(page, { within: '#panel-program' });
    await page
      .locator('input[type=file]')
      .setInputFiles({ name: 'a.xml', mimeType: 'text/xml', buffer: Buffer.from('<a>') });
    await expect(page.getByRole('dialog')).toBeVisible();
    await expectAccessible(page, { within: '[role=dialog]' });
  });
}

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test('a joint is moved by touch; each panel opens from the dock, fits, and axe finds nothing', async ({ page }) => {
    await open(page);
    const place = await tool(page);
    const box = await page.getByLabel('Joint 1', { exact: true }).boundingBox();
    if (!box) throw new Error('The slider is not on the page.');
    expect(box.height).toBeGreaterThanOrEqual(44);
    await page.touchscreen.tap(box.x + box.width * 0.7, box.y + box.height / 2);
    expect(await tool(page)).not.toEqual(place);
    await recordTwo(page);
    for (const [name, room] of [
      ['Robot', 'robot'],
      ['Jog', 'jog'],
      ['Aim', 'aim'],
      ['Program', 'program'],
      ['Code', 'code'],
      ['Jacobian', 'jacobian'],
    ]) {
      // prettier-ignore
      await page.getByRole('navigation', { name: 'Panels' }).getByRole('button', { name }).tap();
      await expect(page.locator(`[data-room=${room}]`)).toBeVisible();
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(width, `${name} is wider than the screen`).toBeLessThanOrEqual(390);
      const view = await page.locator('canvas').boundingBox();
      expect(view?.height ?? 0, `${name} leaves too little of the view`).toBeGreaterThanOrEqual(240);
      await expectAccessible(page);
    }
  });
});

test('nothing is cut off on any screen', async ({ page }) => {
  await open(page, 'robot=scara_cobra600');
  await page.evaluate(async () => {
    // Numbers as real files have them.
    const long = window.denavit.xml().replace('a="275" alpha="180"', 'a="275.12345678" alpha="179.91234567"');
    await window.denavit.load(
      long.replace('lower="-88" upper="88"', 'lower="-89.954373835539" upper="89.954373835539"'),
    );
  });
  for (const [width, height] of [
    [768, 1024],
    [1366, 768],
    [1920, 1080],
    [844, 390],
  ]) {
    await page.setViewportSize({ width, height });
    await settled(page);
    const faults = await page.evaluate(() => {
      const cut = [...document.querySelectorAll('.grid input, .pose output, .topbar > *, .field input')].filter(
        (element) =>
          element.checkVisibility() && element.scrollWidth > element.clientWidth + 1 && element.clientWidth > 0,
      );
      const { scrollWidth, clientWidth } = document.documentElement;
      return [
        ...cut.map((element) => element.getAttribute('aria-label') ?? element.textContent),
        ...(scrollWidth > clientWidth ? ['page'] : []),
      ];
    });
    expect(faults, `${width} × ${height}`).toEqual([]);
  }
});

test('a bad or unknown query parameter is a visible warning, and the page stands', async ({ page }) => {
  await open(page, 'robot=r2d2&cat=%3Cb%3E');
  await expect(page.getByRole('alert').getByRole('listitem')).toHaveText([
    /\?robot=r2d2 is not understood\. Using puma560\./,
    'There is no ?cat parameter.',
  ]);
  await expect(page.getByRole('button', { name: /Puma 560/ })).toBeVisible();
});

test('without WebGL the table and the numbers work, and the view says why it is empty', async ({
  baseURL,
  launchOptions,
}) => {
  const browser = await chromium.launch({ ...launchOptions, args: [...LAUNCH_ARGUMENTS, '--disable-3d-apis'] });
  try {
    const context = await browser.newContext({ baseURL });
    const page = await context.newPage();
    await page.goto('./?theme=light&hint=off');
    await page.evaluate(() => window.denavit.ready);
    await expect(page.locator('.view')).toContainText('WebGL is off or missing');
    const place = await tool(page);
    await page.getByLabel('Joint 2, link length a, millimetres').fill('500');
    await page.keyboard.press('Enter');
    expect(await tool(page)).not.toEqual(place);
    await expectAccessible(page);
  } finally {
    await browser.close();
  }
});

test('nothing moves by itself: with a manual clock frames come when a test says so', async ({ page }) => {
  await page.goto('./?quality=low&theme=light&clock=manual');
  await page.waitForFunction(() => Boolean(window.denavit));
  await expect(page.locator('.pose output').first()).toHaveText('');
  await page.evaluate(() => {
    const { clock } = window.denavit;
    for (let i = 0; i < 3; i++) clock?.tick();
  });
  await expect(page.locator('.pose output').first()).toHaveText('596.30');
});
