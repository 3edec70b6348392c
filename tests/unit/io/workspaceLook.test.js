/** What is asked of the workspace goes with a link, and whatever else stands there does no harm. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readLook } from '../../../src/io/readLook.js';
import { readWorkspaceLook, writeWorkspaceLook } from '../../../src/io/workspaceLook.js';
import { FIRST_WORKSPACE } from '../../../src/model/workspace/workspaceView.js';
import { SEED, runs } from '../../helpers/property.js';

const real = (/** @type {number} */ least, /** @type {number} */ most) =>
  fc.double({ min: least, max: most, noNaN: true }).map((value) => Number(value.toFixed(9)) + 0);

const anyView = fc.record({
  open: fc.subarray(['volume', 'section', 'points']),
  withLimits: fc.boolean(),
  seed: fc.nat(1e6),
  hasVolume: fc.boolean(),
  style: fc.constantFrom('solid', 'points'),
  colour: fc.constantFrom('height', 'manipulability', 'postures', 'margin', 'directions'),
  detail: fc.constantFrom('coarse', 'usual', 'fine'),
  opacity: real(0.1, 1),
  tool: fc.constantFrom('any', 'fixed', 'cone'),
  wpr: fc.tuple(real(-7, 7), real(-7, 7), real(-7, 7)),
  halfAngle: real(0.001, 3),
  hasSection: fc.boolean(),
  cut: fc.constantFrom('own', 'angle', 'plane'),
  angle: real(-7, 7),
  normal: fc.tuple(real(-1, 1), real(-1, 1), real(0.1, 1)),
  offset: real(-100, 100),
  cell: fc.option(real(0.0001, 0.1)),
  isPrecise: fc.boolean(),
});

test('every view comes back as it was', () => {
  fc.assert(
    fc.property(anyView, (drawn) => {
      const view = /** @type {typeof FIRST_WORKSPACE} */ (drawn);
      const { view: read, refused } = readWorkspaceLook(new URLSearchParams(writeWorkspaceLook(view).join('&')));
      expect(refused).toEqual([]);
      expect(read).toEqual(view);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('whatever stands in a link, what is read makes sense', () => {
  const names = Object.keys(FIRST_WORKSPACE);
  const hostile = fc.oneof(
    fc.constantFrom(
      'NaN',
      'Infinity',
      '-1',
      '1e999',
      '0x10',
      'constructor',
      '__proto__',
      '',
      '1,2',
      '1,2,3,4',
      '0,0,0',
      '<b>',
    ),
    fc.string({ maxLength: 30 }),
    fc.double().map(String),
  );
  fc.assert(
    fc.property(fc.constantFrom(...names), hostile, hostile, (name, text, open) => {
      const given = new URLSearchParams([['workspace', open], [`workspace.${name}`, text]]); // prettier-ignore
      const { view } = readWorkspaceLook(given);
      if (!view) throw new Error('A link with the name has a view.');
      expect(Object.keys(view).sort()).toEqual([...names].sort());
      expect(view.open.length).toBeLessThanOrEqual(10);
      for (const fold of view.open) expect(fold).toMatch(/^[a-z]{1,20}$/);
      const numbers = [view.seed, view.opacity, ...view.wpr, view.halfAngle, view.angle, ...view.normal, view.offset, view.cell ?? 1]; // prettier-ignore
      expect(numbers.every(Number.isFinite)).toBe(true);
      expect(view.opacity).toBeGreaterThanOrEqual(0.1);
      expect(Math.hypot(...view.normal)).toBeGreaterThan(0);
      expect(view.cell === null || view.cell >= 1e-5).toBe(true);
      expect(['own', 'angle', 'plane']).toContain(view.cut);
      expect(Object.getPrototypeOf(view)).toBe(Object.prototype);
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});

test('what is not understood is named and left as it is; without its name nothing is asked', () => {
  const { change, refused } = readLook(
    'workspace=volume&workspace.colour=pink&workspace.opacity=0.3&workspace.normal=0,0,0',
  );
  expect(refused).toEqual(['workspace.colour', 'workspace.normal']);
  expect(change.workspace).toEqual({ ...FIRST_WORKSPACE, opacity: 0.3 });
  expect(readLook('workspace.opacity=0.3').change).toEqual({});
  expect(readLook('workspace=A').refused).toEqual(['workspace']);
  expect(writeWorkspaceLook(FIRST_WORKSPACE)).toEqual(['workspace=volume']);
});
