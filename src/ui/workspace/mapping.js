/**
 * Keeps what is known of the workspace to what is asked: works on a question whenever there is a new one, gives the last one up,
 * and tells the session how far it is. A change of the table is a new question; so is another choice in the panel. Who makes a
 * map's status `cancelled` has its work stopped; who takes it away has it done anew.
 *
 * @import { Page } from '../page.js'
 * @import { AppState } from '../../model/session.js'
 * @import { MapState, SectionMap, VolumeMap, WorkspaceMaps } from '../../model/workspace/mapped.js'
 * @import { Asked } from './mapper.js'
 * @import { ProgressOfStages } from '../../model/workspace/progress.js'
 * @import { MapWorkspaceAnswer } from '../../workers/mapWorkspace.js'
 */
import { createFrameLoop } from '../../model/clock.js';
import { together } from '../../model/views.js';
import { sectionQuestion, volumeQuestion } from '../../model/workspace/mapQuestions.js';
import { createProgress } from '../../model/workspace/progress.js';
import { startJob } from '../parts/startJob.js';
import { look } from './look.js';
import { createMapper } from './mapper.js';
import { sectionInWords, volumeInWords, whyText } from './mapText.js';

/** What the stages take, roughly, until it is known how long they take here. */
const VOLUME = { cloud: 1, places: 1, attributes: 5, orientations: 0, middles: 4 };
const ORIENTED = { ...VOLUME, orientations: 20 };
const SECTION = { first: 1, curves: 10, postures: 3, sides: 10, volume: 4 };

/** @param {string} key @returns {MapState} */
const begun = (key) => ({ key, isStale: true, status: 'working', stage: '', share: 0, secondsLeft: null, why: null });

/** @typedef {Extract<MapWorkspaceAnswer, { word: unknown }>['word']} Word */
/** @typedef {Extract<MapWorkspaceAnswer, { found: unknown }>['found']} Found */

/**
 * The first worker is started at once: it comes up while somebody still reaches for the panel.
 * @param {Page} page
 */
export function createMapping(page) {
  const { store, addView, clock, messages, derived, announce } = page;
  const chain = () => derived.chain(store.state.doc);
  /** @param {Partial<WorkspaceMaps>} change */
  const put = (change) =>
    store.dispatch({ type: 'show', change: { maps: { ...store.state.session.maps, ...change } } });

  /**
   * One kind of map, which may take several jobs, one after the other.
   * @template {MapState} Map
   * @param {'volume' | 'section'} name
   * @param {(state: AppState) => boolean} isCancelled
   * @param {(map: Map) => string} inWords
   * @param {Worker | null} worker
   */
  function runner(name, isCancelled, inWords, worker) {
    /** @type {Map | null} what is not in the session yet */
    let map = null;
    const tellNow = () => {
      // whoever cancelled it, or took it away, has seen enough
      if (map && !isCancelled(store.state) && store.state.session.maps[name]?.key === map.key) put({ [name]: map });
    };
    const tell = createFrameLoop(clock, tellNow);
    const fail = (/** @type {unknown} */ error) => {
      change(/** @type {Partial<Map>} */ ({ status: 'failed' }));
      messages.fault(error);
    };
    const mapper = createMapper(clock, fail, worker);

    /** @param {Partial<Map>} now */
    function change(now) {
      if (!map) return;
      map = { ...map, ...now };
      tell();
    }

    /**
     * @param {Map} first
     * @param {readonly Asked[]} questions
     * @param {ProgressOfStages} progress
     * @param {(map: Map, word: Word) => Partial<Map>} onWord
     * @param {(map: Map, found: Found) => Partial<Map>} onFound
     */
    function run(first, questions, progress, onWord, onFound) {
      map = first;
      put({ [name]: first });
      progress.begin(clock.now());
      /** @param {number} at */
      const askNext = (at) =>
        mapper.ask(questions[at], (answer) => {
          if (!map) return;
          if ('fault' in answer) return fail(new Error(answer.fault));
          if ('word' in answer) {
            const { stage, share } = answer.word;
            const far = progress.at(stage, share, clock.now());
            const { isStale } = map;
            change({ ...onWord(map, answer.word), ...far, stage });
            if (isStale && !map.isStale) tellNow(); // the first picture waits for nothing
            return;
          }
          const { found } = answer;
          if (found.kind === 'not-mapped') {
            change(/** @type {Partial<Map>} */ ({ why: found.why, status: 'done', isStale: false }));
            return announce(whyText(found.why));
          }
          change({ ...onFound(map, found), isStale: false });
          if (at + 1 < questions.length) return askNext(at + 1);
          progress.end(clock.now());
          change(/** @type {Partial<Map>} */ ({ status: 'done', share: 1, secondsLeft: 0 }));
          announce(inWords(map));
        });
      askNext(0);
    }

    return { run, mapper };
  }

  const volumes = /** @type {ReturnType<typeof runner<VolumeMap>>} */ (
    runner('volume', ({ session }) => session.maps.volume?.status === 'cancelled', (map) => volumeInWords(store.state, map), startJob('mapWorkspace'))
  ); // prettier-ignore
  const sections = /** @type {ReturnType<typeof runner<SectionMap>>} */ (
    runner('section', ({ session }) => session.maps.section?.status === 'cancelled', (map) => sectionInWords(store.state, map), null)
  ); // prettier-ignore
  const far = { volume: createProgress({ ...VOLUME }), oriented: createProgress({ ...ORIENTED }), section: createProgress({ ...SECTION }) }; // prettier-ignore

  function followVolume() {
    const wanted = volumeQuestion(store.state, chain());
    const now = store.state.session.maps.volume;
    if (!wanted) {
      volumes.mapper.rest();
      if (now) put({ volume: null });
      return;
    }
    const { volume, points } = wanted;
    const placesKey = points?.key ?? now?.placesKey ?? null;
    const isSame = now?.key === volume.key;
    if (isSame && now.status === 'cancelled') return volumes.mapper.stop();
    if (isSame && now.placesKey === placesKey) return;
    const isNewPoints = points !== null && now?.placesKey !== points.key;
    /** @type {Asked[]} */
    const questions = [];
    if (points && isNewPoints) questions.push({ chain: points.chain, job: { kind: 'cloud', options: points.options } });
    if (!isSame || now.status !== 'done') {
      questions.push({ chain: volume.chain, job: { kind: 'volume', options: volume.options } });
    }
    const old = now ?? { cubes: null, surface: null, summary: null, hasValues: false, places: [] };
    let isFirst = true;
    volumes.run(
      { ...old, ...begun(volume.key), isStale: !isSame, placesKey },
      questions,
      store.state.session.workspace?.tool === 'any' ? far.volume : far.oriented,
      ({ places }, word) => {
        if (word.places) {
          const before = isFirst ? [] : places;
          isFirst = false;
          return { places: [...before, word.places] };
        }
        if (!word.voxels || !word.surface) return {};
        const { voxels: cubes, surface, summary = null } = word;
        return { cubes, surface, summary, hasValues: false, isStale: false };
      },
      (_, found) =>
        found.kind === 'volume'
          ? { cubes: found.voxels, surface: found.surface, summary: found.summary, hasValues: true }
          : {},
    );
  }

  function followSection() {
    const wanted = sectionQuestion(store.state, chain());
    const now = store.state.session.maps.section;
    if (!wanted) {
      sections.mapper.rest();
      if (now) put({ section: null });
      return;
    }
    if (now?.key === wanted.key) {
      if (now.status === 'cancelled') sections.mapper.stop();
      return;
    }
    const old = now ?? { first: null, section: null };
    sections.run(
      { ...old, ...begun(wanted.key), hasNone: false }, // what is drawn stays until there is a first picture
      [{ chain: wanted.chain, job: { kind: 'section', options: wanted.options } }],
      far.section,
      (_, { first }) => (first ? { first, section: null, isStale: false } : {}),
      ({ isStale, first }, found) => {
        if (found.kind !== 'section') return {};
        const { section } = found;
        return { section, hasNone: section === null, first: isStale ? null : first };
      },
    );
  }

  // the question is on its way before the panel is made
  addView(
    ({ session }) => session.tab === 'workspace' && session.workspace === null,
    (isFirst) => isFirst && queueMicrotask(() => look(page, {})),
  );
  for (const [follow, name] of /** @type {const} */ ([
    [followVolume, 'volume'],
    [followSection, 'section'],
  ])) {
    // prettier-ignore
    addView(
      together(({ doc, session }) => [
        doc.robot,
        session.workspace,
        session.tab === 'workspace',
        session.maps[name] === null,
        session.maps[name]?.status === 'cancelled',
      ]),
      () => queueMicrotask(follow), // not while views are drawn, but still in this frame
    );
  }
}
