/**
 * Above a program of the document: what its certificate says, and verifying it; below, what that has shown.
 *
 * @import { Page } from '../page.js'
 * @import { CodeVerifier } from './codeVerifier.js'
 * @import { CodeWriter } from './codeWriter.js'
 * @import { Doc, ProgramDoc } from '../../model/document.js'
 */
import { readCertificate } from '../../model/controller/certificate.js';
import { codeSet, statusOf } from '../../model/controller/codeSets.js';
import { sourceOfText, sourceKey } from '../../model/controller/codeSource.js';
import { startOfCode } from '../../model/controller/startOfCode.js';
import { madeOf } from '../../model/controller/writeCode.js';
import { h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { CODE } from '../words/code.js';
import { CERTIFICATE, VERIFY } from '../words/writeCode.js';
import { iconButton } from './writtenView.js';

/** @param {Doc} doc @param {ProgramDoc} own */
export function ownLine(doc, own) {
  const status = statusOf(doc.programs, own, doc.robot);
  const certificate = readCertificate(own.text);
  const text =
    status === 'valid' && certificate
      ? CERTIFICATE.valid(fixed(certificate.millimetres, 4), fixed(certificate.degrees, 4))
      : CERTIFICATE[/** @type {'none'} */ (status)];
  const isBad = status === 'altered' || status === 'other-files' || status === 'other-model';
  return h(
    'div',
    { class: `own-line ${isBad ? 'is-warn' : status === 'valid' ? 'is-good' : ''}`.trim() },
    isBad ? icon('exclamation') : status === 'valid' ? icon('checkCircle') : null,
    h('p', { role: 'status' }, text),
    iconButton('copy', 'copy', CODE.copy),
    h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'verify' }, VERIFY.save),
  );
}

/**
 * What is to be verified of a program of the document, and against what.
 * @param {Page} page
 * @param {CodeWriter} writer
 * @param {ProgramDoc} own
 * @param {{ version: string, today: () => string }} given
 */
export function ownQuestion({ store }, writer, own, { version, today }) {
  const { doc } = store.state;
  const set = codeSet(doc.programs, own);
  const files = set.map(({ file }) => file);
  const source = files.map(({ text }) => sourceOfText(doc, text)).find((one) => one !== null) ?? null;
  const now = writer.source();
  const isNow = source && now && sourceKey(source) === sourceKey(now);
  return {
    ...{ files, about: own, ids: set.map(({ program }) => program.id) },
    *prepare() {
      const start = isNow ? writer.start() : doc.posture;
      if (!source) return { doc, made: null, start };
      const brand = own.language === 'krl' ? /** @type {const} */ ('kuka') : /** @type {const} */ ('fanuc');
      const options = isNow ? writer.options() : {};
      const given = { options, start, version, generatedAt: today() };
      const first = yield* madeOf(doc, source, brand, given);
      // Code that goes to where its program began says itself where that was.
      const there = first.made?.moves[0].move.step === -1 ? startOfCode(doc, files) : null;
      if (!there) return { ...first, start };
      return { ...(yield* madeOf(doc, source, brand, { ...given, start: there })), start: there };
    },
  };
}
