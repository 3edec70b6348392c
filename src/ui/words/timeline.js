/** The timeline of a motion program: its player, and what stops it. */

export const TIMELINE = {
  title: 'Timeline of the program',
  controls: 'Playing',
  previous: 'To the step before',
  play: 'Play',
  pause: 'Pause',
  next: 'To the next step',
  loop: 'Play again and again',
  speed: 'Speed of playing',
  speedOption: (/** @type {number} */ percent) => `${percent} %`,
  plots: 'Plots',
  plotsTitle: 'Plots over time',
  slider: 'Time in the program',
  of: (/** @type {string} */ seconds) => `/ ${seconds} s`,
  at: (/** @type {string} */ time, /** @type {string} */ duration, /** @type {string} */ step) =>
    `${time} of ${duration} seconds${step && `, ${step}`}`,
  step: (/** @type {number} */ number, /** @type {string} */ name) => `step ${number}${name && `, ${name}`}`,
  played: 'Playing.',
  paused: (/** @type {string} */ at) => `Paused at ${at}.`,
  stopped: {
    end: 'The program has ended.',
    refused: 'Here the program stops: the next step cannot be moved.',
    moved: 'Playing has stopped, because the arm was moved otherwise.',
    changed: 'Playing has stopped, because the program or the robot was changed.',
  },
  notPlanned: 'There is nothing to play yet.',
  planning: (/** @type {string} */ percent) => `Planning, ${percent} %`,
  cancel: 'Cancel',
  cancelled: 'Planning was given up.',
  again: 'Plan',
  empty: 'No step of this program moves the arm.',
  /** Why a step is not moved. Short, on a button; `why` is the sentence. */
  refused: {
    limit: (/** @type {number} */ step, /** @type {string} */ joint) => `Step ${step}: ${joint} at its limit`,
    reach: (/** @type {number} */ step) => `Step ${step}: out of reach`,
    orientation: (/** @type {number} */ step) => `Step ${step}: not with this orientation`,
    singularity: (/** @type {number} */ step) => `Step ${step}: a singularity`,
    start: (/** @type {number} */ step) => `Step ${step}: the arm does not stand where it begins`,
    arc: (/** @type {number} */ step) => `Step ${step}: no circle`,
  },
  why: {
    limit: (/** @type {string} */ joint, /** @type {string} */ percent) =>
      `${joint} would have to go past its limit ${percent} % along the way.`,
    reach: (/** @type {string} */ percent) => `The tool does not reach farther than ${percent} % along the way.`,
    orientation: (/** @type {string} */ percent) =>
      `The tool can be ${percent} % along the way, and not farther so turned, without the arm changing its configuration.`,
    singularity: (/** @type {string} */ percent) =>
      `The way leads through a singularity ${percent} % along, where a joint would have to turn without end.`,
    start: 'The way does not begin where the arm stands.',
    arc: 'No circle passes where the arm stands, the point on the way and the end.',
  },
  refusedGhost: 'stops here',
  /** In the view. */
  ghosts: (/** @type {number} */ step) => /** @type {const} */ ([`step ${step} begins`, `step ${step} ends`]),
  path: {
    label: 'Path of the program',
    show: 'Path',
    showTitle: 'Path of the tool over the whole program; the faster, the brighter',
    ghosts: 'Ghosts',
    ghostsTitle: 'The arm where the present step begins and ends',
    dots: (/** @type {string} */ seconds) => `a dot every ${seconds} s`,
  },
  show: 'Show the step.',
  issue: (/** @type {string} */ message) => `Not planned: ${message}`,
};
