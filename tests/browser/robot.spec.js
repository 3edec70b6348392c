/** What belongs to the robot beside its table: joint details, base and tool, links, name and source, named postures. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { expectPicture, open, picture, settled, tool } from './page.js';

/** @param {import('@playwright/test').Page} page */
const robot = (page) => page.evaluate(() => window.denavit.model());

test('a tool is typed, written in other notations without changing, and reset; each is one step to undo', async ({
  page,
}) => {
  await open(page, 'robot=planar2r');
  const [, y] = await tool(page);
  await page.locator('#fold-tool').click();
  await page.getByLabel('Tool, X, millimetres').fill('100');
  await page.keyboard.press('Enter');
  await page.getByLabel('Tool, yaw, degrees').fill('30.1');
  await page.keyboard.press('Enter');
  await expect(page.locator('#fold-tool')).toHaveText(/x 100 mm, turned/);
  const kept = { xyz: [100, 0, 0], rpy: [0, 0, 30.1] };
  expect((await robot(page)).tool).toEqual(kept);
  expect((await tool(page))[1]).toBeCloseTo(y + 0.1, 12); // both links point along y, and so does the tool

  const notation = page.getByLabel('Tool: orientation written as');
  await notation.selectOption('KUKA A B C');
  await expect(page.getByLabel('Tool, A, degrees')).toHaveValue('30.1');
  await notation.selectOption('Quaternion');
  await expect(page.getByLabel('Tool, quaternion x y z w')).toHaveValue(/^0 {2}0 {2}0\.2596/);
  expect((await robot(page)).tool).toEqual(kept);

  const quaternion = page.getByLabel('Tool, quaternion x y z w');
  await quaternion.fill('0 0 3 4');
  await page.keyboard.press('Enter');
  await expect(page.locator('#tool-reason')).toHaveText('A quaternion has the length 1; this one has 5.');
  expect((await robot(page)).tool).toEqual(kept);
  await page.getByRole('button', { name: 'Divide by its length' }).click();
  await expect.poll(async () => (await robot(page)).tool).toEqual({ xyz: [100, 0, 0], quaternion: [0, 0, 0.6, 0.8] });

  await page.getByRole('button', { name: 'Reset to none' }).click();
  await expect(page.locator('#fold-tool')).toHaveText(/none; the flange itself/);
  await page.locator('#fold-base').focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press('Control+z');
  await expect(page.getByRole('button', { name: 'Undo' })).toBeDisabled();
});

test('from the head of a row to limits, home and link of the joint, in the picture too; axe finds nothing', async ({
  page,
}) => {
  await open(page, 'robot=planar3r');
  const before = await picture(page);
  await page.getByRole('button', { name: /^Joint 2,/ }).click();
  await page.getByRole('button', { name: 'Limits, home and link of J2' }).click();
  await expect(page.getByRole('button', { name: /^Joint 2 turns about/ })).toBeFocused();
  await expect(page.getByLabel('Joint 2, upper limit, degrees')).toHaveCount(2); // in the table, and here

  await page.getByRole('button', { name: 'Set home to 40.0°' }).click();
  await page.getByRole('button', { name: 'Set the upper limit to 40.0°' }).click();
  await page.getByLabel('Joint 2, rate limit, degrees per second').fill('-5');
  await page.keyboard.press('Enter');
  await expect(page.locator('#joint-details-reason')).toHaveText(
    'A velocity limit is a number above 0, up to 10⁹; got −5.',
  );
  await page.keyboard.press('Escape');

  await page.getByLabel('Link 2 drawn as').selectOption('Box');
  await page.getByLabel('Joint 2, link drawn as, width, millimetres').fill('200');
  await page.getByLabel('Colour of link 2, as # and six digits').fill('#ffcc00');
  await page.keyboard.press('Enter');
  expect((await robot(page)).joints[1]).toMatchObject({
    upper: 40,
    link: { kind: 'box', width: 200, color: '#ffcc00' },
  });
  await expectPicture(page, before, false);
  for (const name of ['base', 'tool', 'about']) await page.locator(`#fold-${name}`).click();
  await expect(page.getByLabel('Source of the numbers')).toBeVisible();
  await expectAccessible(page);

  await page.getByLabel('Link 2 drawn as').selectOption('Not drawn');
  await expect(page.getByText('The joints at its ends stay in the picture.')).toBeVisible();
  await page.locator('#fold-base').focus();
  while (await page.getByRole('button', { name: 'Undo' }).isEnabled()) await page.keyboard.press('Control+z');
  expect((await robot(page)).joints[1].link).toEqual({ kind: 'auto' });
});

test('the robot gets another name in place, and its source a link; the arm goes to postures by name', async ({
  page,
}) => {
  await open(page);
  await page.locator('#fold-about').click();
  const given = page.getByLabel('Name', { exact: true });
  await given.fill('W'.repeat(201));
  await given.press('Enter');
  await expect(page.locator('p', { hasText: 'The name has at most 200 characters' })).toBeInViewport({ ratio: 1 });
  await given.press('Escape');
  await expect(page.getByRole('link', { name: 'Open the source' })).toHaveAttribute(
    'href',
    'https://doi.org/10.1109/ROBOT.1994.351360',
  );
  await page.getByLabel('Name', { exact: true }).fill('My Puma');
  await page.keyboard.press('Enter');
  await expect(page.locator('.topbar .robot-name')).toHaveText('My Puma');

  const goTo = page.getByRole('button', { name: 'Go to a posture by name' });
  await goTo.click();
  await page.getByRole('button', { name: /^Stretched/ }).click();
  await settled(page);
  expect(await page.evaluate(() => window.denavit.joints())).toEqual([0, 0, -90, 0, 0, 0]);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect(page.locator('.topbar .robot-name')).toHaveText('Puma 560');
});

test('the convention menu shows which numbers would change, and that the tool would not move', async ({ page }) => {
  await open(page);
  await page.getByRole('button', { name: /^Convention:/ }).click();
  const [convert, reread] = await Promise.all([0, 1].map((i) => page.locator('.preview').nth(i).innerText()));
  expect(convert.replace(/\s+/g, ' ')).toContain('row 2 a 431.8 → becomes 0 α 0° → becomes 90°');
  expect(convert).toContain('the same to 1e−12');
  expect(reread).toContain('jumps by 601.79 mm');
});
