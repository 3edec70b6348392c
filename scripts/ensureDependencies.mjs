/**
 * Installs what package-lock.json says, when node_modules is missing or does not match it; says nothing otherwise.
 * Imports only what Node brings, since it runs before anything is installed; and avoids newer syntax, so that an old
 * Node gets as far as the sentence that says so.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { isMain } from './isMain.mjs';
import { nodeVersionProblem } from './nodeVersion.mjs';

const ROOT = dirname(dirname(fileURLToPath(import.meta.url)));

/**
 * @typedef {object} LockedPackage
 * @property {string} [version]
 * @property {string} [integrity]
 * @property {boolean} [optional]     belongs to some platforms only
 * @property {boolean} [devOptional]
 * @property {Record<string, string>} [dependencies]
 * @property {Record<string, string>} [devDependencies]
 */

/**
 * @param {string} path
 * @returns {{ packages: Record<string, LockedPackage> } & LockedPackage}
 */
const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));

/**
 * Why node_modules is not what the lock file says, or undefined when it is. Compares the record that npm leaves in
 * node_modules, and looks whether each package is really there; packages beyond the lock do no harm.
 * @param {string} root
 * @returns {string | undefined}
 */
export function dependencyProblem(root) {
  const record = join(root, 'node_modules', '.package-lock.json');
  if (!existsSync(record)) return 'node_modules is missing';
  const locked = readJson(join(root, 'package-lock.json')).packages;
  const installed = readJson(record).packages;
  const wanted = readJson(join(root, 'package.json'));

  for (const kind of /** @type {const} */ (['dependencies', 'devDependencies'])) {
    for (const [name, range] of Object.entries(wanted[kind] || {})) {
      if ((locked[''][kind] || {})[name] !== range) return `package-lock.json does not have ${name} ${range}`;
    }
  }
  for (const [path, { version, integrity, optional, devOptional }] of Object.entries(locked)) {
    if (path === '') continue;
    const found = installed[path];
    if (!found && (optional || devOptional)) continue; // for another platform
    if (!found || !existsSync(join(root, path, 'package.json'))) return `${path} is missing`;
    if (found.version !== version || found.integrity !== integrity) return `${path} is not version ${version}`;
  }
  return undefined;
}

/**
 * Runs npm: the one that started this script where there is one, so that no other copy of it is needed on the path.
 * @param {string[]} args
 * @param {string} root
 */
function npm(args, root) {
  const npmScript = process.env.npm_execpath || '';
  const found = /npm-cli\.c?js$/.test(npmScript);
  const { error, status } = found
    ? spawnSync(process.execPath, [npmScript, ...args], { cwd: root, stdio: 'inherit' })
    : spawnSync(`npm ${args.join(' ')}`, { cwd: root, stdio: 'inherit', shell: true });
  return !error && status === 0;
}

/**
 * Leaves node_modules as the lock file says, or throws with one sentence.
 * @param {string} [root]
 */
export function ensureDependencies(root = ROOT) {
  const versionProblem = nodeVersionProblem(process.versions.node);
  if (versionProblem) throw new Error(versionProblem);
  const problem = dependencyProblem(root);
  if (!problem) return;

  const options = ['--include=dev', '--no-audit', '--no-fund'];
  console.log(`Installing the packages of package-lock.json, since ${problem}.`);
  if (npm(['ci', ...options], root)) return;
  console.log('npm ci failed (its reason is above), so npm install tries, which may change package-lock.json.');
  if (npm(['install', ...options], root)) return;
  throw new Error(
    'The packages could not be installed; see what npm says above, then try again or run "npm ci" by hand.',
  );
}

if (isMain(import.meta.url)) {
  try {
    ensureDependencies();
  } catch (error) {
    console.error(/** @type {Error} */ (error).message);
    process.exitCode = 1;
  }
}
