/** The page's manners that a look at every screen asked for: order of the keyboard, the left edge, the view in the address. */
import { expect, test } from '@playwright/test';
import { draws, open, settled, tool } from './page.js';

test('the keyboard comes to the picture and the table at once, and each button shows that it has the focus', async ({
  page,
}) => {
  await open(page);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('img', { name: /Puma 560 in 3-D/ })).toBeFocused();
  await page.getByRole('link', { name: 'To the table' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Joint 1, joint angle θ, degrees')).toBeFocused();
  await page.getByRole('link', { name: 'To the target' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Target X, millimetres')).toBeFocused();
  const unseen = await page.evaluate(() =>
    [...document.querySelectorAll('.btn:not(:disabled)')]
      .filter((button) => button instanceof HTMLElement && button.checkVisibility())
      .filter((button) => {
        if (button instanceof HTMLElement) button.focus();
        return getComputedStyle(button).outlineStyle === 'none';
      })
      .map((button) => button.textContent),
  );
  expect(unseen).toEqual([]);
});

test('the left panel is made wider by pulling and by keys, and is so the next time', async ({ page }) => {
  await open(page);
  const left = page.getByRole('complementary', { name: 'Robot and program' });
  const edge = page.getByRole('separator', { name: 'Width of the left panel' });
  const width = async () => Math.round((await left.boundingBox())?.width ?? 0);
  expect(await width()).toBe(404);
  await edge.focus();
  await page.keyboard.press('ArrowRight');
  expect(await width()).toBe(420);
  await expect(edge).toHaveAttribute('aria-valuenow', '420');
  const box = await edge.boundingBox();
  if (!box) throw new Error('The edge is not on the page.');
  await page.mouse.move(box.x + 3, 500);
  await page.mouse.down();
  await page.mouse.move(box.x + 63, 510);
  await page.mouse.up();
  expect(await width()).toBe(480);
  await page.mouse.down();
  await page.mouse.move(1300, 510);
  expect(await width()).toBe(555); // the view keeps its share
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await width()).toBe(480);
  await page.reload();
  await page.evaluate(() => window.denavit.ready);
  expect(await width()).toBe(480);
  await edge.dblclick();
  expect(await width()).toBe(404);
});

test('the address says from where the arm is seen, how, and with which frames', async ({ page }) => {
  await open(page, 'view=top&projection=parallel&frames=all');
  await expect(page.getByRole('img')).toHaveAccessibleName(/Frames drawn: base, 1, 2, 3, 4, 5, 6?,? ?tool/);
  const turned = await page.locator('.cube').getAttribute('style');
  expect(turned).toMatch(/rotateX\(-1\.5/);
  await page.getByRole('button', { name: 'Direction of view' }).click();
  await expect(page.locator('.dropdown-item[aria-current]')).toHaveText('Parallel (orthographic)');
  await open(page, 'view=under&frames=some');
  await expect(page.getByRole('alert').getByRole('listitem')).toHaveText([
    '?view=under is not understood. Expected iso, front, back, left, right, top or bottom. Using iso.',
    '?frames=some is not understood. Expected none, ends, row or all. Using ends.',
  ]);
});

test('an arm that is pulled out of the picture comes back into it once the hand is off, unless the view was turned', async ({
  page,
}) => {
  await open(page, 'robot=planar2r&view=top');
  await settled(page);
  const slider = page.getByLabel('Joint 1', { exact: true });
  const track = await slider.boundingBox();
  if (!track) throw new Error('There is no slider.');
  const at = (/** @type {number} */ share) => track.x + track.width * share;
  const isSeen = () =>
    page.evaluate(() => {
      const [tcp, view] = ['.tag.dot', 'canvas'].map((one) => document.querySelector(one)?.getBoundingClientRect());
      return (
        !!tcp &&
        !!view &&
        tcp.left > view.left &&
        tcp.right < view.right &&
        tcp.top > view.top &&
        tcp.bottom < view.bottom
      );
    });
  expect(await isSeen()).toBe(true);
  const pull = async (/** @type {number} */ to) => {
    await page.mouse.move(at(0.5), track.y + track.height / 2);
    await page.mouse.down();
    await page.mouse.move(at(to), track.y + track.height / 2, { steps: 3 });
    await settled(page);
  };
  await pull(0.2);
  expect(await isSeen()).toBe(false);
  await page.mouse.up();
  await expect.poll(isSeen).toBe(true);

  // The same of a drag of the tool, and of a button that takes it far.
  const toStart = async () => {
    await page.evaluate(() => window.denavit.setJoints([30, 60]));
    await page.getByRole('button', { name: 'Fit the arm into the view' }).click();
    await settled(page);
  };
  await toStart();
  const dot = await page.locator('.stage .tag.dot:visible').first().boundingBox();
  const view = await page.locator('canvas').boundingBox();
  if (!dot || !view) throw new Error('The tool is not in the picture.');
  await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
  await page.mouse.down();
  await page.mouse.move(view.x + view.width + 150, dot.y + 300, { steps: 12 });
  await expect.poll(isSeen).toBe(false);
  await page.mouse.up();
  await expect.poll(isSeen).toBe(true);
  await toStart();
  const jog = page.locator('.jog-panel');
  await jog.getByRole('button', { name: 'Tool', exact: true }).click();
  for (const [step, name] of [
    ['600', 'Y, minus'],
    ['900', 'X, plus'],
  ]) {
    await page.getByLabel('Step of the tool’s place, millimetres').fill(step);
    await jog.getByRole('button', { name, exact: true }).click();
  }
  expect(await tool(page)).toEqual([expect.closeTo(1.766, 2), expect.closeTo(0.9, 2), 0]);
  await expect.poll(isSeen).toBe(true);
  await jog.getByRole('button', { name: 'Joints', exact: true }).click();

  await settled(page);
  await page.locator('canvas').focus();
  for (let times = 0; times < 6; times++) await page.keyboard.press('+'); // nearer, by hand
  await pull(0.8);
  await page.mouse.up();
  await settled(page);
  expect(await isSeen()).toBe(false);
});

test('on another screen, or zoomed, the picture has the pixels of that screen', async ({ page }) => {
  await page.goto('./?theme=light&hint=off&robot=planar2r');
  await page.evaluate(() => window.denavit.ready);
  const sharpness = () =>
    page
      .locator('canvas')
      .evaluate((canvas) => (canvas instanceof HTMLCanvasElement ? canvas.width / canvas.clientWidth : NaN));
  expect(await sharpness()).toBe(1);
  const browser = await page.context().newCDPSession(page);
  const screen = async (/** @type {number} */ width, /** @type {number} */ deviceScaleFactor) => {
    const before = await draws(page);
    await browser.send('Emulation.setDeviceMetricsOverride', { width, height: 768, deviceScaleFactor, mobile: false });
    return before;
  };
  const before = await screen(1365, 2); // as zooming does, too
  await expect.poll(sharpness).toBe(2);
  expect(await draws(page)).toBeGreaterThan(before);
  await screen(1365, 1.5); // the browser under test tells nobody
  await page.evaluate(() => window.denavit.setJoints([20, 40]));
  await expect.poll(sharpness).toBeCloseTo(1.5, 2);
  await screen(1364, 3);
  await expect.poll(sharpness).toBe(2); // beyond that it only costs
  await browser.send('Emulation.clearDeviceMetricsOverride');
});

for (const [width, height] of [
  [768, 1024],
  [1024, 768],
]) {
  test(`on a tablet of ${width} × ${height} each panel has room`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await open(page, 'robot=ur5');
    const dock = page.getByRole('navigation', { name: 'Panels' });
    for (const [name, room] of [
      ['Robot', 'robot'],
      ['Jog', 'jog'],
      ['Aim', 'aim'],
      ['Program', 'program'],
      ['Code', 'code'],
      ['Jacobian', 'jacobian'],
    ]) {
      await dock.getByRole('button', { name }).click();
      const panel = page.locator(`[data-room=${room}]`);
      await expect(panel).toBeVisible();
      const box = await panel.boundingBox();
      expect(box?.width, name).toBeGreaterThanOrEqual(360);
      expect(box?.width, name).toBeLessThanOrEqual(width);
    }
    const viewHasRoom = async (/** @type {number} */ share) => {
      const view = await page.locator('canvas').boundingBox();
      expect((view?.width ?? 0) * (view?.height ?? 0)).toBeGreaterThan(share * width * height);
    };
    await viewHasRoom(0.38);
    // With a program the timeline takes a row of its own, and nothing else moves from its place.
    await dock.getByRole('button', { name: 'Program' }).click();
    await page.getByRole('button', { name: 'Open an example' }).click();
    await page.locator('.dropdown-menu.show button').first().click();
    const time = page.locator('.time');
    await expect(time).toBeVisible();
    for (const part of [time, dock, page.locator('[data-room=program]')])
      await expect(part).toBeInViewport({ ratio: 0.99 });
    expect((await page.locator('[data-room=program]').boundingBox())?.width).toBeGreaterThanOrEqual(360);
    await viewHasRoom(0.36);
  });
}

test('an arm that another reading of its table takes out of the picture is brought back into it, unless it was turned by hand', async ({
  page,
}) => {
  await open(page);
  const outside = () =>
    page.evaluate(() => {
      const view = document.querySelector('canvas')?.getBoundingClientRect();
      const tags = [...document.querySelectorAll('.tag.axis')].map((tag) => tag.getBoundingClientRect());
      return view && tags.filter(({ top, bottom }) => bottom > view.bottom || top < view.top).length;
    });
  const read = async (/** @type {string} */ convention) => {
    await page.getByRole('button', { name: /^Convention: / }).click();
    await page.getByText(`Read the numbers as ${convention}`).click();
    await expect(page.locator('p.note')).toContainText(`read as ${convention}`);
  };
  await read('modified');
  await settled(page);
  await expect.poll(outside).toBe(0);
  await read('standard');
  await page.locator('canvas').focus();
  await page.keyboard.press('ArrowLeft');
  await read('modified');
  await settled(page);
  expect(await outside()).toBeGreaterThan(0);
  // another size altogether, as when metres are read as millimetres: nobody chose to look at that
  const length = page.getByLabel('Joint 2, link length a, millimetres');
  await length.fill('1e6');
  await length.press('Enter');
  await expect(page.locator('.tag.axis', { hasText: /^X$/ }).first()).toBeVisible();
});
