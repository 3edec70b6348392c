/**
 * The editor of controller code: CodeMirror in the page's colours, with the line that is next, places to stop, and what is wrong.
 *
 * @import { Extension } from '@codemirror/state'
 * @import { CompletionSource } from '@codemirror/autocomplete'
 * @import { KnownName } from '../../model/code/codeNames.js'
 * @import { Problem } from '../../model/code/codeProblems.js'
 * @import { ProgramDoc } from '../../model/document.js'
 */
import { autocompletion, completionKeymap, snippetCompletion } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { bracketMatching, foldGutter, foldKeymap, HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search';
import { Compartment, EditorState } from '@codemirror/state';
import { EditorView, gutter, highlightActiveLine, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { whenLineEnds } from '../../model/code/codeFormat.js';
import { CODE } from '../words/code.js';
import { folds } from './editorFolds.js';
import { marked, marksIn, setNext, setProblems, setStops, stops } from './editorMarks.js';
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

/**
 * @param {HTMLElement} host
 * @param {object} acts
 * @param {(text: string) => void} acts.onText
 * @param {() => void} acts.onLeave           the keyboard has left it
 * @param {(lines: readonly number[], line: number) => void} acts.onStops  line: where that is another now
 * @param {(line: number) => void} acts.onLine  the cursor is there
 * @param {(line: number | null) => void} acts.onPoint  the pointer is there
 * @param {() => readonly KnownName[]} acts.names  what may be typed here
 */
export function createEditor(host, { onText, onLeave, onStops, onLine, onPoint, names }) {
  const language = new Compartment();
  const label = new Compartment();
  let isSetting = false;
  let spoken = /** @type {ProgramDoc['language']} */ ('karel');

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

  /** A line that is ended is set in as its blocks have it, and so is the next. @param {EditorView} view */
  function endLine({ state, dispatch }) {
    const { main, ranges } = state.selection;
    const { from, to, text } = state.doc.lineAt(main.head);
    if (!main.empty || ranges.length > 1) return false;
    const set = whenLineEnds(spoken, state.sliceDoc(0, main.head), state.sliceDoc(main.head, to));
    if (!set) return false;
    const blanks = text.length - text.trimStart().length;
    const skipped = /^[ \t]*/.exec(state.sliceDoc(main.head, to))?.[0].length ?? 0;
    const changes = state.changes([
      { from, to: from + blanks, insert: set.own },
      { from: main.head, to: main.head + skipped, insert: `\n${set.next}` },
    ]);
    const anchor = changes.mapPos(main.head + skipped, 1);
    dispatch(state.update({ changes, selection: { anchor }, scrollIntoView: true, userEvent: 'input' }));
    return true;
  }

  /** @type {CompletionSource} */
  const complete = (context) => {
    const word = context.matchBefore(/[$]?[A-Za-z_]\w*/);
    if (!word && !context.explicit) return null;
    const options = names().map(({ name, kind, detail, typed }) => {
      const type = kind === 'routine' || kind === 'built-in' ? 'function' : kind;
      const option = { label: name, detail, type };
      return typed === undefined ? option : snippetCompletion(typed, option);
    });
    return { from: word?.from ?? context.pos, options, validFor: /^[$]?\w*$/ };
  };

  /** The line that is next stays in sight when the room for the text is another. */
  let next = 0;
  let height = 0;
  /** @param {EditorView} view */
  function keepNext({ scrollDOM: { clientHeight } }) {
    if (height === clientHeight) return;
    height = clientHeight;
    bringInSight();
  }
  /** Within the editor alone: the page around it stays where a person has put it. */
  function bringInSight() {
    if (next === 0 || next > view.state.doc.lines) return;
    const { scrollDOM } = view;
    const { top, bottom } = view.lineBlockAt(view.state.doc.line(next).from);
    const margin = Math.min(40, height / 3);
    const [least, most] = [bottom + margin - scrollDOM.clientHeight, top - margin];
    if (scrollDOM.scrollTop > most) scrollDOM.scrollTop = most;
    else if (scrollDOM.scrollTop < least) scrollDOM.scrollTop = least;
  }

  let pointed = 0;
  /** @param {number | null} line */
  function point(line) {
    if (pointed === (line ?? 0)) return;
    pointed = line ?? 0;
    onPoint(line);
  }

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
    ...[marked, search({ top: true }), syntaxHighlighting(COLOURS)],
    gutter({
      class: 'code-marks',
      markers: ({ state }) => marksIn(state),
      domEventHandlers: { mousedown: (view, { from }) => toggleStop(view, from) },
    }),
    autocompletion({ override: [complete], icons: false }),
    EditorView.lineWrapping,
    EditorView.domEventHandlers({
      mousemove({ clientX, clientY }, view) {
        const place = view.posAtCoords({ x: clientX, y: clientY });
        point(place === null ? null : view.state.doc.lineAt(place).number);
      },
      mouseleave: () => point(null),
    }),
    keymap.of([
      { key: 'F9', run: (view) => toggleStop(view, view.state.selection.main.head) },
      ...completionKeymap,
      ...searchKeymap,
      ...foldKeymap,
      { key: 'Enter', run: endLine },
      ...historyKeymap,
      ...defaultKeymap,
    ]),
    EditorView.updateListener.of(({ docChanged, selectionSet, state, focusChanged, geometryChanged, view }) => {
      if (geometryChanged) keepNext(view);
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
      spoken = program.language;
      next = 0;
      view.setState(
        EditorState.create({
          doc: program.text,
          extensions: [
            ...extensions.slice(0, -2),
            language.of(LANGUAGES[program.language]),
            label.of(EditorView.contentAttributes.of({ 'aria-label': CODE.text(program.id), tabindex: '0' })),
          ],
        }),
      );
      isSetting = false;
      if (lines.length > 0) view.dispatch({ effects: setStops.of(lines) });
    },
    /** The same program has another text: of an undo. @param {string} text */
    replace(text) {
      if (text === view.state.doc.toString()) return;
      isSetting = true;
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } });
      isSetting = false;
    },
    /** As if it had been typed: what is the same stays, with its places. @param {string} text */
    rewrite(text) {
      const before = view.state.doc.toString().split('\n');
      const lines = text.split('\n');
      const changes = [];
      let from = 0;
      for (const [i, line] of before.entries()) {
        if (line !== lines[i]) changes.push({ from, to: from + line.length, insert: lines[i] });
        from += line.length + 1;
      }
      view.dispatch({ changes });
    },
    hasFocus: () => view.hasFocus,
    focus: () => view.focus(),
    /** What stands in a line. @param {number} number */
    placeOf(number) {
      const { from, text } = view.state.doc.line(Math.min(Math.max(1, number), view.state.doc.lines));
      return { from: from + text.length - text.trimStart().length, to: from + text.trimEnd().length };
    },
    text: () => view.state.doc.toString(),
    /** @param {readonly Problem[]} problems */
    showProblems(problems) {
      view.dispatch({ effects: setProblems.of(problems) });
    },
    /** @param {number | null} line */
    showNext(line) {
      view.dispatch({ effects: setNext.of(line) });
      if (next === (line ?? 0)) return;
      next = line ?? 0;
      bringInSight();
    },
    /** @param {number} line */
    goTo(line) {
      view.focus(); // first, so that whoever hears of the line finds it looked at
      const { from } = view.state.doc.line(Math.min(Math.max(1, line), view.state.doc.lines));
      view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    },
  };
}

/** @typedef {ReturnType<typeof createEditor>} CodeEditor */
