/**
 * Hand a text, or what is no text, to the person as a file.
 * @import { Clock } from '../../model/clock.js'
 */

/** A browser may begin to read what is downloaded a while after it was asked to. */
const KEPT_SECONDS = 60;

/**
 * @param {string} name
 * @param {string | Blob} content
 * @param {string} type  media type
 * @param {Clock} clock
 */
export function download(name, content, type, clock) {
  const url = URL.createObjectURL(
    content instanceof Blob ? content : new Blob([content], { type: `${type};charset=utf-8` }),
  );
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  clock.after(KEPT_SECONDS, () => URL.revokeObjectURL(url));
}
