/**
 * Where a Chromium or Chrome may be installed, best first. Names only: whether one is there, and starts, is asked
 * elsewhere. Edge comes last: it is a Chromium, and every Windows has it.
 */
import { posix, win32 } from 'node:path';

const COMMANDS = [
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
  'chromium-headless-shell',
  'microsoft-edge',
  'microsoft-edge-stable',
];
const LINUX_PLACES = [
  '/usr/lib/chromium/chromium',
  '/usr/lib64/chromium-browser/chromium-browser',
  '/snap/bin/chromium',
  '/opt/google/chrome/chrome',
  '/opt/microsoft/msedge/msedge',
];
const MAC_APPLICATIONS = ['Chromium', 'Google Chrome', 'Google Chrome for Testing', 'Microsoft Edge'];
const WINDOWS_PROGRAMS = [
  'Chromium\\Application\\chrome.exe',
  'Google\\Chrome\\Application\\chrome.exe',
  'Microsoft\\Edge\\Application\\msedge.exe',
];

/**
 * @param {NodeJS.Platform} platform
 * @param {Record<string, string | undefined>} environment
 * @returns {string[]} absolute paths
 */
export function browserCandidates(platform, environment) {
  if (platform === 'win32') {
    const roots = ['LOCALAPPDATA', 'PROGRAMFILES', 'PROGRAMFILES(X86)'].map((name) => environment[name]);
    return WINDOWS_PROGRAMS.flatMap((program) => roots.flatMap((root) => (root ? [win32.join(root, program)] : [])));
  }
  const folders = (environment.PATH ?? '').split(':').filter((folder) => posix.isAbsolute(folder));
  const onPath = COMMANDS.flatMap((command) => folders.map((folder) => posix.join(folder, command)));
  if (platform !== 'darwin') return [...onPath, ...LINUX_PLACES];

  const roots = ['/Applications', ...(environment.HOME ? [posix.join(environment.HOME, 'Applications')] : [])];
  const applications = MAC_APPLICATIONS.flatMap((name) =>
    roots.map((root) => posix.join(root, `${name}.app`, 'Contents/MacOS', name)),
  );
  return [...applications, ...onPath];
}
