/**
 * Text of unknown origin made fit for a message: short, on one line, with nothing in it that hides or reorders.
 */
const LONGEST = 80;

/** Control, format (direction marks, zero width), surrogate and line-separating characters, and unusual blanks. */
const UNSEEN = /[\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}]|(?! )\p{Zs}/gu;

/** What nearly every text is, and is shown as it stands. */
const PLAIN = /^[ -~]*$/;

/**
 * @example
 * shownText('12,5') // → '12,5'
 * shownText('a\tb') // → 'a\\u{9}b'
 * @param {string} text
 * @returns {string} at most 80 characters; a longer text ends in …
 */
export function shownText(text) {
  if (text.length <= LONGEST && PLAIN.test(text)) return text;
  const characters = Array.from(text.slice(0, 4 * LONGEST), visible);
  const cut = text.length > 4 * LONGEST || characters.join('').length > LONGEST;
  let shown = '';
  for (const character of characters) {
    if (shown.length + character.length > (cut ? LONGEST - 1 : LONGEST)) break;
    shown += character;
  }
  return cut ? `${shown}…` : shown;
}

/** @param {string} character */
const visible = (character) => character.replace(UNSEEN, escaped);

/** @param {string} character */
const escaped = (character) => `\\u{${character.codePointAt(0)?.toString(16).toUpperCase()}}`;
