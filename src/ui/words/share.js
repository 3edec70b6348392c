/** The dialog with the link. */

/** Characters from which on a word of care is in place. No limit that is known: places differ, and change theirs. */
const LONG = 2000;

const count = (/** @type {number} */ n) => n.toLocaleString('en-GB');

export const SHARE = {
  title: (/** @type {string} */ robot) => `Share “${robot}”`,
  what: 'Whoever opens the link gets a copy of the model as it stands now. All of it is in the link itself: nothing is stored on a server, and later changes do not reach it.',
  link: 'The link',
  with: { view: 'As it is seen now: camera, frames, workspace', panels: 'With the panels that are open' },
  /** @param {number} n @returns {[words: string, isLong: boolean]} */
  length: (n) =>
    n <= LONG
      ? [`${count(n)} characters.`, false]
      : [
          `${count(n)} characters: mail or a chat may cut it. A link that was cut says so; a file goes everywhere.`,
          true,
        ],
  tooLarge: 'The model is too large for a link (1 MB of text). Send it as a file.',
  copy: 'Copy the link',
  copied: 'The link is copied',
  copyFailed: 'The browser did not let the page copy; the link is selected, so copy it with the keyboard.',
  saveFile: 'Save as a file',
};
