/**
 * What a static host sees: what is fetched, from where, and when.
 * @import { Page } from '@playwright/test'
 */
import { expect, test } from '@playwright/test';
import { fileURLToPath } from 'node:url';
import { preview } from 'vite';
import { firstLoad } from '../../scripts/firstLoad.mjs';

const DIST = fileURLToPath(new URL('../../dist', import.meta.url));

/**
 * Collects the addresses that a page fetches, relative to the folder it is in; anything from elsewhere stays whole.
 * @param {Page} page
 * @param {string} folder
 */
function recordRequests(page, folder) {
  /** @type {Set<string>} */
  const fetched = new Set();
  page.on('request', (request) => {
    const url = request.url();
    if (!/^(data|blob):/.test(url))
      fetched.add(url === folder ? 'index.html' : url.replace(folder, '').replace(/[?#].*$/, ''));
  });
  return fetched;
}

/** @param {Page} page */
const ready = (page) => page.evaluate(() => window.denavit.ready);

test('the first load and the three seconds after it fetch nothing but what the size check counts', async ({
  page,
  baseURL,
}) => {
  const fetched = recordRequests(page, String(baseURL));
  await page.clock.install();
  await page.goto('./');
  await ready(page);
  await page.clock.runFor(3000);
  await page.waitForLoadState('networkidle');

  const { files, faults } = firstLoad(DIST);
  expect(faults).toEqual([]);
  expect([...fetched].filter((path) => !files.includes(path))).toEqual([]);
  const scripts = files.filter((path) => /\.(js|css)$/.test(path));
  expect(
    scripts.filter((path) => !fetched.has(path)),
    'counted, but not fetched',
  ).toEqual([]);
});

test('the built folder runs from a sub-path', async ({ page }) => {
  const server = await preview({
    base: '/courses/robots/',
    logLevel: 'silent',
    preview: { host: '127.0.0.1', port: 0 },
  });
  try {
    const [address] = server.resolvedUrls?.local ?? [];
    /** @type {string[]} */
    const faults = [];
    page.on('response', (response) => void (response.ok() || faults.push(`${response.status()} ${response.url()}`)));
    page.on('pageerror', ({ message }) => faults.push(message));
    const fetched = recordRequests(page, address);
    await page.goto(address);
    await ready(page);
    expect(new URL(page.url()).pathname).toBe('/courses/robots/');
    expect(faults).toEqual([]);
    expect([...fetched].filter((path) => path.includes(':'))).toEqual([]);
  } finally {
    await page.close();
    await server.close();
  }
});
