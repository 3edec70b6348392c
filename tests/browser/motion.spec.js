/** What shows how the arm moves: the trace of its tool, the dials of its joints, and their curves. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { draws, open, settled, tool } from './page.js';

test('the trace is as long as the way of the tool, has gaps where it was not, and is cleared and switched off', async ({
  page,
}) => {
  await open(page, 'q=0,40,-150,0,30,0&trace=on');
  const line = page.getByRole('group', { name: 'Trace of the tool' });
  await expect(line).toContainText('move the arm');
  const [x, y] = await tool(page);
  const slider = page.getByRole('slider', { name: 'Joint 1', exact: true });
  await slider.focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowRight');
  const angle = await page.evaluate(() => window.denavit.joints()[0]);
  expect(angle).toBeGreaterThan(5);
  // an arc about the axis of joint 1
  const length = Math.hypot(x, y) * ((angle / 180) * Math.PI) * 1000;
  await expect(line).toContainText(`${length.toFixed(1)} mm`);
  await expect(page.locator('.trace-start')).toBeVisible();
  await page.getByRole('button', { name: 'Go to home', exact: true }).click();
  await slider.focus();
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(line).toContainText('in 2 strokes');
  await settled(page);
  const drawn = await draws(page);
  await settled(page);
  expect(await draws(page)).toBe(drawn); // at rest it costs nothing
  await expectAccessible(page, { within: '.trace-line' });

  await line.getByRole('button', { name: 'Clear', exact: true }).click();
  await expect(line).toContainText('move the arm');
  await expect(page.locator('.trace-start')).toBeHidden();
  await page.getByRole('button', { name: 'Frames', exact: true }).click();
  await page.getByRole('button', { name: 'No trace', exact: true }).click();
  await expect(line).toBeHidden();
  await expect(page.locator('canvas')).not.toHaveAttribute('aria-label', /trace/i);
});

test('a joint is turned by its dial, by hand and by keys, and says what is left to its limits', async ({ page }) => {
  await open(page, 'q=0,40,-150,0,30,0');
  const panel = page.locator('.jog-panel');
  await panel.getByText('Dials', { exact: true }).click();
  const dial = panel.getByRole('slider', { name: 'Joint 1', exact: true });
  await expect(dial).toHaveCSS('opacity', '0'); // the arc is drawn in its place
  const joint = () => page.evaluate(() => window.denavit.joints()[0]);
  const box = await dial.boundingBox();
  if (!box) throw new Error('The dial is not seen.');
  const [x, y, radius] = [box.x + box.width / 2, box.y + box.height / 2, box.width / 2 - 4];
  /** @param {number} degrees  clockwise from the top */
  const go = (degrees) => {
    const angle = (degrees / 180) * Math.PI;
    return page.mouse.move(x + radius * Math.sin(angle), y - radius * Math.cos(angle));
  };
  await go(-30);
  await page.mouse.down();
  for (const degrees of [-20, 0, 20, 40, 60]) await go(degrees);
  // 90 of the 270 degrees of the arc, on which the joint has 320
  expect(Math.abs((await joint()) - 320 / 3)).toBeLessThan(0.2);
  await expect(dial).toHaveAttribute('aria-valuetext', /^106\.\d°$/);
  await page.keyboard.press('Escape');
  expect(await joint()).toBe(0);
  await page.mouse.up();

  await dial.focus();
  await page.keyboard.press('End');
  const row = panel.locator('.jog', { has: page.getByRole('slider', { name: 'Joint 1', exact: true }) });
  await expect(row).toHaveClass(/is-near/);
  await expect(row.locator('.margin')).toHaveText('0.0° to limit');
  await panel.getByText('Stop at limits', { exact: true }).click();
  await dial.focus();
  await page.keyboard.press('PageUp');
  await expect(row.locator('.margin')).toHaveText('10.0° beyond');
  await expectAccessible(page, { within: '.jog-panel' });
});

test('curves run while the arm moves and only then, with a table that says the same, and are copied as they are drawn', async ({
  page,
}) => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await open(page, 'q=0,40,-150,0,30,0&panels=jog,pose');
  await page.locator('#fold-motion').click();
  const body = page.locator('#fold-motion-body');
  await expect(body).toContainText('Nothing has moved');
  await expect(body.getByRole('button', { name: 'Copy as CSV', exact: true })).toBeDisabled();
  const slider = page.getByRole('slider', { name: 'Joint 1', exact: true });
  await slider.focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press('Shift+ArrowRight');
  const row = (/** @type {string} */ name) => body.getByRole('row', { name: new RegExp(`^${name} `) });
  await expect(row('J1')).toContainText('40.0°0.0°40.0°');
  await expect(row('J2')).toContainText('40.0°40.0°40.0°');
  // at rest the speed is zero; what it was while a button was held, jogging.spec reads under the manual clock
  await expect(row('Speed').getByRole('cell').first()).toHaveText('0.0 mm/s');

  await body.getByRole('button', { name: 'Pause', exact: true }).click();
  await slider.focus();
  await page.keyboard.press('Shift+ArrowRight');
  await settled(page);
  await expect(row('J1')).toContainText('40.0°0.0°40.0°');
  await body.getByRole('button', { name: 'J1', exact: true }).click();
  await expect(body.getByRole('button', { name: 'J1', exact: true })).toHaveAttribute('aria-pressed', 'false');
  await body.getByRole('button', { name: 'Copy as CSV', exact: true }).click();
  await expect(page.getByRole('status').filter({ hasText: 'comma-separated' })).toHaveCount(1);
  const lines = (await page.evaluate(() => navigator.clipboard.readText())).trim().split(/\r?\n/);
  expect(lines[0]).toBe('time [s],J1 [deg],J2 [deg],J3 [deg],J4 [deg],J5 [deg],J6 [deg],Tool speed [mm/s]');
  expect(lines[1].split(',').map(Number)).toEqual([0, 0, 40, -150, 0, 30, 0, 0]);
  const last = lines[lines.length - 1].split(',').map(Number);
  expect(last.slice(1)).toEqual([40, 40, -150, 0, 30, 0, 0]);
  await expectAccessible(page, { within: '#fold-motion-body' });

  // the same as a drawing, read by its own scale: the joints but J1, which is switched off
  const coming = page.waitForEvent('download');
  await body.getByRole('button', { name: 'Save SVG', exact: true }).click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('motion.svg');
  const drawn = await page.evaluate(
    (text) => {
      const drawing = new DOMParser().parseFromString(text, 'image/svg+xml');
      const [plot] = drawing.querySelectorAll('g');
      const scale = [...plot.querySelectorAll('text[text-anchor=end]')].map(({ textContent, attributes }) => [
        Number(attributes.getNamedItem('y')?.value) - 4, // from the foot of the text to its middle
        Number(textContent?.replace('−', '-')),
      ]);
      const [[y0, v0], [y1, v1]] = [scale[0], scale[scale.length - 1]];
      const curves = [...plot.querySelectorAll('path[data-curve]')].map((path) => {
        const y = Number(path.getAttribute('d')?.split(' ').at(-1));
        return [path.getAttribute('data-curve'), v0 + ((y - y0) / (y1 - y0)) * (v1 - v0)];
      });
      return {
        curves,
        text: drawing.documentElement.textContent,
        faults: drawing.querySelectorAll('parsererror').length,
      };
    },
    await readFile(await download.path(), 'utf8'),
  );
  expect(drawn.faults).toBe(0);
  expect(drawn.text).toContain('Joint values [°]');
  expect(drawn.text).toContain('Tool speed [mm/s]');
  // a curve with pauses is drawn in pieces, of which the last ends where the joint is
  const ends = new Map(drawn.curves.map(([name, value]) => [name, Number(value)]));
  expect([...ends.keys()]).toEqual(['J2', 'J3', 'J4', 'J5', 'J6']);
  [...ends.values()].forEach((value, i) => expect(Math.abs(value - [40, -150, 0, 30, 0][i])).toBeLessThan(1));
});
