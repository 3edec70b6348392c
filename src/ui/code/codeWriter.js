/**
 * Keeps written code to what the model is: writes anew, in slices, whenever what it is written of is another, or the language or
 * an option.
 *
 * @import { Page } from '../page.js'
 * @import { CodeSource } from '../../model/controller/codeSource.js'
 * @import { CodeOptions, WrittenCode } from '../../model/controller/writeCode.js'
 * @import { CodeFormat } from '../../model/document.js'
 */
import { codeSources, sourceKey } from '../../model/controller/codeSource.js';
import { formatOf, keptOptions, optionsFor, sourceWord, withOptions } from '../../model/controller/codeOptions.js';
import { writeCode } from '../../model/controller/writeCode.js';
import { inSlices } from '../../model/inSlices.js';
import { attempt } from '../page.js';

/**
 * @param {Page} page
 * @param {object} given
 * @param {string} given.version
 * @param {() => string} given.today   ISO 8601
 * @param {() => void} given.onChange  something of it is another
 * @param {() => void} given.onProgress  it goes on; nothing else is another
 */
export function createCodeWriter(page, { version, today, onChange, onProgress }) {
  const { store, clock, messages } = page;
  /** Of robots whose maker has no language here: what was chosen last. @type {CodeFormat} */
  let usual = 'pair';
  /** @type {WrittenCode | null} */
  let written = null;
  /** @type {number | null} null: nothing is under way */
  let progress = null;
  /** @type {readonly unknown[]} that the last was written of, or is being written of */
  let inputs = [];
  let cancel = () => {};
  /** To be done with what is being written, once it is. @type {(() => void) | null} */
  let next = null;

  const sources = () => codeSources(store.state.doc);
  /** @returns {CodeSource | null} null: there is nothing to write */
  function source() {
    const { doc, session } = store.state;
    const all = sources();
    const playing = `program:${session.playback?.program}`;
    const find = (/** @type {string | undefined} */ word) => all.find((one) => sourceWord(one) === word);
    return find(keptOptions(doc).source) ?? find(playing) ?? all[0] ?? null;
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
  const format = () => formatOf(store.state.doc, usual);
  /** @returns {CodeOptions} */
  const options = () => {
    const now = source();
    return now ? optionsFor(store.state.doc, format(), now) : {};
  };

  function update() {
    const { doc, gesture } = store.state;
    if (gesture !== null) return; // once the hand is off it
    const now = source();
    const asked = [
      ...[doc.robot, doc.frames, doc.activeTool, doc.targets, doc.postures, doc.motionPrograms],
      ...[now && sourceKey(now), format(), doc.codeOptions],
    ];
    if (asked.length === inputs.length && asked.every((value, i) => value === inputs[i])) return;
    inputs = asked;
    cancel();
    progress = null;
    if (now === null) {
      [written, next] = [null, null];
      return onChange();
    }
    progress = 0;
    onProgress();
    const request = { source: now, format: format(), options: options(), start: start(), version };
    cancel = inSlices(writeCode(doc, { ...request, generatedAt: today().replace(/\.\d+/, '') }), clock, {
      onProgress(share) {
        progress = share;
        onProgress();
      },
      onDone(result) {
        [written, progress] = [result, null];
        onChange();
        next?.();
        next = null;
      },
      onFault(error) {
        [written, progress, next] = [null, null, null];
        onChange();
        messages.fault(error);
      },
    });
  }

  /** @param {Parameters<typeof withOptions>[1]} change  of what the model keeps @returns {string | null} what is against it */
  function choose(change) {
    const reason = attempt(page, { type: 'set-code-options', text: withOptions(store.state.doc, change) });
    update();
    return reason;
  }

  return {
    ...{ update, sources, source, start, format, options, choose },
    /** As it was last written; null: nothing has been. */
    written: () => (source() === null ? null : written),
    progress: () => progress,
    /** Now, or once what is being written is: what is seen may not yet be what was chosen. @param {() => void} act */
    whenWritten(act) {
      update();
      if (progress === null) act();
      else next = act;
    },
    /** @param {CodeFormat} chosen */
    setFormat(chosen) {
      usual = chosen;
      choose({ format: chosen });
    },
    /** @param {string} word */
    setSource: (word) => choose({ source: word, programName: undefined, speed: undefined }),
  };
}

/** @typedef {ReturnType<typeof createCodeWriter>} CodeWriter */
