import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createKeeper } from '../../../src/io/keepWork.js';
import { KEPT, writeKeptWork } from '../../../src/io/keptWork.js';
import { readKeptWork, sortKeptWork } from '../../../src/io/readKeptWork.js';
import { writeRobotXml } from '../../../src/io/robotXmlWriter.js';
import { createManualClock } from '../../../src/model/clock.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { createStore } from '../../../src/model/store.js';
import { runs, SEED } from '../../helpers/property.js';
import { documents } from './documents.js';

/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/session.js').Action} Action */

const puma = newDocument(LIBRARY.puma560);
const ur5 = newDocument(LIBRARY.ur5);
const NOON = '2026-11-22T12:00:00.000Z';

/** A browser's storage, which may be full or forbidden. */
function createStorage() {
  /** @type {Map<string, string>} */
  const values = new Map();
  let isBroken = false;
  let writes = 0;
  return {
    values,
    breakIt: (/** @type {boolean} */ broken) => (isBroken = broken),
    get writes() {
      return writes;
    },
    remember(/** @type {string} */ key, /** @type {string} */ value) {
      writes++;
      if (!isBroken) values.set(key, value);
      return !isBroken;
    },
    forget: (/** @type {string} */ key) => void values.delete(key),
    all: () => [...values].map(([key, text]) => ({ key, text })),
  };
}

/** A visit to the page. @param {ReturnType<typeof createStorage>} storage @param {string} [visit] @param {Doc} [doc] */
function visitPage(storage, visit = 'a', doc = puma) {
  const clock = createManualClock();
  const store = createStore(startState(doc), reduce);
  let fails = 0;
  const keep = createKeeper({
    store,
    clock,
    storage,
    visit,
    today: () => new Date(Date.parse(NOON) + 1000 * clock.now()).toISOString(),
    look: () => 'tab=code',
    onFail: () => void fails++,
  });
  return { clock, store, keep, fails: () => fails };
}

const turn = (/** @type {number} */ value) => /** @type {const} */ ({ type: 'set-joint-value', joint: 0, value });

/** @param {ReturnType<typeof createStorage>} storage @param {Doc} [open] */
const offered = (storage, open = puma) => sortKeptWork(storage.all(), open).works.map(({ doc }) => doc);

test('nothing is written while nothing changed, nor for what is only looked at', () => {
  const storage = createStorage();
  const { clock, store, keep } = visitPage(storage);
  store.dispatch({ type: 'show', change: { tab: 'code' } });
  store.dispatch(turn(puma.posture[0])); // where it is
  clock.tick(100);
  expect(keep()).toBe(true);
  expect(clock.idle).toBe(true);
  expect(storage.writes).toBe(0);
});

test('a drag of a hundred steps is written once a second, and its end is', () => {
  const storage = createStorage();
  const { clock, store } = visitPage(storage);
  for (let i = 1; i <= 100; i++) {
    store.dispatch({ ...turn(i / 10), gesture: 'drag' });
    clock.tick(0.02);
  }
  expect(storage.writes).toBeLessThanOrEqual(2);
  clock.tick(1);
  expect(storage.writes).toBeLessThanOrEqual(3);
  expect(offered(storage)).toStrictEqual([store.state.doc]);
  clock.tick(100);
  expect(storage.writes).toBeLessThanOrEqual(3);
});

test('a page that is killed at any moment loses two seconds at most', () => {
  const pause = fc.noBias(fc.integer({ min: 0, max: 3000 })).map((ms) => ms / 1000);
  const step = fc.oneof(
    fc.integer({ min: -150, max: 150 }).map(turn),
    fc
      .double({ min: 1, max: 900, noNaN: true })
      .map((value) => /** @type {Action} */ ({ type: 'set-joint-field', joint: 1, field: 'a', value })),
    fc.constantFrom(/** @type {Action} */ ({ type: 'undo' }), /** @type {Action} */ ({ type: 'redo' })),
    fc.constant(/** @type {Action} */ ({ type: 'replace-document', doc: ur5 })),
  );
  let lost = 0;
  fc.assert(
    fc.property(fc.array(fc.tuple(step, pause), { minLength: 3, maxLength: 40 }), (session) => {
      const storage = createStorage();
      const { clock, store } = visitPage(storage);
      /** @type {{ at: number, doc: Doc }[]} what the document was, since when */
      const was = [{ at: 0, doc: puma }];
      for (const [action, wait] of session) {
        store.dispatch(action);
        was.push({ at: clock.now(), doc: store.state.doc });
        for (let left = wait; left > 0; left -= 0.05) clock.tick(Math.min(0.05, left));
      }
      // Killed here. What is found again is the document as it was at some time of the last two seconds.
      const killed = clock.now();
      const recent = was.filter(({ at }, i) => (was[i + 1]?.at ?? Infinity) >= killed - 2 || at >= killed - 2);
      const [found = puma] = offered(storage);
      expect(recent.map(({ doc }) => writeRobotXml(doc))).toContain(writeRobotXml(found));
      if (writeRobotXml(found) !== writeRobotXml(store.state.doc)) lost++;
    }),
    { seed: SEED, numRuns: runs(10) },
  );
  expect(lost).toBeGreaterThan(0); // the kill does fall between a change and its writing
});

test('a page that is left in order loses nothing', () => {
  const storage = createStorage();
  const { store, keep } = visitPage(storage);
  store.dispatch(turn(12));
  expect(keep()).toBe(true);
  expect(offered(storage)).toStrictEqual([store.state.doc]);
});

test('work that was undone to its beginning is not offered', () => {
  const storage = createStorage();
  const { clock, store } = visitPage(storage);
  store.dispatch(turn(12));
  clock.tick(1);
  expect(storage.values.size).toBe(1);
  store.dispatch({ type: 'undo' });
  clock.tick(1);
  expect(storage.values.size).toBe(0);
});

test('another arm that is opened leaves the work before it where it is', () => {
  const storage = createStorage();
  const { clock, store } = visitPage(storage);
  store.dispatch(turn(12));
  const work = store.state.doc;
  clock.tick(1);
  store.dispatch({ type: 'replace-document', doc: ur5 });
  clock.tick(1);
  expect(offered(storage)).toStrictEqual([ur5, work]);
  store.dispatch({ type: 'rename-robot', name: 'Mine' });
  clock.tick(1);
  expect(storage.values.size).toBe(2); // the same work under a new name
});

test('two tabs write side by side, and what one leaves is offered as it was', () => {
  const storage = createStorage();
  const [one, other] = [visitPage(storage, 'a'), visitPage(storage, 'b')];
  one.store.dispatch(turn(1));
  other.store.dispatch(turn(2));
  for (const { clock } of [one, other]) clock.tick(1);
  one.store.dispatch(turn(3));
  one.clock.tick(1);
  expect(offered(storage)).toHaveLength(2);
  expect(new Set(offered(storage))).toEqual(new Set([one.store.state.doc, other.store.state.doc]));
});

test('storage that is full is said once, tried again, and leaves the last that was kept', () => {
  const storage = createStorage();
  const { clock, store, keep, fails } = visitPage(storage);
  store.dispatch(turn(1));
  clock.tick(1);
  const before = store.state.doc;
  storage.breakIt(true);
  for (const value of [2, 3, 4]) {
    store.dispatch(turn(value));
    clock.tick(1);
  }
  expect(fails()).toBe(1);
  expect(keep()).toBe(false);
  expect(offered(storage)).toStrictEqual([before]);
  storage.breakIt(false);
  expect(keep()).toBe(true);
  expect(offered(storage)).toStrictEqual([store.state.doc]);
});

test('what is kept comes back as it was, with how it was looked at', () => {
  fc.assert(
    fc.property(documents, (doc) => {
      const text = writeKeptWork({ doc, at: NOON, look: 'tab=code&camera=1,2,3,4,5,6,7' });
      const work = readKeptWork('k', text);
      expect(work).toMatchObject({ key: 'k', state: 'work', at: NOON, file: writeRobotXml(doc) });
      if (work.state !== 'work') return;
      expect(work.doc).toStrictEqual(doc);
      expect(work.look).toEqual({ change: { tab: 'code' }, camera: [1, 2, 3, 4, 5, 6, 7], refused: [] });
    }),
    { seed: SEED, numRuns: runs(20) },
  );
});

test('500 spoilt texts: each is told from work, and handed out as it is', () => {
  const good = writeKeptWork({ doc: puma, at: NOON, look: '' });
  const place = fc.noBias(fc.integer({ min: 0, max: good.length - 1 }));
  const any = fc.string({ unit: fc.constantFrom(...'a1<>"{}\n\0 😀', '__proto__', 'denavit-work 1 '), maxLength: 3 });
  fc.assert(
    fc.property(place, fc.integer({ min: 0, max: 300 }), any, (at, less, more) => {
      const text = good.slice(0, at) + more + good.slice(at + less);
      const work = readKeptWork('k', text);
      if (text === good) return;
      expect(work.state).not.toBe('work');
      expect(text.endsWith(work.file)).toBe(true);
      expect(sortKeptWork([{ key: 'k', text }], puma)).toEqual({ works: [], spoilt: [work], idle: [] });
    }),
    { seed: SEED, numRuns: runs(25) },
  );
  for (const text of ['', '{}', 'null', '\0', 'denavit-work', good.replace('work 1', 'work 0')]) {
    expect(readKeptWork('k', text)).toEqual({ key: 'k', state: 'damaged', file: expect.any(String) });
  }
});

test('work of a newer version is told from damaged work, and its file is found', () => {
  const good = writeKeptWork({ doc: puma, at: NOON, look: '' });
  expect(readKeptWork('k', good.replace('work 1', 'work 2'))).toEqual({
    key: 'k',
    state: 'newer',
    file: writeRobotXml(puma),
  });
});

test('offered is what differs from what is open, each once, the newest first, and not without end', () => {
  const at = (/** @type {number} */ minute) => `2026-11-22T12:${String(minute).padStart(2, '0')}:00.000Z`;
  const work = (/** @type {number} */ minute, /** @type {number} */ value) => ({
    key: `k${minute}`,
    text: writeKeptWork({ doc: { ...puma, posture: [value, 0, 0, 0, 0, 0] }, at: at(minute), look: '' }),
  });
  const open = { key: 'open', text: writeKeptWork({ doc: puma, at: at(50), look: '' }) };
  const { works, spoilt, idle } = sortKeptWork(
    [work(1, 1), open, work(3, 3), work(2, 3), { key: 'bad', text: 'x' }],
    puma,
  );
  expect(works.map(({ key }) => key)).toEqual(['k3', 'k1']);
  expect(spoilt.map(({ key }) => key)).toEqual(['bad']);
  expect(idle.sort()).toEqual(['k2', 'open']);
  const many = sortKeptWork(
    Array.from({ length: 15 }, (_, i) => work(i, i + 1)),
    puma,
  );
  expect(many.works.map(({ key }) => key)).toEqual(Array.from({ length: 10 }, (_, i) => `k${14 - i}`));
  expect(many.idle).toHaveLength(5);
});

test('no two things are kept under one name', () => {
  const storage = createStorage();
  for (const visit of ['a', 'b', 'c']) {
    const { store, keep } = visitPage(storage, visit);
    store.dispatch(turn(5));
    keep();
  }
  expect([...storage.values.keys()]).toEqual(['a', 'b', 'c'].map((visit) => `${KEPT}${visit}.0`));
});
