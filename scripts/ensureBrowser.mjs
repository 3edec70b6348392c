/**
 * Finds a browser for the tests and remembers it in .cache/browser.json, where playwright.config.js reads it. Looked for
 * in this order: CHROMIUM_PATH, an installed Chromium or Chrome, Playwright's own (downloaded when needed), Debian's
 * package. Each is started once to see that it works; one that does not is passed over, saying why.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { browserCandidates } from './browserCandidates.mjs';
import { isMain } from './isMain.mjs';

const ROOT = dirname(dirname(fileURLToPath(import.meta.url)));
const MEMORY = join(ROOT, '.cache', 'browser.json');
const DOWNLOAD_LIMIT_MS = 600_000;

/**
 * @typedef {object} FoundBrowser
 * @property {string} executablePath
 * @property {string} version
 * @property {string} [wished]  CHROMIUM_PATH as it was when the browser was found
 */

/**
 * The browser found before, as long as it is still there and CHROMIUM_PATH has not changed since.
 * @returns {FoundBrowser | undefined}
 */
export function rememberedBrowser() {
  try {
    const found = /** @type {FoundBrowser} */ (JSON.parse(readFileSync(MEMORY, 'utf8')));
    return found.wished === process.env.CHROMIUM_PATH && existsSync(found.executablePath) ? found : undefined;
  } catch {
    return undefined; // never looked for, or the memory is damaged: either way it is looked for anew
  }
}

/**
 * @param {(line: string) => void} [say]
 * @returns {Promise<FoundBrowser>} or throws an error that says what to do
 */
export async function ensureBrowser(say = console.log) {
  const { tryBrowser } = await import('./browserLaunch.mjs');
  const { chromium } = await import('playwright');
  const wished = process.env.CHROMIUM_PATH;
  /** @type {Set<string>} */
  const tried = new Set();

  /**
   * The first that works, of those not tried yet.
   * @param {(string | undefined)[]} paths
   */
  async function firstWorking(paths) {
    for (const executablePath of paths) {
      if (!executablePath) continue;
      if (!existsSync(executablePath)) {
        if (executablePath === wished) say(`CHROMIUM_PATH names ${wished}, which does not exist; looking elsewhere.`);
        continue;
      }
      const file = realpathSync(executablePath); // /bin and /usr/bin are often the same folder
      if (tried.has(file)) continue;
      tried.add(file);
      const result = await tryBrowser(executablePath);
      if (result.problem === undefined) return remember({ executablePath, version: result.version, wished });
      say(`Passing over ${executablePath}: it ${result.problem}.`);
    }
    return undefined;
  }

  const installed = browserCandidates(process.platform, process.env);
  const found = await firstWorking([
    wished,
    rememberedBrowser()?.executablePath,
    ...installed,
    chromium.executablePath(),
  ]);
  if (found) return found;

  say('No installed Chromium or Chrome works; trying "playwright install chromium".');
  tried.clear();
  const downloaded = installWithPlaywright() && (await firstWorking([chromium.executablePath()]));
  if (downloaded) return downloaded;

  if (canUseApt()) {
    say('Trying "apt-get install chromium".');
    tried.clear();
    const packaged = installWithApt() && (await firstWorking(installed));
    if (packaged) return packaged;
  }
  throw new Error(
    'No browser for the browser tests: install Chromium or Chrome, or set CHROMIUM_PATH to the executable of one, and run the tests again.',
  );
}

/** @param {FoundBrowser} found */
function remember(found) {
  mkdirSync(dirname(MEMORY), { recursive: true });
  writeFileSync(MEMORY, `${JSON.stringify(found, null, 2)}\n`);
  return found;
}

/**
 * @param {string} command
 * @param {string[]} args
 */
function runs(command, args) {
  const { status } = spawnSync(command, args, {
    cwd: ROOT,
    stdio: ['ignore', 'inherit', 'inherit'],
    timeout: DOWNLOAD_LIMIT_MS,
  });
  return status === 0;
}

function installWithPlaywright() {
  return runs(process.execPath, [join(ROOT, 'node_modules', 'playwright', 'cli.js'), 'install', 'chromium']);
}

const isRoot = () => process.getuid?.() === 0;

/** Whether packages can be installed without asking anyone for a password. */
function canUseApt() {
  if (process.platform !== 'linux' || !existsSync('/usr/bin/apt-get')) return false;
  return isRoot() || spawnSync('sudo', ['-n', 'true'], { stdio: 'ignore' }).status === 0;
}

function installWithApt() {
  const quietly = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get'];
  const [command, ...before] = isRoot() ? quietly : ['sudo', '-n', ...quietly];
  runs(command, [...before, 'update']); // an old list may still do, so its failure is not the end
  return runs(command, [...before, 'install', '--yes', '--no-install-recommends', 'chromium']);
}

if (isMain(import.meta.url)) {
  try {
    const { executablePath, version } = await ensureBrowser();
    console.log(`Browser: ${executablePath} (${version})`);
  } catch (error) {
    console.error(/** @type {Error} */ (error).message);
    process.exitCode = 1;
  }
}
