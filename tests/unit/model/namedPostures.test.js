/** Postures with a name: where they come from, and for which arm they hold. */
import { describe, expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { applyCommand } from '../../../src/model/commands.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { PUBLISHED_POSTURES } from '../../../src/model/library/postures.js';
import { namedPostures } from '../../../src/model/namedPostures.js';

const names = (/** @type {import('../../../src/model/document.js').RobotDoc} */ robot) =>
  namedPostures(robot).map(({ name }) => name);

test('every arm has home and zero, and the middle of its limits', () => {
  for (const robot of Object.values(LIBRARY)) {
    const [home, zero, middle] = namedPostures(robot);
    expect([home.name, zero.name, middle.name]).toEqual(['home', 'zero', 'middle']);
    expect([home.outside, middle.outside]).toEqual([[], []]);
    expect(zero.q.every((value) => value === 0)).toBe(true);
    expect([home, zero, middle].map(({ source }) => source)).toEqual([null, null, null]);
  }
});

test('every published posture belongs to an arm of the library, has a value for each joint and says where it is from', () => {
  for (const [id, postures] of Object.entries(PUBLISHED_POSTURES)) {
    for (const { q, source, note } of postures) {
      expect(q).toHaveLength(LIBRARY[id].joints.length);
      expect(source).toMatch(/^q\w+ of \w+ in Robotics Toolbox/);
      expect(note.length).toBeGreaterThan(5);
    }
  }
});

describe('published postures', () => {
  test('say which joints are past their limits there', () => {
    const ready = namedPostures(LIBRARY.abb_irb140).find(({ name }) => name === 'ready');
    expect(ready?.outside).toEqual([2]);
    expect(namedPostures(LIBRARY.puma560).every(({ outside }) => outside.length === 0)).toBe(true);
  });

  test('put the tool where their name says', () => {
    const at = (/** @type {string} */ id, /** @type {string} */ name) => {
      const robot = LIBRARY[id];
      const q = namedPostures(robot).find((posture) => posture.name === name)?.q ?? [];
      return [...tcpPose(compileRobot(robot), compilePosture(robot, q))].slice(12, 15);
    };
    // stretched: upper arm and forearm level, one after the other, the elbow's offset between them hanging down
    const [x, y, z] = at('puma560', 'stretched');
    expect([x, y]).toEqual([expect.closeTo(2 * 0.4318, 9), expect.closeTo(-0.15005, 9)]);
    expect(z).toBeCloseTo(0.67183 - 0.0203, 9);
    expect(at('planar2r', 'q1')).toEqual([expect.closeTo(1, 9), expect.closeTo(1, 9), 0]);
  });

  test('hold in other units, in the other convention, with another tool and name; not for another table', () => {
    let doc = newDocument(LIBRARY.puma560);
    const published = ['ready', 'stretched', 'nominal'];
    doc = applyCommand(doc, { type: 'convert-units', units: { length: 'm', angle: 'rad' } });
    doc = applyCommand(doc, { type: 'convert-convention', convention: 'modified' });
    doc = applyCommand(doc, { type: 'rename-robot', name: 'Mine' });
    doc = applyCommand(doc, { type: 'set-tool', pose: { xyz: [0, 0, 0.1], rpy: [0, 0, 0] } });
    expect(names(doc.robot).slice(3)).toEqual(published);
    expect(namedPostures(doc.robot)[3].q).toEqual([0, Math.PI / 2, -Math.PI / 2, 0, 0, 0]);
    doc = applyCommand(doc, { type: 'set-joint-field', joint: 1, field: 'a', value: 0.5 });
    expect(names(doc.robot)).toEqual(['home', 'zero', 'middle']);
  });

  test('of a joint without limits there is no middle', () => {
    const doc = applyCommand(newDocument(LIBRARY.planar2r), {
      type: 'set-joint-type',
      joint: 0,
      jointType: 'continuous',
    });
    expect(names(doc.robot)).toEqual(['home', 'zero', 'q1', 'q2']);
  });
});
