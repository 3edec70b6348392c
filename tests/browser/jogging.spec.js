/** Jogging: buttons each way for joints and for the axes of a frame, by steps or for as long as they are held. */
import { expect, test } from '@playwright/test';
import { expectAccessible } from './accessible.js';
import { open } from './page.js';

/** @typedef {number[][]} Rows */
/** @typedef {import('@playwright/test').Page} Page */

const pose = (/** @type {Page} */ page) => page.evaluate(() => window.denavit.pose());
const joints = (/** @type {Page} */ page) => page.evaluate(() => window.denavit.joints());
const button = (/** @type {Page} */ page, /** @type {string} */ name) =>
  page.locator('.jog-panel').getByRole('button', { name, exact: true });

/** @param {Page} page */
async function openPendant(page) {
  await button(page, 'Tool').click();
  await expect(page.getByRole('group', { name: 'Buttons that move the arm' })).toBeVisible();
}

/** The turn by an angle about a unit vector, by Rodrigues' formula. @param {number[]} axis @param {number} angle @returns {Rows} */
function turnAbout([x, y, z], angle) {
  const [c, s, v] = [Math.cos(angle), Math.sin(angle), 1 - Math.cos(angle)];
  return [
    [c + v * x * x, v * x * y - s * z, v * x * z + s * y],
    [v * x * y + s * z, c + v * y * y, v * y * z - s * x],
    [v * x * z - s * y, v * y * z + s * x, c + v * z * z],
  ];
}

/** Where a press must take the tool. @param {Rows} T @param {number[]} direction @param {boolean} isTurn @param {number} amount @returns {Rows} */
function jogged(T, direction, isTurn, amount) {
  const R = turnAbout(direction, isTurn ? amount : 0);
  return T.map((row, i) =>
    i === 3
      ? row
      : row.map((value, j) => {
          if (j === 3) return isTurn ? value : value + amount * direction[i];
          return R[i].reduce((sum, factor, k) => sum + factor * T[k][j], 0);
        }),
  );
}

/** @param {Rows} one @param {Rows} other */
const farthest = (one, other) =>
  Math.max(...one.flatMap((row, i) => row.map((value, j) => Math.abs(value - other[i][j]))));

const NAMES = ['X', 'Y', 'Z', 'Turn about X', 'Turn about Y', 'Turn about Z'];

/** Roll, pitch and yaw of the frames that are jogged in, degrees. */
const ROBOT_BASE = [20, 10, -35];
const FIXTURE = [25, -40, 70];

/** Rz(yaw) Ry(pitch) Rx(roll), a turn after the other. @param {readonly number[]} angles @returns {Rows} */
function axesOf([roll, pitch, yaw]) {
  const turns = [[[0, 0, 1], yaw], [[0, 1, 0], pitch], [[1, 0, 0], roll]].map(([axis, angle]) => turnAbout(/** @type {number[]} */ (axis), (Number(angle) / 180) * Math.PI)); // prettier-ignore
  return turns.reduce((A, B) => A.map((row) => row.map((_, j) => row.reduce((sum, factor, k) => sum + factor * B[k][j], 0)))); // prettier-ignore
}

test('each button takes the tool along or about its axis, in each frame, by the step that was chosen', async ({
  page,
}) => {
  await open(page, 'q=10,20,-150,30,50,20');
  // on a base that leans, and with a fixture before it: no two frames have an axis in common
  await page.evaluate(
    async ([base, fixture]) => {
      const frames = `<base xyz="100 50 0" rpy="${base.join(' ')}"/><frames activeUser="fixture"><userFrame id="fixture" xyz="300 -200 80" rpy="${fixture.join(' ')}"/></frames>`;
      const posture = window.denavit.joints();
      await window.denavit.load(window.denavit.xml().replace('<chain>', `${frames}<chain>`));
      window.denavit.setJoints(posture);
    },
    [ROBOT_BASE, FIXTURE],
  );
  await openPendant(page);
  /** @type {Record<string, Rows | null>} the frame's axes, as columns; the tool's go along with it */
  const frames = { World: axesOf([0, 0, 0]), Base: axesOf(ROBOT_BASE), User: axesOf(FIXTURE), Tool: null };
  for (const [frame, axes] of Object.entries(frames)) {
    // As a voice or a screen reader presses them; the pointer's hold is the next test.
    const presses = await page.evaluate((text) => {
      const press = (/** @type {Element | undefined} */ element) => element instanceof HTMLElement && element.click();
      press([...document.querySelectorAll('.jog-frames button')].find(({ textContent }) => textContent === text));
      return [...document.querySelectorAll('.jog-key')].map((key) => {
        const before = window.denavit.pose();
        press(key);
        return { label: key.ariaLabel ?? '', before, after: window.denavit.pose() };
      });
    }, frame);
    expect(presses).toHaveLength(12);
    for (const { label, before, after } of presses) {
      const axis = NAMES.findIndex((name) => label.startsWith(`${name},`));
      const direction = [0, 1, 2].map((i) => (axes ?? before)[i][axis % 3]);
      const amount = (label.endsWith('plus') ? 1 : -1) * (axis < 3 ? 0.01 : (5 / 180) * Math.PI);
      expect(farthest(after, jogged(before, direction, axis > 2, amount)), `${frame}: ${label}`).toBeLessThan(1e-7);
    }
  }
  // and with a hand on the button, in the user frame
  await button(page, 'User').click();
  const before = await pose(page);
  await button(page, 'Turn about Y, minus').click();
  const direction = axesOf(FIXTURE).map((row) => row[1]);
  expect(farthest(await pose(page), jogged(before, direction, true, (-5 / 180) * Math.PI))).toBeLessThan(1e-7);
  await expectAccessible(page, { within: '.jog-panel' });
});

test('what is held moves by the clock until it is let go, is one step to undo, and has its curves; a singularity ends it', async ({
  page,
}) => {
  await page.setViewportSize({ width: 1000, height: 420 }); // hundreds of pictures, drawn in software: small ones
  await page.goto('./?quality=low&theme=light&hint=off&clock=manual&panels=jog,pose');
  const ticks = (/** @type {number} */ count, seconds = 1 / 50) =>
    page.evaluate(
      ([n, dt]) => {
        for (let i = 0; i < n; i++) window.denavit.clock?.tick(dt);
      },
      [count, seconds],
    );
  await page.waitForFunction(() => window.denavit?.clock);
  await expect.poll(async () => (await ticks(3), page.evaluate(() => 'undo' in window.denavit))).toBe(true);
  await button(page, 'Tool').click();
  await expect.poll(async () => (await ticks(1), page.locator('.jog-key').count())).toBe(12);
  await button(page, 'Hold').click();
  await page.locator('#fold-motion').click();
  const curves = page.locator('#fold-motion-body');
  await expect.poll(async () => (await ticks(1), curves.textContent())).toContain('Nothing has moved');
  const curve = (/** @type {string} */ name) =>
    curves.getByRole('row', { name: new RegExp(`^${name} `) }).getByRole('cell');
  const start = await pose(page);
  const home = await joints(page);
  await button(page, 'Z, minus').hover();
  await page.mouse.down();
  const plot = () => curves.locator('canvas').first().evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL()); // prettier-ignore
  await ticks(5, 1 / 10);
  const rolling = await plot();
  await ticks(5, 1 / 10); // a second at half of 250 mm/s
  const there = await pose(page);
  expect(there[2][3] - start[2][3]).toBeCloseTo(-0.125, 6);
  await expect(curve('Speed')).toHaveText(['125.0 mm/s', '125.0 mm/s', '125.0 mm/s']);
  const second = (/** @type {number[]} */ q) => `${q[1].toFixed(1)}°`;
  const low = await joints(page);
  await page.mouse.up();
  await ticks(10, 1 / 10);
  expect(await pose(page)).toEqual(there);
  await expect(curve('J2')).toHaveText([second(low), ...[low, home].map(second).sort()]);
  await expect(curve('Speed').first()).toHaveText('0.0 mm/s'); // at rest, and no curve runs on
  const drawn = await plot();
  expect(drawn).not.toBe(rolling);
  await ticks(2, 1);
  expect(await plot()).toBe(drawn);
  await page.keyboard.press('Control+z');
  expect(await joints(page)).toEqual(home);

  // Esc stops while the hand is still on, and so does a window that loses the focus.
  for (const stop of [
    () => page.keyboard.press('Escape'),
    () => page.evaluate(() => dispatchEvent(new Event('blur'))),
  ]) {
    await ticks(1);
    await button(page, 'Z, minus').hover(); // what was said before may have moved it
    await page.mouse.down();
    await ticks(10);
    await stop();
    const stopped = await pose(page);
    expect(stopped).not.toEqual(start);
    await ticks(5);
    expect(await pose(page)).toEqual(stopped);
    await page.mouse.up();
    await page.keyboard.press('Control+z');
    expect(await joints(page)).toEqual(home);
  }

  await page.mouse.down();
  await expect.poll(async () => (await ticks(5, 1 / 10), page.locator('.jog-word').textContent()), { intervals: [10] }).toContain('Stopped: J'); // prettier-ignore
  await page.mouse.up();
  await page.keyboard.press('Control+z'); // what was said of the limit is not true of where the arm is now
  await ticks(2);
  await expect(page.locator('.jog-word')).toHaveText('');

  // Curves of an arm that is exchanged while it moves are over.
  /** @type {string[]} */
  const errors = [];
  page.on('pageerror', ({ message }) => errors.push(message));
  await page.evaluate(() => {
    window.denavit.setJoints([5, 45, -160, 0, 40, 0]);
    return window.denavit.load('planar2r');
  });
  await expect.poll(async () => (await ticks(2), curves.locator('tbody tr').count())).toBe(3);
  expect(errors).toEqual([]);
  await page.evaluate(() => window.denavit.undo());
  await ticks(2);

  // It runs into singularities from outside: past a wrist that is almost straight it slows down, and an elbow that gets
  // straight is the end; no joint goes faster than it may in any frame.
  await page.locator('#fold-motion').click(); // what is drawn of it takes time
  const RATE = 180;
  /** Holds a button until the arm stops. @param {number[]} from @param {string} name */
  async function runInto(from, name) {
    await page.evaluate((q) => window.denavit.setJoints(q), from);
    await button(page, 'World').click();
    await button(page, name).hover();
    await page.mouse.down();
    const ran = await page.evaluate(
      ([most, dt]) => {
        const { clock, joints } = window.denavit;
        /** @type {string[]} */
        const said = [];
        let fastest = 0;
        for (let frame = 0, last = joints(); frame < 400 && !said.at(-1)?.startsWith('Stopped'); frame++) {
          clock?.tick(dt);
          const now = joints();
          fastest = Math.max(fastest, ...now.map((value, i) => Math.abs(value - last[i]) / dt));
          last = now;
          const word = document.querySelector('.jog-word')?.textContent ?? '';
          if (word !== '' && word !== said.at(-1)) said.push(word);
        }
        return { said, isTooFast: fastest > most * (1 + 1e-9) };
      },
      [RATE, 1 / 20],
    );
    await expect.poll(async () => (await ticks(2), page.locator('.lost-line').textContent())).toMatch(/^Lost here: moving along X 0\.\d\d/); // prettier-ignore
    await page.mouse.up();
    await button(page, name.replace('plus', 'minus')).hover(); // and back it comes, on the same elbow
    await page.mouse.down();
    await ticks(10);
    await page.mouse.up();
    const elbow = (await joints(page))[2];
    expect(ran.isTooFast).toBe(false);
    return { said: ran.said, elbow };
  }
  const out = await runInto([0, 45, -150, 0, 45, 0], 'X, plus');
  expect(out.said.at(-1)).toBe('Stopped: the edge of the tool’s reach.');
  expect(out.elbow).toBeLessThan(-87.4); // -150° at first; straight at -87.3°
  const past = await runInto([0, 45, -180, 30, 6, 0], 'Y, plus');
  expect(past.said[0]).toContain('Slowed down: near a singularity');
  expect(past.said.at(-1)).toBe('Stopped: the edge of the tool’s reach.');

  // Axes 4 and 6 are in line: the tool cannot turn about its own X, and the button that is still down moves nothing.
  await page.evaluate(() => window.denavit.setJoints([0, 45, -180, 0, 0, 0]));
  await button(page, 'Tool').last().click();
  await ticks(3);
  const straight = await joints(page);
  await button(page, 'Turn about X, plus').hover();
  await page.mouse.down();
  await ticks(4);
  await expect(page.locator('.jog-word')).toContainText('Stopped at a singularity');
  await expect
    .poll(async () => (await ticks(2), page.locator('.lost-line').textContent()))
    .toContain('turning about X 0.71, Z 0.71');
  await expect.poll(async () => (await ticks(2), page.locator('.tag.miss:visible').allTextContents())).toEqual(['no motion this way', 'no turn about this']); // prettier-ignore
  expect(await joints(page)).toEqual(straight);
  await page.mouse.up();
  await button(page, 'Turn about Y, plus').hover();
  await page.mouse.down();
  await ticks(4);
  await page.mouse.up();
  await ticks(2);
  expect(await joints(page)).not.toEqual(straight);
  await expect(page.locator('.lost-line')).toBeHidden();
});

test('keys alone: a frame, a typed step, a step each way, and joints', async ({ page }) => {
  await open(page);
  await button(page, 'Joints').focus();
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(page.locator('.jog-key')).toHaveCount(12);
  const [[, , , x]] = await pose(page);
  await page.keyboard.press('1'); // right where the focus is
  expect((await pose(page))[0][3] - x).toBeCloseTo(0.01, 8);
  const size = page.getByLabel('Step of the tool’s place, millimetres');
  await size.focus();
  await page.keyboard.type('2000');
  await page.keyboard.press('Enter');
  await expect(page.locator('#jog-step-reason')).toContainText('between 0.001 and 1000');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+a');
  await page.keyboard.type('2.5');
  await page.keyboard.press('Enter');
  await button(page, 'Hold').focus();
  const before = await pose(page);
  await page.keyboard.press('1');
  expect((await pose(page))[0][3] - before[0][3]).toBeCloseTo(0.0025, 8);
  await page.keyboard.press('Shift+Digit3');
  expect((await pose(page))[2][3] - before[2][3]).toBeCloseTo(-0.0025, 8);
  await button(page, 'Joints').focus();
  // The switch that comes with the joints can be gone to before the next frame.
  const isThereAtOnce = await button(page, 'Joints').evaluate((joints) => {
    if (joints instanceof HTMLElement) joints.click();
    const labels = [...document.querySelectorAll('.jog-switches label')];
    const buttons = labels.find(({ textContent }) => textContent === 'Buttons')?.querySelector('input');
    buttons?.focus();
    return document.activeElement === buttons;
  });
  expect(isThereAtOnce).toBe(true);
  await page.keyboard.press('Space');
  await button(page, 'Joint 2, minus').focus();
  const [, second] = await joints(page);
  await page.keyboard.press('Enter');
  await page.keyboard.press('Space');
  expect((await joints(page))[1]).toBeCloseTo(second - 10, 9);
});

test('an arm says what it cannot do', async ({ page }) => {
  await open(page, 'robot=planar2r&q=10,60');
  await openPendant(page);
  const before = await joints(page);
  await button(page, 'Z, plus').click();
  await expect(page.locator('.jog-word')).toHaveText('This arm has no joint that moves the tool that way.');
  expect(await joints(page)).toEqual(before);
});
