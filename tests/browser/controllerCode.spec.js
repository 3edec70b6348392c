/** A motion program as controller code: written, verified, saved; an altered text noticed; a wrong configuration found on its line. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

test.use({ reducedMotion: 'reduce' });

const MANNER = 'acceleration="100" ending="fine"';
const MOVES = [
  `<jointMove id="s1" to="posture" q="0 0 0 0 -40 0" speed="40" speedUnit="%" ${MANNER}/>`,
  `<jointMove id="s2" to="pose" xyz="896.05 273.74 685.11" rpy="156.85 20.24 72.15" speed="40" speedUnit="%" ${MANNER}/>`,
  `<linearMove id="s3" to="pose" xyz="869.81 333.37 636.21" rpy="160.27 22.66 77.4" speed="250" speedUnit="length/s" ${MANNER}/>`,
];

test('a program is written as TP, verified and saved; what is altered is noticed, and a wrong configuration found on its line', async ({
  page,
}) => {
  await open(page, 'robot=fanuc_m10ia');
  await page.evaluate((moves) => {
    const xml = window.denavit.xml();
    const programs = `<motionPrograms><motionProgram id="m" name="Pick part">${moves}</motionProgram></motionPrograms>`;
    window.denavit.load(xml.replace('</robotModel>', `${programs}</robotModel>`));
  }, MOVES.join(''));
  await page.getByRole('tab', { name: 'Code' }).click();
  const text = page.locator('.code');
  await expect(text).toContainText('SET_JPOS_REG');
  await page.getByLabel('Language of the code').selectOption('tp');
  await expect(text).toContainText('Check none: not verified yet');
  await page.getByRole('button', { name: 'Options' }).click();
  const lines = text.locator('.code-line');
  await expect(lines.last()).toHaveAttribute('data-line', String(await lines.count()));
  const name = page.getByLabel('Program name');
  await name.fill('begin');
  await name.press('Enter');
  await expect(page.getByRole('alert').filter({ hasText: '"begin" is a word of KAREL' })).toBeVisible();
  await name.fill('pick');
  const download = page.waitForEvent('download');
  // as slow as a hand, while the new name is being written
  await page.getByRole('button', { name: 'Verify and save' }).click({ delay: 120 });
  expect((await download).suggestedFilename()).toBe('pick.ls');
  expect(await page.evaluate(() => window.denavit.xml())).toContain('format=tp source=program:m programName=pick<');
  const saved = await readFile(await (await download).path(), 'utf8');
  expect(saved).toMatch(/!Check 0\.\d{4}mm 0\.\d{4}deg ;\r\n +\d+: {2}!model [0-9a-f]{8} by /);
  const found = page.getByRole('region', { name: 'Verification' });
  await expect(found).toContainText('from the program at most');
  await expect(text).toContainText('!Check 0.');
  await found.getByText('Each move: 3').click();
  await expect(found.getByRole('row', { name: /linear · N U T, 0, 0, 0/ })).toBeVisible();
  await expectAccessible(page, { within: '#panel-code' });

  await page.getByRole('button', { name: 'Edit a copy' }).click();
  const editor = page.getByRole('textbox', { name: 'Text of pick' });
  await expect(page.getByText(/^As it was verified: 0\.\d{4} mm/)).toBeVisible();
  await editor.press('ControlOrMeta+f');
  await page.getByRole('textbox', { name: 'Find' }).fill("'N U T");
  await page.getByRole('textbox', { name: 'Replace' }).fill("'F U T");
  await page.getByRole('button', { name: 'replace all' }).click();
  await expect(
    page.getByText('Altered since it was verified: the text no longer matches its certificate.'),
  ).toBeVisible();
  await page.getByRole('button', { name: 'Verify and save' }).click();
  await expect(found).toContainText('Not saved.');
  const fault = found.getByRole('listitem').filter({ hasText: 'another posture of the arm' });
  await fault.getByRole('button').click();
  await expect(page.locator('.cm-activeLine')).toContainText('J P[2] 40%');
  await settled(page);
});
