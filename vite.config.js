/** How the page is built: relative addresses only, so that the built folder runs from any sub-path of any static host. */
import { defineConfig } from 'vite';
import { bootstrapParts } from './scripts/bootstrapParts.mjs';
import { contentPolicyPlugin } from './scripts/contentPolicy.mjs';
import { threeParts } from './scripts/threeParts.mjs';
import { workerEntry } from './scripts/workerEntry.mjs';

export default defineConfig({
  base: './',
  plugins: [contentPolicyPlugin(), threeParts(), workerEntry()],
  css: { postcss: { plugins: [bootstrapParts()] } },
  build: {
    target: 'es2022',
    sourcemap: true,
    modulePreload: {
      polyfill: false, // a browser that cannot preload modules loads them a little later, that is all
      // A worker has no document to write preloads into.
      resolveDependencies: (_, dependencies, { hostId }) => (/[\\/]worker-/.test(hostId) ? [] : dependencies),
    },
    chunkSizeWarningLimit: 600, // kB before compression; what counts is measured by scripts/size.mjs
    rolldownOptions: {
      checks: {
        bundlerTimings: false, // slow plugins are no news on a slow machine
        ineffectiveDynamicImport: false, // two of one subject are one piece, also where one asks for the other when needed
      },
      output: {
        codeSplitting: {
          groups: [
            // Apart, because they seldom change: a new version of the page finds them in the browser's cache. Only what the first
            // load needs anyway; what is imported when needed stays with those who import it.
            { name: 'three', test: /[\\/]node_modules[\\/]three[\\/]/, tags: ['$initial'] },
            {
              name: 'bootstrap',
              test: /[\\/]node_modules[\\/](bootstrap|@popperjs|jquery)[\\/].*js$/,
              tags: ['$initial'],
            },
            // What workers need too stands apart from the page, which no worker can run.
            { name: 'core', test: /[\\/]src[\\/](kinematics|motion|model)[\\/]|preload-helper/, tags: ['$initial'] },
            { name: 'page', test: /[\\/]src[\\/](?!workers)/, tags: ['$initial'] },
            // What is imported when needed but always much of it together: in many small pieces it weighs a fifth more than in one.
            ...later({
              kinematics: '(kinematics|motion)',
              parts:
                'ui/(travel|css/(typedIn|controller)|robot/poseEditor|parts/(dialog|textEditor|menuPlugin|severalField|segments|svg|scientific|curveStyle|clipboard|startJob|lastQuestion))',
              tables:
                '(io/(csv|postureCsv|fileIssues|fileLimits|stepsText|poseText|quaternions)|model/(controller/controllerValues|aim/solutions|numbers/orientationNotation))',
              program: '(ui|model)/(program|workcell)',
              workspace: '(ui/workspace|model/workspace|io/workspace)',
              files: 'io',
              chosen: 'ui/files',
              code: '(model/(code|controller)|karel|ui/words/(code|writeCode)|ui/code/(?!codeRoom|editor|languages)[A-Za-z]+)',
              marks: 'render/(drag|marks)',
              arm: 'ui/(aim|pose|jog/(jog|pendant)[A-Za-z]*|robot/(?!pasteTable|robot|frame)[A-Za-z]*)',
              robot: 'ui/robot/(pasteTable|robot|frame)[A-Za-z]*',
            }),
          ],
        },
      },
    },
  },
});

/** @param {Record<string, string>} folders of src, by the name of the piece that they become */
function later(folders) {
  return Object.entries(folders).map(([name, folder]) => ({
    name,
    test: new RegExp(`/src/${folder}(?:/.*)?\\.(js|css)$`.replaceAll('/', '[\\\\/]')),
  }));
}
