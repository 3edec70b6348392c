/**
 * Around the scene: its tools, the grid's step in words, the arm in words for those who cannot see it, and the reason why
 * there is no picture where there is none.
 *
 * @import { Page } from './page.js'
 */
import $ from 'jquery/slim';
import { fill, h } from './dom.js';
import { icon } from './icons.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ poseInWords: () => string }} given
 */
export function createViewPanel({ addView }, host, { poseInWords }) {
  const stageHost = h('div', { class: 'stage', tabindex: 0, role: 'application' });
  const fit = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.view.fit, title: TEXT.view.fit },
    icon('fullscreen'),
  );
  const tools = h('div', { class: 'float tl', role: 'toolbar', 'aria-label': TEXT.view.tools }, fit);
  const grid = h('span', { class: 'scale' });
  fill(host, stageHost, tools, grid);

  addView(
    ({ doc }) => doc,
    ({ robot }) => stageHost.setAttribute('aria-label', TEXT.view.describe(robot.name, poseInWords())),
  );

  return {
    stageHost,
    /** @param {() => void} run */
    onFit: (run) => void $(fit).on('click', run),
    /** @param {string} text */
    showGridStep: (text) => void (grid.textContent = TEXT.view.grid(text)),
    sayWhyEmpty() {
      tools.remove();
      grid.remove();
      fill(stageHost, h('div', { class: 'empty' }, h('p', {}, TEXT.noWebGl)));
    },
  };
}
