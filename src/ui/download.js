/**
 * Hand a text to the person as a file.
 * @import { Clock } from '../model/clock.js'
 */

/** A browser may begin to read what is downloaded a while after it was asked to. */
const KEPT_SECONDS = 60;

/**
 * @param {string} name
 * @param {string} text
 * @param {string} type  media type
 * @param {Clock} clock
 */
export function download(name, text, type, clock) {
  const url = URL.createObjectURL(new Blob([text], { type: `${type};charset=utf-8` }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  clock.after(KEPT_SECONDS, () => URL.revokeObjectURL(url));
}
