/**
 * Unit and property tests: plain Node, no browser. One worker, since two weak cores gain nothing from more; and files
 * share their modules, which saves a third of the time and is safe because no module of ours holds state.
 */
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
      isolate: false,
      testTimeout: timeout,
      hookTimeout: timeout,
      coverage: { provider: 'v8', include: ['src/**/*.js'], exclude: ['src/**/*.d.ts'], reporter: ['text', 'html'] },
    },
  }),
);
