import { expect, test } from 'vitest';
import { browserCandidates } from '../../../scripts/browserCandidates.mjs';

test('on Linux, Chromium on the path comes before Chrome, and Edge last of the path', () => {
  const candidates = browserCandidates('linux', { PATH: '/usr/local/bin:/usr/bin' });
  const places = ['/usr/local/bin/chromium', '/usr/bin/chromium', '/usr/bin/google-chrome', '/usr/bin/microsoft-edge'];
  expect(candidates.filter((path) => places.includes(path))).toEqual(places);
  expect(candidates).toContain('/snap/bin/chromium');
});

test('on macOS, applications are found for everyone and for one person', () => {
  expect(browserCandidates('darwin', { HOME: '/Users/ana' })).toEqual(
    expect.arrayContaining([
      '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
      '/Users/ana/Applications/Chromium.app/Contents/MacOS/Chromium',
    ]),
  );
});

test('on Windows, Chrome comes before Edge, which is always there', () => {
  const candidates = browserCandidates('win32', {
    PROGRAMFILES: 'C:\\Program Files',
    'PROGRAMFILES(X86)': 'C:\\Programs x86',
  });
  expect(candidates).toEqual([
    'C:\\Program Files\\Chromium\\Application\\chrome.exe',
    'C:\\Programs x86\\Chromium\\Application\\chrome.exe',
    'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
    'C:\\Programs x86\\Google\\Chrome\\Application\\chrome.exe',
    'C:\\Program Files\\Microsoft\\Edge\\Application\\msedge.exe',
    'C:\\Programs x86\\Microsoft\\Edge\\Application\\msedge.exe',
  ]);
});

test('a bare environment still has the usual places, and no relative ones', () => {
  for (const platform of /** @type {const} */ (['linux', 'darwin'])) {
    const candidates = browserCandidates(platform, { PATH: '.:' });
    expect(candidates.length).toBeGreaterThan(0);
    expect(candidates.filter((path) => !path.startsWith('/'))).toEqual([]);
  }
});
