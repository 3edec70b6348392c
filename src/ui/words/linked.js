/** A link that was opened. */

export const LINKED = {
  name: 'The link',
  opened: (/** @type {string} */ robot, /** @type {number} */ remarks) =>
    `Opened from the link: “${robot}”${remarks === 0 ? '' : `, with ${remarks === 1 ? 'a remark' : `${remarks} remarks`}`}.`,
  remarks: 'Show',
};
