/** The two conventions, and the ways from one to the other. */

export const CONVENTION = {
  name: { standard: 'standard', modified: 'modified (Craig)' },
  detail: {
    standard: 'Frame i sits at the far end of link i.',
    modified: 'Frame i sits on the axis of joint i.',
  },
  convert: (/** @type {string} */ name) => `Convert to ${name}`,
  convertDetail: 'Same robot, other numbers. The arm does not move.',
  convertedTo: (/** @type {string} */ name) =>
    `Converted to ${name}: other numbers, the same robot; the arm has not moved.`,
  baseChanged: 'The base changed with the table.',
  toolChanged: 'The tool changed with the table.',
  reread: (/** @type {string} */ name) => `Read the numbers as ${name}`,
  rereadDetail: 'Same numbers, another robot. The arm changes shape.',
  rereadAs: (
    /** @type {string} */ name,
    /** @type {'standard' | 'modified'} */ convention,
    /** @type {string} */ distance,
  ) =>
    `The numbers are read as ${name} now: another robot, since a and α of a row come ${convention === 'modified' ? 'before its joint, no longer after it' : 'after its joint, no longer before it'}. The tool moved by ${distance}.`,
};
