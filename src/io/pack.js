/**
 * Text as few letters, and back. What comes back is never more than `MOST_BYTES`, however much the letters stand for: a text
 * of zeros of a thousand times their length is given up long before it is made.
 *
 * @typedef {'cut' | 'damaged' | 'too-large'} PackFault
 */
import { Inflate, deflateSync, strToU8 } from 'fflate';
import { fromBase64url, toBase64url } from './base64url.js';
import { MAX_TEXT_LENGTH } from './fileLimits.js';
import { LINK_DICTIONARY } from './linkDictionary.js';

const MOST_BYTES = MAX_TEXT_LENGTH;
/** No model is so dull that it shrinks to less than a 300th; short ones may. */
const MOST_TIMES = 300;
const SHORT = 64 * 1024;
/** Bytes taken in at a time; deflate makes at most 1032 times as many of them. */
const BITE = 2048;
/** fflate's number for a stream that ends before its end. */
const UNEXPECTED_END = 0;

const dictionary = () => strToU8(LINK_DICTIONARY);

/** @param {string} text @returns {string | null} null when it is more than `unpack` would take */
export function pack(text) {
  const bytes = strToU8(text);
  if (bytes.length > MOST_BYTES) return null;
  const packed = toBase64url(deflateSync(bytes, { level: 9, mem: 6, dictionary: dictionary() }));
  return 'text' in unpack(packed) ? packed : null;
}

/** @param {string} letters @returns {{ text: string } | { fault: PackFault }} */
export function unpack(letters) {
  const bytes = fromBase64url(letters);
  if (!bytes) return { fault: letters.length % 4 === 1 ? 'cut' : 'damaged' };
  if (bytes.length === 0) return { fault: 'cut' };
  const most = Math.min(MOST_BYTES, SHORT + MOST_TIMES * bytes.length);
  /** @type {Uint8Array[]} */
  const parts = [];
  let length = 0;
  const inflate = new Inflate({ dictionary: dictionary() }, (part) => {
    length += part.length;
    parts.push(part);
  });
  try {
    for (let at = 0; at < bytes.length; at += BITE) {
      inflate.push(bytes.subarray(at, at + BITE), at + BITE >= bytes.length);
      if (length > most) return { fault: 'too-large' };
    }
    return { text: new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(joined(parts, length)) };
  } catch (error) {
    const isCut = error instanceof Error && 'code' in error && error.code === UNEXPECTED_END;
    return { fault: isCut ? 'cut' : 'damaged' };
  }
}

/** @param {readonly Uint8Array[]} parts @param {number} length */
function joined(parts, length) {
  const all = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
