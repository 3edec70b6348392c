/**
 * Solutions that are a line: in words, and a slider that moves the arm along it. The line is walked a few steps a frame, so that
 * the page stays as quick as it was.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { FamilyLine } from '../../model/aim/families.js'
 * @import { FoundSolutions } from '../../model/aim/solutions.js'
 */
import { walkFamily } from '../../model/aim/families.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, unitOf, withUnit } from '../parts/format.js';
import { newGesture } from '../page.js';
import { SOLUTIONS } from '../words/solutions.js';

const STEPS_A_FRAME = 2;

/** @param {Page} page */
export function createFamilies(page) {
  const { store, clock } = page;
  const element = h('div', {});
  let turn = 0;

  /** @param {FamilyLine} line @param {HTMLElement} room @param {RobotDoc} robot */
  function build(line, room, robot) {
    const { members, leader, joints, start } = line;
    const moved = joints.map((i) => `J${i + 1}`).join(', ');
    if (members.length < 2) {
      fill(room, h('p', { class: 'soft sm' }, SOLUTIONS.familySingle));
      return;
    }
    const unit = unitOf(robot.joints[leader], robot.units);
    const inWords = (/** @type {number} */ i) => withUnit(jointNumber(members[i].value, unit), unit);
    const slider = h('input', { type: 'range', min: 0, max: members.length - 1, step: 1, value: start });
    const shown = h('output', {}, inWords(start));
    slider.setAttribute('aria-valuetext', inWords(start));
    let gesture = newGesture();
    slider.addEventListener('input', () => {
      const i = Number(slider.value);
      shown.value = inWords(i);
      slider.setAttribute('aria-valuetext', inWords(i));
      store.dispatch({ type: 'set-posture', posture: members[i].posture, gesture });
    });
    slider.addEventListener('change', () => {
      store.dispatch({ type: 'end-gesture' });
      gesture = newGesture();
    });
    fill(
      room,
      h('label', {}, h('span', { class: 'sm' }, SOLUTIONS.familyMove(`J${leader + 1}`)), slider, shown),
      h('p', { class: 'soft sm' }, SOLUTIONS.familyFixed(moved)),
    );
  }

  return {
    element,
    /**
     * @param {RobotDoc} robot
     * @param {Parameters<typeof walkFamily>[1]} chain
     * @param {Float64Array} T
     * @param {FoundSolutions['families']} families
     * @param {boolean} isSame  pose as before: the sliders stay, one of them may be in the hand
     */
    show(robot, chain, T, families, isSame) {
      if (isSame && element.childElementCount === families.length) return;
      const own = ++turn;
      fill(
        element,
        families.map((family) => {
          const room = h('div', {}, h('p', { class: 'soft sm', role: 'status' }, SOLUTIONS.searching));
          const walking = walkFamily(robot, chain, T, family);
          const go = () => {
            if (own !== turn) return;
            for (let i = 0; i < STEPS_A_FRAME; i++) {
              const step = walking.next();
              if (step.done) return build(step.value, room, robot);
            }
            clock.onFrame(go);
          };
          clock.onFrame(go);
          return h('div', { class: 'family' }, h('p', { class: 'sm' }, SOLUTIONS.family[family.kind]), room);
        }),
      );
    },
  };
}
