/** The scene: what it draws beside the arm, from where it is seen, and pictures that were looked at and found good. */
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { draws, expectPicture, open, picture, settled } from './page.js';

/** @import { Page } from '@playwright/test' */

/** Less to draw, and to compare; still a wide page. */
const SMALL = { width: 1160, height: 520 };

const cell = (/** @type {Page} */ page, /** @type {string} */ label) => page.getByLabel(label, { exact: true });
const dimension = (/** @type {Page} */ page) => page.locator('.tag.dim');

/** @param {Page} page @param {string} menu @param {string} choice */
async function choose(page, menu, choice) {
  await page.getByRole('button', { name: menu, exact: true }).click();
  await page.locator('.dropdown-menu.show').getByText(choice, { exact: true }).click();
}

/** @param {Page} page @param {string} key in the view */
async function press(page, key) {
  await page.locator('canvas').focus();
  await page.keyboard.press(key);
}

/** Letters depend on the machine's fonts, and tools are no part of the scene. */
const stylePath = fileURLToPath(new URL('sceneOnly.css', import.meta.url));

/** @param {Page} page @param {string} name */
async function looksAs(page, name) {
  await settled(page);
  await expect(page.locator('canvas')).toHaveScreenshot(`${name}.png`, { stylePath });
}

/** @param {Page} page @param {string} robot id or XML */
async function load(page, robot) {
  await page.evaluate((text) => window.denavit.load(text), robot);
  await settled(page);
}

test('a cell that is chosen, or under the pointer, is drawn as a dimension; nothing is left of it afterwards', async ({
  page,
}) => {
  await page.setViewportSize(SMALL);
  await open(page);
  const before = await picture(page);
  for (const [label, words] of [
    ['Joint 1, link offset d, millimetres', 'd1 = 671.83 mm'],
    ['Joint 3, link twist α, degrees', 'α3 = −90°'],
    ['Joint 2, joint angle θ, degrees', 'θ2 + q2 = 45.0°'],
    ['Joint 5, link length a, millimetres', 'a5 = 0'],
  ]) {
    await cell(page, label).focus();
    await expect(dimension(page)).toHaveText(words);
  }
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', /Dimension drawn: a₅ = 0\./);
  await cell(page, 'Joint 3, link length a, millimetres').hover();
  await expect(dimension(page)).toHaveText('a3 = 20.3 mm');
  await page.mouse.move(600, 400);
  await expect(dimension(page)).toHaveText('a5 = 0');
  await cell(page, 'Joint 2, upper limit, degrees').focus();
  await expect(dimension(page)).toHaveText('J2 45.0°'); // the gauge with the limits
  await page.locator('canvas').focus();
  await expect(dimension(page)).toHaveCount(0);
  await page.locator('canvas').evaluate((canvas) => canvas.blur());
  await expectPicture(page, before);
});

test('views and projections are chosen by menu, cube and keys, frames by menu; what is on is said in words', async ({
  page,
}) => {
  await page.setViewportSize(SMALL);
  await open(page);
  const status = page.locator('[role=status].visually-hidden').first();
  await page.locator('[data-face=front]').click({ force: true });
  await expect(status).toHaveText(/View: Front\./);
  await page.mouse.move(0, 0);
  const front = await picture(page);
  await choose(page, 'Direction of view', 'Parallel (orthographic)');
  await press(page, '2');
  await expect(status).toHaveText(/View: Back\./);
  await choose(page, 'Direction of view', 'Perspective');
  await press(page, '1');
  await page.locator('canvas').evaluate((canvas) => canvas.blur());
  await page.mouse.move(0, 0);
  await expectPicture(page, front);
  await choose(page, 'Frames', 'All frames');
  await expect(page.locator('.tag.axis-z').filter({ hasText: /^z[0-6]$/ })).toHaveCount(7);
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', /Frames drawn: base, 1, 2, 3, 4, 5, 6, tool\./);
  await load(page, 'planar2r');
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', /Frames drawn: base, 1, 2, tool\./);
  await choose(page, 'Frames', 'No frames');
  await expect(page.locator('.tag.axis:visible')).toHaveCount(0);
  const drawn = await draws(page);
  for (let i = 0; i < 3; i++) await settled(page);
  expect(await draws(page)).toBe(drawn);
});

test('“Build it” is played by keys alone, says each step, and leaves no trace', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await open(page);
  const before = await picture(page);
  await cell(page, 'Joint 3, link length a, millimetres').focus();
  await expect(dimension(page)).toHaveCount(1);
  await page.getByRole('button', { name: 'Build it' }).press('Enter');
  const player = page.getByRole('region', { name: 'Build it: how a row makes a frame' });
  await expect(player).toContainText('Four motions take frame 2 to frame 3.');
  const words = ['1 of 4: turn −180.0° about z₂ (θ₃ + q₃).', '2 of 4: slide 150.05 mm along z₂ (d₃).'];
  for (const said of [
    ...words,
    '3 of 4: slide 20.3 mm along x₃ (a₃).',
    '4 of 4: turn −90° about x₃ (α₃). That is frame 3.',
  ]) {
    await page.keyboard.press('ArrowRight');
    await expect(player).toContainText(said);
    await expect(page.locator('[role=status].visually-hidden').first()).toContainText(said);
  }
  await page.keyboard.press('ArrowLeft');
  await expect(player).toContainText('3 of 4:');
  await page.keyboard.press('Escape');
  await expect(player).toHaveCount(0);
  await expect(page.getByRole('button', { name: 'Build it' })).toBeFocused();
  await page.locator('canvas').focus();
  await page.locator('canvas').evaluate((canvas) => canvas.blur());
  await expectPicture(page, before);
});

test('the picture comes back after the graphics context was lost, with all that was drawn', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await open(page);
  await choose(page, 'Frames', 'All frames');
  await cell(page, 'Joint 2, joint angle θ, degrees').focus();
  await expect(dimension(page)).toHaveCount(1);
  await page.addStyleTag({ content: '* { caret-color: transparent !important; }' });
  const before = await picture(page);
  await page.locator('canvas').evaluate(async (canvas) => {
    const gl = /** @type {HTMLCanvasElement} */ (canvas).getContext('webgl2');
    const loss = gl?.getExtension('WEBGL_lose_context');
    const event = (/** @type {string} */ name) => new Promise((resolve) => canvas.addEventListener(name, resolve));
    const [lost, restored] = [event('webglcontextlost'), event('webglcontextrestored')];
    loss?.loseContext();
    await lost;
    await new Promise((resolve) => requestAnimationFrame(resolve)); // it may not be restored while the loss is being told
    loss?.restoreContext();
    await restored;
  });
  await expectPicture(page, before);
});

test('pictures: the arm of the first load', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await open(page);
  await looksAs(page, 'puma-home');
  await cell(page, 'Joint 1, link offset d, millimetres').focus();
  await expect(dimension(page)).toHaveText('d1 = 671.83 mm');
  await looksAs(page, 'puma-dimension-d1');
  await cell(page, 'Joint 3, link twist α, degrees').focus();
  await expect(dimension(page)).toHaveText('α3 = −90°');
  await looksAs(page, 'puma-dimension-alpha3');
  await choose(page, 'Frames', 'All frames');
  await choose(page, 'Direction of view', 'Parallel (orthographic)');
  await press(page, '5');
  await looksAs(page, 'puma-top-parallel-frames');
});

test('pictures: other arms', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await open(page, 'robot=ur5');
  await looksAs(page, 'ur5-home');
  await load(page, 'planar2r');
  await looksAs(page, 'planar2r-home');
  await load(page, 'scara_cobra600');
  await cell(page, 'Joint 3, link offset d, millimetres').focus();
  await expect(dimension(page)).toContainText('d3 + q3 = ');
  await looksAs(page, 'scara-dimension-slide');
  await load(page, 'stanford');
  await cell(page, 'Joint 3, upper limit, millimetres').focus();
  await expect(dimension(page)).toContainText('J3');
  await looksAs(page, 'stanford-limits-slide');
});
