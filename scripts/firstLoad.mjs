/**
 * What a browser fetches before anyone touches the page, read from the built folder: what index.html names, what those
 * chunks import statically (not what they import when needed), and what the stylesheets point to. What a script fetches
 * by itself cannot be seen here; a browser test compares.
 */
import { existsSync, readFileSync } from 'node:fs';
import { extname, join, posix } from 'node:path';
import { parseAst } from 'vite';

/** Links that make the browser fetch something now. */
const FETCHED_NOW = ['stylesheet', 'icon', 'manifest', 'modulepreload', 'preload'];
const FETCHED_AHEAD = ['prefetch', 'prerender', 'dns-prefetch', 'preconnect'];

/**
 * @param {string} dist the built folder
 * @returns {{ files: string[], faults: string[] }} paths in the folder, index.html first; and what index.html may not do
 */
export function firstLoad(dist) {
  const tags = readTags(readFileSync(join(dist, 'index.html'), 'utf8'));
  const files = new Set(['index.html']);
  /** @type {string[]} */
  const faults = [];

  /** @param {string} url @param {string} from */
  function add(url, from) {
    const path = localPath(url, from);
    if (path === null) return void faults.push(`${from} names ${url}, which is not a path relative to the page.`);
    if (files.has(path)) return;
    if (!existsSync(join(dist, path)))
      return void faults.push(`${from} names ${url}, which is not in the built folder.`);
    files.add(path);
    for (const next of dependenciesOf(dist, path)) add(next, path);
  }

  for (const { name, attributes, hasText } of tags) {
    if (name === 'script' && attributes.src === undefined && hasText)
      faults.push('index.html has a script in the page itself.');
    if (name !== 'link' && attributes.src !== undefined) add(attributes.src, 'index.html');
  }
  const needed = new Set(files);
  for (const { attributes } of tags.filter(({ name }) => name === 'link')) {
    const kinds = (attributes.rel ?? '').toLowerCase().split(/\s+/);
    const url = attributes.href ?? '';
    if (kinds.some((kind) => FETCHED_AHEAD.includes(kind))) faults.push(`index.html fetches ${url} ahead of need.`);
    if (!kinds.some((kind) => FETCHED_NOW.includes(kind))) continue;
    add(url, 'index.html');
    const path = localPath(url, 'index.html') ?? '';
    if (extname(path) === '.js' && !needed.has(path)) faults.push(`index.html loads ${url} before it is needed.`);
  }
  return { files: [...files], faults };
}

/**
 * @param {string} html as Vite writes it
 * @returns {{ name: string, attributes: Record<string, string | undefined>, hasText: boolean }[]}
 */
function readTags(html) {
  const text = html.replace(/<!--[\s\S]*?-->/g, '');
  return [
    ...text.matchAll(/<([a-z][a-z0-9-]*)((?:\s+[^\s=>/]+(?:\s*=\s*(?:"[^"]*"|'[^']*'|[^\s>"']+))?)*)\s*\/?>([^<]*)/gi),
  ].map(([, name, attributes, after]) => ({
    name: name.toLowerCase(),
    attributes: Object.fromEntries(
      [...attributes.matchAll(/([^\s=>/]+)(?:\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s>"']+)))?/g)].map(
        ([, key, double, single, bare]) => [key.toLowerCase(), double ?? single ?? bare ?? ''],
      ),
    ),
    hasText: after.trim() !== '',
  }));
}

/**
 * @param {string} url
 * @param {string} from the file in the folder that names it
 * @returns {string | null} the path in the folder; null when the address depends on where the page is hosted
 */
function localPath(url, from) {
  if (/^([a-z][a-z0-9+.-]*:|\/)/i.test(url)) return null;
  const path = posix.normalize(posix.join(posix.dirname(from), decodeURI(url.replace(/[?#].*$/, ''))));
  return path.startsWith('..') ? null : path;
}

/**
 * @param {string} dist
 * @param {string} path
 * @returns {string[]} addresses that the file makes the browser fetch at once
 */
function dependenciesOf(dist, path) {
  const extension = extname(path);
  if (extension === '.js') return staticImports(readFileSync(join(dist, path), 'utf8'));
  if (extension === '.css') return addressesInStyles(readFileSync(join(dist, path), 'utf8'));
  return [];
}

/** @param {string} code */
function staticImports(code) {
  return parseAst(code).body.flatMap((node) => {
    const isImport =
      node.type === 'ImportDeclaration' ||
      node.type === 'ExportNamedDeclaration' ||
      node.type === 'ExportAllDeclaration';
    return isImport && node.source ? [node.source.value] : [];
  });
}

/** @param {string} css */
function addressesInStyles(css) {
  const addresses = [...css.matchAll(/url\(\s*(?:"([^"]*)"|'([^']*)'|([^)\s]*))\s*\)|@import\s*["']([^"']+)["']/g)];
  return addresses
    .map(([, double, single, bare, imported]) => double ?? single ?? bare ?? imported)
    .filter((address) => !/^(data:|#)/.test(address));
}
