/**
 * What the page knows of its library before anyone opens it: the ids, and how to get at an arm.
 * @import { RobotDoc } from './document.js'
 */
import { FIRST_ROBOT, PUMA_560 } from './library/first.js';

export { FIRST_ROBOT };

/** In the order in which a person is shown them. */
export const LIBRARY_IDS = [
  ...[
    'planar2r',
    'planar3r',
    'planar_rp',
    'planar_pr',
    'anthropomorphic_3r',
    'spherical_wrist',
    'polar_rrp',
    'stanford',
  ],
  ...['scara_cobra600', 'cyl_rpp', 'cart_ppp'],
  ...[FIRST_ROBOT, 'kuka_kr5_arc', 'kuka_kr6_r900', 'kuka_kr210_l150', 'fanuc_lrmate200id', 'fanuc_m10ia'],
  ...['abb_irb120', 'abb_irb140', 'mitsubishi_rv2aj'],
  ...['ur3', 'ur5', 'ur10', 'kinova_mico', 'kinova_jaco', 'kuka_youbot'],
];

/** The arm that needs no fetching. */
export const firstRobot = PUMA_560;

/**
 * @param {string} id  one of `LIBRARY_IDS`
 * @returns {Promise<RobotDoc>} rejects when the tables cannot be fetched
 */
export async function loadRobot(id) {
  if (id === FIRST_ROBOT) return PUMA_560;
  const { LIBRARY } = await import('./library.js');
  return LIBRARY[id];
}
