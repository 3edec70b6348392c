/**
 * The named postures of arms of the library, as their published models give them, in millimetres and degrees.
 *
 * @typedef {{ readonly name: string, readonly note: string, readonly q: readonly number[], readonly source: string }} PublishedPosture
 */
import { deepFreeze } from '../freeze.js';

/** @param {string} model @param {string} symbol @param {string} [more] */
const toolbox = (model, symbol, more = '') =>
  `${symbol} of ${model} in Robotics Toolbox for Python @a9ed8d4${more && `; ${more}`}`;

/** @param {string} model */
const universal = (model) => [
  { name: 'ready', note: 'arm level, along x', q: [180, 0, 0, 0, 90, 0], source: toolbox(model, 'qr') },
];
/** @param {string} model */
const kinova = (model) => [
  {
    name: 'ready',
    note: 'arm upright',
    q: [-270, 180, 180, 0, 0, 0],
    source: toolbox(model, 'qr', 'joint 1 counted the other way, as in this table'),
  },
];

/** @type {Readonly<Record<string, readonly PublishedPosture[]>>} keys are ids of the library */
export const PUBLISHED_POSTURES = deepFreeze({
  planar2r: [
    { name: 'q1', note: 'one link level, one upright', q: [0, 90], source: toolbox('Planar2', 'q1') },
    { name: 'q2', note: 'one link upright, one level', q: [90, -90], source: toolbox('Planar2', 'q2') },
  ],
  puma560: [
    { name: 'ready', note: 'arm upright', q: [0, 90, -90, 0, 0, 0], source: toolbox('Puma560', 'qr') },
    { name: 'stretched', note: 'arm straight and level', q: [0, 0, -90, 0, 0, 0], source: toolbox('Puma560', 'qs') },
    {
      name: 'nominal',
      note: 'working over a table, away from singularities',
      q: [0, 45, -180, 0, 45, 0],
      source: toolbox('Puma560', 'qn', 'joint 3 a whole turn back, inside its limits'),
    },
  ],
  kuka_kr5_arc: [
    { name: 'working 1', note: 'a working posture', q: [45, 60, 45, 30, 45, 30], source: toolbox('KR5', 'qk1') },
    { name: 'working 2', note: 'a working posture', q: [45, 60, 30, 60, 45, 30], source: toolbox('KR5', 'qk2') },
    { name: 'working 3', note: 'a working posture', q: [30, 60, 30, 60, 30, 60], source: toolbox('KR5', 'qk3') },
  ],
  abb_irb140: [
    { name: 'ready', note: 'arm upright', q: [0, -90, 90, 0, 90, -90], source: toolbox('IRB140', 'qr') },
    { name: 'data sheet', note: 'lower arm level', q: [0, -90, 180, 0, 0, -90], source: toolbox('IRB140', 'qd') },
  ],
  ur3: universal('UR3'),
  ur5: universal('UR5'),
  ur10: universal('UR10'),
  kinova_mico: kinova('Mico'),
  kinova_jaco: kinova('Jaco'),
});
