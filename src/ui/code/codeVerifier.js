/**
 * Runs code on the model, in slices, and keeps what was found for as long as the texts are the same.
 *
 * @import { Page } from '../page.js'
 * @import { RegisterSetting } from '../../model/code/givenRegisters.js'
 * @import { Doc } from '../../model/document.js'
 * @import { MadeProgram } from '../../model/controller/neutralProgram.js'
 * @import { Verification } from '../../model/controller/verifyCode.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 *
 * @typedef {object} Verified
 * @property {readonly CodeFile[]} files
 * @property {Verification} verification
 * @property {'saved' | 'refused' | 'forced'} fate
 *
 * @typedef {object} VerifyQuestion
 * @property {readonly CodeFile[]} files      the first is the one to run
 * @property {() => Generator<number, { doc: Doc, made: MadeProgram | null, start: readonly number[] }>} prepare  what to compare with
 * @property {unknown} about                  whose it is: compared by identity
 * @property {readonly RegisterSetting[]} [given]   what registers hold at first
 * @property {(verification: Verification) => Generator<number, readonly CodeFile[]>} [finish]  the files as they are to be saved
 */
import { verifyInSlices } from '../../model/controller/verifyCode.js';
import { inSlices } from '../../model/inSlices.js';

/**
 * @param {Page} page
 * @param {() => void} onChange
 * @param {() => void} onProgress  it goes on; nothing else is another
 */
export function createCodeVerifier({ clock, messages }, onChange, onProgress) {
  /** @type {number | null} */
  let progress = null;
  /** @type {{ about: unknown, verified: Verified } | null} */
  let last = null;
  /** @type {unknown} */
  let asked = null;
  let cancel = () => {};

  return {
    /** The share that is done; null: nothing is under way. @param {unknown} about */
    progress: (about) => (asked === about ? progress : null),
    /** @param {unknown} about @returns {Verified | null} */
    found: (about) => (last && last.about === about ? last.verified : null),
    /** @param {VerifyQuestion} question @param {(verified: Verified) => void} onDone  may change the fate */
    ask({ files: read, prepare, about, finish, given }, onDone) {
      cancel();
      [progress, asked, last] = [0, about, null];
      cancel = inSlices(job(), clock, {
        onProgress(share) {
          progress = share;
          onProgress();
        },
        onDone({ verification, files }) {
          progress = null;
          const verified = { files, verification, fate: /** @type {const} */ ('refused') };
          last = { about, verified };
          onDone(verified);
          onChange();
        },
        onFault(error) {
          progress = null;
          onChange();
          messages.fault(error);
        },
      });
      onChange();

      function* job() {
        const { doc, made, start } = yield* prepare();
        const verification = yield* verifyInSlices(doc, made, read, start, given);
        return { verification, files: finish ? yield* finish(verification) : read };
      }
    },
    /** What was found holds for the same code as another object, too. @param {unknown} about */
    follow(about) {
      if (last) last.about = about;
    },
    giveUp() {
      cancel();
      progress = null;
      onChange();
    },
  };
}

/** @typedef {ReturnType<typeof createCodeVerifier>} CodeVerifier */
