/**
 * The workers' script is built together with the page, as a second entry, so that what page and workers both need (the kernel)
 * is in the built folder once. Vite by itself builds workers apart, with a copy of everything they need.
 *
 * No worker can run the page. So the build fails if a job imports the piece that starts it.
 */
import { fileURLToPath } from 'node:url';

const STARTER = '/src/ui/parts/startJob.js';
const WRITTEN = "new URL('../../workers/worker.js', import.meta.url)";
const START = fileURLToPath(new URL('../src/main.js', import.meta.url));
const SCRIPT = fileURLToPath(new URL('../src/workers/worker.js', import.meta.url));

/** @returns {import('vite').Plugin} */
export const workerEntry = () => ({
  name: 'worker-entry',
  apply: 'build',
  enforce: 'pre', // before Vite sees a worker in it
  transform: {
    filter: { id: /[\\/]startJob\.js$/ },
    handler(code, id) {
      if (!id.replaceAll('\\', '/').endsWith(STARTER)) return null;
      if (!code.includes(WRITTEN)) this.error(`${STARTER} no longer says ${WRITTEN}.`);
      const script = this.emitFile({ type: 'chunk', id: SCRIPT, name: 'worker' });
      return { code: code.replace(WRITTEN, `import.meta.ROLLUP_FILE_URL_${script}`), map: null };
    },
  },
  generateBundle(_, bundle) {
    const pieces = Object.values(bundle).filter((file) => file.type === 'chunk');
    const worker = pieces.find(({ facadeModuleId }) => facadeModuleId === SCRIPT);
    if (!worker) this.error('The build has no piece for the workers.');
    const fetched = importedBy([worker.fileName, ...worker.dynamicImports], bundle);
    const page = pieces.find(({ fileName, moduleIds }) => fetched.has(fileName) && moduleIds.includes(START));
    if (page) this.error(`A worker would fetch ${page.fileName}, which starts the page.`);
  },
});

/**
 * @param {readonly string[]} names  of pieces
 * @param {Record<string, import('vite').Rollup.OutputChunk | import('vite').Rollup.OutputAsset>} bundle
 * @returns {Set<string>} these, and what is fetched with them at once
 */
function importedBy(names, bundle) {
  const fetched = new Set(names);
  for (const name of fetched) {
    const piece = bundle[name];
    if (piece?.type === 'chunk') piece.imports.forEach((next) => fetched.add(next));
  }
  return fetched;
}
