/**
 * Menus of the view: from where the arm is seen and how, and which frames are drawn.
 *
 * @import { IconName } from '../parts/icons.js'
 * @import { Page } from '../page.js'
 * @import { FramesShown, Session } from '../../model/session.js'
 *
 * @typedef {keyof typeof TEXT.view.direction} Direction
 */
import { withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

/** @type {readonly Direction[]} */
export const DIRECTIONS = ['home', 'front', 'back', 'left', 'right', 'top', 'bottom'];

/** @type {readonly FramesShown[]} */
const FRAMES = ['none', 'ends', 'row', 'all'];

/** @type {readonly Session['projection'][]} */
const PROJECTIONS = ['perspective', 'parallel'];

const words = TEXT.view;

/** @param {string} name @param {IconName} drawing */
const iconButton = (name, drawing) =>
  h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': name, title: name }, icon(drawing));

/**
 * @param {Page} page
 * @param {(direction: Direction) => void} look
 */
export const createViewMenu = ({ store }, look) =>
  withChoices(iconButton(words.views, 'box'), () => ({
    groups: [
      DIRECTIONS.map((name) => ({
        title: words.direction[name],
        run: () => look(name),
      })),
      PROJECTIONS.map((projection) => ({
        title: words.projection[projection],
        isChosen: store.state.session.projection === projection,
        run: () => store.dispatch({ type: 'show', change: { projection } }),
      })),
    ],
  }));

/** @param {Page} page */
export const createFramesMenu = ({ store }) =>
  withChoices(iconButton(words.frames, 'frames'), () => ({
    groups: [
      FRAMES.map((frames) => ({
        title: words.framesShown[frames],
        isChosen: store.state.session.frames === frames,
        run: () => store.dispatch({ type: 'show', change: { frames } }),
      })),
      [null, 0].map((trace) => ({
        title: trace === null ? words.trace.off : words.trace.on,
        isChosen: (store.state.session.trace === null) === (trace === null),
        run: () => store.dispatch({ type: 'show', change: { trace } }),
      })),
    ],
  }));
