/** Obstacles: put in, seen to be touched, led around, taken back; by pointer and with the keyboard alone. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

/** @param {string} id @param {number[]} q */
const jointMove = (id, q) =>
  `<jointMove id="${id}" to="posture" q="${q.join(' ')}" speed="50" speedUnit="%" acceleration="100" ending="fine"/>`;

const PROGRAM = `<motionPrograms><motionProgram id="p1" name="There">${jointMove('s1', [-50, 40, -170, 0, 40, 0])}${jointMove('s2', [60, 40, -170, 0, 40, 0])}</motionProgram></motionPrograms>`;

test('a box is put in the way: the move that touches it is marked, led around, proven to be clear, and undone; a search is cancelled, or says that it found none', async ({
  page,
}) => {
  await open(page);
  await page.evaluate(
    (program) => window.denavit.load(window.denavit.xml().replace('</robotModel>', `${program}</robotModel>`)),
    PROGRAM,
  );
  await page.locator('#fold-obstacles').click();
  const body = page.locator('#fold-obstacles-body');
  await body.getByRole('button', { name: 'Add an obstacle' }).click();
  await page.getByRole('button', { name: /^Box/ }).click();
  await expect(body.getByLabel('Name of box box_1')).toBeFocused();
  for (const [field, value] of /** @type {const} */ ([
    ['box_1, Width x, millimetres', '120'],
    ['box_1, Depth y, millimetres', '120'],
    ['box_1, Height z, millimetres', '800'],
    ['box_1, X, millimetres', '480'],
    ['box_1, Y, millimetres', '60'],
    ['box_1, Z, millimetres', '400'],
  ])) {
    await body.getByLabel(field).fill(value);
    await body.getByLabel(field).press('Enter');
  }
  // dragged by its handle in the picture: one step, and back
  const middle = async (/** @type {string} */ selector) => {
    const box = await page.locator(selector).boundingBox();
    if (!box) throw new Error(`${selector} is not seen.`);
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const place = () => page.evaluate(() => /<box [^>]*xyz="([^"]*)"/.exec(window.denavit.xml())?.[1]);
  await settled(page);
  const [from, to] = [await middle('.tag.of-obstacle'), await middle('.stage .axis-z.of-handle:visible')];
  const at = (/** @type {number} */ share) => from.map((value, k) => value + share * (to[k] - value));
  await page.mouse.move(at(0.6)[0], at(0.6)[1]);
  await page.mouse.down();
  await page.mouse.move(at(1)[0], at(1)[1]);
  await page.mouse.move(at(1.4)[0], at(1.4)[1]);
  await page.mouse.up();
  expect(await place()).toMatch(/^480 60 (?!400$)/);
  await page.getByRole('button', { name: 'Undo: obstacle box_1 changed' }).click();
  expect(await place()).toBe('480 60 400');

  await expect(body.locator('.clearance-line').first()).toContainText(/\d mm, link \d to box_1/);
  await expectAccessible(page, { within: '#fold-obstacles-body' });

  await page.getByRole('tab', { name: 'Program' }).click();
  const second = page.locator('.steps tr[data-row="1"]');
  await expect(second.locator('.step-touch')).toHaveText(/touches box_1/);
  await expect(page.locator('.steps tr[data-row="0"] .step-touch')).toHaveCount(0);
  await expect(page.locator('.strip-touch')).toHaveCount(1);
  await page.getByRole('button', { name: 'To step 2, which is not clear' }).click();
  const check = page.getByRole('region', { name: 'Clearance of the program' });
  await expect(check).toContainText(/In step 2 link \d touches box_1, first \d+ % along its way, at \d\.\d\d s/);
  await check.getByRole('button', { name: 'Show where' }).click();
  await expect(page.locator('.tag.ghost')).toHaveText('here');
  await check.getByRole('button', { name: 'Find a way around' }).click();
  await expect(check).toContainText(/A way around was found in .* put in before step \d/);
  await expect(check).toContainText('Keeps 5 mm clear of the obstacle, and of itself: proven all along, to 1 mm.');
  await expect(page.locator('.step-touch')).toHaveCount(0);
  expect(await page.locator('.steps tbody tr').count()).toBeGreaterThan(2);
  await expectAccessible(page, { within: '.check' });
  await page.getByRole('button', { name: /^Undo: step/ }).click();
  await expect(page.locator('.steps tbody tr')).toHaveCount(2);
  await expect(second.locator('.step-touch')).toHaveText(/touches box_1/);

  // a search is cancelled at its first sign of progress, which is sooner than a pointer could be there, and the program is as it was
  await page.evaluate(() => window.denavit.load('puma560'));
  const wall = '<box id="wall" xyz="1100 0 500" rpy="0 0 0" width="2000" depth="20" height="4000"/>';
  await page.evaluate(
    ([program, obstacles]) =>
      window.denavit.load(window.denavit.xml().replace('</robotModel>', `${obstacles}${program}</robotModel>`)),
    [PROGRAM, `<obstacles>${wall}</obstacles>`],
  );
  await page.getByRole('button', { name: 'To step 2, which is not clear' }).click();
  const find = check.getByRole('button', { name: 'Find a way around' });
  await check.evaluate((region) => {
    const watch = new MutationObserver(() => {
      if (!/Looking for a way around: [1-9][\d ]* iterations/.test(region.textContent)) return;
      watch.disconnect();
      const isSeen = region.querySelector('progress')?.checkVisibility();
      const cancel = [...region.querySelectorAll('button')].find(({ textContent }) => textContent === 'Cancel');
      if (isSeen) cancel?.click();
    });
    watch.observe(region, { childList: true, characterData: true, subtree: true });
  });
  await find.click();
  await expect(check).toContainText('The search was cancelled; the program is as it was.');
  await expect(find).toBeEnabled();
  await expect(page.locator('.steps tbody tr')).toHaveCount(2);

  // two posts beside the first link of a planar arm: there is no way from one side to the other
  await page.evaluate(() => window.denavit.load('planar2r'));
  await page.evaluate(
    (moves) => {
      const posts = [1, -1].map((side) => `<sphere id="post${side + 1}" xyz="0 ${500 * side} 0" radius="100"/>`);
      const program = `<motionPrograms><motionProgram id="p1" name="">${moves}</motionProgram></motionPrograms>`;
      const more = `<obstacles>${posts.join('')}</obstacles>${program}`;
      return window.denavit.load(window.denavit.xml().replace('</robotModel>', `${more}</robotModel>`));
    },
    jointMove('s1', [0, 30]) + jointMove('s2', [170, 30]),
  );
  await page.getByRole('button', { name: 'To step 2, which is not clear' }).click();
  await find.click();
  await expect(check).toContainText(
    /No path found in \d+\.\d s \(10 000 iterations\)\. That does not say that there is none/,
  );
  await expect(check.getByRole('button', { name: 'Go on looking' })).toBeVisible();
  await expect(page.locator('.steps tbody tr')).toHaveCount(2);
});

test('with the keyboard alone: an obstacle is added, named, sized, hidden, copied and removed', async ({ page }) => {
  await open(page);
  await page.locator('#fold-obstacles').focus();
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Add an obstacle' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: /^Box/ })).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Name of sphere sphere_1')).toBeFocused();
  await page.keyboard.type('tank');
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Name of sphere tank')).toBeVisible();
  await expect(page.locator('.tag.obstacle-name')).toHaveText('tank');
  await page.getByLabel('tank, Radius, millimetres').focus();
  await page.keyboard.type('2 in');
  await page.keyboard.press('Enter');
  await expect.poll(() => page.evaluate(() => window.denavit.xml())).toContain('radius="50.8"');
  await page.getByRole('button', { name: 'Hide in the picture' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.tag.obstacle-name')).toHaveCount(0);
  await page.getByRole('button', { name: 'Duplicate' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByLabel('Name of sphere sphere_1')).toBeFocused();
  for (const name of ['sphere_1', 'tank']) {
    await page.getByRole('button', { name: `Remove ${name}` }).focus();
    await page.keyboard.press('Enter');
    await settled(page);
  }
  await expect(page.getByText('No obstacles yet')).toBeVisible();
  await expect(page.getByRole('button', { name: 'Add an obstacle' })).toBeFocused();
  await page.keyboard.press('Control+z');
  await expect(page.getByLabel('Name of sphere tank')).toBeVisible();
});
