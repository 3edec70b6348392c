import fc from 'fast-check';
import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { compileRobot } from '../../../src/model/compile.js';
import { handleStep } from '../../../src/model/aim/handleAxes.js';
import { PUMA_560 } from '../../../src/model/library/first.js';
import { alongAxis, angleAbout, onPlane, snap, unwrap } from '../../../src/render/drag/dragRays.js';
import { beginGoal } from '../../../src/render/drag/dragGoal.js';
import { beginTurn } from '../../../src/render/drag/dragTurn.js';
import { toolStep } from '../../../src/render/drag/dragKeys.js';
import { PARTS, atHandle, outlineOf, partAt } from '../../../src/render/drag/handleParts.js';
import { eyeOf } from '../../../src/render/eye.js';
import { sightOf } from '../../../src/render/sight.js';
import { SEED, runs } from '../../helpers/property.js';

/**
 * @template Case
 * @param {fc.IPropertyWithHooks<Case>} property
 */
const check = (property) => fc.assert(property, { seed: SEED, numRuns: runs(200) });

const step = { metres: 0.01, radians: 0.1 };
const number = fc.double({ min: -2, max: 2, noNaN: true });
const point = fc.tuple(number, number, number);
const direction = point.filter((v) => Math.hypot(...v) > 0.1).map((v) => v.map((x) => x / Math.hypot(...v)));
const angle = fc.double({ min: -3, max: 3, noNaN: true });

/** @param {readonly number[]} a @param {readonly number[]} b */
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const unit = (/** @type {readonly number[]} */ v) => v.map((x) => x / Math.hypot(...v));

/** A ray to a point from somewhere. @param {readonly number[]} from @param {readonly number[]} to */
const rayTo = (from, to) => ({ from, along: unit(to.map((x, i) => x - from[i])) });

describe('a line of sight', () => {
  test('to a point on an axis finds that point', () => {
    check(
      fc.property(point, direction, number, point, (origin, axis, s, eye) => {
        const on = origin.map((x, i) => x + s * axis[i]);
        fc.pre(apart(on, eye) > 0.2);
        const ray = rayTo(eye, on);
        fc.pre(Math.abs(ray.along.reduce((sum, x, i) => sum + x * axis[i], 0)) < 0.99);
        expect(alongAxis(ray, origin, axis)).toBeCloseTo(s, 8);
      }),
    );
  });

  test('comes no nearer to the axis anywhere else', () => {
    check(
      fc.property(point, direction, point, direction, number, (origin, axis, from, along, other) => {
        const s = alongAxis({ from, along }, origin, axis);
        fc.pre(s !== null);
        const distance = (/** @type {number} */ at) => {
          const w = new Vector3(...origin).addScaledVector(new Vector3(...axis), at).sub(new Vector3(...from));
          return w.cross(new Vector3(...along)).length();
        };
        expect(distance(Number(s))).toBeLessThanOrEqual(distance(other) + 1e-9);
      }),
    );
  });

  test('along an axis or a plane, or away from it, says nothing', () => {
    expect(alongAxis({ from: [0, 0, 1], along: [1, 0, 0] }, [0, 0, 0], [1, 0, 0])).toBeNull();
    expect(onPlane({ from: [0, 0, 1], along: [1, 0, 0] }, [0, 0, 0], [0, 0, 1])).toBeNull();
    expect(onPlane({ from: [0, 0, 1], along: [0, 0, 1] }, [0, 0, 0], [0, 0, 1])).toBeNull();
    expect(alongAxis({ from: [0, 0, 1], along: [0, 0, 1] }, [0, 0, 0], [1, 0, 0])).toBeNull();
  });

  test('meets a plane in the plane, and on the line', () => {
    check(
      fc.property(point, direction, point, direction, (origin, normal, from, along) => {
        const at = onPlane({ from, along }, origin, normal);
        fc.pre(at !== null && Math.hypot(...at) < 50 && apart(at, from) > 0.01);
        const hit = /** @type {number[]} */ (at);
        expect(hit.reduce((sum, x, i) => sum + (x - origin[i]) * normal[i], 0)).toBeCloseTo(0, 9);
        expect(apart(unit(hit.map((x, i) => x - from[i])), along)).toBeLessThan(1e-6);
      }),
    );
  });

  test('sees the angle that a point was turned by', () => {
    check(
      fc.property(angle, fc.double({ min: 0.1, max: 2, noNaN: true }), point, (turn, radius, at) => {
        const eye = [at[0], at[1], 3];
        const hit = [radius * Math.cos(turn), radius * Math.sin(turn), 0];
        expect(angleAbout(rayTo(eye, hit), [0, 0, 0], [0, 0, 1], [1, 0, 0])).toBeCloseTo(turn, 8);
      }),
    );
  });
});

test('angles go on over half a turn, and steps are whole', () => {
  check(
    fc.property(
      fc.double({ min: -40, max: 40, noNaN: true }),
      fc.double({ min: -3, max: 3, noNaN: true }),
      (near, by) => {
        const wrapped = Math.atan2(Math.sin(near + by), Math.cos(near + by));
        expect(unwrap(wrapped, near)).toBeCloseTo(near + by, 8);
      },
    ),
  );
  check(
    fc.property(number, fc.constantFrom(0.01, 0.1, 5), (value, step) => {
      const snapped = snap(value, step);
      expect(Math.abs(snapped - value)).toBeLessThanOrEqual(step / 2 + 1e-12);
      expect(Math.abs(snapped / step - Math.round(snapped / step))).toBeLessThan(1e-9);
      expect(Object.is(snapped, -0)).toBe(false);
    }),
  );
});

/** An eye that looks at the origin, in perspective or not, from anywhere but along an axis. */
const anySight = fc
  .tuple(fc.double({ min: -3, max: 3, noNaN: true }), fc.double({ min: -1, max: 1, noNaN: true }), fc.boolean())
  .map(([azimuth, elevation, isParallel]) => {
    const camera = isParallel
      ? new OrthographicCamera(-1, 1, 0.75, -0.75, -10, 10)
      : new PerspectiveCamera(24, 4 / 3, 0.1, 50);
    camera.up.set(0, 0, 1);
    camera.position.set(
      Math.cos(azimuth) * Math.cos(elevation),
      Math.sin(azimuth) * Math.cos(elevation),
      Math.sin(elevation),
    );
    camera.position.multiplyScalar(4);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    camera.updateProjectionMatrix();
    return sightOf(eyeOf(camera, 800, 600));
  });
const placed = { centre: [0.1, -0.05, 0.02], axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], length: 0.3 }; // prettier-ignore
const T = Float64Array.from([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...placed.centre, 1]);

describe('a pointer in the picture', () => {
  test('is on the line of sight through it', () => {
    check(
      fc.property(
        anySight,
        fc.double({ min: 0, max: 800, noNaN: true }),
        fc.double({ min: 0, max: 600, noNaN: true }),
        (sight, x, y) => {
          const { from, along } = sight.ray(x, y);
          const [px, py] = sight.project(from.map((value, i) => value + 3 * along[i]));
          expect(Math.hypot(px - x, py - y)).toBeLessThan(1e-6);
        },
      ),
    );
  });

  test('on a part of the handle means that part, unless another is as near', () => {
    check(
      fc.property(anySight, fc.constantFrom(...PARTS), fc.nat({ max: 23 }), (sight, part, at) => {
        const outline = outlineOf(part);
        const [x, y] = sight.project(atHandle(placed, outline[at % outline.length]));
        const found = partAt(placed, sight, x, y, false);
        fc.pre(found !== null); // seen end-on it cannot be taken
        const [fx, fy] = sight.project(/** @type {NonNullable<typeof found>} */ (found).point);
        expect(Math.hypot(fx - x, fy - y)).toBeLessThan(found?.part.kind === 'plane' ? 40 : 9.01);
      }),
    );
  });

  test('drags an arrow along its axis and nowhere else, and the arrow stays under it', () => {
    check(
      fc.property(anySight, fc.nat({ max: 2 }), fc.double({ min: -0.4, max: 0.4, noNaN: true }), (sight, axis, way) => {
        const part = { kind: /** @type {const} */ ('move'), axis };
        const held = atHandle(placed, outlineOf(part)[1]);
        fc.pre(Math.abs(sight.towards(placed.centre)[axis]) < 0.95);
        const [x, y] = sight.project(held);
        const goalAt = beginGoal({
          part,
          T_world_tcp: T,
          axes: placed.axes,
          point: held,
          farthest: 9,
          step,
          sight,
          x,
          y,
        });
        const to = held.map((value, i) => value + (i === axis ? way : 0));
        const [px, py] = sight.project(to);
        const goal = goalAt?.(sight, px, py, false);
        const expected = T.slice();
        expected[12 + axis] += way;
        expected.forEach((value, i) => expect(goal?.[i]).toBeCloseTo(value, 6));
        expect(goalAt?.(sight, x, y, false)?.every((value, i) => Math.abs(value - T[i]) < 1e-12)).toBe(true);
        const snapped = goalAt?.(sight, px, py, true)?.[12 + axis] ?? NaN;
        expect(Math.abs((snapped - T[12 + axis]) * 100 - Math.round(way * 100))).toBeLessThan(
          1e-3 + Number(Math.abs(((way * 100) % 1) - 0.5) < 1e-3),
        );
      }),
    );
  });

  test('drags a plane and the point across the line of sight, and what was held stays under it', () => {
    check(
      fc.property(
        anySight,
        fc.constantFrom('plane', 'free'),
        fc.nat({ max: 2 }),
        angle,
        angle,
        (sight, kind, axis, u, v) => {
          const part = { kind: /** @type {'plane' | 'free'} */ (kind), axis };
          fc.pre(kind === 'free' || Math.abs(sight.towards(placed.centre)[axis]) > 0.25);
          const [x, y] = sight.project(placed.centre);
          const goalAt = beginGoal({
            part,
            T_world_tcp: T,
            axes: placed.axes,
            point: placed.centre,
            farthest: 9,
            step,
            sight,
            x,
            y,
          });
          const [px, py] = [x + 15 * u, y + 15 * v];
          const goal = goalAt?.(sight, px, py, false);
          const at = [...(goal?.subarray(12, 15) ?? [])];
          const [gx, gy] = sight.project(at);
          expect(Math.hypot(gx - px, gy - py)).toBeLessThan(1e-5);
          if (kind === 'plane') expect(at[axis]).toBeCloseTo(placed.centre[axis], 9);
        },
      ),
    );
  });

  test('turns about an axis by the angle that it goes round, on the screen too', () => {
    check(
      fc.property(
        anySight,
        fc.nat({ max: 2 }),
        fc.double({ min: -2.5, max: 2.5, noNaN: true }),
        (sight, axis, turn) => {
          fc.pre(Math.abs(sight.towards(placed.centre)[axis]) > 0.4);
          const spot = (/** @type {number} */ at) => {
            const local = [0, 0, 0];
            local[(axis + 1) % 3] = 0.7 * Math.cos(at);
            local[(axis + 2) % 3] = 0.7 * Math.sin(at);
            return atHandle(placed, local);
          };
          const held = spot(0.6);
          const [x, y] = sight.project(held);
          const turnAt = beginTurn({ centre: placed.centre, axis: placed.axes[axis], point: held, sight, x, y });
          let last = /** @type {number | null} */ (0);
          for (let i = 1; i <= 8; i++) last = turnAt(sight, ...sight.project(spot(0.6 + (turn * i) / 8)));
          expect(last).toBeCloseTo(turn, 6);
        },
      ),
    );
  });

  test('goes along the tangent where the axis is seen from the side', () => {
    check(
      fc.property(
        anySight,
        fc.nat({ max: 2 }),
        fc.double({ min: -0.01, max: 0.01, noNaN: true }),
        (sight, axis, turn) => {
          const facing = Math.abs(sight.towards(placed.centre)[axis]);
          fc.pre(facing < 0.25);
          const radial = [0, 0, 0];
          const towards = sight.towards(placed.centre);
          radial[(axis + 1) % 3] = towards[(axis + 1) % 3];
          radial[(axis + 2) % 3] = towards[(axis + 2) % 3];
          const r = unit(radial);
          const spot = (/** @type {number} */ at) =>
            placed.centre.map((value, i) => {
              const e = placed.axes[axis];
              const t = [e[1] * r[2] - e[2] * r[1], e[2] * r[0] - e[0] * r[2], e[0] * r[1] - e[1] * r[0]];
              return value + 0.2 * (Math.cos(at) * r[i] + Math.sin(at) * t[i]);
            });
          const held = spot(0);
          const [x, y] = sight.project(held);
          const turnAt = beginTurn({ centre: placed.centre, axis: placed.axes[axis], point: held, sight, x, y });
          expect(turnAt(sight, ...sight.project(spot(turn)))).toBeCloseTo(turn, 3);
        },
      ),
    );
  });

  test('near the horizon asks for no more than is worth while', () => {
    const part = { kind: /** @type {const} */ ('move'), axis: 0 };
    const camera = new PerspectiveCamera(24, 4 / 3, 0.1, 50);
    camera.up.set(0, 0, 1);
    camera.position.set(-2, -1, 0.5);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    const sight = sightOf(eyeOf(camera, 800, 600));
    const held = atHandle(placed, [0.6, 0, 0]);
    const [x, y] = sight.project(held);
    const goalAt = beginGoal({ part, T_world_tcp: T, axes: placed.axes, point: held, farthest: 2, step, sight, x, y });
    for (let px = -400; px < 1200; px += 7) {
      const goal = goalAt?.(sight, px, y, false);
      if (goal) expect(Math.abs(goal[12] - T[12])).toBeLessThanOrEqual(2 + 1e-12);
    }
  });
});

test('a step is round, and as large as the arm asks for: 10 mm for a Puma 560, from a toy of 20 mm to a crane of 20 m', () => {
  expect(handleStep(compileRobot(PUMA_560)).metres).toBe(0.01);
  const armOf = (/** @type {number} */ reach) =>
    createChain({
      convention: 'standard',
      joints: [0.6, 0.4].map((share) => ({ type: 'revolute', theta: 0, d: 0, a: share * reach, alpha: 0 })),
    });
  expect(handleStep(armOf(0.02)).metres).toBe(0.0002);
  expect(handleStep(armOf(20)).metres).toBe(0.2);
  for (let reach = 0.001; reach < 1000; reach *= 1.13) {
    const { metres } = handleStep(armOf(reach));
    expect(['1', '2', '5']).toContain(metres.toExponential().split('e')[0]);
    expect(reach / metres).toBeGreaterThan(63);
    expect(reach / metres).toBeLessThan(159);
  }
});

test('keys step along the axes, coarse with Shift and fine with Alt or Ctrl', () => {
  const key = (/** @type {string} */ name, more = {}) => ({ key: name, shiftKey: false, altKey: false, ctrlKey: false, metaKey: false, ...more }); // prettier-ignore
  expect(toolStep(key('ArrowLeft'), 'move', 2)).toEqual({ axis: 0, steps: -1 });
  expect(toolStep(key('PageUp', { shiftKey: true }), 'turn', 0)).toEqual({ axis: 2, steps: 5 });
  expect(toolStep(key('ArrowUp', { altKey: true }), 'move', 2)).toEqual({ axis: 1, steps: 0.1 });
  expect(toolStep(key('a'), 'move', 2)).toBeNull();
});
