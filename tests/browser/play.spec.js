/** Playing a motion program: the timeline, the arm on its way, the plots, and what is refused. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';

/** @import { Page } from '@playwright/test' */

const FIRST = [0, 40, -150, 0, 10, 0];
const SECOND = [60, 40, -150, 0, 10, 0];

/** @param {string} id @param {number[]} q */
const jointMove = (id, q) =>
  `<jointMove id="${id}" to="posture" q="${q.join(' ')}" speed="50" speedUnit="%" acceleration="100" ending="fine"/>`;
/** @param {string} id @param {number[]} xyz  with the tool turned as it is at FIRST */
const linearMove = (id, xyz) =>
  `<linearMove id="${id}" to="pose" xyz="${xyz.join(' ')}" rpy="180 80 180" speed="200" speedUnit="length/s" acceleration="100" ending="fine"/>`;

/** Opens the page with a Puma that has a program of these steps. @param {Page} page @param {(tool: number[]) => string} steps */
async function openWith(page, steps) {
  await page.goto('./?quality=low&theme=light&hint=off&autosave=off&clock=manual&q=0,40,-150,0,10,0');
  await page.waitForFunction(() => window.denavit?.clock);
  await page.evaluate(() => window.denavit.clock?.tick());
  await load(page, steps);
}

/** Opens the arm again with a program of these steps, from where it stands. @param {Page} page @param {(tool: number[]) => string} steps */
async function load(page, steps) {
  const tool = await page.evaluate(() =>
    window.denavit
      .pose()
      .slice(0, 3)
      .map((row) => 1000 * row[3]),
  );
  await page.evaluate(
    async (program) => {
      const bare = window.denavit.xml().replace(/<motionPrograms>.*<\/motionPrograms>/s, '');
      const xml = bare.replace('</robotModel>', `${program}</robotModel>`);
      await window.denavit.load(xml);
    },
    `<motionPrograms><motionProgram id="p1" name="There">${steps(tool)}</motionProgram></motionPrograms>`,
  );
}

/** @param {Page} page @param {number} [frames] @param {number} [seconds] */
const tick = (page, frames = 4, seconds = 1 / 60) =>
  page.evaluate(
    ({ frames, seconds }) => {
      for (let i = 0; i < frames; i++) window.denavit.clock?.tick(seconds);
    },
    { frames, seconds },
  );

/** Lets the page's own time run until something is seen. @param {Page} page @param {() => Promise<unknown>} seen */
const ticking = (page, seen) =>
  expect
    .poll(
      async () => {
        await tick(page);
        return Boolean(await seen());
      },
      { timeout: 10_000 },
    )
    .toBe(true);

/** @param {Page} page */
const joints = (page) => page.evaluate(() => window.denavit.joints());
/** @param {number[]} one @param {number[]} other */
const apart = (one, other) => Math.max(...one.map((value, i) => Math.abs(value - other[i])));

test('a program is played, stepped and scrubbed; its plots follow; an edit changes both; nothing of it is a step to undo; a line through a singularity is refused with its reason', async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: 'reduce' }); // whoever plays wants to see it play
  await openWith(page, ([x, y, z]) =>
    [
      jointMove('s1', SECOND),
      '<wait id="s2" seconds="0.5"/>',
      jointMove('s3', FIRST),
      linearMove('s4', [x, y, z - 100]),
    ].join(''),
  );
  const time = page.locator('.time');
  const slider = page.getByRole('slider', { name: 'Time in the program', exact: true });
  await ticking(page, () => time.locator('.strip-moves span').nth(3).isVisible());
  const whole = async () => Number((await time.locator('.time-clock .unit').textContent())?.replace(/[^\d.]/g, ''));
  const now = async () => Number(await slider.getAttribute('aria-valuenow'));
  const duration = await whole();

  // keys alone: from mark to mark
  await slider.focus();
  await page.keyboard.press('PageUp');
  expect(apart(await joints(page), SECOND)).toBeLessThan(1e-6);
  await tick(page);
  const firstMark = await now();
  await page.keyboard.press('PageUp');
  expect(apart(await joints(page), SECOND)).toBeLessThan(1e-6); // it has waited
  await tick(page);
  expect(await now()).toBeCloseTo(firstMark + 0.5, 2);
  await page.keyboard.press('PageUp');
  expect(apart(await joints(page), FIRST)).toBeLessThan(1e-6);
  await page.keyboard.press('End');
  await tick(page);
  expect(await now()).toBeCloseTo(duration, 2);
  await page.keyboard.press('Home');
  expect(await joints(page)).toEqual(FIRST);

  // played: time is the page's, at the chosen speed
  await page.keyboard.press(' ');
  await tick(page, 1);
  await tick(page, 30);
  expect(await now()).toBeCloseTo(31 / 60, 1);
  const [under] = await joints(page);
  expect(under).toBeGreaterThan(0.5);
  expect(under).toBeLessThan(59.5);
  await page.keyboard.press('Escape');
  await tick(page);
  await expect(time.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
  const stands = await joints(page);
  await tick(page, 20);
  expect(await joints(page)).toEqual(stands);
  await expect(page.getByRole('button', { name: /^Undo: .*opened$/ })).toBeVisible(); // as before
  await time.getByRole('combobox', { name: 'Speed of playing' }).selectOption('200');
  await time.getByRole('button', { name: 'Play', exact: true }).click();
  await tick(page, 1);
  const before = await now();
  await tick(page, 12);
  expect(await now()).toBeCloseTo(before + 24 / 60, 1);

  // a hand on the arm stops it
  await page.getByRole('slider', { name: 'Joint 6', exact: true }).press('ArrowRight');
  await tick(page);
  await expect(page.getByRole('status').filter({ hasText: 'Playing has stopped' })).toHaveCount(1);

  // the pointer, the plots and the table
  await page.getByRole('tab', { name: 'Program', exact: true }).click();
  await time.getByRole('button', { name: 'Plots', exact: true }).click();
  const curve = time.locator('.plan-plot [data-curve="0"]');
  await ticking(page, () => curve.isVisible());
  const drawn = await curve.getAttribute('d');
  await expect(time.locator('.plan-plot .curve')).toHaveCount(7); // six joints, and the speed of the tool
  const box = await time.locator('.plan-plot').boundingBox();
  if (!box) throw new Error('The plot is not seen.');
  await page.mouse.click(box.x + 62 + 0.5 * (box.width - 62 - 40), box.y + 60);
  await tick(page);
  expect(Math.abs((await now()) - duration / 2)).toBeLessThan(0.02);
  await ticking(page, () => page.locator('.steps').isVisible());
  await expect(page.locator('.steps tr.is-running')).toHaveCount(1);
  await time.getByRole('combobox', { name: 'What is plotted' }).selectOption('place');
  await tick(page);
  await expect(time.locator('.plan-plot .curve')).toHaveCount(4);
  await time.getByRole('combobox', { name: 'What is plotted' }).selectOption('values');
  await time.getByRole('button', { name: 'Table', exact: true }).click();
  await expect(time.getByRole('table', { name: 'Joint values over time' }).getByRole('row').first()).toContainText(
    'J6',
  );
  await time.getByRole('button', { name: 'Table', exact: true }).click();

  // an edit: faster, so shorter, and the curve another
  const speed = page.getByLabel('Step 1, speed, per cent');
  await speed.fill('100');
  await speed.press('Enter');
  await ticking(page, async () => (await whole()) < duration - 0.1);
  await ticking(page, async () => (await curve.getAttribute('d')) !== drawn);
  await expectAccessible(page, { within: '.time' });
  await expectAccessible(page, { within: '.path-legend' });

  // a line through a singularity: the arm goes up to there, and one click leads to the step
  await page.evaluate((q) => window.denavit.setJoints(q), FIRST);
  await load(page, ([x, y, z]) =>
    [jointMove('s1', SECOND), jointMove('s2', FIRST), linearMove('s3', [x, y, z + 300])].join(''),
  );
  const refused = page.getByRole('button', { name: /^Step 3: a singularity/ });
  await ticking(page, () => refused.isVisible());
  await slider.focus();
  await page.keyboard.press('End');
  expect(apart(await joints(page), FIRST)).toBeLessThan(1e-6);
  await refused.click();
  await ticking(page, () => page.locator('.steps tr.is-chosen').isVisible());
  await expect(page.locator('.steps tr.is-chosen .step-no')).toHaveText('3');
  await expect(page.getByRole('status').filter({ hasText: 'leads through a singularity 3' })).toHaveCount(1);
  const check = page.getByRole('region', { name: 'Clearance of the program' });
  await ticking(page, async () => (await check.textContent())?.includes('proven up to where the program stops'));
});
