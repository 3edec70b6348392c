/**
 * The editor of controller code: CodeMirror in the page's colours, with the line that is next, places to stop, and what is wrong.
 *
 * @import { DecorationSet } from '@codemirror/view'
 * @import { Extension, StateEffectType } from '@codemirror/state'
 * @import { CompletionSource } from '@codemirror/autocomplete'
 * @import { KnownName, Problem } from '../../model/code/codeProblems.js'
 * @import { ProgramDoc } from '../../model/document.js'
 */
import { autocompletion, completionKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import {
  bracketMatching,
  foldGutter,
  foldKeymap,
  foldService,
  HighlightStyle,
  syntaxHighlighting,
} from '@codemirror/language';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { Compartment, EditorState, RangeSet, StateEffect, StateField } from '@codemirror/state';
import {
  Decoration,
  EditorView,
  gutter,
  GutterMarker,
  highlightActiveLine,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { h } from '../parts/dom.js';
import { CODE } from '../words/code.js';
import { LANGUAGES } from './languages.js';

const COLOURS = HighlightStyle.define([
  { tag: tags.keyword, color: 'var(--code-key)' },
  { tag: tags.typeName, color: 'var(--code-type)' },
  { tag: tags.meta, color: 'var(--code-type)' },
  { tag: tags.number, color: 'var(--code-num)' },
  { tag: tags.string, color: 'var(--code-str)' },
  { tag: tags.comment, color: 'var(--code-note)', fontStyle: 'italic' },
  { tag: tags.standard(tags.variableName), color: 'var(--code-fn)' },
  { tag: tags.punctuation, color: 'var(--ink-2)' },
]);

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
const [STOP, NEXT] = [new Stop(), new Next()];

/** @type {StateEffectType<readonly number[]>} lines at which it stops, from 1 */
const setStops = StateEffect.define();
/** @type {StateEffectType<number | null>} the line that is next */
const setNext = StateEffect.define();

/** @type {StateEffectType<readonly Problem[]>} */
const setProblems = StateEffect.define();

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
      return end > start
        ? [Decoration.mark({ class: `code-${severity}`, attributes: { title: message } }).range(start, end)]
        : [];
    }),
    true,
  );

/** Positions of the lines' beginnings; text that is typed moves them along. */
const stops = StateField.define({
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
const marked = EditorView.decorations.compute([stops, next], (state) => {
  const lines = state.field(stops).map((place) => Decoration.line({ class: 'code-stop-line' }).range(place));
  const place = state.field(next);
  if (place !== null)
    lines.push(Decoration.line({ class: 'code-next-line', attributes: { 'aria-current': 'true' } }).range(place));
  return Decoration.set(lines, true);
});
const marks = (/** @type {EditorState} */ state) => {
  const list = state.field(stops).map((place) => STOP.range(place));
  const place = state.field(next);
  if (place !== null) list.push(NEXT.range(place));
  return RangeSet.of(list, true);
};

/** Blocks of KAREL fold from the line that begins them to the line that ends them. */
const BEGINS = /^\s*(ROUTINE|IF\b.*\bTHEN\s*$|FOR|WHILE|REPEAT|SELECT|CONDITION|USING|\w+\s*=\s*STRUCTURE)/i;
const folds = foldService.of(({ doc }, from) => {
  const line = doc.lineAt(from);
  if (!BEGINS.test(line.text)) return null;
  const indent = /^\s*/.exec(line.text)?.[0].length ?? 0;
  for (let number = line.number + 1; number <= doc.lines; number++) {
    const { text, to } = doc.line(number);
    if (!/^\s*(END|UNTIL)/i.test(text) || (/^\s*/.exec(text)?.[0].length ?? 0) > indent) continue;
    return { from: line.to, to };
  }
  return null;
});

/**
 * @param {HTMLElement} host
 * @param {object} acts
 * @param {(text: string) => void} acts.onText
 * @param {() => void} acts.onLeave           the keyboard has left it
 * @param {(lines: readonly number[], line: number) => void} acts.onStops  line: where that is another now
 * @param {(line: number) => void} acts.onLine  the cursor is there
 * @param {() => readonly KnownName[]} acts.names  what may be typed here
 */
export function createEditor(host, { onText, onLeave, onStops, onLine, names }) {
  const language = new Compartment();
  const label = new Compartment();
  let isSetting = false;

  /** @param {EditorView} view @param {number} place */
  function toggleStop(view, place) {
    const { from, number } = view.state.doc.lineAt(place);
    const lines = view.state.field(stops).map((one) => view.state.doc.lineAt(one).number);
    const now = lines.includes(number)
      ? lines.filter((one) => one !== number)
      : [...lines, number].sort((a, b) => a - b);
    view.dispatch({ effects: setStops.of(now), selection: { anchor: from } });
    onStops(now, number);
    return true;
  }

  /** @type {CompletionSource} */
  const complete = (context) => {
    const word = context.matchBefore(/[$]?[A-Za-z_]\w*/);
    if (!word && !context.explicit) return null;
    const options = names().map(({ name, kind, detail }) => ({
      label: name,
      detail,
      type: kind === 'routine' || kind === 'built-in' ? 'function' : kind,
    }));
    return { from: word?.from ?? context.pos, options, validFor: /^[$]?\w*$/ };
  };

  /** @type {Extension[]} */
  const extensions = [
    ...[
      lineNumbers(),
      foldGutter(),
      folds,
      history(),
      bracketMatching(),
      highlightActiveLine(),
      highlightSelectionMatches(),
    ],
    ...[stops, next, marked, underlined, search({ top: true }), syntaxHighlighting(COLOURS)],
    gutter({
      class: 'code-marks',
      markers: ({ state }) => marks(state),
      domEventHandlers: { mousedown: (view, { from }) => toggleStop(view, from) },
    }),
    autocompletion({ override: [complete], icons: false }),
    EditorView.lineWrapping,
    keymap.of([
      { key: 'F9', run: (view) => toggleStop(view, view.state.selection.main.head) },
      ...completionKeymap,
      ...searchKeymap,
      ...foldKeymap,
      ...historyKeymap,
      ...defaultKeymap,
    ]),
    EditorView.updateListener.of(({ docChanged, selectionSet, state, focusChanged, view }) => {
      if (docChanged && !isSetting) onText(state.doc.toString());
      if (docChanged || selectionSet) onLine(state.doc.lineAt(state.selection.main.head).number);
      if (focusChanged && !view.hasFocus) onLeave();
    }),
    ...[language.of([]), label.of([])],
  ];
  const view = new EditorView({ parent: host, state: EditorState.create({ extensions }) });

  return {
    /** Another program, or the same with another text than is here. @param {ProgramDoc} program @param {readonly number[]} lines  at which it stops */
    open(program, lines) {
      isSetting = true;
      view.setState(
        EditorState.create({
          doc: program.text,
          extensions: [
            ...extensions.slice(0, -2),
            language.of(LANGUAGES[program.language]),
            label.of(EditorView.contentAttributes.of({ 'aria-label': CODE.text(program.id) })),
          ],
        }),
      );
      isSetting = false;
      view.dispatch({ effects: setStops.of(lines) });
    },
    /** The same program has another text: of an undo. @param {string} text */
    replace(text) {
      if (text === view.state.doc.toString()) return;
      isSetting = true;
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
      isSetting = false;
    },
    text: () => view.state.doc.toString(),
    /** @param {readonly Problem[]} problems */
    showProblems(problems) {
      view.dispatch({ effects: setProblems.of(problems) });
    },
    /** @param {number | null} line */
    showNext(line) {
      view.dispatch({ effects: setNext.of(line) });
      if (line === null || line > view.state.doc.lines) return;
      view.dispatch({
        effects: EditorView.scrollIntoView(view.state.doc.line(line).from, { y: 'nearest', yMargin: 40 }),
      });
    },
    /** @param {number} line */
    goTo(line) {
      const { from } = view.state.doc.line(Math.min(Math.max(1, line), view.state.doc.lines));
      view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
      view.focus();
    },
  };
}

/** @typedef {ReturnType<typeof createEditor>} CodeEditor */
