/**
 * The page's rooms: bar, left side with its tabs, view, right side, and the dock of a phone. The same elements serve all
 * screens; which of them is seen where is the stylesheet's business (css/layout.css).
 *
 * @import { Page } from './page.js'
 * @import { IconName } from './parts/icons.js'
 * @import { Room } from '../io/queryParameters.js'
 * @import { Panel, Tab } from '../model/session.js'
 */
import $ from 'jquery/slim';
import { h } from './parts/dom.js';
import { icon } from './parts/icons.js';
import { createLeftEdge } from './leftEdge.js';
import { PANELS, TABS, openPanel } from './page.js';
import { createSkipLinks } from './skipLinks.js';
import { TEXT } from './strings.js';

/** @type {Record<Panel, IconName>} */
const PANEL_ICON = {
  robot: 'table',
  jog: 'sliders',
  aim: 'target',
  program: 'list',
  code: 'codeSlash',
  workspace: 'reach',
  jacobian: 'matrix',
};

/**
 * Empty rooms, before anything is known.
 * @param {readonly Room[] | null} [asked]  the only ones beside the view, the first of them open; null: all
 */
export function createShell(asked = null) {
  const has = (/** @type {Room} */ room) => asked === null || asked.includes(room);
  const rooms = {
    bar: h('header', { class: 'topbar', hidden: !has('bar') }),
    tablist: h('div', { class: 'tabs', role: 'tablist', 'aria-label': TEXT.panels.left }),
    /** @type {Record<Tab, HTMLElement>} */
    tabs: {
      robot: tabPanel('robot'),
      program: tabPanel('program'),
      code: tabPanel('code'),
      workspace: tabPanel('workspace'),
      jacobian: tabPanel('jacobian'),
    },
    view: h('main', { class: 'view', 'aria-label': TEXT.panels.view }),
    jog: h('section', { class: 'sec jog-panel', 'data-room': 'jog', hidden: !has('jog') }),
    pose: h('section', { class: 'sec pose-panel', 'data-room': 'pose', hidden: !has('pose') }),
    aim: h('section', { class: 'sec aim-panel', 'data-room': 'aim', hidden: !has('aim') }),
    time: h('section', { class: 'time', hidden: true }),
    dock: h('nav', { class: 'dock', 'aria-label': TEXT.panels.label }),
    notices: h('div', { class: 'notices' }),
  };
  const shownTabs = TABS.filter(has);
  const shownPanels = PANELS.filter((panel) => has(panel) || (panel === 'jog' && has('pose')));
  const hasRight = has('jog') || has('pose') || has('aim');
  rooms.dock.style.setProperty('--panels', String(shownPanels.length));
  const app = h(
    'div',
    {
      class: 'app',
      'data-bar': has('bar') ? null : 'none',
      'data-left': shownTabs.length > 0 ? null : 'none',
      'data-right': hasRight ? null : 'none',
    },
    rooms.bar,
    h(
      'aside',
      { class: 'side left', 'aria-label': TEXT.panels.left, hidden: shownTabs.length === 0 },
      rooms.tablist,
      Object.values(rooms.tabs),
    ),
    rooms.view,
    h(
      'aside',
      { class: 'side right', 'aria-label': TEXT.panels.right, hidden: !hasRight },
      rooms.jog,
      rooms.pose,
      rooms.aim,
    ),
    rooms.time,
    rooms.dock,
    rooms.notices,
  );
  if (!has('bar')) {
    const whole = { href: wholePage(), target: '_blank', rel: 'noopener' };
    app.append(h('a', { class: 'open-whole', ...whole }, TEXT.openWhole));
  }
  document.body.append(app);
  const first = asked?.[0] === 'pose' ? 'jog' : asked?.find((room) => room !== 'bar' && room !== 'pose');
  return { app, ...rooms, has, shownTabs, shownPanels, first: PANELS.find((panel) => panel === first) ?? null };
}

/** @typedef {ReturnType<typeof createShell>} Shell */

/** The address of this page with everything on it. */
function wholePage() {
  const query = new URLSearchParams(location.search);
  for (const name of ['panels', 'hint']) query.delete(name);
  return `?${query}`;
}

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
export function runPanels(page, { app, tablist, tabs, view, jog, aim, dock, shownTabs, shownPanels, first }) {
  app.before(
    createSkipLinks(page, {
      ...{ view, robot: shownTabs.includes('robot') ? tabs.robot : null },
      ...{ jog: jog.hidden ? null : jog, aim: aim.hidden ? null : aim },
    }),
  );
  if (shownTabs.length > 0) view.after(createLeftEdge(page, app));
  if (first) openPanel(page, first);
  else if (shownTabs.length > 0) page.store.dispatch({ type: 'show', change: { tab: shownTabs[0] } });
  const tabButtons = shownTabs.map((tab) =>
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
      const next = tabButtons[(tabButtons.indexOf(event.currentTarget) + step + shownTabs.length) % shownTabs.length];
      next.focus();
      next.click();
    });

  for (const panel of shownPanels) {
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
        button.setAttribute('aria-selected', String(shownTabs[i] === open));
        button.tabIndex = shownTabs[i] === open ? 0 : -1;
        tabs[shownTabs[i]].classList.toggle('is-open', shownTabs[i] === open);
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
