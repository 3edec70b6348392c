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

/** Neither the pointer nor the focus in the view, where either brings the handle. @param {Page} page */
async function leaveView(page) {
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement instanceof HTMLElement && document.activeElement.blur());
}

test('a cell that is chosen, or under the pointer, is drawn as a dimension; nothing is left of it afterwards', async ({
  page,
}) => {
  await page.setViewportSize(SMALL);
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const { linkProgram } = prototype;
    prototype.linkProgram = function (program) {
      document.documentElement.dataset.links = String(Number(document.documentElement.dataset.links ?? 0) + 1);
      linkProgram.call(this, program);
    };
  });
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
  // its marks are made anew with the number, their shaders are not
  const links = () => page.locator('html').getAttribute('data-links');
  const linked = await links();
  await cell(page, 'Joint 5, link length a, millimetres').fill('70');
  await expect(dimension(page)).toHaveText('a5 = 70 mm');
  await settled(page);
  expect(await links()).toBe(linked);
  await page.keyboard.press('Escape');
  await expect(dimension(page)).toHaveText('a5 = 0');
  await cell(page, 'Joint 2, upper limit, degrees').focus();
  await expect(dimension(page)).toHaveText('J2 45.0°'); // the gauge with the limits
  await page.locator('canvas').focus();
  await expect(dimension(page)).toHaveCount(0);
  await leaveView(page);
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
  await expect(page.getByRole('button', { name: 'World', exact: true })).toBeVisible(); // the handle's bar takes room of the view
  await settled(page);
  await press(page, '2');
  await expect(status).toHaveText(/View: Back\./);
  await press(page, '1');
  await expect(status).toHaveText(/View: Front\./);
  await leaveView(page);
  const front = await picture(page);
  await choose(page, 'Direction of view', 'Parallel (orthographic)');
  await press(page, '2');
  await expect(status).toHaveText(/View: Back\./);
  await choose(page, 'Direction of view', 'Perspective');
  await press(page, '1');
  await expect(status).toHaveText(/View: Front\./);
  await leaveView(page);
  await expectPicture(page, front);
  await choose(page, 'Frames', 'All frames');
  await expect(page.locator('.tag.axis-z').filter({ hasText: /^z[0-6]$/ })).toHaveCount(7);
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', /Frames drawn: base, 1, 2, 3, 4, 5, 6, tool\./);
  await load(page, 'planar2r');
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', /Frames drawn: base, 1, 2, tool\./);
  await choose(page, 'Frames', 'No frames');
  await leaveView(page);
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

test('the cell that has the focus when another arm comes hands it to the cell in its place, with the drawing', async ({
  page,
}) => {
  await page.setViewportSize(SMALL);
  await open(page, 'robot=scara_cobra600');
  const [offset, upper] = ['Joint 3, link offset d, millimetres', 'Joint 3, upper limit, millimetres'];
  await cell(page, offset).focus();
  await expect(dimension(page)).toHaveText('d3 + q3 = 80.0 mm');
  await page.evaluate(async (label) => {
    await window.denavit.load('stanford');
    /** @type {HTMLElement | null} */ (document.querySelector(`[aria-label="${label}"]`))?.focus(); // still the old table's
  }, upper);
  await expect(page.locator('.tag.tick').first()).toBeVisible(); // the limits of the joint
  await expect(dimension(page)).toHaveText(/^J3 /);
  await expect(cell(page, upper)).toBeFocused();
  await page.locator('canvas').focus();
  await expect(dimension(page)).toHaveCount(0);
});

test('no label is to be seen before it has its place', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await open(page);
  await page.locator('.scene-labels').evaluate((layer) => {
    new MutationObserver((changes) => {
      for (const { addedNodes } of changes)
        for (const tag of addedNodes)
          if (tag instanceof HTMLElement && tag.style.display !== 'none' && !tag.style.transform)
            layer.setAttribute('data-early', `${layer.getAttribute('data-early') ?? ''}${tag.textContent} `);
    }).observe(layer, { childList: true });
  });
  await cell(page, 'Joint 1, upper limit, degrees').focus();
  await expect(dimension(page)).toBeVisible();
  await cell(page, 'Joint 1, link offset d, millimetres').focus();
  await expect(dimension(page)).toHaveText('d1 = 671.83 mm');
  await choose(page, 'Frames', 'All frames');
  await expect(page.locator('.tag.axis-z').filter({ hasText: /^z[0-6]$/ })).toHaveCount(7);
  await expect(page.locator('.scene-labels')).not.toHaveAttribute('data-early');
});

test('a view that breaks says so, alone: the table and the numbers go on', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await page.goto('./?quality=low&theme=light&hint=off'); // not `open`, which forbids the console's error
  await page.evaluate(() => window.denavit.ready);
  await page.evaluate(() => {
    const { prototype } = WebGL2RenderingContext;
    prototype.drawElements = prototype.drawArrays = () => {
      throw new Error('The driver is gone.');
    };
  });
  const a2 = cell(page, 'Joint 2, link length a, millimetres');
  await a2.fill('600');
  await a2.press('Enter');
  await expect(page.getByRole('alert')).toHaveText(
    /Something broke here: The driver is gone\. The rest of the page goes on working\./,
  );
  await expect(page.locator('.pose-panel output').first()).toHaveText('715.24');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(a2).toHaveValue('431.8');
  await expect(page.getByRole('alert')).toHaveCount(1);
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
  await page.getByRole('button', { name: 'Build it' }).click();
  const player = page.getByRole('region', { name: 'Build it: how a row makes a frame' });
  await expect(player).toContainText('Four motions');
  for (const step of ['1 of 4:', '2 of 4:']) {
    await page.keyboard.press('ArrowRight');
    await expect(player).toContainText(step);
  }
  await expect(page.locator('canvas')).toHaveAttribute(
    'aria-label',
    /“Build it” is open at row 3, with 2 of its 4 motions done\. Frames drawn: 2, 3\. Dimension drawn: d₃ = 150\.05 mm\./,
  );
  await expect(dimension(page)).toHaveText('d3 = 150.05 mm');
  await looksAs(page, 'puma-build-row3-step2');
  await player.getByRole('button', { name: 'Close “Build it”' }).click(); // hidden for its picture, it lost the focus
  await expect(player).toHaveCount(0);
  await choose(page, 'Frames', 'All frames');
  await choose(page, 'Direction of view', 'Parallel (orthographic)');
  await press(page, '5');
  await page.locator('canvas').evaluate((canvas) => canvas.blur()); // a view in hand shows its handle, too
  await page.mouse.move(0, 0);
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

/** An arm of three joints in modified DH, the same in any size. @param {string} name @param {number} mm */
const craigArm = (name, mm) =>
  `<robotModel xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="mm" angleUnit="deg" convention="modified">
  <info><name>${name}</name></info><chain>
    <joint id="j1" type="revolute"><dh theta="0" d="${0.3 * mm}" a="0" alpha="0"/><limits lower="-170" upper="170"/></joint>
    <joint id="j2" type="revolute"><dh theta="-50" d="0" a="${0.05 * mm}" alpha="-90"/><limits lower="-90" upper="90"/></joint>
    <joint id="j3" type="revolute"><dh theta="70" d="${0.05 * mm}" a="${0.4 * mm}" alpha="0"/><limits lower="-120" upper="120"/></joint>
  </chain><tool xyz="${0.3 * mm} 0 0"/></robotModel>`;

test('pictures: a toy of 20 mm and a crane of 20 m in modified DH, by day and by night', async ({ page }) => {
  await page.setViewportSize(SMALL);
  await open(page);
  const grid = page.locator('.scale');
  await load(page, craigArm('Toy', 20));
  await expect(grid).toHaveText('Grid 1 mm');
  await looksAs(page, 'toy-home');
  await load(page, craigArm('Crane', 20000));
  await expect(grid).toHaveText('Grid 1000 mm');
  await cell(page, 'Joint 3, link length a, millimetres').focus();
  await expect(dimension(page)).toHaveText('a3 = 8000 mm');
  await looksAs(page, 'crane-dimension-a3');
  await page.getByRole('button', { name: 'Colours: light or dark' }).click();
  await expect(page.locator('html')).toHaveAttribute('data-bs-theme', 'dark');
  await page.locator('canvas').focus();
  await page.locator('canvas').evaluate((canvas) => canvas.blur());
  await expect(dimension(page)).toHaveCount(0);
  await looksAs(page, 'crane-dark');
});
