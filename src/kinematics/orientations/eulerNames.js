/**
 * Who writes an orientation in which Euler sequence (eulerAngles.js), and what the three angles are called there, in the
 * order of the sequence. Only what is known for certain: a controller that is not here is not thereby one that has none.
 *
 * Sources: Craig, "Introduction to Robotics", section 2.8; Siciliano et al., "Robotics", section 2.4; Spong et al., "Robot Modeling
 * and Control", section 2.5; Goldstein, "Classical Mechanics", section 4.4; for FANUC, KUKA, Yaskawa, Mitsubishi and
 * Kawasaki the pose formats in the manual of the rc_visard camera; for Stäubli the table of conventions in Mech-Mind's manual;
 * OrientZYX in ABB's RAPID reference; "ZYZ' Euler values" in the V+ language guide. Universal Robots show a rotation vector
 * (axisAngle.js), ABB a quaternion with the scalar first (quaternion.js).
 * @import { EulerSequence } from './eulerAngles.js'
 *
 * @typedef {object} EulerName
 * @property {string} name
 * @property {EulerSequence} sequence
 * @property {readonly [string, string, string]} angles
 */

/** @type {readonly Readonly<EulerName>[]} */
export const EULER_NAMES = Object.freeze(
  /** @type {EulerName[]} */ ([
    { name: 'FANUC', sequence: 'xyz', angles: ['W', 'P', 'R'] },
    { name: 'Yaskawa', sequence: 'xyz', angles: ['Rx', 'Ry', 'Rz'] },
    { name: 'Mitsubishi', sequence: 'xyz', angles: ['A', 'B', 'C'] },
    { name: 'URDF, SDFormat', sequence: 'xyz', angles: ['roll', 'pitch', 'yaw'] },
    { name: 'Craig, X–Y–Z fixed angles', sequence: 'xyz', angles: ['γ', 'β', 'α'] },
    { name: 'KUKA', sequence: 'ZYX', angles: ['A', 'B', 'C'] },
    { name: 'ABB OrientZYX', sequence: 'ZYX', angles: ['Z', 'Y', 'X'] },
    { name: 'Craig, Z–Y–X Euler angles', sequence: 'ZYX', angles: ['α', 'β', 'γ'] },
    { name: 'Siciliano, RPY angles', sequence: 'ZYX', angles: ['φ', 'ϑ', 'ψ'] },
    { name: 'aircraft', sequence: 'ZYX', angles: ['yaw', 'pitch', 'roll'] },
    { name: 'Stäubli', sequence: 'XYZ', angles: ['Rx', 'Ry', 'Rz'] },
    { name: 'three.js, default order', sequence: 'XYZ', angles: ['x', 'y', 'z'] },
    { name: 'Kawasaki', sequence: 'ZYZ', angles: ['O', 'A', 'T'] },
    { name: 'V+', sequence: 'ZYZ', angles: ['yaw', 'pitch', 'roll'] },
    { name: 'Craig, Z–Y–Z Euler angles', sequence: 'ZYZ', angles: ['α', 'β', 'γ'] },
    { name: 'Spong, Euler angles', sequence: 'ZYZ', angles: ['φ', 'θ', 'ψ'] },
    { name: 'Goldstein, x convention', sequence: 'ZXZ', angles: ['φ', 'θ', 'ψ'] },
  ]).map(({ name, sequence, angles }) => Object.freeze({ name, sequence, angles: Object.freeze(angles) })),
);
