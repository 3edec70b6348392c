/** The Denavit–Hartenberg table and its parameters. */

export const TABLE = {
  title: 'Denavit–Hartenberg table',
  conventionName: { standard: 'Standard DH', modified: 'Modified DH (Craig)' },
  conventionOrder: {
    standard: 'Rz(θ) · Tz(d) · Tx(a) · Rx(α)',
    modified: 'Rx(α) · Tx(a) · Rz(θ) · Tz(d)',
  },
  joint: 'Joint',
  lower: 'lower',
  upper: 'upper',
  jointType: { revolute: 'revolute', prismatic: 'prismatic', continuous: 'continuous' },
  unlimited: 'none',
  cell: (/** @type {number} */ joint, /** @type {string} */ field, /** @type {string} */ unit) =>
    `Joint ${joint}, ${field}, ${unit}`,
  fieldName: {
    theta: 'joint angle θ',
    d: 'link offset d',
    a: 'link length a',
    alpha: 'link twist α',
    lower: 'lower limit',
    upper: 'upper limit',
    home: 'home',
  },
  unitName: { mm: 'millimetres', cm: 'centimetres', m: 'metres', deg: 'degrees', rad: 'radians' },
  hint: 'Each row leads from one joint axis to the next. Choose a cell to see what it means and change it: 431.8, 12 in, pi/2 rad.',
  source: 'Source',
  keeps: (/** @type {string} */ value) => `The arm keeps ${value}.`,
  stays: (/** @type {string} */ value) => `It stays at ${value}.`,
  waits: (/** @type {string} */ value) => `The arm waits with ${value} until this is settled.`,
  waitsPlainly: (/** @type {string} */ value) => `It stays at ${value} until this is settled.`,
  loading: '…',
  paste: 'Paste table',
  copy: 'Copy table',
  takeBack: 'Take back',
  toWaiting: 'To that cell',
  escape: 'Esc',
  disagrees: (/** @type {string} */ text) =>
    `The file says that ${text} was typed for this, which is another value. The arm follows the number.`,
};

/** What a parameter is, by convention; i counts joints from 1. */
export const DEFINITION = {
  standard: {
    theta: (/** @type {number} */ i) => `Joint angle: from axis x${sub(i - 1)} to x${sub(i)}, about z${sub(i - 1)}.`,
    d: (/** @type {number} */ i) => `Link offset: from x${sub(i - 1)} to x${sub(i)}, along z${sub(i - 1)}.`,
    a: (/** @type {number} */ i) => `Link length: from axis z${sub(i - 1)} to axis z${sub(i)}, along x${sub(i)}.`,
    alpha: (/** @type {number} */ i) => `Link twist: from axis z${sub(i - 1)} to axis z${sub(i)}, about x${sub(i)}.`,
  },
  modified: {
    theta: (/** @type {number} */ i) => `Joint angle: from axis x${sub(i - 1)} to x${sub(i)}, about z${sub(i)}.`,
    d: (/** @type {number} */ i) => `Link offset: from x${sub(i - 1)} to x${sub(i)}, along z${sub(i)}.`,
    a: (/** @type {number} */ i) => `Link length: from axis z${sub(i - 1)} to axis z${sub(i)}, along x${sub(i - 1)}.`,
    alpha: (/** @type {number} */ i) =>
      `Link twist: from axis z${sub(i - 1)} to axis z${sub(i)}, about x${sub(i - 1)}.`,
  },
  variable: (/** @type {number} */ i) => `This is the constant part; the joint value q${sub(i)} adds to it.`,
  lower: 'The joint value may not go below this; empty: no limit.',
  upper: 'The joint value may not go above this; empty: no limit.',
  home: 'Where the joint stands at home.',
};

/** @param {number} index */
const sub = (index) => [...String(index)].map((digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]).join('');
