/** Postures that have a name. */

export const GO_TO = {
  name: { home: 'Home', zero: 'Zero', middle: 'Middle of the limits' },
  detail: {
    home: 'The home value of each joint.',
    zero: 'Every joint value 0: the table’s own figure.',
    middle: 'Half way between the limits of each joint.',
  },
  published: (/** @type {string} */ note, /** @type {string} */ source) =>
    `${note[0].toUpperCase()}${note.slice(1)}. Source: ${source}.`,
  outside: (/** @type {readonly string[]} */ joints) =>
    joints.length === 1
      ? `${joints[0]} is past its limits there.`
      : `${joints.slice(0, -1).join(', ')} and ${joints.at(-1)} are past their limits there.`,
  recorded: 'Recorded in this document.',
  went: (/** @type {string} */ name) => `The arm is at ${name}.`,
};
