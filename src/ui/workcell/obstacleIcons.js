/**
 * The kinds of obstacles as small drawings.
 * @import { ObstacleKind } from '../../model/workcell/obstacles.js'
 */
import { iconOf } from '../parts/icons.js';

const STROKE = 'fill="none" stroke="currentColor" stroke-width="1.3" stroke-linejoin="round"';

/** @param {string} content */
const drawing = (content) =>
  `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 16"><g ${STROKE}>${content}</g></svg>`;

const DRAWINGS = {
  box: drawing('<path d="M8 1.5 14 4.7v6.6L8 14.5 2 11.3V4.7zM2 4.7 8 8l6-3.3M8 8v6.5"/>'),
  sphere: drawing('<circle cx="8" cy="8" r="6.2"/><path d="M1.8 8c2 2.6 10.4 2.6 12.4 0"/>'),
  cylinder: drawing('<ellipse cx="8" cy="3.6" rx="5" ry="2"/><path d="M3 3.6v8.8c0 2.7 10 2.7 10 0V3.6"/>'),
  plane: drawing('<path d="M1 6h14M3.5 6 1 9.5M7 6l-2.5 3.5M10.5 6 8 9.5M14 6l-2.5 3.5"/>'),
};

/** @param {ObstacleKind} kind */
export const kindIcon = (kind) => iconOf(DRAWINGS[kind], 'kind');
