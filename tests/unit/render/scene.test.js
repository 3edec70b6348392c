import fc from 'fast-check';
import { beforeEach, describe, expect, test } from 'vitest';
import { Mesh, Vector3 } from 'three';
import { createChain } from '../../../src/kinematics/chain.js';
import { translation } from '../../../src/kinematics/pose.js';
import { createFrameLoop, createManualClock } from '../../../src/model/clock.js';
import { createArmModel } from '../../../src/render/arm/armModel.js';
import { createScene } from '../../../src/render/scene.js';
import { skinOf } from '../../../src/render/skins.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyRows, apply, framesByHand, inverse, libraryArms, times } from './arms.js';
import { fakeLabels } from './fakeLabels.js';
import { linkFrames } from '../../../src/kinematics/forward.js';

/** @import { Object3D } from 'three' */

/** @type {Record<string, string>} */
const TOKENS = { '--accent': '#5426A8', '--ink': '#171C24', '--bad': '#B3132B' };
const skin = skinOf('light', (name) => TOKENS[name] ?? '#1A6FE8');
const dark = skinOf('dark', () => '#C3B5FD');
const [, puma] = libraryArms[0];
const home = [0, 0.8, -3, 0, 0.8, 0];

/** A scene, drawn through a frame loop as the stage draws it. */
function createStill() {
  const clock = createManualClock();
  const labels = fakeLabels();
  const counts = { draws: 0, shadows: 0 };
  /** @type {number[]} */
  const steps = [];
  let castsAnew = false;
  const invalidate = createFrameLoop(clock, () => {
    counts.draws++;
    if (castsAnew) counts.shadows++;
    castsAnew = false;
  });
  const scene = createScene({
    skin,
    isLow: false,
    labels,
    text: {
      jointValue: (index) => `value of ${index}`,
      jointLimit: (index, which) => `${which} of ${index}`,
      jointExcess: (index, by) => `${index} past by ${by}`,
      missing: (metres) => `${metres.toFixed(3)} m`,
    },
    onChange(change) {
      castsAnew ||= change.castsAnew;
      invalidate();
    },
    onGridStep: (step) => steps.push(step),
  });
  return { scene, clock, labels, counts, steps };
}

/** @param {Object3D} root @returns {Mesh[]} */
function meshesIn(root) {
  /** @type {Mesh[]} */
  const found = [];
  root.traverse((object) => {
    if (object instanceof Mesh) found.push(object);
  });
  return found;
}

describe('a picture is due', () => {
  /** @type {ReturnType<typeof createStill>} */
  let still;
  beforeEach(() => {
    still = createStill();
    still.scene.showArm(puma, []);
    still.scene.showPosture(home);
    still.clock.tick();
  });

  test('once after the arm was shown, and then no more', () => {
    expect(still.counts.draws).toBe(1);
    for (let i = 0; i < 100; i++) still.clock.tick();
    expect(still.counts.draws).toBe(1);
    expect(still.clock.idle).toBe(true);
  });

  test('once a frame, however much has changed', () => {
    for (let i = 1; i <= 10; i++) still.scene.showPosture(home.map((value) => value + i / 100));
    still.scene.highlightJoint(1);
    still.scene.holdJoint(1);
    still.scene.showTarget(translation([0.5, 0, 0.5]), { reached: false });
    still.clock.tick();
    expect(still.counts.draws).toBe(2);
    expect(still.clock.idle).toBe(true);
  });

  test('not when the same is shown again', () => {
    const none = still.scene.extent();
    still.scene.showPosture([...home]);
    still.scene.highlightJoint(null);
    still.scene.holdJoint(null);
    still.scene.showTarget(null, { reached: false });
    expect(still.clock.idle).toBe(true);
    expect(none?.size).toBeGreaterThan(1);
  });

  test('with a new shadow only if the arm moved', () => {
    const { shadows } = still.counts;
    still.scene.highlightJoint(2);
    still.clock.tick();
    still.scene.setSkin(dark);
    still.clock.tick();
    expect(still.counts).toEqual({ draws: 3, shadows });
    still.scene.showPosture(home.map((value) => value + 0.1));
    still.clock.tick();
    expect(still.counts).toEqual({ draws: 4, shadows: shadows + 1 });
  });

  test('and what was built for another table is let go', () => {
    const before = meshesIn(still.scene.scene).filter(({ castShadow }) => castShadow);
    let disposed = 0;
    for (const { geometry } of before) geometry.addEventListener('dispose', () => disposed++);
    still.scene.showPosture(home.map((value) => value + 0.1));
    expect(disposed).toBe(0);
    const same = meshesIn(still.scene.scene).filter(({ castShadow }) => castShadow);
    expect(same).toEqual(before);
    const [, other] = libraryArms[1];
    still.scene.showArm(other, []);
    expect(disposed).toBe(before.length);
    const after = meshesIn(still.scene.scene);
    expect(after.filter((mesh) => before.includes(mesh))).toEqual([]);
  });
});

describe('every part moves with the frame of its link and with nothing else', () => {
  test('seen from a second set of kinematics', () =>
    fc.assert(
      fc.property(anyRows, fc.constantFrom('standard', 'modified'), (drawn, name) => {
        const convention = /** @type {'standard' | 'modified'} */ (name);
        const joints = drawn.map(([row]) => row);
        const chain = createChain({ convention, joints });
        const model = createArmModel({ skin, isLow: true });
        model.build(chain, []);
        const postures = [joints.map(() => 0), drawn.map(([, value]) => value)];
        const [before, after] = postures.map((q) => {
          model.move(linkFrames(chain, q), q);
          model.group.updateMatrixWorld();
          return Array.from({ length: chain.dof + 1 }, (_, i) =>
            meshesIn(model.linkGroup(i))
              .filter(({ matrix }) => matrix.equals(mesh0.matrix))
              .map(cornersOf),
          );
        });
        const [still, moved] = postures.map((q) => framesByHand(convention, joints, q));
        let worst = 0;
        before.forEach((meshes, link) => {
          const step = times(moved[link], inverse(still[link]));
          meshes.flat().forEach((point, i) => {
            const expected = apply(step, point);
            const got = after[link].flat()[i];
            worst = Math.max(worst, ...expected.map((x, k) => Math.abs(x - got[k])));
          });
        });
        expect(worst).toBeLessThan(1e-5); // vertices are single precision
      }),
      { seed: SEED, numRuns: runs(30) },
    ));
});

/** Whose matrix is the identity: rods are the only meshes that have their own. */
const mesh0 = new Mesh();

/** A few corners of a mesh, in the world. @param {Mesh} mesh */
function cornersOf(mesh) {
  const { position } = mesh.geometry.attributes;
  const every = Math.ceil(position.count / 40);
  return Array.from({ length: Math.floor(position.count / every) }, (_, i) =>
    new Vector3()
      .fromBufferAttribute(position, i * every)
      .applyMatrix4(mesh.matrixWorld)
      .toArray(),
  );
}

test('a slide that has come to nothing is drawn without its rod, which would have no inside', () => {
  const model = createArmModel({ skin, isLow: true });
  const row = { a: 0, alpha: 0, d: 0, theta: 0, lower: 0, upper: 1 };
  const chain = createChain({
    convention: 'standard',
    joints: [
      { ...row, type: 'revolute', d: 0.5 },
      { ...row, type: 'prismatic' },
    ],
  });
  model.build(chain, []);
  const hidden = (/** @type {number[]} */ q) => {
    model.move(linkFrames(chain, q), q);
    return meshesIn(model.group).filter(({ visible }) => !visible).length;
  };
  expect(hidden([0, 0.4])).toBe(0);
  expect(hidden([0, 0])).toBe(1);
});

test('nothing is to be seen of an arm before its posture is known, nor of one whose posture was of another', () => {
  const { scene, labels } = createStill();
  expect(scene.extent()).toBe(null);
  scene.showArm(puma, []);
  expect(scene.extent()).toBe(null);
  scene.showPosture(home);
  expect(scene.extent()?.corners.every(({ x, y, z }) => [x, y, z].every(Number.isFinite))).toBe(true);
  expect(labels.texts('axis axis-x')).toEqual(['x0']);
  const [, planar] = libraryArms.find(([id]) => id === 'planar2r') ?? libraryArms[0];
  scene.showArm(planar, []);
  expect(scene.extent()).toBe(null);
  expect(labels.texts('axis axis-x')).toEqual([]);
  scene.showPosture([0, 0]);
  expect(scene.extent()).not.toBe(null);
});

test('a posture without an arm, or of the wrong length, is refused', () => {
  const { scene } = createStill();
  expect(() => scene.showPosture([0])).toThrow('Expected an arm to be shown before its posture.');
  scene.showArm(puma, []);
  expect(() => scene.showPosture([0, 0])).toThrow('Expected 6 joint values, got 2.');
});

describe('the joint in hand', () => {
  test('shows its value and both its limits, in the words of the page', () => {
    const { scene, labels } = createStill();
    scene.showArm(puma, []);
    scene.showPosture(home);
    scene.holdJoint(1);
    expect(labels.texts('dim')).toEqual(['value of 1']);
    expect(labels.texts('tick')).toEqual(['lower of 1', 'upper of 1']);
    scene.holdJoint(null);
    expect(labels.texts('dim')).toEqual([]);
    expect(labels.texts('tick')).toEqual([]);
  });

  test('has an arc of its own past its limit, as long as it would have to go, with the number', () => {
    const { scene, labels } = createStill();
    scene.showArm(puma, []);
    scene.showPosture(home);
    for (const bound of /** @type {const} */ (['lower', 'upper'])) {
      scene.holdJoint(1, { joint: 1, by: 0.5, bound });
      expect(labels.texts('miss')).toEqual(['1 past by 0.5']);
      const [excess] = labels.all.filter(({ className }) => className === 'miss');
      const [lower, upper] = labels.all.filter(({ className }) => className === 'tick');
      const from = excess.from ?? new Vector3();
      // seen from the axis, as far from the limit as it is past it, on the side away from the other
      const turn = (/** @type {Vector3} */ a, /** @type {Vector3} */ b) =>
        a.clone().sub(from).angleTo(b.clone().sub(from));
      expect(turn(excess.at, (bound === 'lower' ? lower : upper).at)).toBeCloseTo(0.5, 9);
      expect(turn(excess.at, (bound === 'lower' ? upper : lower).at)).toBeCloseTo((90 / 180) * Math.PI - 0.5, 6);
    }
    scene.holdJoint(1);
    expect(labels.texts('miss')).toEqual([]);
    scene.holdJoint(null);
    expect(labels.all.some(({ className }) => className === 'miss')).toBe(false);
  });

  test('has no words about limits that it does not have', () => {
    const { scene, labels } = createStill();
    const row = { a: 0.3, alpha: 0, d: 0, theta: 0 };
    const free = createChain({
      convention: 'standard',
      joints: [
        { ...row, type: 'revolute' },
        { ...row, type: 'prismatic', lower: 0 },
      ],
    });
    scene.showArm(free, []);
    scene.showPosture([9, 3]);
    scene.holdJoint(0);
    expect(labels.texts('tick')).toEqual([]);
    scene.holdJoint(1);
    expect(labels.texts('tick')).toEqual(['lower of 1']);
    scene.holdJoint(5); // of another arm
    expect(labels.texts('dim')).toEqual([]);
  });

  test('points its needle along the link, wherever the joint is', () => {
    const { scene, labels } = createStill();
    const [, planar] = libraryArms.find(([id]) => id === 'planar2r') ?? libraryArms[0];
    scene.showArm(planar, []);
    scene.holdJoint(1);
    for (const [q1, q2] of [
      [0.3, -1.2],
      [-2, 2.5],
    ]) {
      scene.showPosture([q1, q2]);
      scene.scene.updateMatrixWorld();
      const [value] = labels.all.filter(({ className }) => className === 'dim');
      const [tip, elbow] = [value.at, value.from ?? new Vector3()].map((point) =>
        point.clone().applyMatrix4(value.parent?.matrixWorld ?? mesh0.matrix),
      );
      const angle = Math.atan2(tip.y - elbow.y, tip.x - elbow.x);
      expect(Math.cos(angle - q1 - q2)).toBeCloseTo(1, 9);
      expect([elbow.x, elbow.y]).toEqual([expect.closeTo(Math.cos(q1), 9), expect.closeTo(Math.sin(q1), 9)]);
    }
  });
});

describe('the target', () => {
  test('says how far the tool is from it, until it is reached', () => {
    const { scene, labels } = createStill();
    const [, planar] = libraryArms.find(([id]) => id === 'planar2r') ?? libraryArms[0];
    scene.showArm(planar, []);
    scene.showPosture([0, 0]); // the tool is at x = 2
    scene.showTarget(translation([2, 0.3, 0.4]), { reached: false });
    expect(labels.texts('miss')).toEqual(['0.500 m']);
    scene.showPosture([Math.PI / 2, 0]);
    expect(labels.texts('miss')).toEqual([`${Math.hypot(2, 1.7, 0.4).toFixed(3)} m`]);
    scene.showTarget(translation([0, 2, 0]), { reached: true });
    expect(labels.texts('miss')).toEqual([]);
    expect(labels.texts('axis axis-x strong')).toEqual(['X']); // the tool's
    scene.showTarget(null, { reached: false });
    expect(labels.all.some(({ className }) => className === 'miss')).toBe(false);
  });
});

test('letters and marks are put away with the scene, and with each other', () => {
  const { scene, labels } = createStill();
  scene.showArm(puma, []);
  scene.showPosture(home);
  scene.holdJoint(2);
  scene.showTarget(translation([1, 0, 0]), { reached: false });
  const count = labels.all.length;
  for (let i = 0; i < 5; i++) {
    scene.setSkin(i % 2 ? skin : dark);
    scene.rewrite();
  }
  expect(labels.all.length).toBe(count);
  scene.dispose();
  expect(labels.all).toEqual([]);
});
