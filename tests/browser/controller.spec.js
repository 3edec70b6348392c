/** Joints as a controller's pendant has them, by a pose that was published with its numbers and its configuration. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, shownPose } from './page.js';

test.use({ reducedMotion: 'reduce' });

const ROWS = [
  [0, 0, 312, -90],
  [-90, 0, 1075, 180],
  [0, 0, 225, -90],
  [0, -1280, 0, 90],
  [0, 0, 0, -90],
  [0, -270, 0, 180], // 215 of the flange and 55 of the tool
];
const LIMITS = [180, 76, 230, 360, 125, 360];
const XML = `<robotModel xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="mm" angleUnit="deg" convention="standard"><info><name>R-2000iB/165F</name></info><chain>${ROWS.map(
  ([theta, d, a, alpha], i) =>
    `<joint id="j${i + 1}" type="revolute"><dh theta="${theta}" d="${d}" a="${a}" alpha="${alpha}"/><limits lower="-${LIMITS[i]}" upper="${LIMITS[i]}"/></joint>`,
).join('')}</chain></robotModel>`;
const PENDANT = [7.962, -5.284, -36.25, 77.661, -51.975, -79.273];
const POSE = { X: 1500, Y: 0, Z: 360, W: 135, P: -45, R: 0 };

test('the published numbers of an R-2000iB, typed as on its pendant, are its published pose as N U T', async ({
  page,
}) => {
  await open(page);
  await page.evaluate((xml) => window.denavit.load(xml), XML);
  await page.getByRole('switch', { name: 'Pendant numbers' }).check();
  await expect(page.locator('.controller-note')).toContainText('no controller data');
  // the coupling of J3 is set below the table, by keys
  const fold = page.locator('#fold-joint');
  const third = page.getByRole('group', { name: 'Joint 3 on the pendant' });
  await page.getByLabel('Joint 3, link length a, millimetres').evaluate((cell) => {
    cell.focus();
    const head = document.getElementById('fold-joint');
    head?.focus();
    head?.click(); // as a key does that comes before the next picture
  });
  await expect(third).toBeVisible();
  await fold.press('Enter');
  await expect(third).toBeHidden();
  await fold.press('Enter');
  await third.getByRole('combobox', { name: 'Joint 3 on the pendant follows' }).selectOption('J2');
  await expect(third).toContainText('J3 = q3 − J2');
  const factor = third.getByRole('textbox', { name: 'Joint 3 on the pendant follows by the factor' });
  await factor.fill('two');
  await factor.press('Enter');
  await expect(page.locator('#joint-details-reason')).toBeVisible();
  await factor.press('Escape');
  await expectAccessible(page, { within: '#fold-joint-body' });
  await expect(page.locator('.controller-lines')).toContainText('J3 = q3 − J2');
  const field = (/** @type {number} */ joint) => page.getByRole('textbox', { name: `Joint ${joint}, degrees` });
  for (const [i, value] of PENDANT.entries()) {
    await field(i + 1).fill(String(value));
    await field(i + 1).press('Enter');
  }
  await expect(field(3)).toHaveValue('−36.3');
  await expect(page.locator('.configuration')).toContainText('N U T, 0, 0, 0');
  for (const [name, value] of Object.entries(POSE)) {
    const away = async () => Number((await shownPose(page, name).textContent())?.replace('−', '-')) - value;
    await expect.poll(async () => Math.abs(await away())).toBeLessThanOrEqual(0.02);
  }
  const joints = await page.evaluate(() => window.denavit.joints());
  expect(joints[2]).toBeCloseTo(-41.534, 9);
  // J3 stops where its joint does, which is another number for another J2
  await field(3).fill('240');
  await expect(page.locator('#jog-reason')).toBeHidden();
  await field(3).press('Enter');
  await expect(page.locator('#jog-reason')).toHaveText(
    'J3 stops at its limits: −224.716° to 235.284° while J2 is −5.3°.',
  );
  await field(3).press('Escape');
  await expect(page.getByRole('status').filter({ hasText: 'Configuration: FANUC N U T, 0, 0, 0' })).toHaveCount(1);
  await expectAccessible(page, { within: '.side.right' });
  // the slider of J2 takes the third joint along, in one step to undo
  await page.getByRole('slider', { name: 'Joint 2', exact: true }).focus();
  await page.keyboard.press('Shift+ArrowRight');
  await expect(field(3)).toHaveValue('−36.3');
  const moved = await page.evaluate(() => window.denavit.joints());
  expect(moved[2] - joints[2]).toBeCloseTo(moved[1] - joints[1], 9);
  await page.getByRole('switch', { name: 'Pendant numbers' }).uncheck();
  await expect(page.locator('.configuration')).toContainText('N U T, 0, 0, 0'); // it is of the arm, not of the numbers
  await expect(field(3)).not.toHaveValue('−36.3');
  await page.keyboard.press('Control+z');
  expect(await page.evaluate(() => window.denavit.joints())).toEqual(joints);
});
