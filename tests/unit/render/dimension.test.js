/**
 * The dimensions of the scene, judged by the books' own definitions of the four numbers (Spong, section 3.2; Craig, section
 * 3.4): from which axis to which each is measured, along or about which, and with what sign.
 *
 * @import { JointRow } from '../../../src/kinematics/joint.js'
 * @import { Rows } from './arms.js'
 */
import fc from 'fast-check';
import { ConeGeometry, Group, Mesh, PerspectiveCamera, Scene, SphereGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { linkFrames } from '../../../src/kinematics/forward.js';
import { createDimensionMarks } from '../../../src/render/marks/dimension.js';
import { eyeOf } from '../../../src/render/eye.js';
import { skinOf } from '../../../src/render/skins.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, framesByHand } from './arms.js';
import { fakeLabels } from './fakeLabels.js';

/** @typedef {'theta' | 'd' | 'a' | 'alpha'} Field */
const FIELDS = /** @type {Field[]} */ (['theta', 'd', 'a', 'alpha']);
const skin = skinOf('light', () => '#1A6FE8');

/** @param {number[]} p @param {number[]} v @param {number} [t] */
const plus = (p, v, t = 1) => p.map((x, i) => x + t * v[i]);
/** @param {number[]} p @param {number[]} v */
const minus = (p, v) => plus(p, v, -1);
/** @param {number[]} p @param {number[]} v */
const dot = (p, v) => p.reduce((sum, x, i) => sum + x * v[i], 0);
/** @param {number[]} p @param {number[]} v */
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (/** @type {number[]} */ v) => v.map((x) => x / Math.hypot(...v));
/** Turned about a unit vector. @param {number[]} v @param {number[]} k @param {number} t */
const turned = (v, k, t) =>
  plus(
    plus(
      v.map((x) => x * Math.cos(t)),
      cross(k, v),
      Math.sin(t),
    ),
    k,
    dot(k, v) * (1 - Math.cos(t)),
  );
/** @param {Rows} T @param {0 | 2 | 3} i  x, z or the origin */
const column = (T, i) => [0, 1, 2].map((row) => T[row][i]);

/**
 * What a book says of one number of a row, from the two frames alone.
 * @param {'standard' | 'modified'} convention
 * @param {Rows} T0
 * @param {Rows} T1
 * @param {Field} field
 */
function byTheBook(convention, T0, T1, field) {
  const isFirst = convention === 'standard'; // z turns and slides first, at the old frame
  const [x0, z0, O0, x1, z1, O1] = [T0, T1].flatMap((T) => /** @type {const} */ ([0, 2, 3]).map((i) => column(T, i)));
  const [z, x] = isFirst ? [z0, x1] : [z1, x0];
  const corner = isFirst ? plus(O0, z, dot(minus(O1, O0), z)) : plus(O0, x, dot(minus(O1, O0), x));
  const [fromZ, toZ] = isFirst ? [O0, corner] : [corner, O1];
  const [fromX, toX] = isFirst ? [corner, O1] : [O0, corner];
  return {
    theta: { axis: z, from: x0, to: x1, at: fromZ },
    alpha: { axis: x, from: z0, to: z1, at: isFirst ? O1 : O0 },
    d: { axis: z, from: fromZ, to: toZ, at: fromZ },
    a: { axis: x, from: fromX, to: toX, at: fromX },
  }[field];
}

/** The axes that must be named, by frame. @param {'standard' | 'modified'} convention @param {number} i @param {Field} field */
function namesByTheBook(convention, i, field) {
  const own = convention === 'standard' ? { z: i, x: i + 1 } : { z: i + 1, x: i };
  return field === 'theta' || field === 'd' ? [`z${own.z}`, `x${i}`, `x${i + 1}`] : [`x${own.x}`, `z${i}`, `z${i + 1}`];
}

/** A drawing of one number, seen from somewhere, as its parts. @param {Parameters<typeof drawAll>} given */
const draw = (...given) => drawAll(...given).look();

/**
 * @param {ReturnType<typeof createChain>} chain
 * @param {number[]} q
 * @param {{ joint: number, field: Field, share: number }} wanted
 */
function drawAll(chain, q, wanted) {
  const scene = new Scene();
  const labels = fakeLabels();
  const frames = new Float64Array(16 * (chain.dof + 1));
  linkFrames(chain, q, frames);
  const marks = createDimensionMarks({ scene, labels, skin, linkGroup: () => new Group(), text: () => ['words'] });
  const size = Math.max(...Array.from(frames).map(Math.abs));
  const arm = /** @type {Parameters<typeof marks.show>[0]} */ (
    /** @type {unknown} */ ({ chain, parts: { size }, posture: Float64Array.from(q), frames })
  );
  marks.show(arm);
  marks.want(wanted);
  const camera = new PerspectiveCamera(24, 1.5, 0.01 * size, 60 * size);
  camera.up.set(0, 0, 1);
  camera.position.set(3 * size, -5 * size, 2 * size);
  camera.lookAt(0, 0, 0);
  const eye = eyeOf(camera, 600, 400);
  const look = () => {
    marks.face?.(eye);
    /** @type {Mesh[]} */
    const meshes = [];
    scene.traverse((object) => void (object instanceof Mesh && meshes.push(object)));
    const one = (/** @type {typeof ConeGeometry | typeof SphereGeometry} */ Shape) => {
      const [mesh] = meshes.filter(({ geometry }) => geometry instanceof Shape);
      const { elements } = mesh.matrix;
      return { visible: mesh.visible, at: elements.slice(12, 15), way: unit(elements.slice(8, 11)) };
    };
    const named = labels.all.filter(({ className, visible }) => className.startsWith('axis') && visible);
    return {
      head: one(ConeGeometry),
      start: one(SphereGeometry),
      words: labels.all.filter(({ className }) => className === 'dim')[0].at.toArray(),
      axes: named.map(({ text, at, from }) => ({ text, way: unit(minus(at.toArray(), from?.toArray() ?? [])) })),
      perPixel: (/** @type {number[]} */ point) => eye.perPixel(new Vector3(...point)),
    };
  };
  return { look, marks, labels, size };
}

/** @param {ReturnType<typeof createChain>} chain @param {number[]} q @param {number} joint @param {Field} field */
function judge(chain, q, joint, field) {
  const { convention } = chain;
  const hand = framesByHand(convention, chain.joints, q);
  const said = byTheBook(convention, hand[joint], hand[joint + 1], field);
  const row = chain.joints[joint];
  const isVariable = field === (row.type === 'prismatic' ? 'd' : 'theta');
  const value = row[field] + (isVariable ? q[joint] : 0);
  const drawing = draw(chain, q, { joint, field, share: 1 });
  const size = Math.max(...hand.flat(2).map(Math.abs));
  const near = (/** @type {number[]} */ got, /** @type {number[]} */ due, within = 1e-9 * size) =>
    expect(Math.max(...minus(got, due).map(Math.abs)), `${field} of ${joint}, ${value}`).toBeLessThan(within);

  if (field === 'd' || field === 'a') {
    expect(dot(minus(said.to, said.from), said.axis)).toBeCloseTo(value, 9); // of the oracle itself
    const isZero = Math.abs(value) < 1e-9;
    expect(drawing.head.visible).toBe(!isZero);
    if (isZero) near(drawing.start.at, said.from);
    else {
      near(minus(drawing.head.at, drawing.start.at), minus(said.to, said.from));
      const aside = minus(drawing.start.at, said.from);
      expect(Math.abs(dot(aside, said.axis))).toBeLessThan(1e-9 * size);
      const pixels = Math.hypot(...aside) / drawing.perPixel(plus(said.from, minus(said.to, said.from), 0.5));
      expect(pixels).toBeGreaterThan(43.9);
      expect(pixels).toBeLessThan(104.1);
      // on the side that is away from the arm
      const middle = hand.reduce((sum, T) => plus(sum, column(T, 3), 1 / hand.length), [0, 0, 0]);
      const outside = minus(plus(said.from, minus(said.to, said.from), 0.5), middle);
      expect(dot(aside, outside)).toBeGreaterThan(-1e-9 * size * size);
      if (Math.abs(value) > 1e-4 * size)
        near(
          drawing.head.way,
          said.axis.map((x) => x * Math.sign(value)),
          1e-6,
        );
    }
  } else {
    const isZero = Math.abs(value) < 1e-9;
    expect(drawing.head.visible).toBe(!isZero);
    const arm = minus(drawing.start.at, said.at);
    near(unit(arm), said.from, 1e-6);
    if (!isZero) {
      const tip = minus(drawing.head.at, said.at);
      near(unit(tip), said.to, 1e-6);
      near(unit(minus(drawing.words, said.at)), turned(said.from, said.axis, value / 2), 1e-6);
      if (Math.abs(value) > 1e-3)
        expect(Math.sign(dot(drawing.head.way, cross(said.axis, tip)))).toBe(Math.sign(value));
    }
  }
  return { drawing, value, hand };
}

test('a dimension lies between the axes of the definition, with its sign, on the outer side, in either convention', () =>
  fc.assert(
    fc.property(anyChain, ({ chain, q }) => {
      for (let joint = 0; joint < chain.dof; joint++) for (const field of FIELDS) judge(chain, q, joint, field);
    }),
    { seed: SEED, numRuns: runs(40) },
  ));

describe.each(['standard', 'modified'])('in %s DH', (name) => {
  const convention = /** @type {'standard' | 'modified'} */ (name);
  /** @param {Partial<JointRow>} row */
  const chainOf = (row) => {
    const bend = /** @type {const} */ ({ type: 'revolute', a: 0.3, alpha: 0.7, d: 0.2, theta: 0.4 });
    return createChain({ convention, joints: [bend, { ...bend, ...row }, bend] });
  };

  test.each(FIELDS)('%s is drawn for a number above, at and below nothing', (field) => {
    for (const value of [0.5, -0.5, 0, -2.5]) judge(chainOf({ [field]: value }), [0.3, 0, 0.2], 1, field);
    if (field !== 'd') return;
    for (const q of [0.5, -0.5, 0.2]) judge(chainOf({ type: 'prismatic', d: -0.2 }), [0.3, q, 0.2], 1, field);
  });

  test('the joint turns farther than once, either way', () => {
    for (const q of [5, -5, 8, -8, 18, -18]) judge(chainOf({}), [0, q, 0], 1, 'theta');
  });

  test.each(FIELDS)('the axes of %s have the names and ways of the definition', (field) => {
    const { drawing, hand } = judge(chainOf({}), [0.3, 0.5, 0.2], 1, field);
    expect(drawing.axes.map(({ text }) => text).sort()).toEqual(namesByTheBook(convention, 1, field).sort());
    for (const { text, way } of drawing.axes) {
      const axis = column(hand[Number(text[1])], text[0] === 'x' ? 0 : 2);
      expect(dot(way, axis), text).toBeCloseTo(1, 9);
    }
  });

  test.each(FIELDS)('%s that is nothing names no axis twice in one place', (field) => {
    const row = field === 'd' || field === 'theta' ? { d: 0, theta: -0.5 } : { a: 0, alpha: 0 };
    const { drawing } = judge(chainOf(row), [0.3, 0.5, 0.2], 1, field);
    const [axis, from] = namesByTheBook(convention, 1, field);
    expect(drawing.axes.map(({ text }) => text)).toEqual([axis, from]);
  });

  test('a part of it, while the row is built up, has its start where it always is and the new axis no name', () => {
    const chain = chainOf({ d: -0.6, theta: -1.2 });
    const hand = framesByHand(convention, chain.joints, [0.3, 0, 0.2]);
    for (const share of [0.25, 0.75]) {
      const long = draw(chain, [0.3, 0, 0.2], { joint: 1, field: 'd', share });
      const { axis } = byTheBook(convention, hand[1], hand[2], 'd');
      const span = minus(long.head.at, long.start.at);
      expect(dot(span, axis)).toBeCloseTo(-0.6 * share, 9);
      expect(Math.hypot(...span)).toBeCloseTo(0.6 * share, 9);
      const turn = byTheBook(convention, hand[1], hand[2], 'theta');
      const bent = draw(chain, [0.3, 0, 0.2], { joint: 1, field: 'theta', share });
      const due = turned(turn.from, turn.axis, -1.2 * share);
      expect(dot(unit(minus(bent.head.at, turn.at)), due)).toBeCloseTo(1, 9);
      expect(bent.axes).toHaveLength(2);
    }
  });
});

test('a dimension of a row that the next arm does not have is put away, with its words', () => {
  const bend = /** @type {const} */ ({ type: 'revolute', a: 0.3, alpha: 0.7, d: 0.2, theta: 0.4 });
  const chain = createChain({ convention: 'standard', joints: [bend, bend, bend] });
  const { marks, labels } = drawAll(chain, [0, 0, 0], { joint: 2, field: 'd', share: 1 });
  expect(labels.texts('dim')).toEqual(['words']);
  const next = createChain({ convention: 'standard', joints: [bend, bend] });
  const arm = { chain: next, parts: { size: 1 }, posture: new Float64Array(2), frames: linkFrames(next, [0, 0]) };
  marks.show(/** @type {Parameters<typeof marks.show>[0]} */ (/** @type {unknown} */ (arm)));
  expect(labels.all).toEqual([]);
  expect(() => marks.follow()).not.toThrow();
});
