/** What a program touches, by its steps; and a way around, as steps of it. */
import { expect, test } from 'vitest';
import { compilePosture } from '../../../src/model/compile.js';
import { createDerived } from '../../../src/model/derived.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { atOnce } from '../../../src/model/inSlices.js';
import { planRequest } from '../../../src/model/program/planRequest.js';
import { questionNow } from '../../../src/model/program/planning.js';
import { reduce, startState } from '../../../src/model/session.js';
import {
  aroundRequest,
  checkNow,
  checkRequest,
  checkWanted,
  endsOfMove,
  isSameCheck,
  stepTouches,
  waySteps,
} from '../../../src/model/workcell/programCheck.js';
import { createWorkcells } from '../../../src/model/workcell/workcell.js';
import { checkPlan } from '../../../src/motion/clearance/checkPlan.js';
import { armBodies } from '../../../src/motion/clearance/armBodies.js';
import { createWorkcell } from '../../../src/motion/clearance/workcell.js';
import { answerPlanQuestion } from '../../../src/motion/planQuestion.js';
import { planAtOnce } from '../../../src/motion/planner/planAround.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { automaticRadii } from '../../../src/render/arm/automaticRadii.js';

/** @import { AppState } from '../../../src/model/session.js' */
/** @import { NewStep } from '../../../src/model/program/motionCommands.js' */

const LEFT = [-50, 40, -170, 0, 40, 0];
const RIGHT = [60, 40, -170, 0, 40, 0];
/** @param {readonly number[]} values @returns {NewStep} */
const joints = (values) => ({
  ...{ kind: 'joint', target: { kind: 'posture', values }, speed: 50, speedUnit: '%', acceleration: 100 },
  ...{ ending: { kind: 'percent', value: 50 }, comment: 'there' },
});
/** @param {NewStep} step @returns {NewStep} */
const stopping = (step) => /** @type {NewStep} */ ({ ...step, ending: { kind: 'fine' } });
/** @type {NewStep} */
const WAIT = { kind: 'wait', seconds: 1 };
const POST = /** @type {const} */ ({ kind: 'box', xyz: [480, 60, 400], width: 120, depth: 120, height: 800 });

const derived = createDerived();
const cells = createWorkcells(derived, automaticRadii);

/** A Puma that goes from left to right, past a post. */
function start() {
  let state = startState(newDocument(LIBRARY.puma560));
  const steps = [joints(LEFT), WAIT, joints(RIGHT)];
  state = reduce(state, { type: 'add-motion-program', name: 'There', steps });
  return reduce(state, { type: 'add-obstacle', obstacle: { ...POST, rpy: [0, 0, 0] } });
}

/** The same once it is planned. @param {AppState} state */
function planned(state) {
  const question = questionNow(state);
  if (!question) throw new Error('There is a program.');
  const { request, issues, ...rest } = atOnce(planRequest(question, derived.chain(state.doc)));
  expect(issues).toEqual([]);
  const planning = {
    ...{ question, progress: null, series: null, issues, isGivenUp: false },
    planned: { plan: answerPlanQuestion(request), ...rest },
  };
  return { state: reduce(state, { type: 'show', change: { planning } }), planned: planning.planned };
}

/** As the worker does it. @param {AppState} state @param {ReturnType<typeof planned>['planned']} plan */
function touchesOf(state, plan) {
  const request = checkRequest(state, derived.chain(state.doc), cells, plan);
  const { chains, chainOf, radii, obstacles, parts, margin } = structuredClone(request);
  const among = chains.map((chain) => createWorkcell(armBodies(createChain(chain), radii), obstacles));
  const check = checkPlan((move) => among[chainOf[move]], { parts }, { margin });
  for (;;) {
    const turn = check.next();
    if (turn.done) return stepTouches(turn.value, plan, state.doc);
  }
}

test('a program is checked once it is planned and there is something to keep clear of; an old answer is none', () => {
  const { state, planned: plan } = planned(start());
  const wanted = checkWanted(state);
  expect(wanted).toMatchObject({ planned: plan, margin: null });
  expect(isSameCheck(wanted, checkWanted(state))).toBe(true);
  if (!wanted) throw new Error('As above.');
  const known = reduce(state, { type: 'show', change: { check: { ...wanted, progress: null, touches: [] } } });
  expect(checkNow(known)).not.toBeNull();
  const moved = reduce(known, { type: 'set-posture', posture: known.doc.posture.map((value) => value + 1) });
  expect(checkNow(moved)).toBeNull(); // it begins elsewhere now
  expect(checkNow(reduce(known, { type: 'remove-obstacle', index: 0 }))).toBeNull();
  expect(checkWanted(reduce(known, { type: 'remove-obstacle', index: 0 }))).not.toBeNull(); // it may touch itself
  expect(checkWanted(reduce(known, { type: 'remove-motion-program', program: 0 }))).toBeNull();
  const { workcell } = known.session;
  expect(checkNow(reduce(known, { type: 'show', change: { workcell: { ...workcell, margin: 0.1 } } }))).toBeNull();
  expect(checkNow(reduce(known, { type: 'show', change: { workcell: { ...workcell, isOpen: true } } }))).not.toBeNull();
});

test('a colliding move is found, led around, and clear then; undo brings it back', () => {
  const { state, planned: plan } = planned(start());
  const touches = touchesOf(state, plan);
  expect(touches).toMatchObject([{ step: 2, obstacle: 'box_1', isTouch: true }]);
  expect(touches[0].time).toBeGreaterThan(plan.plan.parts[1].end);
  const ends = endsOfMove(plan, 2);
  if (!ends) throw new Error('It is a joint move.');
  expect(ends.from).toEqual(compilePosture(state.doc.robot, LEFT)); // past the wait
  expect(ends.to).toEqual(compilePosture(state.doc.robot, RIGHT));
  expect(endsOfMove(plan, 1)).toBeNull();
  expect(endsOfMove(plan, 0)?.from).toEqual(plan.plan.start);
  const asked = structuredClone(
    aroundRequest(state, derived.chain(state.doc), cells, ends, { seed: 1, iterations: 5000 }),
  );
  const cell = createWorkcell(armBodies(createChain(asked.chain), asked.radii), asked.obstacles);
  const found = planAtOnce(cell, asked.from, asked.to, asked.options);
  if (found.status !== 'found') throw new Error('There is a way.');
  const steps = waySteps(state.doc, 0, 2, found.way);
  expect(steps.length).toBe(found.way.length - 2);
  expect(steps.length).toBeGreaterThan(0);
  for (const step of steps) {
    expect(step).toMatchObject({ kind: 'joint', speed: 50, ending: { kind: 'fine' }, comment: undefined });
  }
  const led = reduce(state, { type: 'insert-steps', program: 0, at: 2, steps });
  const again = planned(led);
  expect(again.planned.plan.refused).toBeNull();
  expect(touchesOf(again.state, again.planned)).toEqual([]);
  expect(reduce(led, { type: 'undo' }).doc.motionPrograms).toBe(state.doc.motionPrograms);
});

test('an arm that folds onto itself is told of without any obstacle, in the move that does it', () => {
  let state = startState(newDocument(LIBRARY.kuka_kr6_r900));
  const steps = [joints([0, -60, 60, 0, 60, 0]), joints([0, 30, 150, 0, 90, 0]), joints([0, -60, 60, 0, 60, 0])];
  state = reduce(state, { type: 'add-motion-program', name: 'Folds', steps });
  const { state: known, planned: plan } = planned(state);
  const touches = touchesOf(known, plan);
  expect(touches.map(({ step, obstacle }) => [step, obstacle])).toEqual([
    [1, null],
    [2, null],
  ]);
  expect(touches[0].other).not.toBeNull();
});

test('each move is checked with its own tool, a joint move too', () => {
  let state = start();
  state = reduce(state, { type: 'add-frame', kind: 'tool', pose: { xyz: [0, 0, 300] } });
  const [{ id }] = state.doc.frames;
  state = reduce(state, { type: 'remove-motion-program', program: 0 });
  // a ball 200 mm ahead of the flange, where only the long tool is
  const T = tcpPose(derived.chain(state.doc), compilePosture(state.doc.robot, LEFT));
  const centre = [12, 13, 14].map((k) => 1000 * (T[k] + 0.2 * T[k - 4]));
  state = reduce(state, { type: 'remove-obstacle', index: 0 });
  state = reduce(state, { type: 'add-obstacle', obstacle: { kind: 'sphere', xyz: centre, radius: 30 } });
  const back = LEFT.map((value, i) => (i === 0 ? value - 30 : value));
  const steps = [joints(back), joints(LEFT), joints(back), { ...joints(LEFT), tool: id }];
  state = reduce(state, { type: 'add-motion-program', name: 'Tools', steps: steps.map(stopping) });
  const { state: known, planned: plan } = planned(state);
  expect(plan.moves.map((move) => 'chain' in move && move.chain !== undefined)).toEqual([false, false, false, true]);
  expect(touchesOf(known, plan)).toMatchObject([{ step: 3, link: 5 }]);
  const ends = endsOfMove(plan, 3);
  if (!ends) throw new Error('It is a joint move.');
  const asked = aroundRequest(known, derived.chain(known.doc), cells, ends, { seed: 1, iterations: 5 });
  expect(asked.chain.tool?.[14]).toBeCloseTo(0.3, 9);
});
