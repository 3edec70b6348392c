/** How the browser tests start a browser, and whether one starts that way. */
import { chromium } from 'playwright';

/**
 * What the window around the page would load for each new window, at the cost of a third of a page's own load: what drops
 * down from its address bar is a page itself.
 */
const WINDOW_PAGES = ['WebUIOmniboxPopup', 'WebUIOmniboxAimPopup', 'WebUIOmniboxFullPopup', 'PreloadTopChromeWebUI'];

/** What Playwright turns off by the same switch, of which only the last counts. */
const OFF_ANYWAY = [
  'AimEnabled',
  'AvoidCorsURLLoaderRestartOnRedirect',
  'AvoidUnnecessaryBeforeUnloadCheckSync',
  'DestroyProfileOnBrowserClose',
  'HttpsFirstBalancedModeAutoEnable',
  'HttpsUpgrades',
  'LensOverlay',
  'MediaRouter',
  'NetworkTimeServiceQuerying',
  'OptimizationHints',
  'PaintHolding',
  'PreconnectToSearch',
  'ThirdPartyStoragePartitioning',
];

/**
 * The same pixels everywhere: WebGL in software, one colour profile, no font hinting. Never --disable-gpu, which changes
 * how the rest of the page is drawn.
 */
export const LAUNCH_ARGUMENTS = [
  '--use-angle=swiftshader',
  '--force-color-profile=srgb',
  '--font-render-hinting=none',
  '--disable-lcd-text',
  // Text and boxes are painted, and put together with the scene, by the processor itself: through the software GL that
  // takes several times as long. WebGL stays as it is.
  '--disable-gpu-rasterization',
  '--disable-gpu-compositing',
  `--disable-features=${[...OFF_ANYWAY, ...WINDOW_PAGES].join(',')}`,
];

/**
 * Starts the browser, opens a page and asks for WebGL 2, without which the tests could not see the arm.
 * @param {string} executablePath
 * @returns {Promise<{ version: string, problem?: undefined } | { problem: string }>}
 */
export async function tryBrowser(executablePath) {
  let browser;
  try {
    browser = await chromium.launch({ executablePath, args: LAUNCH_ARGUMENTS, timeout: 60_000 });
    const page = await browser.newPage();
    const hasWebgl = await page.evaluate(() => document.createElement('canvas').getContext('webgl2') !== null);
    return hasWebgl ? { version: browser.version() } : { problem: 'starts, but offers no WebGL 2' };
  } catch (error) {
    return { problem: `does not start (${reasonOf(/** @type {Error} */ (error))})` };
  } finally {
    await browser?.close();
  }
}

/**
 * The one telling line of Playwright's long report: what the browser itself said last, where it said something.
 * @param {Error} error
 */
function reasonOf({ message }) {
  const lines = message.split('\n').map((line) => line.replace(/^[\s-]*(\[pid=\d+\])?(\[err\])?\s*/, ''));
  const telling = lines.find((line) => /error while loading|cannot open|not found|ENOENT|EACCES/i.test(line));
  return telling ?? (lines[0].includes('has been closed') ? 'it ends at once' : lines[0]);
}
