import fc from 'fast-check';
import { expect, test } from 'vitest';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { stepName } from '../../../src/ui/stepName.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyAction, anyDocument } from '../model/arbitrary.js';

/** @typedef {import('../../../src/model/session.js').Action} Action */

const START = startState(newDocument(LIBRARY.puma560));
const pose = { xyz: [1, 2, 3], rpy: [0, 0, 0] };
const GO = /** @type {Action} */ ({ type: 'set-joint-value', joint: 4, value: 7 });

/** What undo says after these, the last of which is to be undone. @type {[string, Action[]][]} */
const SESSIONS = [
  ['link length a of joint 2', [{ type: 'set-joint-field', joint: 1, field: 'a', value: 500 }]],
  ['link twist α of joint 1', [{ type: 'set-joint-field', joint: 0, field: 'alpha', value: 90, text: 'pi/2 rad' }]],
  ['upper limit of joint 3', [{ type: 'set-joint-field', joint: 2, field: 'upper', value: undefined }]],
  ['rate limit of joint 6', [{ type: 'set-joint-rate', joint: 5, rate: 'velocity', value: 90 }]],
  ['how link 2 is drawn', [{ type: 'set-link', joint: 1, link: { kind: 'box' } }]],
  ['type of joint 3', [{ type: 'set-joint-type', joint: 2, jointType: 'prismatic' }]],
  ['joint 5 moved', [GO]],
  ['arm moved', [GO, { type: 'set-posture', posture: [1, 2, 3, 4, 5, 6] }]],
  ['joint 5 moved', [{ ...GO, gesture: 'a' }, { ...GO, value: 9, gesture: 'a' }, { type: 'end-gesture' }]],
  ['joint 2 removed', [{ type: 'remove-joint', joint: 1 }]],
  ['joint 6 removed', [{ type: 'remove-joint', joint: 5 }]],
  [
    'joint 4 added',
    [
      { type: 'remove-joint', joint: 1 },
      { type: 'duplicate-joint', joint: 2 },
    ],
  ],
  [
    'joint 1 added',
    [
      { type: 'remove-joint', joint: 1 },
      { type: 'add-joint', after: -1 },
    ],
  ],
  ['order of the joints', [{ type: 'move-joint', joint: 0, to: 3 }]],
  [
    'table changed',
    [{ type: 'set-table', convention: 'standard', rows: [{ numbers: { a: 1 } }, { numbers: { a: 2 } }] }],
  ],
  ['units m and rad', [{ type: 'convert-units', units: { length: 'm', angle: 'rad' } }]],
  ['modified DH', [{ type: 'convert-convention', convention: 'modified' }]],
  ['modified DH', [{ type: 'reinterpret-convention', convention: 'modified' }]],
  ['base', [{ type: 'set-base', pose }]],
  ['tool', [{ type: 'set-tool', pose }]],
  ['name Bob', [{ type: 'rename-robot', name: 'Bob' }]],
  ['name Robot without a name', [{ type: 'rename-robot', name: '' }]],
  ['facts about the robot', [{ type: 'set-robot-info', field: 'author', text: 'A' }]],
  ['UR5 opened', [{ type: 'replace-document', doc: newDocument(LIBRARY.ur5) }]],
  ['posture p1 added', [{ type: 'record-posture' }]],
  ['how code is written', [{ type: 'set-code-options', text: 'format=krl' }]],
  ['posture pick renamed', [{ type: 'record-posture' }, { type: 'rename-posture', index: 0, id: 'pick' }]],
  ['posture p1 removed', [{ type: 'record-posture' }, { type: 'remove-posture', index: 0 }]],
  ['target aim_1 added', [{ type: 'add-target', pose }]],
  [
    'target aim_1 changed',
    [
      { type: 'add-target', pose },
      { type: 'edit-target', index: 0, pose: { ...pose, xyz: [0, 0, 9] } },
    ],
  ],
  [
    'target aim_3 moved in its list',
    [...Array(3).fill({ type: 'add-target', pose }), { type: 'move-target', index: 2, to: 0 }],
  ],
  [
    'target aim_1 moved in its list',
    [...Array(3).fill({ type: 'add-target', pose }), { type: 'move-target', index: 0, to: 2 }],
  ],
];

test.each(SESSIONS)('undo names the step, and redo the same one: %s', (name, actions) => {
  const end = actions.reduce(reduce, START);
  expect(stepName(end, 'undo')).toBe(name);
  expect(stepName(end, 'redo')).toBe(null);
  expect(stepName(reduce(end, { type: 'undo' }), 'redo')).toBe(name);
});

test('there is a name exactly where there is a step, and none says “undefined”', () => {
  expect(stepName(START, 'undo')).toBe(null);
  fc.assert(
    fc.property(anyDocument, fc.array(anyAction, { maxLength: 20 }), (doc, actions) => {
      let state = startState(doc);
      for (const action of actions) {
        try {
          state = reduce(state, action);
        } catch {
          continue; // refused
        }
        const [undo, redo] = [stepName(state, 'undo'), stepName(state, 'redo')];
        expect([undo !== null, redo !== null]).toEqual([state.past.length > 0, state.future.length > 0]);
        expect(`${undo} ${redo}`).not.toMatch(/undefined|NaN|last change|object/);
      }
    }),
    { seed: SEED, numRuns: runs(150) },
  );
});
