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
  if (!(await page.evaluate(() => 'axe' in window))) {
    await page.evaluate(AXE);
    await page.evaluate(readColoursOnce);
  }
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

/** The text of a colour says the same at every element: axe, which reads it at each anew, takes a third less time so. */
function readColoursOnce() {
  /** @typedef {{ r: number, g: number, b: number, alpha: number, parseString: (text: string) => unknown }} Colour */
  const { prototype } = /** @type {{ prototype: Colour }} */ (Reflect.get(window, 'axe').commons.color.Color);
  const { parseString } = prototype;
  /** @type {Map<string, Pick<Colour, 'r' | 'g' | 'b' | 'alpha'>>} */
  const known = new Map();
  prototype.parseString = function (text) {
    const found = known.get(text);
    if (found) return Object.assign(this, found);
    parseString.call(this, text);
    const { r, g, b, alpha } = this;
    known.set(text, { r, g, b, alpha });
    return this;
  };
}
