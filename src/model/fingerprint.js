/**
 * A short number that another text has only by a chance of one in four thousand million, to notice that a text was damaged
 * on its way (FNV-1a over UTF-16 code units; a change of one of them is always noticed). It keeps no secret.
 * @param {string} text
 * @returns {string} 8 hexadecimal digits
 */
export function fingerprint(text) {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, '0');
}
