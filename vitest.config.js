/** Unit and property tests: plain Node, no browser. One worker, since two weak cores gain nothing from more. */
import { defineConfig, mergeConfig } from 'vitest/config';
import viteConfig from './vite.config.js';

const deep = Boolean(process.env.DENAVIT_DEEP);

export default mergeConfig(
  viteConfig,
  defineConfig({
    test: {
      include: ['tests/unit/**/*.test.js'],
      environment: 'node',
      pool: 'threads',
      maxWorkers: 1,
      testTimeout: deep ? 1_800_000 : 60_000, // a guard against hanging, not a measure of speed
      coverage: { provider: 'v8', include: ['src/**/*.js'], exclude: ['src/**/*.d.ts'], reporter: ['text', 'html'] },
    },
  }),
);
