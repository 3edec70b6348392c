/**
 * Keeps written code to what the model is: writes anew, in slices, whenever what it is written of is another, or the language or
 * an option.
 *
 * @import { Page } from '../page.js'
 * @import { CodeSource } from '../../model/controller/codeSource.js'
 * @import { CodeFormat, CodeOptions, WrittenCode } from '../../model/controller/writeCode.js'
 */
import { codeSources, sourceKey } from '../../model/controller/codeSource.js';
import { optionsFor } from '../../model/controller/codeOptions.js';
import { writeCode } from '../../model/controller/writeCode.js';
import { inSlices } from '../../model/inSlices.js';

/**
 * @param {Page} page
 * @param {object} given
 * @param {string} given.version
 * @param {() => string} given.today   ISO 8601
 * @param {() => void} given.onChange  something of it is another
 */
export function createCodeWriter({ store, clock, messages }, { version, today, onChange }) {
  /** @type {CodeFormat} */
  let format = 'pair';
  /** What a person chose; null: the first. @type {string | null} */
  let wanted = null;
  /** @type {CodeOptions} */
  let options = {};
  /** @type {WrittenCode | null} */
  let written = null;
  /** @type {number | null} null: nothing is under way */
  let progress = null;
  /** @type {readonly unknown[]} that the last was written of, or is being written of */
  let inputs = [];
  let cancel = () => {};

  const sources = () => codeSources(store.state.doc);
  /** @returns {CodeSource | null} null: there is nothing to write */
  function source() {
    const all = sources();
    const playing = `program ${store.state.session.playback?.program}`;
    const find = (/** @type {string | null} */ key) => all.find((one) => sourceKey(one) === key);
    return find(wanted) ?? find(playing) ?? all[0] ?? null;
  }

  /** Where the arm stands when the code begins: as the program is played, or where it is now. */
  function start() {
    const { doc, session } = store.state;
    const { playback } = session;
    return playback && `program ${playback.program}` === keyNow() ? playback.start : doc.posture;
  }
  const keyNow = () => {
    const now = source();
    return now && sourceKey(now);
  };

  function update() {
    const { doc, gesture } = store.state;
    if (gesture !== null) return; // once the hand is off it
    const now = source();
    const next = [
      ...[doc.robot, doc.frames, doc.activeTool, doc.targets, doc.postures, doc.motionPrograms],
      ...[now && sourceKey(now), format, options],
    ];
    if (next.length === inputs.length && next.every((value, i) => value === inputs[i])) return;
    inputs = next;
    cancel();
    progress = null;
    if (now === null) {
      written = null;
      return onChange();
    }
    progress = 0;
    const request = { source: now, format, options: optionsFor(format, options), start: start(), version };
    cancel = inSlices(writeCode(doc, { ...request, generatedAt: today().replace(/\.\d+/, '') }), clock, {
      onProgress(share) {
        progress = share;
        onChange();
      },
      onDone(result) {
        [written, progress] = [result, null];
        onChange();
      },
      onFault(error) {
        [written, progress] = [null, null];
        onChange();
        messages.fault(error);
      },
    });
  }

  return {
    ...{ update, sources, source, start },
    format: () => format,
    options: () => options,
    /** As it was last written; null: nothing has been. */
    written: () => (source() === null ? null : written),
    progress: () => progress,
    /** @param {CodeFormat} next */
    setFormat(next) {
      format = next;
      update();
    },
    /** @param {string} key */
    setSource(key) {
      wanted = key;
      options = { ...options, programName: undefined, speed: undefined };
      update();
    },
    /** @param {CodeOptions} change */
    setOptions(change) {
      options = { ...options, ...change };
      update();
    },
  };
}

/** @typedef {ReturnType<typeof createCodeWriter>} CodeWriter */
