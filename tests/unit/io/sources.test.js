import { expect, test } from 'vitest';
import { createSources } from '../../../src/io/sources.js';
import { readXmlTree } from '../../../src/io/xmlTree.js';

test('a value of a document has the line of its attribute, or else of the closest thing around it', () => {
  const { root } = readXmlTree('<a>\n<b\n c="1"\n d="2"/></a>');
  const inner = root?.children[1];
  if (!root || inner?.kind !== 'element') throw new Error('Expected two elements.');
  const joint = { theta: 1, text: { d: '2' } };
  const doc = { robot: { name: '', joints: [{}, joint] }, posture: [1] };
  const sources = createSources();
  sources.add(doc, root);
  sources.add(joint, inner);
  sources.add(joint, inner, { at: 'theta', attribute: 'c' });
  sources.add(joint, inner, { at: 'text.d', attribute: 'd' });
  sources.follow(doc, 'posture', joint, 'theta');
  const lines = [
    'robot.joints.1.theta',
    'robot.joints.1.text.d',
    'robot.joints.1.lower',
    'robot.joints.1',
    'posture.0',
    'robot.name',
    '',
  ];
  expect(lines.map((path) => sources.lineOf(doc, path))).toEqual([3, 4, 2, 2, 3, 1, 1]);
  expect(sources.lineOf({}, 'robot')).toBeUndefined();
});
