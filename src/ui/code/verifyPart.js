/**
 * Below the code: verifying what is shown, and saving it if nothing is against that.
 *
 * @import { Page } from '../page.js'
 * @import { RegisterSetting } from '../../model/code/givenRegisters.js'
 * @import { Verified } from './codeVerifier.js'
 * @import { CodeWriter } from './codeWriter.js'
 * @import { Verification } from '../../model/controller/verifyCode.js'
 * @import { ProgramDoc } from '../../model/document.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 */
import $ from 'jquery/slim';
import { recertified } from '../../model/controller/certificate.js';
import { certified } from '../../model/controller/writeCode.js';
import { attempt } from '../page.js';
import { fill, h } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { fixed } from '../parts/format.js';
import { VERIFY } from '../words/writeCode.js';
import { createCodeVerifier } from './codeVerifier.js';
import { savedCode } from './openCode.js';
import { ownQuestion } from './ownLine.js';
import { drawVerification } from './verificationView.js';

/**
 * @param {Page} page
 * @param {object} given
 * @param {CodeWriter} given.writer
 * @param {() => ProgramDoc | null} given.ownChosen  null: what is written is shown
 * @param {() => void} given.redraw
 * @param {string} given.version
 * @param {() => string} given.today
 * @param {() => readonly RegisterSetting[]} given.given  what registers hold at first
 */
export function createVerifyPart(page, { writer, ownChosen, redraw, version, today, given }) {
  const { store, clock, announce } = page;
  const verifier = createCodeVerifier(page, redraw, draw);
  const element = h('section', { class: 'verify', 'aria-label': VERIFY.region, hidden: true });
  /** What a person has read. @type {Verified | null} */
  let closed = null;

  /** Whose code is shown. */
  const about = () => ownChosen() ?? writer.written();
  const foundNow = () => verifier.found(about());

  /** @param {Verified} found */
  function saveIfSound(found) {
    clock.onFrame(() => element.scrollIntoView({ block: 'nearest' })); // when it is drawn
    if (found.verification.findings.some(({ severity }) => severity === 'error')) return announce(VERIFY.notSaved);
    found.fate = 'saved';
    save(found.files, VERIFY.saved);
  }

  /** Texts of the document that do what their program does get their certificate, in one step to undo. @param {Verified} found @param {readonly string[]} ids */
  function certifyOwn(found, ids) {
    const { matches, isCompared, deviation } = found.verification;
    if (!matches || !isCompared) return;
    const { robot, programs } = store.state.doc;
    const files = recertified(found.files, robot, version, deviation);
    if (!files) return;
    found.files = files;
    const changed = programs.map((program) => {
      const i = ids.indexOf(program.id);
      const text = files[i]?.text.replaceAll('\r\n', '\n') ?? program.text;
      return text === program.text ? program : { ...program, text };
    });
    attempt(page, { type: 'set-code', programs: changed });
    verifier.follow(ownChosen());
  }

  /** @param {readonly CodeFile[]} files @param {(names: string) => string} said */
  function save(files, said) {
    for (const file of files) download(file.name, savedCode(page, file), 'text/plain', clock);
    announce(said(files.map(({ name }) => name).join(', ')));
  }

  $(element)
    .on('click', '[data-action=cancel]', () => {
      toVerify();
      verifier.giveUp();
      announce(VERIFY.cancelled);
    })
    .on('click', '[data-action=force]', () => {
      const found = foundNow();
      if (!found) return;
      found.fate = 'forced';
      save(found.files, VERIFY.savedUnverified);
      toVerify();
      redraw();
    })
    .on('click', '[data-action=close-found]', () => {
      closed = foundNow();
      toVerify();
      draw();
    });

  /** To the button that began it, from one that goes. */
  function toVerify() {
    const button = element.parentElement?.querySelector('[data-action=verify]');
    if (element.contains(document.activeElement) && button instanceof HTMLElement) button.focus();
  }

  const bar = h('progress', { max: 1, 'aria-label': VERIFY.region });
  const share = h('p', {});
  const underWay = h(
    'div',
    { class: 'verify-head' },
    ...[bar, share],
    h('button', { type: 'button', class: 'btn btn-small btn-outline', 'data-action': 'cancel' }, VERIFY.cancel),
  );

  function draw() {
    const [progress, found] = [verifier.progress(about()), foundNow()];
    const isWhole = element.querySelector('.verify-moves')?.hasAttribute('open') ?? false;
    element.hidden = progress === null && (found === null || found === closed);
    if (progress !== null) {
      bar.value = progress;
      share.textContent = VERIFY.isRunning(fixed(100 * progress, 0));
      if (!underWay.isConnected) fill(element, underWay);
    } else {
      if (underWay.isConnected) toVerify();
      fill(element, found ? drawVerification(found, store.state.doc.robot, isWhole) : null);
    }
  }

  function verifyWritten() {
    const written = writer.written();
    if (!written?.made) return;
    const { doc, made, request, files } = written;
    const question = {
      ...{ files, about: written },
      *prepare() {
        yield 0;
        return { doc, made, start: request.start };
      },
      *finish(/** @type {Verification} */ verification) {
        return verification.matches ? yield* certified(written, verification) : files;
      },
    };
    verifier.ask(question, saveIfSound);
  }

  return {
    element,
    verify() {
      const own = ownChosen();
      if (own) {
        const question = { ...ownQuestion(page, writer, own, { version, today }), given: given() };
        return verifier.ask(question, (found) => {
          certifyOwn(found, question.ids);
          saveIfSound(found);
        });
      }
      writer.whenWritten(verifyWritten);
    },
    /** What was written, with its certificate, if it has been verified as it is. */
    filesSaved() {
      const written = writer.written();
      const found = written && verifier.found(written);
      return found && found.fate === 'saved' ? found.files : null;
    },
    draw,
  };
}
