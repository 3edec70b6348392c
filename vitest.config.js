/** Unit and property tests: plain Node, no browser. One worker, since two weak cores gain nothing from more. */
import { defineConfig, mergeConfig } from 'vitest/config';
import viteConfig from './vite.config.js';

/** A guard against hanging, not a measure of speed: the machine may be slow and busy. */
const timeout = process.env.DENAVIT_DEEP ? 1_800_000 : 120_000;

export default mergeConfig(
  viteConfig,
  defineConfig({
    test: {
      include: ['tests/unit/**/*.test.js'],
      environment: 'node',
      pool: 'threads',
      maxWorkers: 1,
      isolate: false, // the modules of all files are loaded once; no test changes what another sees
      testTimeout: timeout,
      hookTimeout: timeout,
      coverage: { provider: 'v8', include: ['src/**/*.js'], exclude: ['src/**/*.d.ts'], reporter: ['text', 'html'] },
    },
  }),
);
