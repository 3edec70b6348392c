/**
 * The page's rooms: bar, left side with its tabs, view, right side, and the dock of a phone. The same elements serve all
 * screens; which of them is seen where is the stylesheet's business (css/layout.css).
 *
 * @import { Page } from './page.js'
 * @import { IconName } from './icons.js'
 * @import { Panel, Tab } from '../model/session.js'
 */
import $ from 'jquery/slim';
import { h } from './dom.js';
import { icon } from './icons.js';
import { PANELS, TABS, openPanel } from './page.js';
import { TEXT } from './strings.js';

/** @type {Record<Panel, IconName>} */
const PANEL_ICON = { robot: 'table', jog: 'sliders', aim: 'target', program: 'list', code: 'codeSlash' };

/** Empty rooms, before anything is known. */
export function createShell() {
  const rooms = {
    bar: h('header', { class: 'topbar' }),
    tablist: h('div', { class: 'tabs', role: 'tablist', 'aria-label': TEXT.panels.left }),
    /** @type {Record<Tab, HTMLElement>} */
    tabs: { robot: tabPanel('robot'), program: tabPanel('program'), code: tabPanel('code') },
    view: h('main', { class: 'view', 'aria-label': TEXT.panels.view }),
    jog: h('section', { class: 'sec jog-panel', 'data-room': 'jog' }),
    pose: h('section', { class: 'sec pose-panel', 'data-room': 'pose' }),
    aim: h('section', { class: 'sec aim-panel', 'data-room': 'aim' }),
    dock: h('nav', { class: 'dock', 'aria-label': TEXT.panels.label }),
    notices: h('div', { class: 'notices' }),
  };
  const app = h(
    'div',
    { class: 'app' },
    rooms.bar,
    h('aside', { class: 'side left', 'aria-label': TEXT.panels.left }, rooms.tablist, Object.values(rooms.tabs)),
    rooms.view,
    h('aside', { class: 'side right', 'aria-label': TEXT.panels.right }, rooms.jog, rooms.pose, rooms.aim),
    rooms.dock,
    rooms.notices,
  );
  document.body.append(app);
  return { app, ...rooms };
}

/** @typedef {ReturnType<typeof createShell>} Shell */

/** @param {Tab} tab */
const tabPanel = (tab) =>
  h('div', {
    class: 'tab-panel',
    role: 'tabpanel',
    id: `panel-${tab}`,
    'aria-labelledby': `tab-${tab}`,
    'data-room': tab,
  });

/**
 * Tabs and dock: which panel is open.
 * @param {Page} page
 * @param {Shell} shell
 */
export function runPanels(page, { app, tablist, tabs, dock }) {
  const tabButtons = TABS.map((tab) =>
    h(
      'button',
      { type: 'button', role: 'tab', id: `tab-${tab}`, 'aria-controls': `panel-${tab}`, 'data-opens': tab },
      TEXT.panels[tab],
    ),
  );
  tablist.append(...tabButtons);
  $(tablist)
    .on('click', '[data-opens]', ({ currentTarget }) => openPanel(page, currentTarget.dataset.opens))
    .on('keydown', '[data-opens]', (event) => {
      const step = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
      if (!step) return;
      event.preventDefault();
      const next = tabButtons[(tabButtons.indexOf(event.currentTarget) + step + TABS.length) % TABS.length];
      next.focus();
      next.click();
    });

  for (const panel of PANELS) {
    dock.append(
      h('button', { type: 'button', 'data-opens': panel }, icon(PANEL_ICON[panel]), h('span', {}, TEXT.panels[panel])),
    );
  }
  $(dock).on('click', '[data-opens]', ({ currentTarget }) => openPanel(page, currentTarget.dataset.opens));

  page.addView(
    ({ session }) => session.tab,
    (open) => {
      app.dataset.tab = open;
      tabButtons.forEach((button, i) => {
        button.setAttribute('aria-selected', String(TABS[i] === open));
        button.tabIndex = TABS[i] === open ? 0 : -1;
        tabs[TABS[i]].classList.toggle('is-open', TABS[i] === open);
      });
    },
  );
  page.addView(
    ({ session }) => session.panel,
    (open) => {
      app.dataset.panel = open;
      for (const button of dock.children) {
        if (button instanceof HTMLElement && button.dataset.opens === open) button.setAttribute('aria-current', 'true');
        else button.removeAttribute('aria-current');
      }
    },
  );
}
