/** What a file or a link brings along is text: nothing of it runs, whatever it is called, and nothing is fetched for it. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { open, settled } from './page.js';

/** @typedef {import('@playwright/test').Page} Page */

/** @type {{ names: string[] }} */
const { names: all } = JSON.parse(await readFile(new URL('../fixtures/hostileNames.json', import.meta.url), 'utf8'));

const isDeep = Boolean(process.env.DENAVIT_DEEP);
/** Every third, and each that is markup. */
const names = all.filter((name, i) => isDeep || i % 3 === 0 || name.includes('__pwn'));

/** As an attribute or an element of XML holds it. @param {string} text */
const escaped = (text) =>
  text.replace(/[&<>"\t\n]/g, (character) => `&#${/** @type {number} */ (character.codePointAt(0))};`);

/** A 2R arm that has the name wherever a robot file has room for a text. @param {string} name */
function armCalled(name) {
  const text = escaped(name);
  const joint = (/** @type {number} */ i) =>
    `<joint id="j${i}" label="${text}" type="revolute"><dh theta="0" d="0" a="1" alpha="0"/></joint>`;
  const info = ['name', 'manufacturer', 'author', 'licence', 'source', 'description']
    .map((element) => `<${element}>${text}</${element}>`)
    .join('');
  return `<robotModel xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="m" angleUnit="deg" convention="standard" generator="${text}">
<info>${info}</info><chain>${joint(1)}${joint(2)}</chain>
<programs><program id="p" language="karel">${text}</program></programs>
<extensions><x:note xmlns:x="urn:other" is="${text}">${text}</x:note></extensions></robotModel>`;
}

/** Whether anything ran, and what the policy had to stop. @param {Page} page */
const harm = (page) =>
  page.evaluate(() => ({ ran: '__pwn' in window, stopped: Reflect.get(window, '__stopped'), proto: '__pwn' in {} }));

const NONE = { ran: false, stopped: [], proto: false };

/** @param {Page} page */
const watch = (page) =>
  page.addInitScript(() => {
    /** @type {string[]} */
    const stopped = [];
    Reflect.set(window, '__stopped', stopped);
    document.addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) =>
      stopped.push(`${violatedDirective} ${blockedURI}`),
    );
  });

test('the built page runs its own scripts only, and fetches from nowhere else', async ({ page }) => {
  await watch(page);
  await page.goto('./?quality=low&hint=off');
  await page.evaluate(() => window.denavit.ready);
  expect(await harm(page)).toEqual(NONE);
  const answers = await page.evaluate(async () => {
    const inline = document.createElement('script');
    inline.textContent = 'window.__pwn = 1';
    const picture = document.createElement('div');
    picture.innerHTML = '<img src="data:," onerror="window.__pwn = 1">';
    const base = document.createElement('base');
    base.href = 'https://example.org/';
    document.body.append(inline, picture, base);
    const address = document.createElement('script');
    address.src = 'data:text/javascript,window.__pwn=1';
    document.body.append(address);
    const fetched = await fetch('https://example.org/').then(
      () => 'fetched',
      () => 'refused',
    );
    // What is evaluated for a test may compile; what the page calls later may not.
    const compiled = await new Promise((resolve) =>
      setTimeout(() => {
        try {
          resolve(new Function('return "compiled"')());
        } catch {
          resolve('refused');
        }
      }, 50),
    );
    return { fetched, compiled, base: document.baseURI.startsWith('https://example.org') };
  });
  expect(answers).toEqual({ fetched: 'refused', compiled: 'refused', base: false });
  const { ran, stopped } = await harm(page);
  expect(ran).toBe(false);
  const directives = stopped.map((/** @type {string} */ line) => line.split(' ')[0]);
  expect(new Set(directives)).toEqual(
    new Set(['script-src-elem', 'script-src-attr', 'connect-src', 'base-uri', 'script-src']),
  );
});

test(`${names.length} hostile names are text wherever a name is shown`, async ({ page }) => {
  await watch(page);
  await open(page);
  for (const name of names) {
    const seen = await page.evaluate(async (xml) => {
      await window.denavit.load(xml);
      await new Promise((resolve) => requestAnimationFrame(resolve));
      return {
        kept: window.denavit.model().name,
        label: window.denavit.model().joints[0].label,
        page: document.body.innerText,
        title: document.title,
        text: (await Promise.all(['denavit', 'urdf', 'sdf', 'mjcf', 'rlkin'].map(window.denavit.file))).join(''),
      };
    }, armCalled(name));
    expect([seen.kept, seen.label]).toEqual([name, name]);
    const [shown, wanted] = [seen.page, name].map((text) => text.replace(/\s+/g, ' ').trim());
    expect(shown).toContain(wanted.slice(0, 60));
    expect(seen.title.replace(/\s+/g, ' ')).toContain(wanted);
    expect(seen.text).not.toMatch(/<(img|script|svg|style)/);
  }
  expect(await harm(page)).toEqual(NONE);

  // The worst of them with everything open, as the name of a file too, and undone.
  for (const name of names.filter((each) => each.includes('<img') || each.includes('{{'))) {
    await page.evaluate((xml) => window.denavit.load(xml), armCalled(name));
    await page.evaluate(() => {
      for (const fold of document.querySelectorAll('button[aria-expanded=false]:not([data-bs-toggle])'))
        if (fold instanceof HTMLElement && fold.checkVisibility()) fold.click();
    });
    await expect(page.locator('[aria-busy]')).toHaveCount(0);
    for (const tab of ['Code', 'Program']) await page.getByRole('tab', { name: tab }).click();
    await page
      .locator('input[type=file]')
      .first()
      .setInputFiles({
        name: `${name.replaceAll('/', '-')}.xml`,
        mimeType: 'text/xml',
        buffer: Buffer.from(armCalled(name).replace('a="1"', `a="${escaped(name)}"`)),
      });
    const dialog = page.getByRole('dialog');
    await expect(dialog).toContainText(name.replaceAll('/', '-'));
    await page.keyboard.press('Escape');
    await expect(dialog).toHaveCount(0);
    await page.getByRole('button', { name: 'Undo' }).hover();
  }
  await settled(page);
  expect(await harm(page)).toEqual(NONE);
});
