import { expect, test } from 'vitest';
import { readRobotXml } from '../../../src/io/robotXml.js';
import { ROBOT_MODEL } from '../../../src/io/robotXmlTable.js';
import { BAD_FILES, robotFile, rootWith, SAMPLES } from './files.js';
import { describeRule, describeSchema } from './schemaTable.js';
import { DRAFT_SCHEMA, PUBLISHED_SCHEMA, schemaErrors } from './xmllint.js';
import { decodeText } from '../../../src/io/decodeText.js';

/** @typedef {import('./schemaTable.js').Description} Description */

test('the table that reads and writes files says what the published schema says', () => {
  expect(describeRule(ROBOT_MODEL)).toEqual(describeSchema(PUBLISHED_SCHEMA));
});

test('the published schema has lost nothing of its first draft', () => {
  expectKept(describeSchema(PUBLISHED_SCHEMA), describeSchema(DRAFT_SCHEMA));
});

/** Elements and attributes may have been added; what was there is as it was. @param {Description} now @param {Description} then */
function expectKept(now, { children, ...then }) {
  expect(now).toMatchObject(then);
  const added = Object.entries(now.attributes).filter(([name]) => !Object.hasOwn(then.attributes, name));
  expect(added.filter(([, { required }]) => required)).toEqual([]);
  for (const child of children) {
    const same = now.children.find(({ name }) => name === child.name);
    expect(same, `<${child.name}> in <${then.name}>`).toBeDefined();
    if (same) expectKept(same, child);
  }
}

const EMPTY = '<dh theta="0" d="1" a="0" alpha="0">';
const XSI = 'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"';
const EXTENSION = '<x:e xmlns:x="urn:example:x"';
const PAIR = '<joint id="a" type="revolute"><dh theta="0" d="0" a="1" alpha="0"/></joint>';

/** What the schema refuses: libxml2 is asked, too. */
const REFUSED = {
  'blanks in an element that must be empty': { dh: `${EMPTY} </dh>` },
  'a text in the chain': { more: 'text' },
  'a text in an empty element': { dh: `${EMPTY}text</dh>` },
  'a CDATA section between elements': { after: '<![CDATA[ ]]>' },
  'an unknown element': { inJoint: '<mass/>' },
  'an element in a text': { before: '<info><name>a<b/></name></info>' },
  'an element of no namespace': { inJoint: '<limits xmlns=""/>' },
  'an element of another namespace outside extensions': { inJoint: `${EXTENSION}/>` },
  'an element that is there twice': { inJoint: '<limits/><limits/>' },
  'a second chain': { more: '</chain><chain>' },
  'an unknown attribute': { dh: '<dh theta="0" d="1" a="0" alpha="0" beta="0"/>' },
  'an attribute in our namespace': { before: '<base p:xyz="0 0 0" xmlns:p="urn:denavit:robot-model:1"/>' },
  'an attribute on a text element': { before: '<info><name lang="en">a</name></info>' },
  'xml:lang': { root: `${rootWith('', '')} xml:lang="en"` },
  'xsi:nil': { before: `<base ${XSI} xsi:nil="true"/>` },
  'a missing attribute': { dh: '<dh theta="0" d="1" a="0"/>' },
  'a missing unit': { root: rootWith('angleUnit="deg"', '') },
  'an unknown unit': { root: rootWith('"m"', '"inch"') },
  'an unknown convention': { root: rootWith('standard', 'craig') },
  'an unknown joint type': { joint: 'id="joint_1" type="planar"' },
  'an id with a hyphen': { joint: 'id="joint-1" type="revolute"' },
  'an id that is empty': { joint: 'id="" type="revolute"' },
  'an id of 65 characters': { joint: `id="${'a'.repeat(65)}" type="revolute"` },
  'an id twice': { joint: 'id="joint_2" type="revolute"' },
  'a comma in a number': { dh: '<dh theta="0" d="0,5" a="0" alpha="0"/>' },
  'a no-break space in a number': { dh: '<dh theta="0" d="&#xA0;1" a="0" alpha="0"/>' },
  'a number that is empty': { dh: '<dh theta="0" d="" a="0" alpha="0"/>' },
  'not a number': { dh: '<dh theta="0" d="NaN" a="0" alpha="0"/>' },
  infinity: { dh: '<dh theta="0" d="-INF" a="0" alpha="0"/>' },
  'a number too large': { dh: '<dh theta="0" d="1.1e9" a="0" alpha="0"/>' },
  'a rate of zero': { inJoint: '<limits velocity="0"/>' },
  'a radius that rounds to zero': { inJoint: '<link radius="1e-400"/>' },
  'two numbers in xyz': { before: '<base xyz="0 0"/>' },
  'no number in xyz': { before: '<base xyz=""/>' },
  'three numbers in a quaternion': { before: '<base quat_xyzw="0 0 1"/>' },
  'seven joint values': { after: '<postures><posture id="a" q="0 0 0 0 0 0 0"/></postures>' },
  'one joint value': { after: '<postures><posture id="a" q="0"/></postures>' },
  'seven joints': { more: PAIR.repeat(5).replace(/id="a"/g, (id, at) => `id="a${at}"`) },
  'a sign of 2': { inJoint: '<controller sign="2"/>' },
  'a sign of 1.0': { inJoint: '<controller sign="1.0"/>' },
  'a coupling to no joint': { inJoint: '<controller coupledTo="joint_9"/>' },
  'a frame number of 0': { after: '<frames><userFrame id="a" number="0"/></frames>' },
  'a frame id twice': { after: '<frames><userFrame id="a"/><toolFrame id="a"/></frames>' },
  'an active tool that is not there': { after: '<frames activeTool="b"><toolFrame id="a"/></frames>' },
  'an active tool that is a user frame': { after: '<frames activeTool="a"><userFrame id="a"/></frames>' },
  'an active user frame that is not there': { after: '<frames activeUser="a"/>' },
  'a target in a frame that is not there': { after: '<targets><target id="a" frame="b"/></targets>' },
  'an obstacle id twice': { after: '<obstacles><plane id="a"/><sphere id="a" radius="1"/></obstacles>' },
  'an obstacle without its size': { after: '<obstacles><cylinder id="a" radius="1"/></obstacles>' },
  'an obstacle with the size of another': { after: '<obstacles><sphere id="a" radius="1" height="2"/></obstacles>' },
  'an obstacle of no size': { after: '<obstacles><sphere id="a" radius="0"/></obstacles>' },
  'an obstacle of no known kind': { after: '<obstacles><cone id="a" radius="1" height="1"/></obstacles>' },
  'more than 100 obstacles': { after: `<obstacles>${times(101, (i) => `<plane id="o${i}"/>`)}</obstacles>` },
  'more than 100 frames': { after: `<frames>${times(101, (i) => `<userFrame id="f${i}"/>`)}</frames>` },
  'a posture id twice': { after: '<postures><posture id="a" q="0 0"/><posture id=" a " q="0 0"/></postures>' },
  'more than 1000 postures': { after: `<postures>${times(1001, (i) => `<posture id="p${i}" q="0 0"/>`)}</postures>` },
  'a program id twice': { after: `<programs>${times(2, () => '<program id="a" language="krl"/>')}</programs>` },
  'more than 20 programs': {
    after: `<programs>${times(21, (i) => `<program id="p${i}" language="krl"/>`)}</programs>`,
  },
  'an unknown language': { after: '<programs><program id="a" language="rapid"/></programs>' },
  'an element among the options of code': { after: '<codeOptions><info/></codeOptions>' },
  'options of code twice': { after: '<codeOptions/><codeOptions/>' },
  'a colour by name': { inJoint: '<link color="red"/>' },
  'a name of 201 characters': { before: `<info><name>${'😀'.repeat(201)}</name></info>` },
  'a description of 10001 characters': { before: `<info><description>${'a'.repeat(10001)}</description></info>` },
  'a text in extensions': { after: '<extensions>text</extensions>' },
  'an extension of no namespace': { after: '<extensions><e xmlns=""/></extensions>' },
  'an extension of our namespace': { after: '<extensions><info/></extensions>' },
  'half a robot in an extension': { after: `<extensions>${EXTENSION}><robotModel/></x:e></extensions>` },
  'an extension of a type that nobody knows': {
    after: `<extensions>${EXTENSION}><x:f ${XSI} xsi:type="x:g"/></x:e></extensions>`,
  },
  'an undeclared prefix': { after: '<extensions><x:e/></extensions>' },
};

/** @param {number} count @param {(i: number) => string} make */
function times(count, make) {
  return Array.from({ length: count }, (_, i) => make(i)).join('');
}

/** What the schema allows, and people and programs do. */
const ACCEPTED = {
  'as it is': {},
  'a comment in an element that must be empty': { dh: `${EMPTY}<!-- 0 --></dh>` },
  'a comment and an instruction in a name': { before: '<info><name>a<!-- b -->c<?d e?></name></info>' },
  'blanks by reference between elements': { after: '&#32;' },
  'where the schema is': { root: `${rootWith('', '')} ${XSI} xsi:schemaLocation="urn:denavit:robot-model:1 a.xsd"` },
  'limits before the table row': { dh: '<limits lower="-1"/>', inJoint: EMPTY.replace('>', '/>') },
  'the chain before the info': { after: '<info/>' },
  'blanks around words and numbers': {
    joint: 'id="  joint_1 " type="\n revolute\t"',
    dh: '<dh theta=" 0&#10;" d="1 " a="&#9;0" alpha="0"/>',
  },
  'all spellings of a number': { dh: '<dh theta="+1." d=".5" a="-1.5E-3" alpha="1e+2"/>' },
  'a number that rounds to zero': { dh: '<dh theta="1e-400" d="-0" a="0" alpha="0"/>' },
  'the largest numbers': { dh: '<dh theta="1e9" d="-1000000000.0" a="1" alpha="0"/>' },
  'many blanks between numbers': { before: '<base xyz=" 0 &#10; 0 &#9;0 "/>' },
  'a sign with a sign': { inJoint: '<controller sign=" +1 "/>' },
  'a coupling by an id with blanks': { inJoint: '<controller coupledTo=" joint_2 "/>' },
  'a frame number with zeros': { after: '<frames><toolFrame id="a" number="+007"/></frames>' },
  'an active tool and user frame, by ids with blanks': {
    before: '<tool xyz="0 0 1"/>',
    after:
      '<frames activeTool=" a" activeUser="b "><toolFrame id="a" xyz="0 0 1"/><userFrame id="b"/></frames><targets><target id="a" frame="b"/></targets>',
  },
  'options of code that nobody understands': { after: '<codeOptions>__proto__=1 speed=; END</codeOptions>' },
  'a name of 200 emoji': { before: `<info><name>${'😀'.repeat(200)}</name></info>` },
  'an empty info, frames, postures, programs, extensions': {
    before: '<info/>',
    after: '<frames/><postures/><programs/><extensions/>',
  },
  'an extension with elements of ours by accident': { after: `<extensions>${EXTENSION}><f/>text</x:e></extensions>` },
  'the older name of postures': {
    after: '<configurations><configuration id="a" q="0 0"/></configurations>',
  },
};

test('what the schema refuses is refused', async () => {
  const texts = Object.values(REFUSED).map(robotFile);
  const errors = await schemaErrors(texts);
  const verdicts = Object.keys(REFUSED).map((name, i) => [
    name,
    {
      libxml2: errors[i].length > 0 ? 'refused' : 'accepted',
      here: readRobotXml(texts[i]).doc ? 'accepted' : 'refused',
    },
  ]);
  const all = Object.keys(REFUSED).map((name) => [name, { libxml2: 'refused', here: 'refused' }]);
  expect(Object.fromEntries(verdicts)).toEqual(Object.fromEntries(all));
});

test('what the schema allows is opened', async () => {
  const texts = Object.values(ACCEPTED).map(robotFile);
  expect((await schemaErrors(texts)).flat()).toEqual([]);
  for (const [i, name] of Object.keys(ACCEPTED).entries()) {
    const errors = readRobotXml(texts[i]).issues.filter(({ severity }) => severity === 'error');
    expect({ name, errors }).toEqual({ name, errors: [] });
  }
});

test('whatever is opened of the samples and of the bad files is valid under the published schema', async () => {
  const decoded = BAD_FILES.map(({ bytes }) => decodeText(bytes).text).filter((text) => text !== null);
  const opened = [...SAMPLES.map(({ text }) => text), ...decoded].filter((text) => readRobotXml(text).doc);
  const unicode = opened.map((text) => text.replace(/^\uFEFF?<\?xml.*?\?>/, '')); // its encoding is no longer so
  expect(opened.length).toBeGreaterThan(50);
  expect((await schemaErrors(unicode)).flat()).toEqual([]);
});
