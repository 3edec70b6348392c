/**
 * What a step to be undone did, told from the documents before and after it: nothing has to be kept for that, and a drag of
 * a hundred commands is named as the one thing that it comes to. Words are for whoever shows it (ui/stepName.js).
 *
 * @import { Convention, Doc, JointDoc, JointField, RobotDoc, Units } from './document.js'
 * @import { Rate } from './robot/robotCommands.js'
 *
 * @typedef {'postures' | 'targets' | 'frames' | 'obstacles' | 'programs' | 'motionPrograms'} ListName
 * @typedef {'added' | 'removed' | 'renamed' | 'moved' | 'changed'} ListChange
 *
 * @typedef {{ what: 'field', joint: number, field: JointField }
 *   | { what: 'rate', joint: number, rate: Rate }
 *   | { what: 'type' | 'link' | 'controller' | 'joint' | 'joint-added' | 'joint-removed' | 'joint-moved', joint: number }
 *   | { what: 'robot' | 'name', name: string }
 *   | { what: 'tool-chosen' | 'user-chosen', id: string | null }
 *   | { what: 'units', units: Units }
 *   | { what: 'convention', convention: Convention }
 *   | { what: 'base' | 'tool' | 'info' | 'order' | 'table' | 'posture' | 'postures' | 'codeOptions' | 'other' }
 *   | { what: 'step', change: ListChange, step: number }
 *   | { what: 'list', list: ListName, change: ListChange, id: string }} Change  `joint` and `step` count from 0
 */
import { textOf } from './robot/jointFields.js';

/**
 * @param {Doc} before
 * @param {Doc} after  another one
 * @returns {Change}
 */
export function whatChanged(before, after) {
  const chosen = before.robot.joints === after.robot.joints ? ofActive(before, after) : null;
  if (chosen) return chosen;
  if (before.robot !== after.robot) return ofRobot(before.robot, after.robot);
  if (areSeveral(before.postures, after.postures)) return { what: 'postures' };
  if (before.posture !== after.posture) {
    const moved = differing(before.posture, after.posture);
    return moved.length === 1 ? { what: 'joint-moved', joint: moved[0] } : { what: 'posture' };
  }
  for (const list of /** @type {const} */ (['postures', 'frames', 'targets', 'obstacles', 'programs'])) {
    if (before[list] !== after[list]) return ofList(list, before[list], after[list]);
  }
  if (before.motionPrograms !== after.motionPrograms) return ofPrograms(before.motionPrograms, after.motionPrograms);
  return { what: before.codeOptions === after.codeOptions ? 'other' : 'codeOptions' };
}

/** @param {Doc['motionPrograms']} before @param {Doc['motionPrograms']} after @returns {Change} */
function ofPrograms(before, after) {
  const { change, id } = ofList('motionPrograms', before, after);
  const [old, now] = [before, after].map((programs) => programs.find((program) => program.id === id));
  if (old && now && old.steps !== now.steps) {
    const step = ofList('motionPrograms', old.steps, now.steps);
    const { steps } = step.change === 'removed' ? old : now;
    return { what: 'step', change: step.change, step: steps.findIndex((one) => one.id === step.id) };
  }
  return {
    what: 'list',
    list: 'motionPrograms',
    change: old && now ? 'renamed' : change,
    id: (now ?? old)?.name ?? id,
  };
}

/**
 * Another active tool or user frame, unless the old one was only renamed; one that is gone was removed.
 * @param {Doc} before @param {Doc} after @returns {Change | null}
 */
function ofActive(before, after) {
  const isGone = after.frames.length < before.frames.length;
  if (before.activeTool === after.activeTool && before.activeUser === after.activeUser) return null;
  if (isGone) return ofList('frames', before.frames, after.frames);
  const isListed = (/** @type {string | undefined} */ id) =>
    id === undefined || after.frames.some((frame) => frame.id === id);
  if (before.activeTool !== after.activeTool) {
    return isListed(before.activeTool) ? { what: 'tool-chosen', id: after.activeTool ?? null } : null;
  }
  return isListed(before.activeUser) ? { what: 'user-chosen', id: after.activeUser ?? null } : null;
}

/** @param {RobotDoc} before @param {RobotDoc} after @returns {Change} */
function ofRobot(before, after) {
  const { name, units, convention, joints } = after;
  if (joints !== before.joints && (name !== before.name || after.info !== before.info)) return { what: 'robot', name };
  if (units.length !== before.units.length || units.angle !== before.units.angle) return { what: 'units', units };
  if (convention !== before.convention) return { what: 'convention', convention };
  if (joints !== before.joints) return ofJoints(before.joints, joints);
  if (after.base !== before.base) return { what: 'base' };
  if (after.tool !== before.tool) return { what: 'tool' };
  if (name !== before.name) return { what: 'name', name };
  return { what: 'info' };
}

/** @param {readonly JointDoc[]} before @param {readonly JointDoc[]} after @returns {Change} */
function ofJoints(before, after) {
  const [old, now] = [before, after].map((joints) => joints.map(({ id }) => id));
  if (now.length === old.length + 1) return { what: 'joint-added', joint: firstOther(now, old) };
  if (now.length === old.length - 1) return { what: 'joint-removed', joint: firstOther(old, now) };
  if (now.length !== old.length) return { what: 'table' };
  if (now.some((id, i) => id !== old[i])) return { what: 'order' };
  const changed = differing(before, after);
  const retyped = changed.filter((i) => before[i].type !== after[i].type);
  if (retyped.length === 1) return { what: 'type', joint: retyped[0] }; // couplings to it go, too
  return changed.length === 1 ? ofJoint(changed[0], before[changed[0]], after[changed[0]]) : { what: 'table' };
}

/** @type {readonly JointField[]} */
const FIELDS = ['theta', 'd', 'a', 'alpha', 'lower', 'upper', 'home'];
/** @type {readonly Rate[]} */
const RATES = ['velocity', 'acceleration', 'jerk', 'effort'];

/** @param {number} joint @param {JointDoc} before @param {JointDoc} after @returns {Change} */
function ofJoint(joint, before, after) {
  const fields = FIELDS.filter(
    (field) => !Object.is(before[field], after[field]) || textOf(before, field) !== textOf(after, field),
  );
  const rates = RATES.filter((rate) => before[rate] !== after[rate]);
  const isLink = before.link !== after.link;
  const isController = before.controller !== after.controller;
  if (fields.length + rates.length + Number(isLink) + Number(isController) !== 1) return { what: 'joint', joint };
  if (isLink) return { what: 'link', joint };
  if (isController) return { what: 'controller', joint };
  return fields.length === 1 ? { what: 'field', joint, field: fields[0] } : { what: 'rate', joint, rate: rates[0] };
}

/** @param {ListName} list @param {readonly { id: string }[]} before @param {readonly { id: string }[]} after @returns {Extract<Change, { what: 'list' }>} */
function ofList(list, before, after) {
  const [old, now] = [before, after].map((items) => items.map(({ id }) => id));
  /** @param {ListChange} change @param {string} id @returns {Extract<Change, { what: 'list' }>} */
  const told = (change, id) => ({ what: 'list', list, change, id });
  if (now.length > old.length) return told('added', now[firstOther(now, old)]);
  if (now.length < old.length) return told('removed', old[firstOther(old, now)]);
  const others = differing(old, now);
  if (others.length === 1) return told('renamed', now[others[0]]);
  if (others.length > 1) {
    const [first, last] = [others[0], others[others.length - 1]];
    return told('moved', now[last] === old[first] ? now[last] : now[first]);
  }
  const changed = differing(before, after);
  return told('changed', now[changed[0] ?? 0]);
}

/**
 * Of the postures more than one changed at once, as happens when a table of them is read.
 * @param {Doc['postures']} before @param {Doc['postures']} after
 */
function areSeveral(before, after) {
  if (Math.abs(before.length - after.length) > 1) return true;
  if (before.length !== after.length) return false;
  const ids = new Set(before.map(({ id }) => id));
  return differing(before, after).length > 1 && !after.every(({ id }) => ids.has(id));
}

/** Where two lists of one length differ. @param {readonly unknown[]} one @param {readonly unknown[]} other */
const differing = (one, other) => [...one.keys()].filter((i) => !Object.is(one[i], other[i]));

/** The first place of the longer list that the shorter one has not likewise. @param {readonly unknown[]} longer @param {readonly unknown[]} shorter */
const firstOther = (longer, shorter) => longer.findIndex((item, i) => item !== shorter[i]);
