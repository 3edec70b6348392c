/**
 * Unit and property tests: plain Node, no browser. One worker, since two weak cores gain nothing from more. Node loads what it
 * can by itself, a sixth quicker than through Vite; the few tests that need Vite's ways of importing are named here.
 */
import { defineConfig, mergeConfig } from 'vitest/config';
import viteConfig from './vite.config.js';

/** They import a style sheet or plain JSON, a whole folder, or a package that is watched. */
const BY_VITE = ['docs', 'io/robotXml', 'io/xmlTree', 'ui/parameterWarnings'].map(
  (name) => `tests/unit/${name}.test.js`,
);

/** A guard against hanging, not a measure of speed: the machine may be slow and busy. */
const timeout = process.env.DENAVIT_DEEP ? 1_800_000 : 120_000;

export default mergeConfig(
  viteConfig,
  defineConfig({
    test: {
      environment: 'node',
      pool: 'threads',
      maxWorkers: 1,
      isolate: false, // the modules of all files are loaded once; no test changes what another sees
      testTimeout: timeout,
      hookTimeout: timeout,
      projects: [
        {
          extends: true,
          test: {
            name: 'by Node',
            include: ['tests/unit/**/*.test.js'],
            exclude: BY_VITE,
            experimental: { viteModuleRunner: false, nodeLoader: false },
          },
        },
        { extends: true, test: { name: 'by Vite', include: BY_VITE } },
      ],
      coverage: { provider: 'v8', include: ['src/**/*.js'], exclude: ['src/**/*.d.ts'], reporter: ['text', 'html'] },
    },
  }),
);
