/**
 * Below the tools of the view while the trace of the tool is drawn: how long it is, and the button that clears it.
 *
 * @import { Page } from '../page.js'
 */
import '../css/trace.css';
import { traceOf } from '../../model/jog/trace.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { jointNumber, withUnit } from '../parts/format.js';
import { TRACE } from '../words/trace.js';

/** @param {Page} page @param {HTMLElement} view */
export function createTraceLine(page, view) {
  const { store, addView, announce } = page;
  const recorder = traceOf(page);
  const words = h('span', {});
  const clear = h('button', { type: 'button', class: 'btn', title: TRACE.clearTitle }, TRACE.clear);
  const line = h(
    'div',
    { class: 'float trace-line', role: 'group', 'aria-label': TRACE.label },
    h('span', { class: 'caption', 'aria-hidden': 'true' }, TRACE.caption),
    words,
    clear,
  );
  view.append(line);
  clear.addEventListener('click', () => {
    store.dispatch({ type: 'show', change: { trace: (store.state.session.trace ?? 0) + 1 } });
    announce(TRACE.cleared);
  });

  addView(
    together(({ doc, session }) => [doc.robot.units, session.trace, recorder.trace, recorder.trace?.length]),
    ([units, order, trace, length]) => {
      line.hidden = order === null;
      if (!trace || length === undefined) return;
      const long = withUnit(jointNumber(fromKernel('length', length, units), units.length), units.length);
      const { strokes } = trace;
      words.textContent = length === 0 ? TRACE.none : strokes > 1 ? `${long} ${TRACE.strokes(strokes)}` : long;
      clear.disabled = length === 0;
    },
  );
}
