/** Controller code on the page: written, checked while it is typed, run on the arm, stopped, and taken back. */
import { readFile } from 'node:fs/promises';
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open, settled } from './page.js';

const PROGRAM = `PROGRAM main
VAR i : INTEGER
  here : XYZWPR
BEGIN
  here = CURPOS(0, 0)
  here.z = here.z + 20.0
  WITH $MOTYPE = LINEAR, $SPEED = 1000.0, $TERMTYPE = FINE MOVE TO here
  i = 1
  WAIT FOR DIN[1]
  WHILE TRUE DO
    i = i + 1
  ENDWHILE
END main
`;

test('a KAREL program is typed, run to a breakpoint, stepped back with the arm, and stopped in its endless loop', async ({
  page,
}) => {
  await open(page);
  await page.getByRole('tab', { name: 'Code' }).click();
  await page.getByRole('button', { name: 'New KAREL program' }).click();
  const editor = page.getByRole('textbox', { name: 'Text of main' });
  await editor.press('ControlOrMeta+a');
  await page.keyboard.insertText(PROGRAM);
  // what is pressed stands, though leaving the editor draws it anew
  await page.getByRole('button', { name: 'go_lin.ls' }).click({ delay: 120 });
  await expect(page.getByRole('textbox', { name: 'Text of go_lin' })).toContainText('L PR[1]');
  await page.getByRole('button', { name: 'main.kl' }).click();
  const problem = page.locator('.code-problem');
  await expect(problem).toContainText('1 warning. Line 7: MOVE is deprecated');

  await page.locator('.cm-line').nth(7).click();
  await page.keyboard.press('F9');
  await expect(page.locator('.code-stop')).toHaveCount(1);
  const status = page.locator('.code-status');
  const height = () => page.evaluate(() => window.denavit.pose()[2][3]);
  const [before, joints] = [await height(), await page.evaluate(() => window.denavit.joints())];
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(status).toHaveText('Stopped before line 8');
  expect(await height()).toBeCloseTo(before + 0.02, 5);
  await expect(page.locator('.code-next-line')).toHaveText('  i = 1');
  await expect(page.getByRole('row', { name: /^here XYZWPR/ })).toBeVisible();
  await expectAccessible(page, { within: '#panel-code' });

  await page.getByRole('button', { name: 'Step back' }).click();
  await expect(status).toHaveText('Stopped before line 7');
  expect(await page.evaluate(() => window.denavit.joints())).toEqual(joints);
  await page.getByRole('button', { name: 'Step over' }).click();
  await expect(status).toHaveText('Stopped before line 8');
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(status).toHaveText('Line 9 waits');
  await page.getByRole('switch', { name: 'DIN[1], an input: set it' }).click();
  await expect(status).toHaveText(/^Running line 1[01]$/); // and goes on for ever, while the page answers
  await page.getByRole('button', { name: 'Stop', exact: true }).click();
  await expect(status).toHaveText('Stopped');

  await page.locator('.cm-line').nth(7).click();
  await page.keyboard.press('End');
  await page.keyboard.type(' + nothing');
  await expect(page.locator('.code-error')).toHaveText('nothing');
  await expect(problem).toContainText('Line 8');
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(status).toHaveText('One error is in the way; it is marked.');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.locator('.cm-line').nth(7)).toHaveText('  i = 1');

  await page.getByRole('button', { name: 'Go to the next one' }).click();
  await page.getByRole('button', { name: 'Write as TP call' }).press('Enter');
  await expect(page.getByRole('button', { name: 'main_mv.ls' })).toBeVisible();
  await expect(editor).toContainText('%NOLOCKGROUP');
  await expect(editor).toBeFocused();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(editor).toContainText('MOVE TO here');
  await expect(page.getByRole('button', { name: 'main_mv.ls' })).toBeHidden();
  await settled(page);
});

test('files of code are opened, renamed and removed, and the document keeps them', async ({ page }) => {
  await open(page);
  await page.getByRole('tab', { name: 'Code' }).click();
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open a file…' }).click();
  await (
    await chooser
  ).setFiles({
    name: '2 part.kl',
    mimeType: 'text/plain',
    buffer: Buffer.from("PROGRAM part\r\nBEGIN\r\n-- gr\xfcn\r\nWRITE('<b>', CR)\r\nEND part\r\n", 'latin1'),
  });
  await expect(page.getByRole('textbox', { name: 'Text of _2_part' })).toContainText('-- grün');
  expect(await page.evaluate(() => window.denavit.xml())).toContain('PROGRAM part');
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(page.locator('.code-output')).toHaveText('<b>');
  const menu = page.getByRole('button', { name: 'Files: new, open, rename, remove' });
  await menu.click();
  await page.getByRole('button', { name: 'Rename _2_part…' }).click();
  await expect(page.getByLabel('Name of the program')).toBeFocused();
  await page.getByLabel('Name of the program').fill('no name');
  await page.keyboard.press('Enter');
  await expect(page.locator('.code-refusal')).toContainText('no name');
  await page.getByLabel('Name of the program').fill('part');
  await page.keyboard.press('Enter');
  await expect(page.locator('.files').getByRole('button', { name: 'part.kl' })).toHaveAttribute('aria-pressed', 'true');
  await menu.click();
  await page.getByRole('button', { name: 'Remove part' }).click();
  await expect(page.getByText('No code yet')).toBeVisible();
  await expect(page.locator('#panel-code :focus')).toHaveCount(1);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('textbox', { name: 'Text of part' })).toBeVisible();
  // a listing that is dropped on the page stands beside it, and is saved as it came
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File(['/PROG  LF\n/MN\n   1:  R[1]=1 ;\n/POS\n/END\n'], 'lf.ls'));
    for (const type of ['dragenter', 'dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
  });
  await expect(page.getByRole('textbox', { name: 'Text of lf' })).toContainText('R[1]=1');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Verify and save' }).click();
  expect(await readFile(await (await download).path(), 'utf8')).toBe('/PROG  LF\n/MN\n   1:  R[1]=1 ;\n/POS\n/END\n');
});

test('a TP program shows where its lines lead, waits for an input, and runs on when that is set', async ({ page }) => {
  await open(page);
  await page.getByRole('tab', { name: 'Code' }).click();
  await page.getByRole('button', { name: 'New TP program' }).click();
  const lines = page.locator('.cm-line');
  await expect(lines.nth(12)).toContainText('L PR[2:above] 100mm/sec FINE');

  // where the arm would be, under the pointer; and from a point of the path to its line
  const points = page.locator('.path-step');
  await expect(points).toHaveText(['13', '15']);
  await lines.nth(12).hover();
  await expect(page.locator('.tag.ghost')).toHaveText('line 13');
  const point = await points.first().boundingBox();
  if (!point) throw new Error('Expected the point of line 13 in the scene.');
  await page.mouse.click(point.x + point.width / 2, point.y + point.height / 2);
  await expect(page.locator('.cm-activeLine')).toContainText('L PR[2:above]');
  await expect(page.locator('.tag.ghost')).toHaveText('line 13'); // there is no hovering with a finger

  const status = page.locator('.code-status');
  const height = () => page.evaluate(() => window.denavit.pose()[2][3]);
  const before = await height();
  await page.getByRole('button', { name: 'Run', exact: true }).click();
  await expect(status).toHaveText('Line 14 waits');
  expect(await height()).toBeCloseTo(before + 0.05, 5);
  await expect(page.locator('.code-next-line')).toContainText('WAIT DI[1:go back]=ON');
  await expectAccessible(page, { within: '#panel-code' });
  await page.getByRole('switch', { name: 'DI[1] go back, an input: set it' }).click();
  await expect(status).toHaveText('The program has ended');
  expect(await height()).toBeCloseTo(before, 5);
  await expectAccessible(page, { within: '#panel-code' });

  await page.getByRole('button', { name: 'Step back' }).click();
  await expect(page.locator('.code-next-line')).toContainText('L PR[1:here]');
  await page.getByLabel('PR[2] Z').fill('100');
  await page.getByLabel('Another register').fill('r 7');
  await page.keyboard.press('Enter');
  await page.getByLabel('R[7]', { exact: true }).fill('3');
  await page.getByRole('button', { name: 'Variables' }).click();
  await page.getByLabel('Watch an expression').fill('PR[2,3]-PR[1,3]>100 AND R[7]=3');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('row', { name: /^PR\[2,3\]-PR\[1,3\]>100/ })).toContainText('ON');
  await settled(page);
});
