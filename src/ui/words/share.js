/** The dialog with the link. */

/** Where long links are known to be cut or not taken, and after how many characters. */
const PLACES = /** @type {const} */ ([
  ['Outlook mail', 1024],
  ['Discord', 2000],
  ['Slack', 4000],
]);

const count = (/** @type {number} */ n) => n.toLocaleString('en-GB');

export const SHARE = {
  title: (/** @type {string} */ robot) => `Share “${robot}”`,
  what: 'Whoever opens the link gets a copy of the model as it stands now. All of it is in the link itself: nothing is stored on a server, and later changes do not reach it.',
  link: 'The link',
  with: { view: 'As it is seen now: camera, frames', panels: 'With the panels that are open' },
  /** @param {number} n @returns {[words: string, isLong: boolean]} */
  length(n) {
    const short = PLACES.filter(([, most]) => n > most).map(([name, most]) => `${name} (${count(most)})`);
    if (short.length === 0) return [`${count(n)} characters.`, false];
    const last = short.pop();
    const places = short.length > 0 ? `${short.join(', ')} and ${last}` : last;
    return [`${count(n)} characters: more than ${places} may take whole. A file goes everywhere.`, true];
  },
  tooLarge: 'The model is too large for a link (1 MB of text). Send it as a file.',
  copy: 'Copy the link',
  copied: 'The link is copied',
  copyFailed: 'The browser did not let the page copy; the link is selected, so copy it with the keyboard.',
  saveFile: 'Save as a file',
};
