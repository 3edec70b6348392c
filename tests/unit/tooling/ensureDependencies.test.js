import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { dependencyProblem } from '../../../scripts/ensureDependencies.mjs';
import { nodeVersionProblem } from '../../../scripts/nodeVersion.mjs';

/** @type {string} */
let root;
beforeEach(() => (root = mkdtempSync(join(tmpdir(), 'denavit-'))));
afterEach(() => rmSync(root, { recursive: true, force: true }));

const ONE = { version: '1.0.0', integrity: 'sha512-one' };
const OTHER_PLATFORM = { version: '1.0.0', integrity: 'sha512-two', optional: true };

/** @param {string} path @param {object} content */
function write(path, content) {
  mkdirSync(dirname(join(root, path)), { recursive: true });
  writeFileSync(join(root, path), JSON.stringify(content));
}

/** A project with one package, installed as its lock file says. */
function installed() {
  const dependencies = { one: '1.0.0' };
  write('package.json', { dependencies });
  write('package-lock.json', {
    packages: { '': { dependencies }, 'node_modules/one': ONE, 'node_modules/two': OTHER_PLATFORM },
  });
  write('node_modules/.package-lock.json', { packages: { 'node_modules/one': ONE } });
  write('node_modules/one/package.json', {});
}

describe('packages are installed', () => {
  test('not when they are as the lock file says, whatever other platforms need', () => {
    installed();
    expect(dependencyProblem(root)).toBeUndefined();
  });

  test('when node_modules is missing', () => {
    installed();
    rmSync(join(root, 'node_modules'), { recursive: true });
    expect(dependencyProblem(root)).toBe('node_modules is missing');
  });

  test('when a package is of another version', () => {
    installed();
    write('node_modules/.package-lock.json', { packages: { 'node_modules/one': { ...ONE, version: '0.9.0' } } });
    expect(dependencyProblem(root)).toBe('node_modules/one is not version 1.0.0');
  });

  test('when a package of the same version has other content', () => {
    installed();
    write('node_modules/.package-lock.json', { packages: { 'node_modules/one': { ...ONE, integrity: 'sha512-x' } } });
    expect(dependencyProblem(root)).toMatch(/node_modules\/one/);
  });

  test('when a package was deleted by hand', () => {
    installed();
    rmSync(join(root, 'node_modules/one'), { recursive: true });
    expect(dependencyProblem(root)).toBe('node_modules/one is missing');
  });

  test('when package.json asks for what the lock file does not have', () => {
    installed();
    write('package.json', { dependencies: { one: '1.0.0' }, devDependencies: { three: '3.0.0' } });
    expect(dependencyProblem(root)).toBe('package-lock.json does not have three 3.0.0');
  });
});

test.each(['20.19.0', '20.20.2', '22.12.0', '22.21.1', '24.0.0', '26.1.0'])('Node %s will do', (version) => {
  expect(nodeVersionProblem(version)).toBeUndefined();
});

test.each(['14.21.3', '18.20.0', '20.18.3', '21.7.0', '22.11.0'])('Node %s is refused in one sentence', (version) => {
  expect(nodeVersionProblem(version)).toMatch(
    /^Denavit needs Node 20\.19 .* this is Node \d+\.\d+\.\d+; [^.]*https:\/\/nodejs\.org\.$/,
  );
});
