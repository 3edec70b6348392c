import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { dexterity, forceEllipsoid, velocityEllipsoid } from '../../../src/kinematics/dexterity.js';
import { staticTorques, twistOf } from '../../../src/kinematics/differentials.js';
import { freedomsOf, ownPart, singularValuesOf } from '../../../src/kinematics/measures/homogeneous.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain } from './oracle.js';
import { ALL_ARMS, publishedArm, publishedForward } from './publishedArms.js';

/** @import { JointRow } from '../../../src/kinematics/joint.js' */

/** @param {Partial<JointRow>} row @returns {JointRow} */
const revolute = (row) => ({ type: 'revolute', a: 0, alpha: 0, d: 0, theta: 0, ...row });
/** @param {number[]} lengths */
const planar = (...lengths) => createChain({ convention: 'standard', joints: lengths.map((a) => revolute({ a })) });
/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => Array.from(a).reduce((sum, value, i) => sum + value * b[i], 0);
/** @param {ArrayLike<number>} found @param {number[]} wanted @param {number} tolerance */
function expectNear(found, wanted, tolerance) {
  expect(found.length).toBe(wanted.length);
  wanted.forEach((value, i) => expect(Math.abs(found[i] - value)).toBeLessThan(tolerance));
}

describe('singular values of Jacobians made elsewhere: products of the table and SVD in 60 digits (mpmath), L = 0.5 m', () => {
  test.each([
    {
      name: 'puma560',
      q: [0.1, 0.7, -0.4, 0.3, -0.9, 0.2],
      full: [
        2.272394044879949, 1.630579037973879, 0.8326560558030234, 0.6412835369627906, 0.3964053048712066,
        0.2986282119241361,
      ],
      linear: [0.838673138381466, 0.2262635232058035, 0.1969569058913574],
      angular: [1.7312690378916737, 1.6053708492052583, 0.6522974436249356],
    },
    {
      name: 'stanford',
      q: [0.3, -0.8, 0.5, 0.4, 0.6, -0.2],
      full: [
        1.7177669977031584, 1.4786595524158332, 1.0598335855907728, 0.9901206013302726, 0.5046586643241137,
        0.3011288577996408,
      ],
      linear: [0.5317845558120374, 0.5, 0.3372399983505147],
      angular: [1.6197032096873576, 1.282731789568885, 0.8550793346572454],
    },
    {
      name: 'scara_cobra600',
      q: [0.3, 0.9, 0.1, -0.5],
      full: [1.9953377136207175, 1, 0.6681764786569963, 0.2100445888041624],
      linear: [0.5951032363328816, 0.5, 0.1176431890697954],
      angular: [1.7320508075688772, 0, 0],
    },
    {
      name: 'mitsubishi_rv2aj',
      q: [0.3, 0.4, 0.7, -0.6, 0.2],
      full: [1.846250137183136, 1.4261241328283414, 0.5114689867968982, 0.5050252661560268, 0.07640834997720904],
      linear: [0.3937924390445058, 0.268738051683863, 0.11809782942072836],
      angular: [1.7320508075688772, 1.3702490875349536, 0.3498820345625469],
    },
  ])('$name', ({ name, q, full, linear, angular }) => {
    const chain = createChain(publishedArm(name));
    const J = geometricJacobian(chain, q);
    for (const [part, wanted] of /** @type {const} */ ([
      ['full', full],
      ['linear', linear],
      ['angular', angular],
    ])) {
      expectNear(singularValuesOf(chain, J, { part, lengthScale: 0.5 }).singularValues, wanted, 1e-14);
      const rough = finiteDifferenceJacobian(chain, q, { method: 'central' });
      expectNear(singularValuesOf(chain, rough, { part, lengthScale: 0.5 }).singularValues, wanted, 1e-9);
    }
  });
});

describe('the planar 2R arm, in closed form', () => {
  test('Yoshikawa 1985: manipulability is a1 a2 |sin q2|, and the singular values are the roots of the characteristic equation', () => {
    const length = fc.double({ min: 0.1, max: 2, noNaN: true });
    const angle = fc.double({ min: -3, max: 3, noNaN: true });
    fc.assert(
      fc.property(length, length, angle, angle, (a1, a2, q1, q2) => {
        const found = dexterity(planar(a1, a2), [q1, q2]);
        const w = a1 * a2 * Math.abs(Math.sin(q2));
        expect(found.part).toBe('linear');
        expect(Math.abs(found.manipulability - w)).toBeLessThan(1e-14);
        // trace and determinant of JᵀJ
        const trace = a1 * a1 + 2 * a1 * a2 * Math.cos(q2) + 2 * a2 * a2;
        const larger = Math.sqrt((trace + Math.sqrt(Math.max(0, trace * trace - 4 * w * w))) / 2);
        expect(Math.abs(found.singularValues[0] - larger)).toBeLessThan(1e-7 * larger);
        expect(Math.abs(found.singularValues[1] - w / larger)).toBeLessThan(1e-7 * larger);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('Siciliano et al., section 3.9: it is best at right angles, isotropic where a1 = √2 a2 and cos q2 = −1/√2', () => {
    const best = dexterity(planar(Math.SQRT2 * 0.5, 0.5), [0.3, (3 * Math.PI) / 4]);
    expect(best.isotropy).toBeCloseTo(1, 12);
    expect(best.conditionNumber).toBeCloseTo(1, 12);
    expect(dexterity(planar(1, 1), [0, Math.PI / 2]).manipulability).toBeCloseTo(1, 14);
  });
});

describe('what an arm can do in general', () => {
  test.each([
    [planar(1, 1), { full: 2, linear: 2, angular: 1 }, 'linear'],
    [planar(1, 1, 1), { full: 3, linear: 2, angular: 1 }, 'full'],
    [planar(1, 1, 1, 1), { full: 3, linear: 2, angular: 1 }, 'full'],
    [createChain(publishedArm('scara_cobra600')), { full: 4, linear: 3, angular: 1 }, 'full'],
    [createChain(publishedArm('cart_ppp')), { full: 3, linear: 3, angular: 0 }, 'linear'],
    [createChain(publishedArm('polar_rrp')), { full: 3, linear: 3, angular: 2 }, 'linear'],
    [createChain(publishedArm('kuka_youbot')), { full: 5, linear: 3, angular: 3 }, 'full'],
    [createChain(publishedArm('puma560')), { full: 6, linear: 3, angular: 3 }, 'full'],
  ])('arm %#', (chain, freedoms, part) => {
    expect(freedomsOf(chain)).toEqual(freedoms);
    expect(ownPart(chain)).toBe(part);
  });
  test('joints to spare do not make a planar arm singular', () => {
    const found = dexterity(planar(1, 1, 1, 1), [0.1, 0.5, 0.6, -0.9]);
    expect(found.rank).toBe(3);
    expect(found.singularValues[3]).toBeLessThan(1e-14);
    expect(found.conditionNumber).toBeLessThan(100);
    expect(found.manipulability).toBeGreaterThan(0.1);
  });
});

describe('units', () => {
  test.each(ALL_ARMS)('%s: the same numbers at any scale', (name) => {
    const [q] = publishedForward(name).q;
    const { joints } = publishedArm(name);
    const wanted = dexterity(createChain(publishedArm(name)), q);
    for (const scale of [1e-3, 1 / 3, 25.4, 1e3]) {
      const chain = createChain(publishedArm(name, scale));
      const scaled = q.map((value, i) => (joints[i].type === 'prismatic' ? value * scale : value));
      const found = dexterity(chain, scaled);
      const unit = found.part === 'linear' ? scale : 1;
      found.singularValues.forEach((value, i) =>
        expect(Math.abs(value / unit - wanted.singularValues[i])).toBeLessThan(1e-12 * wanted.singularValues[0]),
      );
      expect(found.rank).toBe(wanted.rank);
      expect(Math.abs(found.conditionNumber / wanted.conditionNumber - 1)).toBeLessThan(1e-9);
    }
  });
});

describe('any arm', () => {
  test('has no measure that is not a number, and they agree with each other', () => {
    fc.assert(
      fc.property(anyChain, fc.constantFrom('full', 'linear', 'angular'), ({ description, q }, part) => {
        const chain = createChain(description);
        const found = dexterity(chain, q, { part });
        const { singularValues, manipulability, conditionNumber, isotropy, rank, freedoms } = found;
        expect([...singularValues, manipulability, isotropy].every(Number.isFinite)).toBe(true);
        expect(conditionNumber).toBeGreaterThanOrEqual(1);
        expect(isotropy >= 0 && isotropy <= 1).toBe(true);
        expect(Number.isFinite(conditionNumber)).toBe(freedoms > 0 && rank >= freedoms);
        // √det(J Jᵀ) = Π σ: by the trace of J Jᵀ, which is Σ σ²
        const J = geometricJacobian(chain, q);
        const rows = { full: [0, 6], linear: [0, 3], angular: [3, 6] }[part];
        let square = 0;
        description.joints.forEach(({ type }, k) => {
          for (let i = rows[0]; i < rows[1]; i++) {
            const L = chain.characteristicLength;
            const value = J[6 * k + i] * (type === 'prismatic' ? L : 1);
            square += (part === 'full' && i < 3 ? value / L : value) ** 2;
          }
        });
        expect(Math.abs(dot(singularValues, singularValues) - square)).toBeLessThan(1e-12 * (1 + square));
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
});

describe('ellipsoids', () => {
  const arms = ['puma560', 'stanford', 'scara_cobra600', 'planar2r', 'polar_rrp', 'cart_ppp', 'kuka_youbot'];
  test.each(arms)(
    '%s: no velocity of unit joint rates leaves the body, and the ends of its axes are reached',
    (name) => {
      const chain = createChain(publishedArm(name));
      const { lengthScale: L } = dexterity(chain, new Float64Array(chain.dof));
      for (const q of publishedForward(name).q.slice(0, 3)) {
        for (const part of /** @type {const} */ (['linear', 'angular'])) {
          const { axes, halfLengths, rank, isDegenerate, center } = velocityEllipsoid(chain, q, { part });
          const columns = [0, 3, 6].map((at) => axes.subarray(at, at + 3));
          columns.forEach((a, i) => columns.forEach((b, j) => expect(dot(a, b)).toBeCloseTo(Number(i === j), 13)));
          const [x, y, z] = columns;
          expect(dot([x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]], z)).toBeCloseTo(
            1,
          );
          expect(isDegenerate).toBe(rank < 3);
          expect(Array.from(halfLengths, (half) => half > 0)).toEqual([rank > 0, rank > 1, rank > 2]);
          expect(center.length).toBe(3);
          columns.forEach((axis, i) => {
            // the joint rates that reach furthest along an axis are along the gradient Jᵀ a
            const wrench = part === 'linear' ? [...axis, 0, 0, 0] : [0, 0, 0, ...axis];
            const pull = staticTorques(chain, q, wrench).map(
              (value, k) => value * (chain.joints[k].type === 'revolute' ? 1 : L),
            );
            const size = Math.hypot(...pull);
            expect(Math.abs(size - halfLengths[i])).toBeLessThan(1e-12);
            if (halfLengths[i] === 0) return;
            const rates = pull.map((value, k) => (value / size) * (chain.joints[k].type === 'revolute' ? 1 : L));
            const twist = twistOf(chain, q, rates)
              .subarray(part === 'linear' ? 0 : 3)
              .subarray(0, 3);
            expectNear(
              twist,
              Array.from(axis, (value) => value * halfLengths[i]),
              1e-12,
            );
          });
        }
      }
    },
  );
  test('a force at the end of an axis takes joint torques of norm 1', () => {
    const chain = createChain(publishedArm('puma560'));
    const [q] = publishedForward('puma560').q;
    const { axes, halfLengths } = forceEllipsoid(chain, q);
    halfLengths.forEach((half, i) => {
      const force = Array.from(axes.subarray(3 * i, 3 * i + 3), (value) => value * half);
      expect(Math.hypot(...staticTorques(chain, q, [...force, 0, 0, 0]))).toBeCloseTo(1, 12);
    });
  });
  test('a planar arm stretched out moves along a line, and holds without end across it', () => {
    const chain = planar(1, 0.5);
    const velocity = velocityEllipsoid(chain, [Math.PI / 2, 0]);
    expect(velocity.rank).toBe(1);
    expect(velocity.isDegenerate).toBe(true);
    expect(velocity.halfLengths[0]).toBeCloseTo(Math.hypot(1.5, 0.5), 12);
    expect(Math.abs(velocity.axes[0])).toBeCloseTo(1, 12);
    expect(Array.from(velocity.halfLengths.subarray(1))).toEqual([0, 0]);
    expect(Array.from(forceEllipsoid(chain, [Math.PI / 2, 0]).halfLengths.subarray(1))).toEqual([Infinity, Infinity]);
  });
});

test('wrong calls are refused', () => {
  const chain = planar(1, 1);
  const sideways = /** @type {'linear'} */ (/** @type {unknown} */ ('sideways'));
  expect(() => dexterity(chain, [1])).toThrow('Expected 2 joint values, got 1.');
  expect(() => dexterity(chain, [1, NaN])).toThrow('Expected joint value 2');
  expect(() => dexterity(chain, [1, 2], { part: sideways })).toThrow("got 'sideways'");
  expect(() => velocityEllipsoid(chain, [1, 2], { part: sideways })).toThrow("'linear' or 'angular', got 'sideways'");
  for (const lengthScale of [0, -1, NaN, Infinity]) {
    expect(() => dexterity(chain, [1, 2], { lengthScale })).toThrow(`length scale in metres, got ${lengthScale}`);
  }
  expect(() => singularValuesOf(chain, new Float64Array(6))).toThrow('Expected room for 12 numbers, got 6.');
  expect(() => singularValuesOf(chain, new Float64Array(12).fill(NaN))).toThrow('finite numbers, got NaN');
});
