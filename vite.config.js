/** How the page is built: relative addresses only, so that the built folder runs from any sub-path of any static host. */
import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  build: {
    target: 'es2022',
    sourcemap: true,
    modulePreload: { polyfill: false }, // one that cannot preload modules loads them a little later, that is all
    chunkSizeWarningLimit: 600, // kB before compression; what counts is measured by scripts/size.mjs
    rolldownOptions: {
      output: {
        codeSplitting: {
          // Apart, because they change only with package-lock.json: a new version of the page reuses them from the cache.
          groups: [
            { name: 'three', test: /[\\/]node_modules[\\/]three[\\/]/ },
            { name: 'bootstrap', test: /[\\/]node_modules[\\/](bootstrap|@popperjs|jquery)[\\/].*js$/ },
          ],
        },
      },
    },
  },
});
