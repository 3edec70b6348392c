import fc from 'fast-check';
import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { linkFrames } from '../../../src/kinematics/forward.js';
import { createManualClock } from '../../../src/model/clock.js';
import { compileRobot } from '../../../src/model/compile.js';
import { LIBRARY } from '../../../src/model/library.js';
import { fitCamera, fitParallel } from '../../../src/render/fit.js';
import { gridSteps } from '../../../src/render/floor.js';
import { homeDirection } from '../../../src/render/homeDirection.js';
import { createView } from '../../../src/render/view.js';
import { DIRECTIONS, axesOf, between } from '../../../src/render/viewpoint.js';
import { SEED, runs } from '../../helpers/property.js';

/**
 * @import { Chain } from '../../../src/kinematics/chain.js'
 * @import { ViewName } from '../../../src/render/viewpoint.js'
 */

describe('an arm is first seen', () => {
  const angleBetween = (/** @type {Vector3} */ a, /** @type {Vector3} */ b) => (a.angleTo(b) * 180) / Math.PI;
  const seenFrom = (/** @type {Chain} */ chain) => {
    const frames = new Float64Array(16 * (chain.dof + 1));
    linkFrames(chain, new Float64Array(chain.dof).fill(0.3), frames);
    return axesOf(homeDirection(chain, frames)).back;
  };
  const usual = axesOf(DIRECTIONS.home).back;

  test('as always, unless all its joints move it in one plane', () => {
    for (const [id, robot] of Object.entries(LIBRARY)) {
      const isFlat = ['planar2r', 'planar3r', 'planar_rp'].includes(id);
      const turned = angleBetween(seenFrom(compileRobot(robot)), usual);
      if (isFlat) expect(turned, id).toBeGreaterThan(20);
      else expect(turned, id).toBeLessThan(1e-5);
    }
  });

  test('with its plane open to the eye, however it stands in the world, and never from below the floor that it lies on', () => {
    const joints = [0.5, 0.4, 0.2].map((a) => ({
      type: /** @type {const} */ ('revolute'),
      theta: 0,
      d: 0,
      a,
      alpha: 0,
    }));
    fc.assert(
      fc.property(
        fc.double({ min: -3, max: 3, noNaN: true }),
        fc.double({ min: -3, max: 3, noNaN: true }),
        fc.constantFrom(.../** @type {const} */ (['standard', 'modified'])),
        (turn, lean, convention) => {
          const [c, s, C, S] = [Math.cos(turn), Math.sin(turn), Math.cos(lean), Math.sin(lean)];
          // about z by turn, then about the new x by lean: the third column is the arm's normal
          const base = Float64Array.of(c, s, 0, 0, -s * C, c * C, S, 0, s * S, -c * S, C, 0, 0, 0, 0, 1);
          const back = seenFrom(createChain({ convention, base, joints }));
          const normal = new Vector3(s * S, -c * S, C);
          expect(Math.min(angleBetween(back, normal), angleBetween(back, normal.negate()))).toBeLessThan(38.01);
        },
      ),
      { seed: SEED, numRuns: runs(100) },
    );
    expect(seenFrom(createChain({ convention: 'standard', joints })).z).toBeGreaterThan(0.7);
  });
});

describe('the step of the grid', () => {
  test('is 1, 2 or 5 times a power of ten, and neither crowded nor empty, from a toy of 20 mm to a crane of 20 m', () => {
    const sizes = Array.from({ length: 400 }, (_, i) => 0.02 * 1000 ** (i / 399));
    for (const size of sizes) {
      const { minor, major } = gridSteps(size);
      expect(['1', '2', '5']).toContain(minor.toExponential().split('e')[0]);
      expect(size / minor).toBeGreaterThan(10);
      expect(size / minor).toBeLessThan(28);
      expect(Math.round(major / minor)).toBeGreaterThanOrEqual(4);
      expect(Math.abs(major / minor - Math.round(major / minor))).toBeLessThan(1e-9);
    }
  });
  test('is 100 mm for a Puma 560', () => expect(gridSteps(1.69)).toEqual({ minor: 0.1, major: 0.5 }));
});

test('a fitted camera sees all points within the part of the picture that they may fill, and touches its edge', () => {
  const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
  fc.assert(
    fc.property(
      fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 1, maxLength: 20 }),
      fc.double({ min: -3, max: 3, noNaN: true }),
      fc.double({ min: -1.4, max: 1.4, noNaN: true }),
      fc.double({ min: 0.3, max: 3, noNaN: true }),
      (coordinates, azimuth, elevation, aspect) => {
        // corners of boxes, as those of parts are
        const points = coordinates.flatMap((xyz) =>
          Array.from({ length: 8 }, (_, i) => new Vector3(...xyz.map((x, k) => (i & (1 << k) ? x : x + 0.1)))),
        );
        const back = new Vector3(
          Math.cos(elevation) * Math.cos(azimuth),
          Math.cos(elevation) * Math.sin(azimuth),
          Math.sin(elevation),
        );
        const right = new Vector3(0, 0, 1).cross(back).normalize();
        const up = back.clone().cross(right);
        const half = Math.tan((12 * Math.PI) / 180);
        const { x, y, z } = fitCamera(points, { right, up, back }, { tanX: 0.8 * half * aspect, tanY: 0.65 * half });
        const camera = new PerspectiveCamera(24, aspect, 0.001, 1000);
        camera.up.set(0, 0, 1);
        camera.position.addScaledVector(right, x).addScaledVector(up, y).addScaledVector(back, z);
        camera.lookAt(camera.position.clone().sub(back));
        camera.updateMatrixWorld();
        const seen = points.map((point) => point.clone().project(camera));
        const [wide, high] = [seen.map((p) => Math.abs(p.x) / 0.8), seen.map((p) => Math.abs(p.y) / 0.65)];
        expect(Math.max(...wide, ...high)).toBeCloseTo(1, 6);
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
});

describe('the views', () => {
  const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
  const points = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => new Vector3(i & 1 ? 2 : -1, i & 2 ? 0.5 : 0, i & 4 ? 3 : 0));

  test('have right and up where a drawing has them', () => {
    const said = (/** @type {ViewName} */ name) =>
      Object.fromEntries(
        Object.entries(axesOf(DIRECTIONS[name])).map(([key, { x, y, z }]) => [
          key,
          [x, y, z].map((value) => Math.round(value) || 0).join(),
        ]),
      );
    expect(said('front')).toEqual({ right: '1,0,0', up: '0,0,1', back: '0,-1,0' });
    expect(said('back')).toEqual({ right: '-1,0,0', up: '0,0,1', back: '0,1,0' });
    expect(said('left')).toEqual({ right: '0,-1,0', up: '0,0,1', back: '-1,0,0' });
    expect(said('right')).toEqual({ right: '0,1,0', up: '0,0,1', back: '1,0,0' });
    expect(said('top')).toEqual({ right: '1,0,0', up: '0,1,0', back: '0,0,1' });
    expect(said('bottom')).toEqual({ right: '1,0,0', up: '0,-1,0', back: '0,0,-1' });
  });

  test('in parallel fill just what they may', () =>
    fc.assert(
      fc.property(fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 2, maxLength: 20 }), (all) => {
        const axes = axesOf(DIRECTIONS.home);
        const some = [...all, [0, 0, 0], [1, 1, 1]].map((xyz) => new Vector3(...xyz));
        const { x, y, z, depth } = fitParallel(some, axes, { tanX: 0.3, tanY: 0.2 });
        const spread = (/** @type {Vector3} */ axis, /** @type {number} */ middle) =>
          some.map((point) => Math.abs(point.dot(axis) - middle));
        const fill = Math.max(...spread(axes.right, x).map((w) => w / 0.3), ...spread(axes.up, y).map((h) => h / 0.2));
        expect(fill).toBeCloseTo(depth, 9);
        const along = some.map((point) => point.dot(axes.back));
        expect(z - depth).toBeCloseTo((Math.min(...along) + Math.max(...along)) / 2, 9);
      }),
      { seed: SEED, numRuns: runs(50) },
    ));

  test('turn into one another the shorter way, and end exactly', () => {
    const from = { azimuth: 3, elevation: 0, distance: 1, target: new Vector3() };
    const to = { azimuth: -3, elevation: 1, distance: 4, target: new Vector3(1, 0, 0) };
    const half = between(from, to, 0.5);
    expect(Math.cos(half.azimuth)).toBeCloseTo(-1, 9);
    expect(half).toMatchObject({ elevation: 0.5, distance: 2, target: { x: 0.5 } });
    expect(between(from, to, 1)).toBe(to);
  });

  /** A view in no page. @param {boolean} isCalm */
  function createStillView(isCalm) {
    const clock = createManualClock();
    const target = new EventTarget();
    const element = /** @type {HTMLElement} */ (
      /** @type {unknown} */ (
        Object.assign(target, {
          style: {},
          ownerDocument: new EventTarget(),
          getRootNode: () => target,
          clientHeight: 400,
        })
      )
    );
    let changes = 0;
    /** @type {(string | null)[]} */
    const looks = [];
    const view = createView(element, {
      clock,
      isCalm: () => isCalm,
      onChange: () => changes++,
      onLook: (name) => looks.push(name),
    });
    view.resize(600, 400);
    const press = (/** @type {string} */ key, shiftKey = false) =>
      target.dispatchEvent(Object.assign(new Event('keydown', { cancelable: true }), { key, shiftKey }));
    return { clock, view, looks, press, changes: () => changes };
  }

  test('are flown to in less than 0.4 s, and then nothing more happens', () => {
    const { clock, view, changes } = createStillView(false);
    view.fit(points, 3, { free: null, from: 'home', flies: false });
    expect(clock.idle).toBe(true);
    view.fit(points, 3, { free: null, from: 'top', flies: true });
    let seconds = 0;
    for (; !clock.idle && seconds < 2; seconds += 1 / 60) clock.tick();
    expect(seconds).toBeGreaterThan(0.2);
    expect(seconds).toBeLessThan(0.4);
    expect(view.viewpoint().elevation).toBeCloseTo(Math.PI / 2, 4);
    const drawn = changes();
    clock.tick();
    expect(changes()).toBe(drawn);
  });

  test('are there at once where nothing may move', () => {
    const { clock, view } = createStillView(true);
    view.fit(points, 3, { free: null, from: 'right', flies: true });
    expect(clock.idle).toBe(true);
    expect(view.viewpoint().azimuth).toBeCloseTo(0, 9);
  });

  test('are come to though the room changes on the way', () => {
    const { clock, view } = createStillView(false);
    view.fit(points, 3, { free: null, from: 'home', flies: false });
    view.fit(points, 3, { free: null, from: 'front', flies: true });
    clock.tick(0.1);
    view.resize(500, 500);
    view.fit(points, 3, { free: null, from: null, flies: false });
    for (let i = 0; i < 60; i++) clock.tick();
    const resized = view.viewpoint();
    view.fit(points, 3, { free: null, from: 'front', flies: false });
    const { azimuth, elevation, distance } = view.viewpoint();
    expect([resized.azimuth, resized.elevation, resized.distance]).toEqual([azimuth, elevation, distance]);
  });

  test('give way to the hand in the middle of a flight', () => {
    const { clock, view, press } = createStillView(false);
    view.fit(points, 3, { free: null, from: 'home', flies: false });
    view.fit(points, 3, { free: null, from: 'back', flies: true });
    clock.tick(0.1);
    press('ArrowLeft');
    const { azimuth } = view.viewpoint();
    for (let i = 0; i < 60; i++) clock.tick();
    expect(view.viewpoint().azimuth).toBe(azimuth);
    expect(view.isUntouched).toBe(false);
  });

  test('in perspective and in parallel show what is looked at in the same size, from a toy of 20 mm to a crane of 20 m', () => {
    for (const size of [0.02, 1, 20]) {
      const { view } = createStillView(true);
      const scaled = points.map((point) => point.clone().multiplyScalar(size / 3));
      view.fit(scaled, size, { free: null, from: 'front', flies: false });
      view.scaleTo(size);
      const { target } = view.viewpoint();
      const beside = target.clone().add(new Vector3(0.1 * size, 0, 0.05 * size));
      const seen = [false, true].map((isParallel) => {
        view.project(isParallel);
        view.camera.updateMatrixWorld();
        const { near, far } = view.camera;
        expect(far - near).toBeGreaterThan(10 * size);
        return beside.clone().project(view.camera);
      });
      expect(seen[0].x).toBeCloseTo(seen[1].x, 9);
      expect(seen[0].y).toBeCloseTo(seen[1].y, 9);
      for (const { z } of seen) expect(Math.abs(z)).toBeLessThan(1);
    }
  });

  test('fill the picture alike with an arm of any size, a folded one too', () => {
    const seen = [0.02, 1, 20].map((size) => {
      const { view } = createStillView(true);
      return [1, 0.02].map((share) => {
        const scaled = points.map((point) => point.clone().multiplyScalar((share * size) / 3));
        view.fit(scaled, size, { free: null, from: 'home', flies: false });
        view.camera.updateMatrixWorld();
        return Math.max(...scaled.map((point) => Math.abs(point.clone().project(view.camera).y)));
      });
    });
    for (const [whole, folded] of seen) {
      expect(whole).toBeCloseTo(0.65, 2);
      expect(folded).toBeCloseTo(seen[1][1], 9);
      expect(folded).toBeLessThan(0.1); // not blown up
    }
  });

  test('tell of every step, however small the arm', () => {
    const { view, press, changes } = createStillView(true);
    view.fit(
      points.map((point) => point.clone().multiplyScalar(0.001)),
      0.003,
      { free: null, from: 'home', flies: false },
    );
    for (const [key, shift] of /** @type {const} */ ([
      ['ArrowUp', true],
      ['ArrowLeft', false],
      ['+', false],
    ])) {
      const before = changes();
      press(key, shift);
      expect(changes(), key).toBe(before + 1);
    }
  });

  test('are out of range where the arm came to be a speck or all around the eye, never by keys', () => {
    const { view, press } = createStillView(true);
    const isOut = (/** @type {number} */ size) => (view.scaleTo(size), view.isOutOfRange);
    view.fit(points, 3, { free: null, from: 'home', flies: false });
    expect([0.003, 0.1, 1, 3, 9, 600, 3e6].map(isOut)).toEqual([true, true, false, false, false, true, true]);
    for (const key of ['-', '+']) {
      view.scaleTo(3);
      for (let i = 0; i < 60; i++) press(key);
      expect(isOut(3), key).toBe(false);
    }
  });

  test('are asked for by keys', () => {
    const { looks, press } = createStillView(true);
    for (const key of ['f', 'Home', '0', '1', '5', '6', 'x', '9']) press(key);
    expect(looks).toEqual([null, 'home', 'home', 'front', 'top', 'bottom']);
  });
});
