/**
 * Point to point: whether places can be reached, in which postures, how near it comes to those that cannot, and whether
 * the straight line between two of them can be travelled.
 *
 * @import { Page } from '../page.js'
 * @import { PointRow, LineRow } from '../../model/workspace/pointAnswers.js'
 * @import { NamedPoint } from '../../io/pointsText.js'
 * @import { Asked } from './mapper.js'
 * @import { MapWorkspaceAnswer } from '../../workers/mapWorkspace.js'
 */
import '../css/workspacePoints.css';
import { MAX_POINTS_TEXT, readPoints } from '../../io/pointsText.js';
import { compilePosture } from '../../model/compile.js';
import { fromKernel, toKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { lineParts, lineRow, placeFromKernel, pointRow } from '../../model/workspace/pointAnswers.js';
import { placeInSection, seenInSection, toolPlace } from '../../model/workspace/sweep.js';
import { FARTHEST } from '../../model/workspace/workspaceView.js';
import { h } from '../parts/dom.js';
import { copyable } from '../parts/format.js';
import { TEXT } from '../strings.js';
import { POINTS } from '../words/workspacePoints.js';
import { createLineAnswer } from './lineAnswer.js';
import { isFoldOpen, viewNow } from './look.js';
import { createMapper } from './mapper.js';
import { createPickButton } from './pickButton.js';
import { createPointAnswer } from './pointAnswer.js';
import { createPointsTable, SHORT_NAME } from './pointsTable.js';
import { sectionNow, showProbe } from './probes.js';
import { createReachFigure } from './reachFigure.js';

/** @param {Page} page @param {HTMLElement} body @param {(summary: string) => void} say @param {(draw: () => void) => void} afterPress  when nothing is pressed */
export function createPointsPanel(page, body, say, afterPress) {
  const { store, addView, derived, announce, clock, messages } = page;
  const robot = () => store.state.doc.robot;
  const chainNow = () => derived.chain(store.state.doc);
  /** What was asked, and what was said to it; points without an answer are still being asked. @type {readonly NamedPoint[]} */
  let asked = [];
  /** @type {PointRow[]} */
  let rows = [];
  /** @type {{ from: number, to: number, row: LineRow | null } | null} */
  let line = null;
  let chosen = 0;

  const text = h('textarea', {
    ...{ class: 'text-box', rows: 3, spellcheck: 'false', placeholder: POINTS.placeholder },
    maxlength: MAX_POINTS_TEXT + 1,
  });
  const reason = h('p', { class: 'reason sm', role: 'alert', hidden: true });
  const working = h('p', { class: 'sm soft', role: 'status', hidden: true });
  const input = h('input', { type: 'file', accept: '.csv,.tsv,.txt,text/csv' }); // stands nowhere: it is only asked
  const act = (/** @type {string} */ name, /** @type {string} */ look, /** @type {() => void} */ run) => {
    const made = h('button', { type: 'button', class: `btn ${look}` }, name);
    made.addEventListener('click', run);
    return made;
  };
  const answer = createPointAnswer(page);
  const table = createPointsTable(page, choose, () => {
    text.value = ''; // what is picked next is added to nothing
    take([]);
  });
  const lineAnswer = createLineAnswer(page, askLine);
  const figure = createReachFigure(POINTS.drawing, pick, announce);
  const mapper = createMapper(clock, failed);
  const liner = createMapper(clock, failed);
  const nameOf = (/** @type {number} */ i) => rows[i]?.name || String(i + 1);

  /** @param {unknown} error */
  function failed(error) {
    working.textContent = POINTS.failed;
    working.hidden = false;
    messages.fault(error);
  }

  /** @param {string | null} why */
  function refuse(why) {
    reason.textContent = why ?? '';
    reason.hidden = why === null;
  }

  function read() {
    const { units } = robot();
    const { points, fault } = readPoints(text.value, fromKernel('length', FARTHEST, units));
    if (points) {
      refuse(null);
      take(points);
    } else {
      refuse('line' in fault ? POINTS.fault[fault.code](fault.line) : POINTS.fault[fault.code]);
      text.focus();
    }
  }

  /** Asks for places besides those that stand there. @param {readonly number[]} place  m */
  function add(place) {
    const typed = text.value.trimEnd();
    text.value = [typed, copyable(placeFromKernel(robot(), place).map((value) => Number(value.toPrecision(7))))]
      .filter(Boolean)
      .join('\n');
    read();
    if (reason.hidden) chosen = asked.length - 1;
  }

  /** @param {number} u @param {number} v */
  function pick(u, v) {
    const section = sectionNow(store);
    if (section) add(placeInSection(section, u, v));
  }

  input.addEventListener('change', async () => {
    const file = input.files?.[0];
    input.value = '';
    if (!file) return;
    if (file.size > 4 * MAX_POINTS_TEXT) return refuse(POINTS.fault['too-long']);
    try {
      text.value = new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
    } catch {
      return refuse(POINTS.fileFault);
    }
    read();
  });
  text.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey || !text.value.includes('\n'))) {
      if (event.shiftKey) return;
      event.preventDefault();
      read();
    }
  });

  const describe = () => {
    const { convention, base, tool, joints } = chainNow();
    return { convention, base, tool, joints };
  };
  /** @param {typeof mapper} by @param {Asked['job']} job @param {(said: MapWorkspaceAnswer) => void} answered  when nothing is pressed */
  const ask = (by, job, answered) => by.ask({ chain: describe(), job }, (said) => afterPress(() => answered(said)));
  const options = () => ({ withLimits: viewNow(page).withLimits, seed: viewNow(page).seed });
  /** @param {readonly number[]} at */
  const inKernel = (at) => at.map((value) => toKernel('length', value, robot().units));

  /** @param {readonly NamedPoint[]} points */
  function take(points) {
    asked = points;
    rows = [];
    line = null;
    chosen = Math.min(chosen, Math.max(0, points.length - 1));
    liner.stop();
    draw();
    if (points.length === 0) {
      working.hidden = true;
      return mapper.stop();
    }
    working.hidden = false;
    working.textContent = POINTS.asking(0, points.length);
    const places = points.map(({ at }) => inKernel(at));
    ask(mapper, { kind: 'points', places, options: options() }, (said) => {
      if (asked !== points) return;
      if ('fault' in said) return failed(new Error(said.fault));
      if ('word' in said) {
        working.textContent = POINTS.asking(Math.round(said.word.share * points.length), points.length);
        return;
      }
      const { found } = said;
      working.hidden = found.kind === 'points';
      if (found.kind !== 'points') {
        working.textContent = POINTS.notMapped;
        return;
      }
      rows = found.answers.map((one, i) => pointRow(robot(), points[i], one));
      draw();
      lineAnswer.offer(rows, nameOf);
      const reached = rows.filter(({ verdict }) => verdict === 'reached').length;
      if (rows.length > 1) announce(POINTS.summary(reached, rows.length));
    });
  }

  /** @param {number} from @param {number} to */
  function askLine(from, to) {
    const now = { from, to, row: /** @type {LineRow | null} */ (null) };
    line = now;
    lineAnswer.draw(null, POINTS.line.working);
    const [a, b] = [from, to].map((i) => inKernel(asked[i].at));
    ask(liner, { kind: 'line', from: a, to: b, options: options() }, (said) => {
      if ('fault' in said) return failed(new Error(said.fault));
      if ('word' in said || said.found.kind !== 'line' || line !== now) return;
      now.row = lineRow(robot(), said.found.answer);
      lineAnswer.draw(now.row);
      draw();
    });
  }

  /** @param {number} index */
  function choose(index) {
    chosen = index;
    draw();
  }

  function draw() {
    answer.draw(rows[chosen] ?? null, nameOf(chosen));
    table.draw(rows.length > 0 ? rows : [], chosen, nameOf);
    lineAnswer.element.hidden = rows.length < 2;
    say(rows.length > 0 ? POINTS.summary(rows.filter(({ verdict }) => verdict === 'reached').length, rows.length) : '');
    const points = rows.map(({ at, verdict }, i) => ({
      at: inKernel(at),
      text: nameOf(i).length > SHORT_NAME ? String(i + 1) : nameOf(i),
      isReached: verdict === 'reached',
    }));
    const lines = line?.row
      ? lineParts(line.row.share, inKernel(asked[line.from].at), inKernel(asked[line.to].at))
      : [];
    showProbe(page, 'points', points.length > 0 ? { points, lines } : null);
    drawFigure();
  }

  function drawFigure() {
    const section = sectionNow(store);
    figure.element.hidden = section === null;
    if (!section) return;
    const shown = store.state.session.probes.points ?? { points: [], lines: [] };
    const { posture } = store.state.doc;
    figure.draw(
      {
        section,
        units: robot().units,
        lines: shown.lines.map(({ points, kind }) => ({
          kind,
          points: [...seenInSection(section, points), ...seenInSection(section, points, points.length - 3)],
        })),
        dots: shown.points.map(({ at, text: name, isReached }, i) => {
          const [u, v] = seenInSection(section, at);
          return { u, v, text: name, isReached, press: () => choose(i) };
        }),
        tool: seenInSection(section, toolPlace(chainNow(), compilePosture(robot(), posture))),
      },
      `${POINTS.drawing}. ${POINTS.drawingHelp}`,
    );
  }

  const tool = act(POINTS.tool, 'btn-outline', () =>
    add(toolPlace(chainNow(), compilePosture(robot(), store.state.doc.posture))),
  );
  body.append(
    h(
      'div',
      { class: 'reach-body' },
      h('p', { class: 'sm soft' }, POINTS.about),
      h(
        'div',
        { class: 'section-figure' },
        text,
        reason,
        h(
          'div',
          { class: 'row-flex points-acts' },
          act(POINTS.ask, 'btn-primary', read),
          tool,
          createPickButton(page, { add, choose }),
          act(POINTS.open, 'btn-outline', () => input.click()),
        ),
        working,
      ),
      answer.element,
      table.element,
      lineAnswer.element,
      h('p', { class: 'sm soft' }, POINTS.pick),
      figure.element,
    ),
  );
  answer.draw(null, '');
  table.draw([], 0, nameOf);
  lineAnswer.element.hidden = true;

  addView(
    ({ doc }) => doc.robot.units.length,
    (unit) => text.setAttribute('aria-label', POINTS.text(TEXT.table.unitName[unit])),
  );
  // another arm, or other limits: the same points are asked again
  let before = '';
  addView(
    together(({ doc, session }) => [
      derived.chain(doc),
      session.workspace?.withLimits,
      isFoldOpen(session, 'points') && session.tab === 'workspace',
    ]),
    ([chain, withLimits, isOpen]) => {
      const { convention, base, tool: onTool, joints } = chain;
      const now = JSON.stringify([convention, base, onTool, joints, withLimits, robot().units]);
      if (!isOpen || now === before) return;
      const isFirst = before === '';
      before = now;
      if (!isFirst && asked.length > 0) clock.onFrame(() => afterPress(read));
    },
  );
  addView(
    together(({ doc, session }) => [session.maps.section, doc.posture, isFoldOpen(session, 'points')]),
    ([, , isOpen]) => {
      if (isOpen) afterPress(drawFigure);
    },
  );
}
