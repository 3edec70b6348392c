import fc from 'fast-check';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { deflateRawSync, inflateRawSync } from 'node:zlib';
import { expect, test } from 'vitest';
import { fromBase64url, toBase64url } from '../../../src/io/base64url.js';
import { fingerprint } from '../../../src/model/fingerprint.js';
import { libraryQuery } from '../../../src/io/libraryLink.js';
import { LINK_DICTIONARY } from '../../../src/io/linkDictionary.js';
import { writeLook } from '../../../src/io/look.js';
import { pack, unpack } from '../../../src/io/pack.js';
import { SCHEMA, readQueryParameters } from '../../../src/io/queryParameters.js';
import { readLook } from '../../../src/io/readLook.js';
import { writeRobotXml } from '../../../src/io/robotXmlWriter.js';
import { readShareLink, writeShareLink } from '../../../src/io/shareLink.js';
import { applyCommand } from '../../../src/model/commands.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { startDocument } from '../../../src/model/startDocument.js';
import { validateDocument } from '../../../src/model/validate.js';
import { runs, SEED } from '../../helpers/property.js';
import { documents } from './documents.js';
import { SAMPLES } from './files.js';

/** @typedef {import('../../../src/model/document.js').Doc} Doc */

const puma = newDocument(LIBRARY.puma560);
const linkOf = (/** @type {Doc} */ doc) => `#${writeShareLink(doc)}`;
/** @param {string} hash */
const codes = (hash) => readShareLink(hash).issues.map(({ code }) => code);
const dictionary = Buffer.from(LINK_DICTIONARY);

/** A link as somebody else would make it. @param {string | Buffer} text @param {string} [print] */
const forged = (text, print = fingerprint(String(text))) =>
  `#model=1.${deflateRawSync(text, { level: 9, dictionary }).toString('base64url')}.${print}`;

/** @param {Doc} doc */
function expectSameAgain(doc) {
  const hash = linkOf(doc);
  const { doc: opened, hasModel, issues } = readShareLink(hash);
  expect(issues.filter(({ severity }) => severity === 'error')).toEqual([]);
  expect(hasModel).toBe(true);
  expect(opened).toStrictEqual(doc);
  expect(opened && writeRobotXml(opened)).toBe(writeRobotXml(doc));
  expect(opened && linkOf(opened)).toBe(hash);
  expect(hash).toMatch(/^#model=1\.[\w-]+\.[0-9a-f]{8}$/);
}

test('every arm of the library goes through a link as it is, in few letters', () => {
  for (const robot of Object.values(LIBRARY)) {
    expectSameAgain(newDocument(robot));
    const isCoupled = robot.joints.some(({ controller }) => controller.coupledTo); // which is written, being no default
    expect(linkOf(newDocument(robot)).length).toBeLessThan(isCoupled ? 500 : 460);
  }
});

test('any document goes through a link as it is', () => {
  fc.assert(fc.property(documents, expectSameAgain), { seed: SEED, numRuns: runs(60) });
});

test.for(SAMPLES)('$name is unpacked by another program, and by this one whatever packed it', ({ text }) => {
  const packed = /** @type {string} */ (pack(text));
  expect(inflateRawSync(Buffer.from(packed, 'base64url'), { dictionary }).toString()).toBe(text);
  const { doc, issues } = readShareLink(forged(text));
  expect(issues).toEqual([]);
  expect(doc && writeRobotXml(doc)).toContain('<robotModel');
});

test('bytes as letters are what Node makes of them', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 40 }), (bytes) => {
      expect(toBase64url(bytes)).toBe(Buffer.from(bytes).toString('base64url'));
      expect(fromBase64url(toBase64url(bytes))).toStrictEqual(bytes);
    }),
    { seed: SEED, numRuns: runs(50) },
  );
  for (const wrong of ['a', 'ab=', 'ab+c', 'ab/c', 'äöü', 'ab c']) expect(fromBase64url(wrong)).toBeNull();
});

test('links that were made by version 1 are opened for ever', () => {
  // Made on 2026-11-22. Nothing here may be made anew: links like these are in mails and course pages.
  const kept = JSON.parse(readFileSync(new URL('../../fixtures/links/version1.json', import.meta.url), 'utf8'));
  expect(kept.links.length).toBeGreaterThan(3);
  for (const { hash, file } of kept.links) {
    const { doc, issues } = readShareLink(hash);
    expect(issues.filter(({ severity }) => severity === 'error')).toEqual([]);
    expect(doc).not.toBeNull();
    // the generator's name is that of the program that writes
    const undated = (/** @type {string} */ xml) => xml.replace(/ generator="[^"]*"/, '');
    expect(doc && undated(writeRobotXml(doc))).toBe(undated(file));
  }
  expect(createHash('sha256').update(LINK_DICTIONARY).digest('hex')).toBe(kept.dictionary);
});

test('a link that is cut off anywhere says so', () => {
  const hash = linkOf(puma);
  for (let length = '#model='.length; length < hash.length; length++) {
    const cut = hash.slice(0, length);
    expect([cut, ...codes(cut)]).toEqual([cut, 'link-cut']);
  }
});

test('what a sentence leaves at the end of a link does no harm', () => {
  for (const stray of ['.', ',', ').', '”', '>', '…', "'", ' ']) {
    expect(readShareLink(linkOf(puma) + stray).doc).toStrictEqual(puma);
  }
});

test('a link of a newer version, of none, and no link at all are told apart', () => {
  const rest = linkOf(puma).slice('#model=1.'.length);
  expect(codes(`#model=2.${rest}`)).toEqual(['link-newer']);
  expect(codes('#model=2.anything at all?')).toEqual(['link-newer']);
  expect(codes(`#model=0.${rest}`)).toEqual(['link-damaged']);
  expect(codes(`#model=x.${rest}`)).toEqual(['link-damaged']);
  expect(codes(`#model=9999999.${rest}`)).toEqual(['link-damaged']);
  expect(codes('#model=')).toEqual(['link-cut']);
  expect(codes('#mdoel=1.abc')).toEqual(['link-unknown']);
  expect(codes(`#${rest}`)).toEqual(['link-unknown']);
  for (const none of ['', '#', '#top', '#section-2_b']) {
    expect(readShareLink(none)).toMatchObject({ hasModel: false, doc: null, issues: [] });
  }
});

test('what is in a link is held to the rules of files', () => {
  const file = writeRobotXml(puma);
  for (const [from, to] of [
    ['a="431.8"', 'a="431,8"'],
    ['<chain>', '<!DOCTYPE a><chain>'],
    ['version="1.0"', 'version="2.0"'],
    ['</robotModel>', ''],
  ]) {
    const { doc, issues } = readShareLink(forged(file.replace(from, to)));
    expect(doc).toBeNull();
    expect(issues).toHaveLength(1);
    expect(issues[0].message).toMatch(/^The link holds no model that can be opened: .*\.$/);
  }
  expect(codes(forged(''))).toEqual(['empty']);
  expect(codes(forged(file, '00000000'))).toEqual(['link-damaged']);
  expect(codes(forged(Buffer.from([0xff, 0xfe, 0xc0, 0x80])))).toEqual(['link-damaged']);
});

test('a bomb is given up before it goes off', () => {
  for (const size of [100_000, 1_000_000, 64_000_000]) {
    const bomb = deflateRawSync(Buffer.alloc(size), { level: 9 });
    expect(size / bomb.length).toBeGreaterThan(800);
    expect(unpack(bomb.toString('base64url'))).toEqual({ fault: 'too-large' });
    expect(codes(`#model=1.${bomb.toString('base64url')}.00000000`)).toEqual(['link-too-large']);
  }
  // of bombs in bombs, only the outermost would be unpacked
  const inner = deflateRawSync(deflateRawSync(Buffer.alloc(10_000_000), { level: 9 }), { level: 9 });
  expect(codes(`#model=1.${inner.toString('base64url')}.00000000`)).toEqual(['link-damaged']);
  expect(codes(`#model=1.${'A'.repeat(3_000_000)}.00000000`)).toEqual(['link-too-large']);
});

test('a document that is too large for a link has none', () => {
  const program = (/** @type {string} */ text) => ({
    ...puma,
    programs: [{ id: 'p', language: /** @type {const} */ ('krl'), text }],
  });
  expect(writeShareLink(program('x'.repeat(1_048_576)))).toBeNull(); // too long
  expect(writeShareLink(program('x'.repeat(900_000)))).toBeNull(); // like a bomb
  expectSameAgain(program('INI\n'.repeat(12_000)));
});

test('2,000 spoilt links: each is refused in a sentence, or is the very document; the open one stays', () => {
  const goods = [puma, ...fc.sample(documents, { seed: SEED, numRuns: 6 })].map((doc) => ({ doc, hash: linkOf(doc) }));
  const letter = fc.constantFrom(
    ...'AZaz09-_.=&#%+ ?äüé😀\0<"',
    'model=',
    '&model=2.',
    '&camera=1,2',
    '%00',
    '%ZZ',
    '__proto__=1&',
  );
  const place = fc.noBias(fc.integer({ min: 0, max: 999_999 })).map((millionths) => millionths / 1_000_000);
  const at = (/** @type {string} */ text, /** @type {number} */ where) => Math.floor(where * (text.length + 1));
  /** @type {fc.Arbitrary<(text: string) => string>[]} */
  const mutations = [
    fc.tuple(place, letter, fc.integer({ min: 0, max: 1 })).map(([where, token, less]) => (text) => {
      return text.slice(0, at(text, where)) + token + text.slice(at(text, where) + less);
    }),
    fc.tuple(place, fc.integer({ min: 1, max: 40 })).map(([where, many]) => (text) => {
      return text.slice(0, at(text, where)) + text.slice(at(text, where) + many);
    }),
    fc.tuple(place, place, fc.integer({ min: 1, max: 200 })).map(([from, to, many]) => (text) => {
      return text.slice(0, at(text, to)) + text.slice(at(text, from), at(text, from) + many) + text.slice(at(text, to));
    }),
    place.map((where) => (text) => text.slice(0, at(text, where))),
  ];
  const mutation = fc.oneof(...mutations);
  const before = Object.getOwnPropertyNames(Object.prototype).join();
  let refused = 0;
  fc.assert(
    fc.property(
      fc.constantFrom(...goods),
      fc.array(mutation, { minLength: 1, maxLength: 3 }),
      ({ doc, hash }, mutate) => {
        const answer = readShareLink(mutate.reduce((text, next) => next(text), hash));
        for (const { message } of answer.issues) expect(message).toMatch(/^[^\p{Cc}\p{Cf}\p{Cs}]{20,900}\.$/u);
        const errors = answer.issues.filter(({ severity }) => severity === 'error');
        expect(errors.length > 0).toBe(answer.doc === null && answer.hasModel);
        if (answer.doc) {
          expect(validateDocument(answer.doc)).toEqual([]);
          expect(answer.doc).toStrictEqual(doc);
        } else refused++;
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
  expect(refused).toBeGreaterThan(30);
  expect(Object.getOwnPropertyNames(Object.prototype).join()).toBe(before);
});

test('any text after the # is answered', () => {
  fc.assert(
    fc.property(
      fc.string({ unit: 'binary', maxLength: 200 }),
      fc.constantFrom('#', '#model=', '#model=1.', '#camera='),
      (text, start) => {
        const { doc, issues } = readShareLink(start + text);
        expect(doc).toBeNull();
        for (const { message } of issues) expect(message).toMatch(/\.$/);
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('how it is looked at goes with a link', () => {
  const { session } = startState(puma);
  expect(writeLook({ panels: session, view: session })).toBe('');
  const other = /** @type {const} */ ({ ...session, tab: 'code', panel: 'aim', frames: 'all', projection: 'parallel' });
  const camera = [-68.0000001, 19.123456789, 2.5, 0.1 + 0.2, -1e-7, 0, 16 / 9];
  const written = writeLook({ panels: other, view: other, camera });
  expect(written).toBe('tab=code&panel=aim&frames=all&projection=parallel&camera=-68,19.1235,2.5,0.3,-1e-7,0,1.77778');
  const { doc, look, issues } = readShareLink(`${linkOf(puma)}&${written}`);
  expect(issues).toEqual([]);
  expect(doc).toStrictEqual(puma);
  expect(look.change).toEqual({ tab: 'code', panel: 'aim', frames: 'all', projection: 'parallel' });
  expect(look.camera).toEqual([-68, 19.1235, 2.5, 0.3, -1e-7, 0, 1.77778]);
  expect(readLook(writeLook({ panels: other })).change).toEqual({ tab: 'code', panel: 'aim' });
  expect(readShareLink(`#${written}`)).toMatchObject({ hasModel: false, issues: [], look: { change: look.change } });
});

test.for([
  ['tab=constructor', 'tab'],
  ['frames=', 'frames'],
  ['camera=1,2,3', 'camera'],
  ['camera=0,0,0,0,0,0,1', 'camera'], // no distance
  ['camera=0,0,-1,0,0,0,1', 'camera'],
  ['camera=0,0,1,0,0,0,0', 'camera'], // no width
  ['camera=0,0,1,NaN,0,0,1', 'camera'],
  ['camera=0,0,1e99,0,0,0,1', 'camera'],
])('%s is left out of a link, and said', ([text, name]) => {
  const { doc, look, issues } = readShareLink(`${linkOf(puma)}&${text}`);
  expect(doc).toStrictEqual(puma);
  expect(look).toMatchObject({ change: {}, camera: null });
  expect(issues.map(({ code }) => code)).toEqual(['link-look']);
  expect(issues[0].message).toContain(`(${name})`);
});

test('an arm of the library has a short address, which begins at the very document', () => {
  for (const [id, robot] of Object.entries(LIBRARY)) {
    const home = newDocument(robot);
    expect(libraryQuery(home)).toBe(`robot=${id}`);
    const moved = applyCommand(home, { type: 'set-posture', posture: home.posture.map((_, i) => i / 3 - 0.1) });
    const inMetres = applyCommand(moved, { type: 'convert-units', units: { length: 'm', angle: 'rad' } });
    for (const doc of [home, moved, inMetres]) {
      const query = libraryQuery(doc);
      const { values, refused } = readQueryParameters(`?${query}`, SCHEMA);
      expect(refused).toEqual([]);
      expect(values.robot).toBe(id);
      expect(startDocument(LIBRARY[id], values).doc).toStrictEqual(doc);
    }
  }
});

test('an arm that is changed, however little, has no short address', () => {
  const { doc } = reduce(startState(puma), { type: 'set-joint-field', joint: 1, field: 'a', value: 431.9 });
  expect(libraryQuery(doc)).toBeNull();
  expect(libraryQuery({ ...puma, postures: [{ id: 'p1', q: puma.posture }] })).toBeNull();
  expect(libraryQuery({ ...puma, robot: { ...puma.robot, name: 'UR5' } })).toBeNull();
  expect(libraryQuery({ ...puma, posture: [-0, 0, 0, 0, 0, 0] })).toBeNull(); // an address has no -0
});
