/** How the page is built: relative addresses only, so that the built folder runs from any sub-path of any static host. */
import { defineConfig } from 'vite';
import { bootstrapParts } from './scripts/bootstrapParts.mjs';
import { contentPolicyPlugin } from './scripts/contentPolicy.mjs';
import { threeParts } from './scripts/threeParts.mjs';

export default defineConfig({
  base: './',
  plugins: [contentPolicyPlugin(), threeParts()],
  worker: { format: 'es' }, // what jobs have in common is fetched by all of them
  css: { postcss: { plugins: [bootstrapParts()] } },
  build: {
    target: 'es2022',
    sourcemap: true,
    modulePreload: { polyfill: false }, // one that cannot preload modules loads them a little later, that is all
    chunkSizeWarningLimit: 600, // kB before compression; what counts is measured by scripts/size.mjs
    rolldownOptions: {
      checks: { bundlerTimings: false }, // slow plugins are no news on a slow machine
      output: {
        codeSplitting: {
          // Apart, because they seldom change: a new version of the page finds them in the browser's cache.
          // Only what the first load needs anyway; what is imported when needed stays with those who import it.
          groups: [
            { name: 'three', test: /[\\/]node_modules[\\/]three[\\/]/, tags: ['$initial'] },
            {
              name: 'bootstrap',
              test: /[\\/]node_modules[\\/](bootstrap|@popperjs|jquery)[\\/].*js$/,
              tags: ['$initial'],
            },
            // All of the first load's own code in one piece: what panels that come later share with it would else be cut into
            // a dozen small ones, which compress worse together.
            { name: 'page', test: /[\\/]src[\\/].*\.js$/, tags: ['$initial'] },
          ],
        },
      },
    },
  },
});
