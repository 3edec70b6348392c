import { parseXml } from '@rgrove/parse-xml';
import { beforeEach, expect, test, vi } from 'vitest';
import { readRobotXml } from '../../../src/io/robotXml.js';
import { readXmlTree } from '../../../src/io/xmlTree.js';
import { robotFile } from './files.js';

vi.mock('@rgrove/parse-xml', { spy: true });
beforeEach(() => void vi.clearAllMocks());

/** @param {string} text */
const faults = (text) => readXmlTree(text).issues.map(({ code, message }) => [code, message]);

test('the tree has names, namespaces, attributes, texts and lines', () => {
  const { root } = readXmlTree(
    '<a xmlns="urn:a" xmlns:b="urn:b">\n<b:c d="1&amp;"\n b:e="2">x<![CDATA[<y>]]><!-- z --></b:c>\n<?f g?></a>',
  );
  expect(root).toMatchObject({
    name: 'a',
    namespace: 'urn:a',
    line: 1,
    children: [
      { kind: 'text', text: '\n' },
      {
        name: 'b:c',
        localName: 'c',
        namespace: 'urn:b',
        line: 2,
        attributes: [
          { name: 'd', namespace: '', value: '1&' },
          { name: 'b:e', localName: 'e', namespace: 'urn:b', value: '2' },
        ],
        children: [
          { kind: 'text', text: 'x', isCdata: false },
          { kind: 'text', text: '<y>', isCdata: true },
        ],
      },
      { kind: 'text' },
      { kind: 'instruction', name: 'f', content: 'g' },
    ],
  });
  const [, child] = root?.children ?? [];
  expect(child.kind === 'element' && [child.lineOf('d'), child.lineOf('b:e'), child.lineOf('none')]).toEqual([2, 3, 2]);
});

test('lines are counted in a text with emoji, too', () => {
  expect(faults('<a>😀😀😀\n😀\n<b></a>')[0][1]).toMatch(/^Line 3: /);
  expect(readXmlTree('<a>😀😀😀\n😀\n<b/></a>').root?.children[1]).toMatchObject({ name: 'b', line: 3 });
});

test.for([
  '<!DOCTYPE a><a/>',
  '<!doctype a>\n<a/>',
  '<?xml version="1.0"?><!DocType a [<!ENTITY b "c">]><a/>',
  '<!-- > --><!DOCTYPE a><a/>',
  '<!----><!DOCTYPE a><a/>',
  '<?b ?><!DOCTYPE a><a/>',
  '<!ENTITY b "c"><a/>',
  '\uFEFF<!DOCTYPE a><a/>',
])('a document type is refused before the parser sees it: %s', (text) => {
  expect(faults(text)[0][0]).toBe('doctype');
  expect(parseXml).not.toHaveBeenCalled();
});

test.for([
  '<!-- <!DOCTYPE a> --><a/>',
  '<!-- -> ]]> ?> <!DOCTYPE a> --><a/>',
  '<a><![CDATA[<!DOCTYPE a><!ENTITY b "c">]]></a>',
  '<?a <!DOCTYPE a> ?><a/>',
  '<a b="!DOCTYPE"/>',
])('what only looks like a document type is no reason: %s', (text) => expect(faults(text)).toEqual([]));

test('too much is refused before the parser sees it', () => {
  const start = '<a xmlns="urn:a">';
  expect(faults(`<a>${'x'.repeat(1024 * 1024)}</a>`)).toEqual([
    ['too-large', 'The file has 1048583 characters; expected at most 1048576.'],
  ]);
  expect(faults(`${start}${'<b/>'.repeat(4000)}</a>`)).toEqual([
    ['too-many-elements', 'The file has 4001 elements; expected at most 4000.'],
  ]);
  expect(faults(`${start}\n${'<b>'.repeat(32)}${'</b>'.repeat(32)}</a>`)).toEqual([
    ['too-deep', 'Line 2: elements are nested 33 deep; expected at most 32.'],
  ]);
  expect(faults(`<a>\n<b ${Array.from({ length: 101 }, (_, i) => `c${i}="=>"`).join(' ')}/></a>`)).toEqual([
    ['too-many-attributes', 'Line 2: an element has 101 attributes; expected at most 100.'],
  ]);
  expect(faults('<a>'.repeat(340_000))[0][0]).toBe('too-many-elements');
  expect(parseXml).not.toHaveBeenCalled();
});

test('as much as allowed is read', () => {
  expect(faults(`<a>${'x'.repeat(1024 * 1024 - 7)}</a>`)).toEqual([]);
  expect(faults(`<a>${'<b c=">"/>'.repeat(1999)}</a>`)).toEqual([]);
  expect(faults(`${'<b>'.repeat(32)}<!-- <c> --><![CDATA[<c>]]><?c <c>?>${'</b>'.repeat(32)}`)).toEqual([]);
  expect(faults(`<a b="${'x'.repeat(10_000)}"/>`)).toEqual([]);
  expect(faults(`<a ${Array.from({ length: 100 }, (_, i) => `c${i}="=>"`).join(' ')}/>`)).toEqual([]);
});

test('a long attribute is refused, and counted in characters', () => {
  expect(faults(`<a b="${'😀'.repeat(10_000)}"/>`)).toEqual([]);
  expect(faults(`<a b="${'x'.repeat(10_001)}"/>`)).toEqual([
    ['attribute-length', 'Line 1: the attribute "b" of <a> has 10001 characters; expected at most 10000.'],
  ]);
});

test.for([
  ['<a b></a>', 'an attribute has no value in quotation marks; expected name="value".'],
  ['<a b=1/>', 'an attribute has no value in quotation marks; expected name="value".'],
  ['<a b="1" b="2"/>', 'the attribute "b" is there twice in one element; expected it once.'],
  ['<a xml:space="maybe"/>', 'the attribute xml:space has a wrong value; expected "default" or "preserve".'],
  ['<a b="<"/>', 'a "<" stands in the value of an attribute; expected &lt; there, or a quotation mark before it.'],
  ['<a b="1/>', 'the value of an attribute does not end; expected a quotation mark.'],
  ['<a><![CDATA[b</a>', 'a CDATA section does not end; expected "]]>".'],
  [
    `<a b="${'<c d="1" e="2"/>'.repeat(60)}</a>`,
    'a "<" stands in the value of an attribute; expected &lt; there, or a quotation mark before it.',
  ],
  ['<a>]]></a>', 'the characters "]]>" stand in a text; expected "]]&gt;".'],
  ['<a>b]]></a>', 'the characters "]]>" stand in a text; expected "]]&gt;".'],
  ['<a><!-- -- --></a>', 'the characters "--" stand in a comment; expected "-->" or nothing of the kind.'],
  ['<a><!-- b</a>', 'a comment does not end; expected "-->".'],
  ['<a $/>', 'the tag <a does not end properly; expected more attributes, or ">".'],
  ['<a><b></a>', 'the element <b> is not closed: expected </b>, found "</a>".'],
  ['<a><b>', 'the element <b> is not closed: expected </b>, found the end of the file.'],
  ['<a>1 < 2</a>', 'the element <a> is not closed: expected </a>, found "< 2".'],
  ['<a></a', 'the tag </a does not end properly; expected ">".'],
  ['<a/><?xml version="1.0"?>', 'the XML declaration stands here; expected it at the very start of the file.'],
  ['<a><??></a>', 'a "<?" stands here without a name; expected <?name …?>.'],
  ['<a><?b$?></a>', 'a "<?" with a wrong name stands here; expected <?name …?>.'],
  ['<a><?b c</a>', 'a processing instruction does not end; expected "?>".'],
  ['<a>b & c</a>', 'a "&" stands here by itself; expected &amp;.'],
  ['<a>&#x;</a>', 'a reference such as &#65; is misspelt; expected digits and a semicolon.'],
  ['<a>&#0;</a>', 'a reference stands for a character that XML forbids; expected another.'],
  ['<a>&nbsp;</a>', 'the reference &nbsp; is not known; expected &amp;, &lt;, &gt;, &quot; or &apos;.'],
  ['<a/><b/>', 'there is more after the end of the root element; expected the end of the file.'],
  ['<a>\u0001</a>', 'the character U+0001 stands here, which XML forbids; expected it to be taken out.'],
  ['<a>\uD800</a>', 'the character U+D800 stands here, which XML forbids; expected it to be taken out.'],
  ['<?xml version="one"?><a/>', 'the XML declaration is misspelt; expected <?xml version="1.0" encoding="UTF-8"?>.'],
  ['<?xml encoding="UTF-8"?><a/>', 'the XML declaration is misspelt; expected <?xml version="1.0" encoding="UTF-8"?>.'],
  [
    '<?xml version="1.0" encoding="°"?><a/>',
    'the XML declaration is misspelt; expected <?xml version="1.0" encoding="UTF-8"?>.',
  ],
  [
    '<?xml version="1.0" standalone="?"?><a/>',
    'the XML declaration is misspelt; expected <?xml version="1.0" encoding="UTF-8"?>.',
  ],
  ['<?xml version="1.0"', 'the XML declaration is misspelt; expected <?xml version="1.0" encoding="UTF-8"?>.'],
  ['<>', 'the file has "<>" where its root element must begin; expected an element such as <robotModel>.'],
  [
    '<!-- nothing -->',
    'the file has the end of the file where its root element must begin; expected an element such as <robotModel>.',
  ],
])('what is not well-formed is refused in plain words: %s', ([text, message]) => {
  expect(faults(text)).toEqual([['not-xml', `Line 1: ${message}`]]);
});

test.for([
  ['<a:b/>', 'the prefix of <a:b> is not declared; expected xmlns:a="…" there or further out.'],
  ['<a b:c="1"/>', 'the prefix of the attribute "b:c" is not declared; expected xmlns:b="…" there or further out.'],
  ['<a:b:c xmlns:a="urn:a"/>', 'the name of <a:b:c> has a colon in the wrong place; expected a name, or prefix:name.'],
  ['<:a/>', 'the name of <:a> has a colon in the wrong place; expected a name, or prefix:name.'],
  ['<a:1 xmlns:a="urn:a"/>', 'the name of <a:1> has a colon in the wrong place; expected a name, or prefix:name.'],
  ['<a xmlns:b="urn:a b"/>', 'the declaration xmlns:b="urn:a b" is not allowed; expected xmlns:prefix="namespace".'],
  ['<a xmlns:b=""/>', 'the declaration xmlns:b="" is not allowed; expected xmlns:prefix="namespace".'],
  [
    '<a xmlns:xmlns="urn:a"/>',
    'the declaration xmlns:xmlns="urn:a" is not allowed; expected xmlns:prefix="namespace".',
  ],
  [
    '<a xmlns:b="urn:a" xmlns:c="urn:a" b:d="1" c:d="2"/>',
    '<a> has one attribute under two prefixes; expected it once.',
  ],
])('wrong namespaces are refused: %s', ([text, message]) => {
  expect(faults(text)).toEqual([['namespace', `Line 1: ${message}`]]);
});

test('a name of the file cannot reach an object of the program', () => {
  const { root } = readXmlTree('<a __proto__="1" constructor="2"><__proto__/></a>');
  expect(root?.attributes.map(({ name, value }) => [name, value])).toEqual([
    ['__proto__', '1'],
    ['constructor', '2'],
  ]);
  expect(readRobotXml(robotFile({ joint: 'id="__proto__" type="revolute"' })).doc?.robot.joints[0].id).toBe(
    '__proto__',
  );
});
