/**
 * What the folds of points and of single joints share: what they put into the scene, and postures in words.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { CriticalSection, Probes, ReachHand, ReachShown } from '../../model/workspace/asked.js'
 * @import { TracedSection } from '../../model/workspace/mapped.js'
 */
import { jointNumber, poseNumber, unitOf, withUnit } from '../parts/format.js';

/** @param {Page} page @param {keyof Probes} name @param {ReachShown | null} shown */
export function showProbe({ store }, name, shown) {
  const { probes } = store.state.session;
  if (probes[name] !== shown) store.dispatch({ type: 'show', change: { probes: { ...probes, [name]: shown } } });
}

/**
 * A point of a fold has been pressed in the scene.
 * @param {Page} page
 * @param {keyof Probes} fold
 * @param {(index: number) => void} use
 */
export const whenPressed = (page, fold, use) =>
  takePress(page, (pressed) => {
    const isMeant = 'fold' in pressed && pressed.fold === fold;
    if (isMeant) use(pressed.index);
    return isMeant;
  });

/**
 * @param {Pick<Page, 'store' | 'addView' | 'clock'>} page
 * @param {(pressed: NonNullable<ReachHand['pressed']>) => boolean} take  false: it is meant for others
 */
export function takePress({ store, addView, clock }, take) {
  const hand = () => store.state.session.reachHand;
  addView(
    ({ session }) => session.reachHand.pressed,
    (pressed) => {
      if (!pressed) return;
      clock.onFrame(() => {
        if (hand().pressed !== pressed || !take(pressed)) return;
        store.dispatch({ type: 'show', change: { reachHand: { ...hand(), pressed: null } } });
      });
    },
  );
}

/** The section, once it is known and is still that of this arm. @param {Page['store']} store @returns {(TracedSection & CriticalSection) | null} */
export function sectionNow({ state }) {
  const { section } = state.session.maps;
  if (!section || section.isStale || section.why || !section.section?.extent) return null;
  return /** @type {TracedSection & CriticalSection} */ (section.section); // the worker posts all of it
}

/** @param {RobotDoc} robot @param {readonly number[]} place  in its units */
export const placeText = ({ units }, place) =>
  withUnit(place.map((value) => poseNumber(value, units.length)).join('  '), units.length);

/** @param {RobotDoc} robot @param {readonly number[]} posture */
export const postureText = ({ joints, units }, posture) =>
  posture
    .map((value, i) => withUnit(jointNumber(value, unitOf(joints[i], units)), unitOf(joints[i], units)))
    .join('  ');
