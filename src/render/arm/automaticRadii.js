/** @import { Chain } from '../../kinematics/chain.js' */
import { radiiOf } from './armPlan.js';
import { bodiesOf } from './bodies.js';

/** How thick each joint's link is drawn where nobody says so, in metres. @param {Chain} chain */
export const automaticRadii = (chain) => radiiOf(bodiesOf(chain).size, chain.dof).slice(1);
