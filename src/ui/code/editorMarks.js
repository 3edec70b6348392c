/**
 * What the editor marks: places to stop, the line that is next, and what is wrong. Text that is typed moves them along.
 *
 * @import { DecorationSet } from '@codemirror/view'
 * @import { EditorState, StateEffectType } from '@codemirror/state'
 * @import { Problem } from '../../model/code/codeProblems.js'
 */
import { RangeSet, StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, GutterMarker } from '@codemirror/view';
import { h } from '../parts/dom.js';
import { CODE } from '../words/code.js';

class Stop extends GutterMarker {
  toDOM() {
    return h('span', { class: 'code-stop', role: 'img', 'aria-label': CODE.breakpoint });
  }
}
class Next extends GutterMarker {
  toDOM() {
    return h('span', { class: 'code-next', role: 'img', 'aria-label': CODE.nextLine });
  }
}
class Fault extends GutterMarker {
  /** @param {Problem['severity']} severity */
  constructor(severity) {
    super();
    this.severity = severity;
  }
  toDOM() {
    return h('span', {
      class: `code-fault is-${this.severity}`,
      role: 'img',
      'aria-label': CODE.severity[this.severity],
    });
  }
}
const [STOP, NEXT] = [new Stop(), new Next()];
const FAULTS = { error: new Fault('error'), warning: new Fault('warning') };

/** @type {StateEffectType<readonly number[]>} lines at which it stops, from 1 */
export const setStops = StateEffect.define();
/** @type {StateEffectType<number | null>} the line that is next */
export const setNext = StateEffect.define();

/** @type {StateEffectType<readonly Problem[]>} */
export const setProblems = StateEffect.define();

/** Under what is wrong; text that is typed moves it along. */
const underlined = StateField.define({
  create: () => Decoration.none,
  update(marks, { changes, effects, state }) {
    let now = marks.map(changes);
    for (const effect of effects) if (effect.is(setProblems)) now = underlines(effect.value, state.doc.length);
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** @param {readonly Problem[]} problems @param {number} length  of the text @returns {DecorationSet} */
const underlines = (problems, length) =>
  Decoration.set(
    problems.flatMap(({ from, to, severity, message }) => {
      const end = Math.min(Math.max(to, from + 1), length);
      const start = Math.min(from, Math.max(0, end - 1));
      const mark = Decoration.mark({ class: `code-${severity}`, attributes: { title: message }, severity });
      return end > start ? [mark.range(start, end)] : [];
    }),
    true,
  );

/** The worst of each line that has neither a breakpoint nor is next. @param {EditorState} state @param {ReadonlySet<number>} taken  beginnings of lines */
function faultsIn(state, taken) {
  /** @type {Map<number, Problem['severity']>} */
  const worst = new Map();
  state.field(underlined).between(0, state.doc.length, (from, _, { spec }) => {
    const line = state.doc.lineAt(from).from;
    if (!taken.has(line) && worst.get(line) !== 'error') worst.set(line, spec.severity);
  });
  return [...worst].map(([line, severity]) => FAULTS[severity].range(line));
}

/** Positions of the lines' beginnings; text that is typed moves them along. */
export const stops = StateField.define({
  create: () => /** @type {readonly number[]} */ ([]),
  update(places, { changes, effects, state, docChanged }) {
    let now = places;
    if (docChanged) now = [...new Set(now.map((place) => state.doc.lineAt(changes.mapPos(place, 1)).from))];
    for (const effect of effects)
      if (effect.is(setStops))
        now = effect.value.filter((line) => line <= state.doc.lines).map((line) => state.doc.line(line).from);
    return now;
  },
});
const next = StateField.define({
  create: () => /** @type {number | null} */ (null),
  update(place, { effects, state, docChanged }) {
    for (const effect of effects)
      if (effect.is(setNext))
        return effect.value === null || effect.value > state.doc.lines ? null : state.doc.line(effect.value).from;
    return docChanged ? null : place;
  },
});
const shown = EditorView.decorations.compute([stops, next], (state) => {
  const lines = state.field(stops).map((place) => Decoration.line({ class: 'code-stop-line' }).range(place));
  const place = state.field(next);
  if (place !== null)
    lines.push(Decoration.line({ class: 'code-next-line', attributes: { 'aria-current': 'true' } }).range(place));
  return Decoration.set(lines, true);
});
export const marksIn = (/** @type {EditorState} */ state) => {
  const list = state.field(stops).map((place) => STOP.range(place));
  const place = state.field(next);
  if (place !== null) list.push(NEXT.range(place));
  const taken = new Set(list.map(({ from }) => from));
  return RangeSet.of([...list, ...faultsIn(state, taken)], true);
};

/** All of them. */
export const marked = [stops, next, shown, underlined];
