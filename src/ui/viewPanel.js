/**
 * Around the scene: its tools, the grid's step in words, the arm in words for those who cannot see it, and the reason why
 * there is no picture where there is none. It knows no scene; main.js brings the two together.
 *
 * @import { Page } from './page.js'
 */
import $ from 'jquery/slim';
import { fromKernel } from '../model/units.js';
import { fill, h } from './dom.js';
import { editable, jointNumber, plain, poseNumber, unitOf, withUnit } from './format.js';
import { icon } from './icons.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ poseInWords: () => string }} given
 */
export function createViewPanel({ store, addView }, host, { poseInWords }) {
  const stageHost = h('div', { class: 'stage' });
  const fit = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.view.fit, title: TEXT.view.fit },
    icon('fullscreen'),
  );
  const tools = h('div', { class: 'float tl', role: 'toolbar', 'aria-label': TEXT.view.tools }, fit);
  const grid = h('span', { class: 'scale' });
  fill(host, stageHost, tools, grid);

  const robot = () => store.state.doc.robot;
  const length = (/** @type {number} */ metres) => fromKernel('length', metres, robot().units);

  return {
    stageHost,

    /** The words of the scene's labels. */
    text: {
      view: '',
      /** @param {number} index */
      jointValue(index) {
        const joint = robot().joints[index];
        const unit = unitOf(joint, robot().units);
        return `J${index + 1} ${withUnit(jointNumber(store.state.doc.posture[index], unit), unit)}`;
      },
      /** @param {number} index @param {'lower' | 'upper'} which */
      jointLimit(index, which) {
        const joint = robot().joints[index];
        const limit = joint[which];
        return limit === undefined ? '' : withUnit(editable(limit), unitOf(joint, robot().units));
      },
      /** @param {number} metres */
      missing: (metres) => withUnit(poseNumber(length(metres), robot().units.length), robot().units.length),
    },

    /** @param {number} metres */
    showGridStep(metres) {
      const step = withUnit(plain(Number(length(metres).toPrecision(3))), robot().units.length);
      grid.textContent = TEXT.view.grid(step);
    },

    /**
     * @param {HTMLCanvasElement} canvas
     * @param {() => void} onFit
     */
    surround(canvas, onFit) {
      $(fit).on('click', onFit);
      addView(
        ({ doc }) => doc,
        () => canvas.setAttribute('aria-label', TEXT.view.describe(robot().name, poseInWords())),
      );
    },

    sayWhyEmpty() {
      tools.remove();
      grid.remove();
      fill(stageHost, h('div', { class: 'empty' }, h('p', {}, TEXT.noWebGl)));
    },
  };
}
