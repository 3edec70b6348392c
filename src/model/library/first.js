/** The arm that the page begins with. */
import { deepFreeze } from '../freeze.js';
import { robot, turn } from './rows.js';

export const FIRST_ROBOT = 'puma560';

export const PUMA_560 = deepFreeze(
  robot(
    'Puma 560',
    'Corke and Armstrong-Hélouvry, ICRA 1994, pp. 1608–1613, doi:10.1109/ROBOT.1994.351360; limits as Robotics Toolbox for Python 1.5.0',
    [
      turn(0, 671.83, 0, 90, -160, 160, 0),
      turn(0, 0, 431.8, 0, -45, 225, 45),
      turn(0, 150.05, 20.3, -90, -225, 45, -180),
      turn(0, 431.8, 0, 90, -110, 170, 0),
      turn(0, 0, 0, -90, -100, 100, 45),
      turn(0, 0, 0, 0, -266, 266, 0),
    ],
  ),
);
