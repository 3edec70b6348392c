/**
 * Files of controller code: bytes → text, and back as they came. Programs of controllers are often older than UTF-8.
 *
 * @typedef {{ bytes: Uint8Array, text: string, lineEnd: string, isOld: boolean }} CodeBytes
 *   text: with "\n" alone; isOld: Windows-1252, not UTF-8
 */
const ANY_END = /\r\n?|\n/g;
const MARK = [0xef, 0xbb, 0xbf];

/** @param {Uint8Array} bytes @returns {CodeBytes} */
export function decodeCode(bytes) {
  let text;
  let isOld = false;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    text = new TextDecoder('windows-1252').decode(bytes);
    isOld = true;
  }
  return { bytes, text: text.replace(ANY_END, '\n'), lineEnd: /\r\n?|\n/.exec(text)?.[0] ?? '\n', isOld };
}

/**
 * A text as bytes of the form that it came in: the very same where nothing was altered.
 * @param {string} text
 * @param {CodeBytes} came
 * @returns {Uint8Array}
 */
export function encodeCode(text, { bytes, text: before, lineEnd, isOld }) {
  const plain = text.replace(ANY_END, '\n');
  if (plain === before) return bytes;
  const written = plain.replaceAll('\n', lineEnd);
  const codes = Array.from(written, (sign) => Number(sign.codePointAt(0)));
  // of Windows-1252 what is as in Latin-1
  if (isOld && codes.every((code) => code < 0x80 || (code >= 0xa0 && code < 0x100))) return Uint8Array.from(codes);
  const isMarked = MARK.every((byte, i) => bytes[i] === byte);
  return Uint8Array.from([...(isMarked ? MARK : []), ...new TextEncoder().encode(written)]);
}
