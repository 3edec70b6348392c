/** What a singularity takes, where a book says what that is. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { lostDirectionAt } from '../../../src/model/aim/lostDirection.js';
import { nearestShown } from '../../../src/model/aim/nearestShown.js';
import { lostWanted } from '../../../src/model/aim/lostShown.js';
import { lostInWords } from '../../../src/ui/view/lostWords.js';

/** Two links of 1 m in a plane: stretched, it cannot move along itself. */
const planar = createChain({
  convention: 'standard',
  joints: [0, 1].map(() => ({ type: 'revolute', theta: 0, d: 0, a: 1, alpha: 0 })),
});

describe('a planar arm of two links', () => {
  test.each([0, 0.6, 2])('that is stretched towards %d cannot move that way', (q1) => {
    const lost = lostDirectionAt(planar, [q1, 0], false);
    const along = lost?.along ?? [];
    expect(Math.abs(along[0] * Math.cos(q1) + along[1] * Math.sin(q1))).toBeCloseTo(1, 9);
    expect(along[2]).toBeCloseTo(0, 12);
    expect(lost?.about).toBeNull();
  });

  test('that is bent has lost nothing, unless a singularity is said to stop it', () => {
    expect(lostDirectionAt(planar, [0.3, 1.5], false)).toBeNull();
    expect(lostDirectionAt(planar, [0.3, 1.5], true)).not.toBeNull();
  });
});

test('a spherical wrist with its outer axes in line cannot turn about the axis square to both', () => {
  const quarter = Math.PI / 2;
  const joint = { type: /** @type {const} */ ('revolute'), theta: 0, d: 0, a: 0 };
  const wrist = createChain({
    convention: 'standard',
    joints: [
      { ...joint, alpha: -quarter },
      { ...joint, alpha: quarter },
      { ...joint, alpha: 0 },
    ],
  });
  // axes z, y, z at zero: x is missing
  expect(lostDirectionAt(wrist, [0, 0, 0], false)).toEqual({
    along: null,
    about: [1, 0, 0].map((v) => expect.closeTo(v, 9)),
  });
  expect(lostDirectionAt(wrist, [0, 1, 0], false)).toBeNull();
});

test('in words, without what is nothing', () => {
  expect(lostInWords({ along: [0.6, 0, -0.8], about: null })).toBe(
    'Lost here: moving along X 0.60, Z −0.80 of the world.',
  );
  expect(lostInWords({ along: null, about: [0, 1, 1e-9] })).toBe('Lost here: turning about Y 1.00 of the world.');
  expect(lostInWords({ along: [1, 0, 0], about: [0, 1, 0] })).toContain('and, with it, turning about Y 1.00');
});

test('it is looked for where a singularity is in the way, and at the nearest posture of a target that is not met', () => {
  const posture = [1, 2];
  const state = (/** @type {object} */ session) =>
    /** @type {Parameters<typeof lostWanted>[0]} */ (
      /** @type {unknown} */ ({
        doc: { posture },
        session: { drag: null, jogEnd: null, answer: null, target: null, ...session },
      })
    );
  const answer = { isMet: false, posture };
  expect(lostWanted(state({}))).toBeNull();
  expect(lostWanted(state({ drag: { hindrance: { kind: 'singularity' } } }))).toBe('stopped');
  expect(lostWanted(state({ drag: { hindrance: { kind: 'reach' } } }))).toBe('near');
  expect(lostWanted(state({ target: [0], answer }))).toBe('near');
  expect(lostWanted(state({ target: [0], answer: { ...answer, isMet: true } }))).toBeNull();
  expect(lostWanted(state({ target: [0], answer: { ...answer, posture: [1, 3] } }))).toBeNull();
  expect(lostWanted(state({ target: null, answer }))).toBeNull();
  expect(lostWanted(state({ jogEnd: { why: 'singularity', posture } }))).toBe('stopped');
  expect(lostWanted(state({ jogEnd: { why: 'reach', posture } }))).toBe('near');
  expect(lostWanted(state({ jogEnd: { why: 'limit', joint: 1, posture } }))).toBeNull();
  expect(lostWanted(state({ jogEnd: { why: 'singularity', posture: [1, 3] } }))).toBeNull();
});

test('the nearest posture of a target that is not met is shown until the arm is there, or has something else to do', () => {
  const state = (/** @type {object} */ session) =>
    /** @type {Parameters<typeof nearestShown>[0]} */ (
      /** @type {unknown} */ ({
        doc: { posture: [1, 2] },
        session: { drag: null, answer: null, target: [0], ...session },
      })
    );
  const answer = { isMet: false, posture: [1, 3] };
  expect(nearestShown(state({ answer }))).toEqual([1, 3]);
  for (const other of [
    {},
    { answer: { ...answer, isMet: true } },
    { answer: { ...answer, posture: [1, 2] } },
    { answer, drag: { hindrance: null } },
    { answer, target: null },
  ])
    expect(nearestShown(state(other))).toBeNull();
});
