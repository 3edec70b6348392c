/** The pendant's numbers, and what a controller calls the posture. */

export const CONTROLLER = {
  isShown: 'Joints are shown as on the pendant.',
  isNotShown: 'Joints are shown as in the table.',
  while: (/** @type {string} */ joint, /** @type {string} */ value) => ` while ${joint} is ${value}`,
  stoppedBy: (/** @type {string[]} */ joints) => `, where ${joints.join(' and ')} would pass its own limit`,
  about: 'The numbers of the controller: J is what the pendant shows, q is the joint value of the table.',
  coupled: (/** @type {string} */ joint, /** @type {string} */ to) =>
    `${joint} counts against ${to}: a new ${to} turns the joint of ${joint} as well, so that the number of ${joint} stays.`,
  lines: 'Pendant and table',
  noData:
    'This robot has no controller data, so the pendant would show the joint values of the table. A FANUC counts J3 from the horizontal; that coupling to J2, signs and zeros come with the robot file, or are set below the table, under the joint.',
  configuration: 'Configuration',
  fanuc: 'FANUC',
  kuka: 'KUKA',
  kukaCode: (/** @type {number} */ status, /** @type {number} */ turn) => `S ${status}, T ${turn}`,
  kukaBits: (/** @type {number} */ status, /** @type {number} */ turn) =>
    `S ${status.toString(2).padStart(3, '0')}, T ${turn.toString(2).padStart(6, '0')} in bits`,
  spoken: (/** @type {string} */ fanuc, /** @type {string} */ kuka) => `Configuration: FANUC ${fanuc}; KUKA ${kuka}.`,
};

/** How the pendant counts one joint. */
export const JOINT_CONTROLLER = {
  group: (/** @type {number} */ joint) => `Joint ${joint} on the pendant`,
  about: 'On the controller’s pendant. It changes numbers only: the arm stays where it is.',
  sign: (/** @type {number} */ joint) => `Joint ${joint} on the pendant counts`,
  signShort: 'Counts',
  signs: { 1: 'as the table', '-1': 'backwards' },
  offset: (/** @type {number} */ joint, /** @type {string} */ unit) => `Joint ${joint} on the pendant at zero, ${unit}`,
  offsetShort: 'At table zero',
  coupledTo: (/** @type {number} */ joint) => `Joint ${joint} on the pendant follows`,
  coupledToShort: 'Follows',
  none: 'no joint',
  coupling: (/** @type {number} */ joint) => `Joint ${joint} on the pendant follows by the factor`,
  couplingShort: 'By the factor',
};
