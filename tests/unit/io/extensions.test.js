import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { runs, SEED } from '../../helpers/property.js';
import { robotFile, rootWith } from './files.js';
import { schemaErrors } from './xmllint.js';

/** @param {string} extensions @param {string} [declarations] on the root */
function open(extensions, declarations = '') {
  const { doc, issues } = readRobotXml(
    robotFile({ root: `${rootWith('', '')} ${declarations}`, after: `<extensions>${extensions}</extensions>` }),
  );
  if (!doc) throw new Error(issues.map(({ message }) => message).join('\n'));
  return doc;
}

test('what another program put there is kept, but for its comments', () => {
  const element = '<x:a xmlns:x="urn:x" b="1" x:c="&quot;&lt;&#10;">text &amp; <x:d/>more<?go on?></x:a>';
  expect(open(`\n  ${element}\n  <!-- 1 -->${element}`).extensions).toEqual([element, element]);
  expect(open('<a xmlns="urn:x"><!-- b --><![CDATA[<&]]></a>').extensions).toEqual(['<a xmlns="urn:x">&lt;&amp;</a>']);
});

test('namespaces that were declared further out go with it', () => {
  expect(open('<x:a y:b="1"/>', 'xmlns:x="urn:x" xmlns:y="urn:y" xmlns:z="urn:z"').extensions).toEqual([
    '<x:a xmlns:x="urn:x" xmlns:y="urn:y" y:b="1"/>',
  ]);
});

test('so do those that are used in a value only', () => {
  const declarations = 'xmlns:x="urn:x" xmlns:unit="urn:unit"';
  expect(open('<x:a b="unit:mm"/>', declarations).extensions).toEqual([
    '<x:a xmlns:unit="urn:unit" xmlns:x="urn:x" b="unit:mm"/>',
  ]);
  expect(open('<x:a>unit:mm</x:a>', declarations).extensions).toEqual([
    '<x:a xmlns:unit="urn:unit" xmlns:x="urn:x">unit:mm</x:a>',
  ]);
});

test('an element without a prefix stays in the namespace it was in', () => {
  expect(open('<x:a xmlns:x="urn:x"><b/></x:a>').extensions).toEqual([
    '<x:a xmlns="urn:denavit:robot-model:1" xmlns:x="urn:x"><b/></x:a>',
  ]);
  const text = robotFile({ after: '<extensions><x:a xmlns:x="urn:x"><b xmlns=""/></x:a></extensions>' });
  expect(readRobotXml(text).doc?.extensions).toEqual(['<x:a xmlns:x="urn:x"><b xmlns=""/></x:a>']);
});

test('an element of no namespace stays in none when ours becomes the default one', () => {
  const text = robotFile({ after: '<extensions>EXTENSION</extensions>' })
    .replace('xmlns=', 'xmlns:rm=')
    .replace(/<(\/?)(?=[a-z])/gi, '<$1rm:')
    .replace('EXTENSION', '<x:a xmlns:x="urn:x"><b/></x:a>');
  expect(readRobotXml(text).doc?.extensions).toEqual(['<x:a xmlns="" xmlns:x="urn:x"><b/></x:a>']);
});

test('kept text is valid, and stays the same from the first save on', async () => {
  const name = fc.constantFrom('a', 'x:b', 'y:c', 'z:d');
  const value = fc.string({
    unit: fc.constantFrom('x:', '&amp;', '&lt;', '&#13;', '&#9;', 'é😀', ' ', '\n', ']]&gt;'),
    maxLength: 8,
  });
  const declaration = fc.constantFrom('', ' xmlns="urn:other"', ' xmlns:x="urn:x2"', ' xmlns:w="urn:w" w:v="1"');
  /** @param {fc.Arbitrary<string>} inner @returns {fc.Arbitrary<string>} */
  const around = (inner) =>
    fc
      .tuple(name, declaration, value, fc.array(inner, { maxLength: 3 }))
      .map(([tag, declared, content, inside]) => `<${tag}${declared} v="${content}">${inside.join('')}</${tag}>`);
  const element = around(fc.oneof(value, around(fc.oneof(value, around(value)))));
  const declarations = 'xmlns:x="urn:x" xmlns:y="urn:y" xmlns:z="urn:z"';
  /** @type {string[]} */
  const saved = [];
  fc.assert(
    fc.property(element, (inside) => {
      const doc = open(`<x:outer>${inside}</x:outer>`, declarations);
      const first = writeRobotXml(doc);
      saved.push(first);
      expect(readRobotXml(first).doc).toStrictEqual(doc);
    }),
    { seed: SEED, numRuns: runs(60) },
  );
  expect((await schemaErrors(saved.slice(0, 60))).flat()).toEqual([]);
});
