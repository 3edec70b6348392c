/** The workspace: mapped, cancelled, mapped anew when a link is another, heard, and saved. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open } from './page.js';

test('a robot is mapped, the work is cancelled and goes on, a changed link maps it anew, and the solid is saved', async ({
  page,
}) => {
  await open(page);
  await page.getByRole('tab', { name: 'Workspace' }).click();
  const body = page.locator('#fold-reach-volume-body');
  const head = page.locator('#fold-reach-volume');
  // finer takes its time: there is progress, and a way out
  await body.getByLabel('Edge of a cube').selectOption('fine');
  await expect(body.getByRole('progressbar')).toBeVisible();
  await body.getByRole('button', { name: 'Cancel' }).click();
  await expect(body.getByText('Cancelled')).toBeVisible();
  await body.getByLabel('Edge of a cube').selectOption('coarse');
  await expect(head).toContainText('2.5 ± 0.3 m³');
  await expect(body).toContainText('closed-form inverse kinematics');
  await expectAccessible(page, { within: '#panel-workspace' });

  // another colour says what it means, in numbers
  await body.getByLabel('The volume is coloured by').selectOption('postures');
  await expect(body.getByRole('img')).toHaveAccessibleName(/^Number of postures: 1: \d+ % of the volume; 2: /);

  // while it maps in the background, a link is made longer; a screen reader hears what is reached then
  await page.getByRole('tab', { name: 'Robot' }).click();
  await expect(page.getByRole('group', { name: 'The workspace in the scene' })).toContainText('Workspace: volume');
  const cell = page.getByLabel('Joint 2, link length a, millimetres');
  await cell.fill('600');
  await cell.press('Enter');
  await expect(
    page.locator('[aria-live]').filter({ hasText: /The volume that is reached is 4\.\d ± 0\.\d m³/ }),
  ).toHaveCount(1);

  await page.getByRole('tab', { name: 'Workspace' }).click();
  await body.getByRole('button', { name: 'Save…' }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog).toContainText('Lengths are in mm');
  const saved = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  expect((await saved).suggestedFilename()).toBe('Puma-560-workspace.stl');
});

test('the section of a planar arm has the area of its closed form, is read by keys, saved as SVG, and goes with a link', async ({
  page,
}) => {
  await open(page, 'robot=planar2r');
  await page.getByRole('tab', { name: 'Workspace' }).click();
  const volume = page.locator('#fold-reach-volume-body');
  await volume.getByLabel('The volume is coloured by').selectOption('height'); // there is one height only
  await expect(volume.getByRole('img')).toHaveAccessibleName(/: 0\.00 mm: 100 % of the volume/);
  await page.locator('#fold-reach-volume').click();
  await page.locator('#fold-reach-section').click();
  const body = page.locator('#fold-reach-section-body');
  await expect(body.locator('dd').first()).toHaveText('12.56635 ± 0.00003 m²'); // 4π is 12.566371
  await expect(body).toContainText('Proven');
  const drawing = body.getByRole('application');
  await expect(drawing).toHaveAccessibleName(
    /The section’s area is 12\.56635 ± 0\.00003 m², without holes\. It extends over x from −2000\.00 mm to 2000\.00 mm/,
  );
  // the panel scrolls, and never the page with it
  expect(await page.evaluate(() => document.documentElement.scrollHeight - innerHeight)).toBe(0);
  await drawing.focus();
  await page.keyboard.press('ArrowRight');
  await expect(body.locator('.section-reading')).toHaveText(/reached$/);
  await expectAccessible(page, { within: '#panel-workspace' });
  await body.getByRole('button', { name: 'Save…' }).click();
  const saved = page.waitForEvent('download');
  await page.getByRole('dialog').getByRole('button', { name: 'Save', exact: true }).click();
  expect((await saved).suggestedFilename()).toBe('Planar-2R-section.svg');

  await body.getByRole('button', { name: 'A plane' }).click();
  await body.getByLabel('Normal of the plane, three numbers').fill('1 0 0');
  await page.keyboard.press('Enter');
  await expect(body).toContainText('there is no area to be measured');
  const link = await page.evaluate(() => window.denavit.link({ view: true }));
  expect(link).toContain('workspace=section&workspace.cut=plane&workspace.normal=1,0,0');
});
