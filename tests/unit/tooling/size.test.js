import { randomBytes } from 'node:crypto';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { firstLoad } from '../../../scripts/firstLoad.mjs';
import { FIRST_LOAD_LIMIT, TOTAL_LIMIT, measure } from '../../../scripts/size.mjs';

/** @type {string} */
let dist;
beforeEach(() => (dist = mkdtempSync(join(tmpdir(), 'denavit-'))));
afterEach(() => rmSync(dist, { recursive: true, force: true }));

/** @param {Record<string, string | Buffer>} files */
function write(files) {
  for (const [path, content] of Object.entries(files)) {
    mkdirSync(dirname(join(dist, path)), { recursive: true });
    writeFileSync(join(dist, path), content);
  }
}

/** A small page as Vite builds it, with more in its head where a test says so. */
const page = (head = '') => ({
  'index.html': `<!doctype html><html><head>
    <!-- <script src="./assets/commented.js"></script> -->
    <link rel="icon" href="./icon.svg" /><link rel="canonical" href="https://example.org/" />
    <script type="module" crossorigin src="./assets/main.js"></script>
    <link rel="modulepreload" crossorigin href="./assets/three.js">
    <link rel="stylesheet" crossorigin href="./assets/main.css">${head}
  </head><body></body></html>`,
  'icon.svg': '<svg/>',
  'assets/main.js':
    "import { a } from './three.js'; export * from './shared.js'; export const later = () => import('./lazy.js'); a();",
  'assets/three.js': 'export const a = () => {};',
  'assets/shared.js': 'export const text = "import \'./lazy.js\'";',
  'assets/lazy.js': "import './lazier.js';",
  'assets/lazier.js': '',
  'assets/main.css':
    "@import './print.css'; a { background: url(../picture.png?v=1); mask: url('data:image/svg+xml,x') }",
  'assets/print.css': '',
  'picture.png': '',
  'assets/main.js.map': '{}',
});

describe('the first load', () => {
  test('is the page, what it names and what that imports, not what is imported when needed', () => {
    write(page());
    const { files, faults } = firstLoad(dist);
    expect(files.sort()).toEqual(
      [
        'index.html',
        'icon.svg',
        'picture.png',
        ...['main.css', 'main.js', 'print.css', 'shared.js', 'three.js'].map((name) => `assets/${name}`),
      ].sort(),
    );
    expect(faults).toEqual([]);
  });

  test.each([
    [
      'a preload of a chunk that is needed later',
      '<link rel="modulepreload" href="./assets/lazy.js">',
      /lazy\.js before it is needed/,
    ],
    ['a prefetch', '<link href=./assets/lazy.js rel=prefetch>', /lazy\.js ahead of need/],
    ['an address from the root of the host', '<script src="/assets/main.js"></script>', /not a path relative/],
    ['another host', '<link rel="stylesheet" href="https://example.org/a.css">', /not a path relative/],
    ['a folder above', '<script src="../main.js"></script>', /not a path relative/],
    ['a missing file', '<script src="./nowhere.js"></script>', /nowhere\.js, which is not in the built folder/],
    ['a script in the page', '<script>document.title = 1;</script>', /script in the page itself/],
  ])('may not have %s', (_what, head, fault) => {
    write(page(head));
    expect(firstLoad(dist).faults).toContainEqual(expect.stringMatching(fault));
  });
});

describe('the size check', () => {
  test('passes a small page, and counts no source map', () => {
    write(page());
    const { sizes, faults } = measure(dist);
    expect(faults).toEqual([]);
    expect(sizes.map(({ path }) => path)).not.toContain('assets/main.js.map');
    expect(
      sizes
        .filter(({ first }) => !first)
        .map(({ path }) => path)
        .sort(),
    ).toEqual(['assets/lazier.js', 'assets/lazy.js']);
  });

  // Random bytes do not compress, so they weigh what they are.
  test('refuses a first load over its limit', () => {
    write({ ...page(), 'picture.png': randomBytes(FIRST_LOAD_LIMIT) });
    expect(measure(dist).faults).toEqual([expect.stringMatching(/^The first load is 25\d{4} bytes/)]);
  });

  test('refuses a folder over its limit, whenever its files are fetched', () => {
    write({ ...page(), 'assets/lazy.bin': randomBytes(TOTAL_LIMIT) });
    expect(measure(dist).faults).toEqual([expect.stringMatching(/^The built folder is 80\d{4} bytes/)]);
  });

  test('says what to do when nothing was built', () => {
    expect(() => measure(dist)).toThrow('npm run build');
  });
});
