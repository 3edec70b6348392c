/**
 * The workspace: what the arm can reach. Each question is a fold of its own (folds.js). Fetched when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { WorkspaceView } from '../../model/workspace/workspaceView.js'
 */
import '../css/workspace.css';
import { FIRST_WORKSPACE } from '../../model/workspace/workspaceView.js';
import { h } from '../parts/dom.js';
import { foldMaker } from '../parts/fold.js';
import { createPressGate } from '../parts/pressed.js';
import { segments } from '../parts/segments.js';
import { WORKSPACE } from '../words/workspace.js';
import { FOLDS } from './folds.js';

/** @param {Page} page @param {HTMLElement} host */
export function createWorkspacePanel(page, host) {
  const { store, addView, clock, messages } = page;
  const view = () => store.state.session.workspace ?? FIRST_WORKSPACE;
  /** @param {Partial<WorkspaceView>} change */
  const look = (change) => store.dispatch({ type: 'show', change: { workspace: { ...view(), ...change } } });

  const limits = segments(WORKSPACE.limits.label, ['on', 'off'], WORKSPACE.limits.name, (value) =>
    look({ withLimits: value === 'on' }),
  );
  // a map that is done, and a fold above that is shorter then, would take a button from under a slow finger
  const afterPress = createPressGate(host, clock);
  const fold = foldMaker(clock, messages.fault);
  const folds = FOLDS.map(({ id, name, create }) => {
    const made = fold(
      `fold-reach-${id}`,
      (body) => create(page, body, (summary) => made.setHead(name, summary), afterPress),
      (isOpen) => look({ open: [...view().open.filter((other) => other !== id), ...(isOpen ? [id] : [])] }),
    );
    made.setHead(name);
    return { id, ...made };
  });
  host.append(
    h(
      'section',
      { class: 'sec' },
      h('header', {}, h('h2', {}, WORKSPACE.title), h('span', { class: 'grow' }), limits.element),
    ),
    ...folds.map(({ element }) => element),
  );

  if (store.state.session.workspace === null) look({});
  addView(
    ({ session }) => session.workspace,
    (now) => {
      const { open, withLimits } = now ?? FIRST_WORKSPACE;
      limits.draw(withLimits ? 'on' : 'off');
      for (const { id, set } of folds) void set(open.includes(id), false);
    },
  );
}
