/** The Node versions the tools run on: the first of each line that has what Vite needs. Keep in step with package.json. */
const FIRST = { 20: 19, 22: 12 };
const NEWEST_LINE = 22;

/**
 * @param {string} version as process.versions.node
 * @returns {string | undefined} what is wrong with it, in one sentence
 */
export function nodeVersionProblem(version) {
  const [major, minor] = version.split('.').map(Number);
  const first = /** @type {Record<number, number | undefined>} */ (FIRST)[major];
  if (major > NEWEST_LINE || (first !== undefined && minor >= first)) return undefined;
  return `Denavit needs Node 20.19 or later (of Node 22: 22.12 or later), and this is Node ${version}; install a current one from https://nodejs.org.`;
}
