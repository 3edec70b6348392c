/**
 * Around the scene: its tools, the grid's step in words, the arm in words for those who cannot see it, and the reason why
 * there is no picture where there is none. It knows no scene; main.js brings the two together.
 *
 * @import { Page } from '../page.js'
 * @import { Direction } from './viewMenu.js'
 *
 * @typedef {{ canvas: HTMLCanvasElement, look: (direction: Direction | null) => void }} Scene  all that is known of it here
 */
import $ from 'jquery/slim';
import { shownFrames, shownUserFrames } from '../../model/frames/shownFrames.js';
import { isRowField, motionAt } from '../../model/robot/rowMotions.js';
import { together } from '../../model/views.js';
import { createBuildButton } from '../robot/buildButton.js';
import { fill, h } from '../parts/dom.js';
import { createHandleBar, createHandleButton } from './handleBar.js';
import { icon } from '../parts/icons.js';
import { createLostLine } from './lostLine.js';
import { asText, createSceneText } from './sceneText.js';
import { TEXT } from '../strings.js';
import { createViewCube } from './viewCube.js';
import { createFramesMenu, createViewMenu } from './viewMenu.js';
import { whenFirst } from '../parts/whenFirst.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ poseInWords: () => string, isCalm: () => boolean, isWide: () => boolean }} given  `isCalm`: the person wants
 *   no motion; `isWide`: the screen has room for the handle on the tool at all times
 */
export function createViewPanel(page, host, { poseInWords, isCalm, isWide }) {
  const { store, addView, announce } = page;
  const stageHost = h('div', { class: 'stage' });
  const fit = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.view.fit, title: TEXT.view.fit },
    icon('fullscreen'),
  );
  /** @type {Scene | null} */
  let scene = null;

  /** @param {Direction | null} direction  null: the whole arm, as it is seen now */
  function look(direction) {
    scene?.look(direction);
    if (direction) announce(TEXT.view.seen(TEXT.view.direction[direction]));
  }
  const cube = createViewCube(look);
  const tools = h(
    'div',
    { class: 'float tl', role: 'toolbar', 'aria-label': TEXT.view.tools },
    fit,
    createViewMenu(page, look),
    createFramesMenu(page),
    createHandleButton(page, isWide),
    createBuildButton(page, host, isCalm),
  );
  const grid = h('span', { class: 'scale' });
  fill(host, stageHost, tools, cube.element, grid);
  createHandleBar(page, host, { isWide, poseInWords });
  createLostLine(page, host);
  whenFirst(
    page,
    ({ session }) => session.trace !== null,
    async () => (await import('./traceLine.js')).createTraceLine(page, host),
  );
  $(fit).on('click', () => look(null));

  const robot = () => store.state.doc.robot;
  const text = createSceneText(page);

  /** What is in the picture beside the arm, in words. */
  function drawn() {
    const { doc, session } = store.state;
    const frames = [
      ...shownFrames(session, doc.robot.joints.length).map(TEXT.view.frameName),
      ...shownUserFrames(doc, session).map(({ id }) => TEXT.view.userFrame(id, id === doc.activeUser)),
    ];
    const { build } = session;
    const cell = build
      ? { joint: build.joint, field: motionAt(doc.robot.convention, build.at)?.motion.field ?? '' }
      : (session.pointedCell ?? session.cell);
    return [
      build && TEXT.view.building(build.joint + 1, Math.floor(build.at)),
      frames.length ? TEXT.view.drawnFrames(frames) : TEXT.view.noFrames,
      session.trace !== null && TEXT.view.traced,
      cell && isRowField(cell.field) && TEXT.view.drawnDimension(asText(text.dimension(cell.joint, cell.field))),
    ]
      .filter(Boolean)
      .join(' ');
  }

  return {
    stageHost,

    text,

    /** @param {number} metres */
    showGridStep(metres) {
      grid.textContent = TEXT.view.grid(text.gridStep(metres));
    },

    look,
    showViewpoint: cube.turn,

    /** What of the view nothing covers: on a phone the tools stand at the right, and the player lies below. */
    freePart() {
      const { left, top, width, height } = host.getBoundingClientRect();
      const strip = tools.getBoundingClientRect();
      const player = host.querySelector('.build')?.getBoundingClientRect();
      if (strip.height <= strip.width && !player) return null;
      return {
        left: 0,
        top: 0,
        width: strip.height > strip.width ? strip.left - left : width,
        height: player ? player.top - top : height,
      };
    },

    /** @param {Scene} stage */
    surround(stage) {
      scene = stage;
      addView(
        together(({ doc }) => [doc, drawn()]),
        ([, words]) => stage.canvas.setAttribute('aria-label', TEXT.view.describe(robot().name, poseInWords(), words)),
      );
    },

    sayWhyEmpty() {
      tools.remove();
      cube.element.remove();
      host.querySelector('.handle-bar')?.remove();
      grid.remove();
      fill(stageHost, h('div', { class: 'empty' }, h('p', {}, TEXT.noWebGl)));
    },
  };
}
