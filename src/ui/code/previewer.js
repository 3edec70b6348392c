/**
 * Where the code that is open would take the arm, found out in the page's frames a while after it was typed, for the scene and for
 * the lines.
 *
 * @import { Preview } from '../../model/code/codePreview.js'
 * @import { Page } from '../page.js'
 * @import { RunControl } from './runControl.js'
 */
import { moveOfLine, pathOf, previewOf } from '../../model/code/codePreview.js';
import { CODE } from '../words/code.js';

/** s after it was asked for, and s of a frame. */
const IDLE = 0.5;
const LONGEST_TURN = 0.008;

/** @param {Page} page @param {RunControl['given']} given @param {() => void} onFound */
export function createPreviewer({ store, clock, messages }, given, onFound) {
  /** @type {Preview | null} */
  let preview = null;
  let id = '';
  let asked = 0;
  /** @type {(() => void) | null} */
  let cancel = null;
  let hasGhost = false;

  /** @param {number} number  of the question */
  function begin(number) {
    const finding = previewOf(store.state.doc, id, given());
    const next = () => {
      if (number !== asked) return;
      try {
        const begun = clock.now();
        do {
          const found = finding.next();
          if (!found.done) continue;
          preview = found.value;
          show();
          return onFound();
        } while (clock.now() - begun < LONGEST_TURN);
      } catch (error) {
        return messages.fault(error);
      }
      clock.onFrame(next);
    };
    clock.onFrame(next);
  }

  function show() {
    const { code } = store.state.session;
    const path = preview && pathOf(preview, id);
    if (path !== code.path) store.dispatch({ type: 'show', change: { code: { ...code, path } } });
  }

  return {
    /** Anew, of this program; none where nothing is open. @param {string | null} program */
    ask(program) {
      asked++;
      cancel?.();
      cancel = null;
      if (program === null || program !== id) {
        preview = null;
        show();
      }
      id = program ?? '';
      if (program === null) return;
      const number = asked;
      cancel = clock.after(IDLE, () => begin(number));
    },
    faults: () => (preview?.faults ?? []).filter((fault) => fault.id === id),
    /** The arm where the motion of a line leads. @param {number | null} line */
    ghost(line) {
      const move = line === null || !preview ? null : moveOfLine(preview, id, line);
      if (!move && !hasGhost) return;
      hasGhost = move !== null;
      const ghost = move && { posture: move.posture, label: CODE.ghost(/** @type {number} */ (line)) };
      store.dispatch({ type: 'show', change: { ghost } });
    },
  };
}
