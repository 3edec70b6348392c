/**
 * The numbers of the Jacobian panel as sheets to copy (copyText.js), in the document's length and in radians.
 *
 * @import { Doc } from '../document.js'
 * @import { CopySheet } from './copyText.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { JacobianView } from './jacobianView.js'
 */
import { isSliding } from '../document.js';
import { dexterityNumbers, partOf } from './dexterityNumbers.js';
import { jacobiansAt, rowsInDocument, stepOf } from './jacobianNumbers.js';
import { jointLoads } from './statics.js';

/** @typedef {'geometric' | 'numeric' | 'measures' | 'statics'} JacobianSheet */

/**
 * @param {JacobianSheet} what
 * @param {Doc} doc
 * @param {Chain} chain
 * @param {ArrayLike<number>} q  metres and radians
 * @param {JacobianView} view
 * @param {Float64Array} T_world_user
 * @returns {CopySheet}
 */
export function jacobianSheet(what, { robot, activeUser }, chain, q, view, T_world_user) {
  const name = robot.name || 'Robot';
  const { length } = robot.units;
  const frame = view.frame === 'user' ? `user frame ${activeUser}` : view.frame;
  const place = `at the tool point, along ${view.frame === 'user' ? `the axes of the ${frame}` : `${frame} axes`}`;
  const facts = { robot: robot.name, frame, units: { length, angle: 'rad' } };
  const joints = robot.joints.map((_, i) => `J${i + 1}`);
  if (what === 'statics') {
    const units = robot.joints.map((joint) => (isSliding(joint) ? 'N' : 'N m'));
    return {
      title: `${name}: joint torques that hold a force at the tool, tau = J^T F`,
      facts: { robot: robot.name, frame, jointUnits: units },
      items: [
        {
          name: 'F',
          latex: 'F',
          about: `what the tool presses with: force in N, moment in N m, ${place}`,
          labels: ['Fx', 'Fy', 'Fz', 'Mx', 'My', 'Mz'],
          values: view.wrench,
        },
        {
          name: 'tau',
          latex: '\\tau',
          about: joints.map((joint, i) => `${joint} in ${units[i]}`).join(', '),
          labels: joints,
          values: jointLoads(chain, q, view.wrench, view.frame, T_world_user),
        },
      ],
    };
  }
  if (what === 'measures') {
    const part = partOf(chain, view.part);
    const { values, lengthScale, manipulability, conditionNumber } = dexterityNumbers(
      robot,
      chain,
      q,
      part,
      view.frame,
      T_world_user,
    );
    const unit = part === 'linear' ? `in ${length}` : 'pure numbers';
    return {
      title: `${name}: singular values of the Jacobian, ${part} part`,
      facts: { robot: robot.name, part, units: { length, angle: 'rad' }, lengthScale, manipulability },
      items: [
        {
          name: 'sigma',
          latex: '\\sigma',
          about: `falling, ${unit}; length scale L = ${lengthScale} ${length}, manipulability ${manipulability}, condition number ${conditionNumber}`,
          labels: values.map((_, i) => `s${i + 1}`),
          values,
        },
      ],
    };
  }
  const { geometric, numeric } = jacobiansAt(chain, q, view, T_world_user);
  const isGeometric = what === 'geometric';
  const how = isGeometric ? 'by geometry' : `by ${view.method} difference, step ${stepOf(view)} rad`;
  return {
    title: `${name}: Jacobian ${how}`,
    facts: { ...facts, how },
    items: [
      {
        name: 'J',
        latex: 'J',
        about: `J ${place}: rows vx, vy, vz in ${length} per rad (per ${length} of a slide), then wx, wy, wz in rad per rad (per ${length})`,
        rows: rowsInDocument(robot, isGeometric ? geometric : numeric),
      },
    ],
  };
}
