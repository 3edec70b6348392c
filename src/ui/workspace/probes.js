/**
 * What the folds of points and of single joints share: what they put into the scene, and postures in words.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { CriticalSection, ReachShown, Probes } from '../../model/workspace/asked.js'
 * @import { TracedSection } from '../../model/workspace/mapped.js'
 */
import { jointNumber, poseNumber, unitOf, withUnit } from '../parts/format.js';

/** @param {Page} page @param {keyof Probes} name @param {ReachShown | null} shown */
export function showProbe({ store }, name, shown) {
  const { probes } = store.state.session;
  if (probes[name] !== shown) store.dispatch({ type: 'show', change: { probes: { ...probes, [name]: shown } } });
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
