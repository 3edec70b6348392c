/**
 * What somebody with a screen reader, a keyboard or weak eyes would trip over, as axe-core sees it. It is run right in the
 * page, which has no frames: a tenth of the time that it takes to hand it from frame to frame.
 *
 * @import { Page } from '@playwright/test'
 */
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { expect } from '@playwright/test';
import { settled } from './page.js';

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/**
 * @param {Page} page
 * @param {object} [options]
 * @param {string} [options.within]  a selector; else the whole page
 * @param {string[]} [options.rules]  by their ids; else all
 */
export async function expectAccessible(page, { within, rules } = {}) {
  await settled(page);
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(AXE);
  const faults = await page.evaluate(
    async ({ within, rules }) => {
      const axe = /** @type {typeof import('axe-core')} */ (Reflect.get(window, 'axe'));
      const part = within === undefined ? document : document.querySelector(within);
      if (!part) return [`There is no ${within}.`];
      const { violations } = await axe.run(part, {
        resultTypes: ['violations'],
        ...(rules && { runOnly: { type: /** @type {const} */ ('rule'), values: rules } }),
      });
      return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
    },
    { within, rules },
  );
  expect(faults).toEqual([]);
}
