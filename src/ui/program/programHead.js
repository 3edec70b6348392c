/**
 * The head of the Program panel: which program, what "Record here" makes, and what else can be a step.
 *
 * @import { Choice } from '../parts/choices.js'
 * @import { Page } from '../page.js'
 * @import { MotionProgramDoc, MoveStep } from '../../model/document.js'
 * @import { NewStep } from '../../model/program/motionCommands.js'
 *
 * @typedef {object} HeadActs
 * @property {() => void} record
 * @property {(step: NewStep) => void} add
 * @property {() => void} copy    the chosen steps
 * @property {() => void} paste
 * @property {(id: string) => void} choose     a program
 * @property {() => void} rename
 * @property {(text: string) => void} say
 * @property {(reason: string | null) => void} refuse
 */
import { newStep, withTarget } from '../../model/program/newSteps.js';
import { FIRST_RECORDING } from '../../model/program/recording.js';
import { chosenSteps } from '../../model/program/stepRange.js';
import { refusal } from '../../model/refusals.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { withChoices } from '../parts/choices.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { readyChoices } from './readyMenu.js';
import { segments } from '../parts/segments.js';
import { PROGRAM } from '../words/program.js';
import { STEP_RANGE } from '../words/stepRange.js';

/** @type {readonly MoveStep['kind'][]} */
const KINDS = ['joint', 'linear', 'circular'];
const OTHERS = /** @type {const} */ (['wait', 'set-output', 'wait-input', 'call', 'label', 'comment']);

/**
 * @param {Page} page
 * @param {HeadActs} acts
 */
export function createProgramHead(page, acts) {
  const { store } = page;
  const nameText = h('span', { class: 'b program-name' });
  const programs = h(
    'button',
    { type: 'button', class: 'btn', title: PROGRAM.programs },
    nameText,
    icon('caret', 'caret'),
  );
  const recordText = h('span', {}, PROGRAM.record);
  const record = h(
    'button',
    { type: 'button', class: 'btn btn-primary', 'data-action': 'record' },
    icon('record'),
    recordText,
  );
  record.addEventListener('click', acts.record);
  const kinds = segments(PROGRAM.kinds, KINDS, PROGRAM.kind, (kind) =>
    store.dispatch({ type: 'show', change: { recording: { ...FIRST_RECORDING, kind } } }),
  );
  const plus = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': PROGRAM.add, title: PROGRAM.add },
    icon('plus'),
  );
  const forget = h('button', { type: 'button', class: 'btn btn-small' }, PROGRAM.noVia);
  forget.addEventListener('click', () => {
    store.dispatch({ type: 'show', change: { recording: { kind: 'circular', via: null } } });
  });
  const hint = h('p', { class: 'sm soft inset', role: 'status', hidden: true }, PROGRAM.recordedVia, ' ', forget);

  /** @returns {readonly Choice[]} */
  function programChoices() {
    const { doc } = store.state;
    const { program, index } = shownProgram(store.state);
    const all = doc.motionPrograms.map(({ id, name }) => ({
      title: name,
      isChosen: id === program?.id,
      run: () => acts.choose(id),
    }));
    return program && index >= 0 ? all : [];
  }

  /** @returns {Choice[]} */
  function programActs() {
    const { doc } = store.state;
    const { program, index } = shownProgram(store.state);
    const add = /** @type {const} */ ({
      type: 'add-motion-program',
      name: PROGRAM.newName(doc.motionPrograms.length + 1),
    });
    const remove = /** @type {const} */ ({ type: 'remove-motion-program', program: index });
    return [
      {
        title: PROGRAM.newProgram,
        against: refusal(doc, add)?.message ?? null,
        run() {
          if (attempt(page, add) === null) acts.choose(lastOf(store.state.doc.motionPrograms).id);
        },
      },
      ...(program
        ? [
            { title: PROGRAM.rename, run: acts.rename },
            {
              title: PROGRAM.removeProgram(program.name),
              against: refusal(doc, remove)?.message ?? null,
              run() {
                if (attempt(page, remove) === null) acts.say(PROGRAM.removedProgram(program.name));
              },
            },
          ]
        : []),
    ];
  }

  const others = () => {
    const { doc } = store.state;
    const { program, step } = shownProgram(store.state);
    const before = program?.steps.slice(0, step < 0 ? undefined : step + 1) ?? [];
    return {
      groups: [
        OTHERS.map((kind) => ({ title: PROGRAM.addStep[kind], run: () => acts.add(newStep(kind, doc, program)) })),
        doc.targets.map(({ id }) => ({
          title: PROGRAM.moveTo(id),
          run: () => acts.add(withTarget(doc, 'joint', { kind: 'target', id }, before)),
        })),
        [
          ...(step < 0 ? [] : [{ title: STEP_RANGE.copyChosen(chosenSteps(store.state)?.count ?? 1), run: acts.copy }]),
          { title: STEP_RANGE.act.paste, run: acts.paste },
        ],
      ].filter((group) => group.length > 0),
    };
  };

  const examples = h('button', { type: 'button', class: 'btn' }, PROGRAM.examples, icon('caret', 'caret'));
  const element = h(
    'div',
    { class: 'program-head' },
    h(
      'div',
      { class: 'table-head' },
      withChoices(programs, () => ({
        groups: [programChoices(), programActs(), readyChoices(page, acts)].filter((group) => group.length > 0),
      })),
      h('span', { class: 'grow' }),
      record,
      withChoices(plus, others),
    ),
    h(
      'div',
      { class: 'program-kinds' },
      h('span', { class: 'soft sm', 'aria-hidden': 'true' }, PROGRAM.kinds),
      h('span', { class: 'grow' }),
      kinds.element,
    ),
    hint,
  );

  return {
    element,
    examples: withChoices(examples, () => ({ groups: [readyChoices(page, acts)] })),
    draw() {
      const { program } = shownProgram(store.state);
      const { kind, via } = store.state.session.recording;
      element.hidden = program === null;
      fill(nameText, program?.name || PROGRAM.title);
      kinds.draw(kind);
      recordText.textContent = kind !== 'circular' ? PROGRAM.record : via ? PROGRAM.recordEnd : PROGRAM.recordVia;
      hint.hidden = via === null;
    },
  };
}

/** @param {readonly MotionProgramDoc[]} programs  at least one */
const lastOf = (programs) => programs[programs.length - 1];
