/**
 * What the page does between a slider's `input` event and the moment when scene and readouts have the new posture, in the
 * built page and a real browser; drawing the picture is not counted. With a manual clock a first tick draws every view and
 * moves the scene's parts, and a second one renders, so that the two can be told apart.
 * @import { Page } from 'playwright'
 * @import { BenchRow } from './run.mjs'
 */
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { LAUNCH_ARGUMENTS } from '../scripts/browserLaunch.mjs';
import { ensureBrowser, rememberedBrowser } from '../scripts/ensureBrowser.mjs';
import { freePort } from '../scripts/freePort.mjs';
import { median, quantile } from './measure.mjs';

const ROOT = join(fileURLToPath(import.meta.url), '..', '..');
const ARM = 'puma560';
const ROUNDS = 6; // of pulls, one of each joint
const WARM_UP = 2;
const STEPS = 15; // in a pull

/** The picture is not what is measured, and without a graphics card it takes the longest. */
const TINY_VIEW = '.stage { width: 1px !important; height: 1px !important; }';

/** With these the browser's clock has a grain of 5 µs instead of 100. */
const ISOLATION = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

/**
 * Runs in the page: milliseconds of each step of each pull, without and with the style and layout that follow.
 * @param {{ rounds: number, warmUp: number, steps: number }} options
 */
function pullSliders({ rounds, warmUp, steps }) {
  const { clock } = window.denavit;
  if (!clock) throw new Error('The page has no manual clock.');
  const sliders = [...document.querySelectorAll('.jog input[type=range]')].map(
    (element) => /** @type {HTMLInputElement} */ (element),
  );
  /** @type {{ update: number[], layout: number[] }} */
  const times = { update: [], layout: [] };
  for (let round = 0; round < rounds; round++) {
    for (const slider of sliders) {
      const [least, most] = [Number(slider.min), Number(slider.max)];
      slider.dispatchEvent(new PointerEvent('pointerdown'));
      for (let step = 0; step < steps; step++) {
        const value = String(least + ((most - least) * (step + 0.5 + (round % 7) / 7)) / (steps + 1));
        const start = performance.now();
        slider.value = value;
        slider.dispatchEvent(new Event('input', { bubbles: true }));
        clock.tick();
        const updated = performance.now();
        void document.body.offsetHeight;
        const laidOut = performance.now();
        if (round >= warmUp) {
          times.update.push(updated - start);
          times.layout.push(laidOut - start);
        }
        clock.tick(); // renders
      }
      slider.dispatchEvent(new Event('change', { bubbles: true }));
      slider.dispatchEvent(new PointerEvent('pointerup'));
      clock.tick();
    }
  }
  return { ...times, isIsolated: window.crossOriginIsolated };
}

/** @param {string} what @param {number[]} times @param {boolean} isJudged @param {string} note @returns {BenchRow[]} */
function rowsOf(what, times, isJudged, note) {
  const name = `slider to screen, ${ARM}: ${what}`;
  const row = (/** @type {string} */ which, /** @type {number} */ value, /** @type {number} */ atMost) => ({
    name: `${name}, ${which}`,
    unit: 'ms',
    median: value,
    ...(isJudged && { target: /** @type {const} */ ({ of: 'median', atMost }) }),
    note,
  });
  return [row('median', median(times), 1), row('95 %', quantile(times, 0.95), 4)];
}

/** @param {Page} page @param {string} address @param {string | null} opened  what is opened in the pose panel */
async function measure(page, address, opened) {
  await page.goto(`${address}?robot=${ARM}&quality=low&theme=light&clock=manual`);
  await page.waitForFunction(() => Boolean(window.denavit?.clock));
  await page.addStyleTag({ content: TINY_VIEW });
  const tick = () => page.evaluate(() => [1, 2, 3].forEach(() => window.denavit.clock?.tick()));
  await tick();
  if (opened) {
    await page.locator(`[data-ask=${opened}]`).click();
    // it is fetched first, and drawn by a tick after that
    for (let tries = 0; tries < 200 && (await page.locator('.matrix').count()) === 0; tries++) await tick();
  }
  return await page.evaluate(pullSliders, { rounds: ROUNDS, warmUp: WARM_UP, steps: STEPS });
}

/** @returns {Promise<BenchRow[]>} none where there is no browser, and why */
export async function bench() {
  const { chromium } = await import('playwright');
  const { build, preview } = await import('vite');
  let browser;
  try {
    const { executablePath } = rememberedBrowser() ?? (await ensureBrowser());
    browser = await chromium.launch({ executablePath, args: LAUNCH_ARGUMENTS });
  } catch (error) {
    const [reason] = /** @type {Error} */ (error).message.split('\n');
    console.error(`interaction.mjs is passed over: no browser starts (${reason}).`);
    return [];
  }
  const outDir = join(ROOT, '.cache', 'bench-page');
  /** @type {Awaited<ReturnType<typeof preview>> | undefined} */
  let server;
  try {
    await build({ root: ROOT, logLevel: 'error', build: { outDir, emptyOutDir: true, sourcemap: false } });
    const port = await freePort();
    server = await preview({
      root: ROOT,
      logLevel: 'error',
      build: { outDir },
      preview: { host: '127.0.0.1', port, headers: ISOLATION },
    });
    const page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
    const address = `http://127.0.0.1:${port}/`;
    const usual = await measure(page, address, null);
    const links = await measure(page, address, 'links');
    const note = `${usual.update.length} events${usual.isIsolated ? '' : ', clock of 0.1 ms'}`;
    return [
      ...rowsOf('scene and readouts', usual.update, true, note),
      ...rowsOf('with style and layout', usual.layout, false, ''),
      ...rowsOf('with the link transforms open', links.update, true, ''),
    ];
  } finally {
    await browser.close();
    await server?.close();
  }
}
