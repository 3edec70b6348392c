/**
 * Browser tests, on the production build in dist. One browser, one worker, no second chances: a test that passes
 * sometimes is a fault.
 */
import { defineConfig } from '@playwright/test';
import { LAUNCH_ARGUMENTS } from './scripts/browserLaunch.mjs';
import { ensureBrowser, rememberedBrowser } from './scripts/ensureBrowser.mjs';
import { freePort } from './scripts/freePort.mjs';

const { executablePath } = rememberedBrowser() ?? (await ensureBrowser());
// Playwright reads this file again in each worker, which must come to the same address.
process.env.DENAVIT_TEST_PORT ??= String(await freePort());
const port = process.env.DENAVIT_TEST_PORT;
const deep = Boolean(process.env.DENAVIT_DEEP);

export default defineConfig({
  testDir: 'tests/browser',
  testMatch: '**/*.spec.js',
  outputDir: 'test-results',
  // Canvas pixels are the same wherever SwiftShader draws them, so pictures are not kept per platform.
  snapshotPathTemplate: 'tests/browser/pictures/{arg}{ext}',
  workers: 1,
  retries: 0,
  timeout: deep ? 600_000 : 120_000, // guards against hanging: the machine may be slow and busy
  expect: { timeout: 30_000, toHaveScreenshot: { maxDiffPixels: 20, animations: 'disabled' } },
  reporter: [['list']],
  use: {
    // One window goes from journey to journey, emptied of what was kept and set in it: a third of a journey was the making of a new one.
    reuseContext: true,
    baseURL: `http://127.0.0.1:${port}/`,
    viewport: { width: 1366, height: 768 },
    contextOptions: { reducedMotion: 'reduce' },
    locale: 'en-GB',
    timezoneId: 'UTC',
    launchOptions: { executablePath, args: LAUNCH_ARGUMENTS },
    // a trace of each test, thrown away when it passes, would take a third of the time
    trace: process.env.DENAVIT_TRACE ? 'retain-on-failure' : 'off',
    video: 'off',
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --host 127.0.0.1 --port ${port} --strictPort`,
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
    stdout: 'ignore',
    stderr: 'pipe',
  },
});
