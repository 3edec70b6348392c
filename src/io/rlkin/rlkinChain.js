/**
 * The frames of an rlkin file, joined by transforms and joints → the one serial chain that is the arm: from the world to
 * the end with the most joints on its way, of those with 2 to 6.
 *
 * @import { Issue } from '../../model/issues.js'
 * @import { RlkinFile, RlkinJoint, RlkinTransform } from './rlkinTable.js'
 *
 * @typedef {RlkinJoint | RlkinTransform} RlkinStep
 */
import { MAX_JOINTS, MIN_JOINTS } from '../../model/document.js';
import { shownText } from '../../model/shownText.js';
import { fileIssue } from '../fileIssues.js';

/** @param {RlkinStep} step @returns {step is RlkinJoint} */
export const isJoint = (step) => 'type' in step;

/**
 * @param {RlkinFile} file  read without errors
 * @param {(record: object) => number | undefined} lineOf
 * @returns {{ path: RlkinStep[], tip: string, issues: Issue[] } | { path: null, issues: Issue[] }}
 */
export function rlkinChain({ frames, joints, transforms }, lineOf) {
  const steps = [...joints, ...transforms];
  const faults = nameFaults(frames, steps, lineOf);
  if (faults.length > 0) return { path: null, issues: faults };
  const refused = (/** @type {string} */ message, /** @type {number | undefined} */ line) => ({
    path: null,
    issues: [fileIssue('not-a-tree', message, { line })],
  });
  /** @type {Map<string, RlkinStep>} what carries a frame */
  const above = new Map();
  for (const step of steps) {
    const other = above.get(step.to);
    if (other) {
      const both = `"${shownText(other.id)}" and "${shownText(step.id)}"`;
      return refused(`The frame "${shownText(step.to)}" is carried by two, ${both}; expected one.`, lineOf(step));
    }
    above.set(step.to, step);
  }
  const world = frames.find(({ kind }) => kind === 'world')?.id ?? '';
  const carrier = above.get(world);
  if (carrier) return refused(`The world is carried by "${shownText(carrier.id)}"; expected nothing.`, lineOf(carrier));
  const frameOf = (/** @type {string} */ id) => frames.find((frame) => frame.id === id) ?? frames[0];
  /** @type {{ id: string, path: RlkinStep[], moving: number }[]} */
  const ways = [];
  for (const frame of frames) {
    const path = pathTo(above, world, frame.id);
    const shown = `The frame "${shownText(frame.id)}"`;
    if (!path) return refused(`${shown} is not joined to the world; expected one tree.`, lineOf(frame));
    ways.push({ id: frame.id, path, moving: path.filter(isJoint).length });
  }
  const carrying = new Set(steps.map(({ from }) => from));
  const ends = ways.filter(({ id }) => !carrying.has(id));
  const arms = ends.filter(({ moving }) => moving >= MIN_JOINTS && moving <= MAX_JOINTS);
  const [arm] = arms.sort((a, b) => b.moving - a.moving || b.path.length - a.path.length);
  if (!arm) {
    const [longest] = ends.sort((a, b) => b.moving - a.moving);
    const chain = `The chain from the world to "${shownText(longest.id)}" has ${longest.moving}`;
    const message = `${chain} ${longest.moving === 1 ? 'joint' : 'joints'}; expected ${MIN_JOINTS} to ${MAX_JOINTS}.`;
    return { path: null, issues: [fileIssue('joint-count', message, { line: lineOf(frameOf(longest.id)) })] };
  }
  const beside = steps.filter((step) => !arm.path.includes(step));
  const issues = beside.length === 0 ? [] : [besideIssue(beside, arm.id, lineOf)];
  return { path: arm.path, tip: arm.id, issues };
}

/** @param {readonly RlkinStep[]} beside @param {string} tip @param {(record: object) => number | undefined} lineOf */
function besideIssue(beside, tip, lineOf) {
  const [{ id }] = beside;
  const more = beside.length === 1 ? '' : ` and ${beside.length - 1} more`;
  const message = `The element "${shownText(id)}"${more} is not on the chain from the world to "${shownText(tip)}" and is not read.`;
  return fileIssue('not-read', message, { line: lineOf(beside[0]) });
}

/**
 * @param {RlkinFile['frames']} frames
 * @param {readonly RlkinStep[]} steps
 * @param {(record: object) => number | undefined} lineOf
 * @returns {Issue[]}
 */
function nameFaults(frames, steps, lineOf) {
  const issues = [];
  const ids = new Set();
  for (const each of [...frames, ...steps]) {
    if (ids.has(each.id)) {
      const message = `Two elements have the id "${shownText(each.id)}"; expected a different id for each.`;
      issues.push(fileIssue('id-taken', message, { line: lineOf(each) }));
    }
    ids.add(each.id);
  }
  const known = new Set(frames.map(({ id }) => id));
  /** @param {string | undefined} id @param {string} of @param {object} where */
  const check = (id, of, where) => {
    if (id === undefined || known.has(id)) return;
    const message = `The ${of} refers to "${shownText(id)}", which is no frame of this file.`;
    issues.push(fileIssue('unknown-link', message, { line: lineOf(where) }));
  };
  for (const step of steps) {
    for (const id of [step.from, step.to]) check(id, `element "${shownText(step.id)}"`, step);
  }
  for (const { id, ignores = [] } of frames) {
    for (const ignore of ignores) check(ignore.idref, `link "${shownText(id)}"`, ignore);
  }
  return issues;
}

/** @param {ReadonlyMap<string, RlkinStep>} above @param {string} base @param {string} tip @returns {RlkinStep[] | null} */
function pathTo(above, base, tip) {
  /** @type {RlkinStep[]} */
  const path = [];
  for (let frame = tip; frame !== base;) {
    const step = above.get(frame);
    if (!step || path.length > above.size) return null;
    path.push(step);
    frame = step.from;
  }
  return path.reverse();
}
