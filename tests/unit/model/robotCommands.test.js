/** Base and tool, links, rates, name and source: each change, and each refusal in words. */
import { describe, expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { applyCommand } from '../../../src/model/commands.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';
import { validateDocument } from '../../../src/model/validate.js';
import { whatChanged } from '../../../src/model/whatChanged.js';

/** @typedef {import('../../../src/model/commands.js').Command} Command */

const doc = newDocument(LIBRARY.puma560);
/** @param {unknown} command */
const reason = (command) => refusal(doc, /** @type {Command} */ (command))?.message ?? null;
const rpy = [0, 0, 0];

describe('a command about the robot', () => {
  /** @type {[Command, (doc: import('../../../src/model/document.js').Doc) => unknown, unknown][]} */
  const changes = [
    [{ type: 'set-base', pose: { xyz: [1, 2, 3], rpy } }, ({ robot }) => robot.base, { xyz: [1, 2, 3], rpy }],
    [
      { type: 'set-tool', pose: { xyz: [0, 0, 160], quaternion: [0, 0, 0.6, 0.8] } },
      ({ robot }) => robot.tool,
      { xyz: [0, 0, 160], quaternion: [0, 0, 0.6, 0.8] },
    ],
    [
      { type: 'set-link', joint: 1, link: { kind: 'box', width: 80, color: '#ffcc00' } },
      ({ robot }) => robot.joints[1].link,
      { kind: 'box', width: 80, color: '#ffcc00' },
    ],
    [{ type: 'set-joint-rate', joint: 2, rate: 'velocity', value: 120 }, ({ robot }) => robot.joints[2].velocity, 120],
    [
      {
        type: 'set-controller',
        joint: 2,
        controller: { sign: -1, offset: 90, coupling: -1, coupledTo: doc.robot.joints[1].id },
      },
      ({ robot }) => robot.joints[2].controller,
      { sign: -1, offset: 90, coupling: -1, coupledTo: doc.robot.joints[1].id },
    ],
    [{ type: 'rename-robot', name: 'My arm' }, ({ robot }) => robot.name, 'My arm'],
    [{ type: 'set-robot-info', field: 'author', text: 'A. N.' }, ({ robot }) => robot.info.author, 'A. N.'],
    [{ type: 'set-robot-info', field: 'source', text: '' }, ({ robot }) => 'source' in robot.info, false],
  ];
  test.each(changes)('%j is carried out, leaves the rest, is saved and opened', (command, read, wanted) => {
    expect(refusal(doc, command)).toBeNull();
    const now = applyCommand(doc, command);
    expect(read(now)).toEqual(wanted);
    expect(now.posture).toBe(doc.posture);
    expect(validateDocument(now)).toEqual([]);
    expect(readRobotXml(writeRobotXml(now)).doc?.robot).toEqual(now.robot);
    expect(applyCommand(now, command)).toBe(now); // twice is once
  });

  test('takes a rate away with undefined, and leaves no empty field behind', () => {
    const limited = applyCommand(doc, { type: 'set-joint-rate', joint: 0, rate: 'velocity', value: 90 });
    const free = applyCommand(limited, { type: 'set-joint-rate', joint: 0, rate: 'velocity', value: undefined });
    expect(free).toEqual(doc);
    expect(Object.keys(free.robot.joints[0])).not.toContain('velocity');
  });
});

test('a new name leaves the target, the open cell and the joints as they are', () => {
  const cell = /** @type {const} */ ({ joint: 1, field: 'a' });
  let state = reduce(startState(doc), { type: 'show', change: { target: [1, 2, 3, 0, 0, 0], cell, openJoint: 1 } });
  state = reduce(state, { type: 'rename-robot', name: 'Other' });
  expect(state.session).toMatchObject({ target: [1, 2, 3, 0, 0, 0], cell, openJoint: 1 });
});

test('the open joint stays open when joints come and go, and is the last one if it went itself', () => {
  let state = reduce(startState(doc), { type: 'show', change: { openJoint: 5 } });
  state = reduce(state, { type: 'remove-joint', joint: 0 });
  expect(state.session.openJoint).toBe(4);
});

describe('is refused with a reason:', () => {
  test.each([
    [{ type: 'set-base', pose: { xyz: [0, 0], rpy } }, 'Expected 3 numbers as position, got 2.'],
    [{ type: 'set-base', pose: null }, 'Expected 3 numbers as position, got undefined.'],
    [
      { type: 'set-tool', pose: { xyz: [0, 0, 2e9], rpy } },
      'A number of the position is a number from −10⁹ to 10⁹; got 2000000000.',
    ],
    [
      { type: 'set-tool', pose: { xyz: [0, 0, 0], rpy: [0, NaN, 0] } },
      'A number of the orientation is a number from −10⁹ to 10⁹; got NaN.',
    ],
    [
      { type: 'set-tool', pose: { xyz: [0, 0, 0], quaternion: [0, 0, 1, 1] } },
      'A quaternion has the length 1; this one has 1.414214.',
    ],
    [
      { type: 'set-tool', pose: { xyz: [0, 0, 0], rpy, quaternion: [0, 0, 0, 1] } },
      'An orientation is given as rpy or as a quaternion, not both.',
    ],
    [{ type: 'set-link', joint: 6, link: { kind: 'auto' } }, 'Expected a joint index from 0 to 5, got 6.'],
    [
      { type: 'set-link', joint: 0, link: { kind: 'ball' } },
      'Expected auto or cylinder or box or none as the kind of a link, got "ball".',
    ],
    [{ type: 'set-link', joint: 0, link: { kind: 'box', width: 0 } }, 'A width is a number above 0, up to 10⁹; got 0.'],
    [
      { type: 'set-link', joint: 0, link: { kind: 'auto', color: 'red' } },
      'A colour is # and six digits from 0 to f, such as #ffcc00; got "red".',
    ],
    [
      { type: 'set-joint-rate', joint: 0, rate: 'velocity', value: -5 },
      'A velocity limit is a number above 0, up to 10⁹; got −5.',
    ],
    [
      { type: 'set-joint-rate', joint: 0, rate: 'speed', value: 5 },
      'Expected velocity or acceleration or jerk or effort as the rate, got "speed".',
    ],
    [{ type: 'rename-robot', name: 'x'.repeat(201) }, 'The name has at most 200 characters; this one has 201.'],
    [
      { type: 'set-robot-info', field: 'price', text: '1' },
      'Expected manufacturer or author or licence or source or description as the field, got "price".',
    ],
  ])('%j', (command, wanted) => expect(reason(command)).toBe(wanted));
});

describe('how a pendant counts a joint', () => {
  const [j1, j2, j3] = doc.robot.joints.map(({ id }) => id);
  const plain = /** @type {const} */ ({ sign: 1, offset: 0, coupling: 0 });
  /** @param {number} joint @param {object} controller */
  const set = (joint, controller) => ({ type: 'set-controller', joint, controller: { ...plain, ...controller } });

  test.each([
    [set(6, {}), 'Expected a joint index from 0 to 5, got 6.'],
    [set(0, { sign: 0 }), 'A sign is 1 or −1; got 0.'],
    [set(0, { offset: NaN }), 'A number on the pendant is a number from −10⁹ to 10⁹; got NaN.'],
    [set(0, { coupling: -1 }), 'A coupling is to a joint.'],
    [set(0, { coupling: -1, coupledTo: 'none' }), 'There is no joint "none".'],
    [set(1, { coupling: -1, coupledTo: j2 }), 'A circle of couplings: J2, J2.'],
  ])('%j is refused: %s', (command, message) => {
    expect(reason(command)).toBe(message);
  });

  test('in a circle is refused, with the circle', () => {
    const one = applyCommand(doc, /** @type {Command} */ (set(2, { coupling: -1, coupledTo: j2 })));
    const two = applyCommand(one, /** @type {Command} */ (set(1, { coupling: 1, coupledTo: j1 })));
    expect(refusal(two, /** @type {Command} */ (set(0, { coupling: 1, coupledTo: j3 })))?.message).toBe(
      'A circle of couplings: J1, J3, J2, J1.',
    );
    expect(whatChanged(doc, one)).toEqual({ what: 'controller', joint: 2 });
  });

  test('between turning and sliding is refused either way and with any factor; of one kind it is not', () => {
    const slide = applyCommand(doc, { type: 'set-joint-type', joint: 2, jointType: 'prismatic' });
    const against = (/** @type {number} */ joint, /** @type {object} */ controller) =>
      refusal(slide, /** @type {Command} */ (set(joint, controller)))?.message ?? null;
    const sentence = 'J2 turns and J3 slides; a coupling adds numbers of one kind.';
    expect(against(2, { coupling: -1, coupledTo: j2 })).toBe(sentence);
    expect(against(1, { coupling: 0, coupledTo: j3 })).toBe(sentence);
    expect(against(1, { coupling: 1, coupledTo: j1 })).toBeNull();
    const two = applyCommand(slide, { type: 'set-joint-type', joint: 1, jointType: 'prismatic' });
    const slides = /** @type {Command} */ (set(2, { coupling: 1, coupledTo: j2 }));
    expect(refusal(two, slides)).toBeNull();
    // a joint that becomes the other kind loses its couplings
    const turned = applyCommand(applyCommand(two, slides), { type: 'set-joint-type', joint: 1, jointType: 'revolute' });
    expect(turned.robot.joints[2].controller).toEqual(plain);
  });
});
