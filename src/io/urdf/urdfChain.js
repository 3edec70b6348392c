/**
 * Which serial chain of a URDF's tree is the arm: from a base link to a tip link, with 2 to 6 joints that move.
 *
 * @import { Issue } from '../../model/issues.js'
 * @import { UrdfJoint, UrdfRobot } from './urdfRobot.js'
 *
 * @typedef {object} UrdfTree
 * @property {string} root
 * @property {ReadonlyMap<string, UrdfJoint>} above   the joint that carries a link, by the link's name; none for the root
 *
 * @typedef {object} TipChoice  a link that may be the tip
 * @property {string} link
 * @property {number} moving    how many joints move between the base and it
 */
import { MAX_JOINTS, MIN_JOINTS } from '../../model/document.js';
import { shownText } from '../../model/shownText.js';
import { fileIssue } from '../fileIssues.js';

/** What makers call the link that tools are screwed to, best first. */
const TIP_NAMES = [/(^|[_/])tool0$/i, /(^|[_/])flange$/i];

/** Joints that come after the arm. */
const FINGERS = /finger|gripper|knuckle|jaw|suction/i;

/** @param {UrdfJoint} joint */
export const moves = ({ type }) => type !== 'fixed';

/** @param {UrdfJoint} joint  that moves */
const isArmJoint = ({ name, type, mimics }) =>
  mimics === null && type !== 'floating' && type !== 'planar' && !FINGERS.test(name);

/**
 * @param {UrdfRobot} robot  read without errors
 * @returns {{ tree: UrdfTree, issues: [] } | { tree: null, issues: Issue[] }}
 */
export function urdfTree({ links, joints }) {
  const refused = (/** @type {string} */ message, /** @type {number | undefined} */ line) => ({
    tree: null,
    issues: [fileIssue('not-a-tree', message, { line })],
  });
  /** @type {Map<string, UrdfJoint>} */
  const above = new Map();
  for (const joint of joints) {
    const other = above.get(joint.child);
    if (other) {
      const both = `"${shownText(other.name)}" and "${shownText(joint.name)}"`;
      return refused(
        `The link "${shownText(joint.child)}" is carried by two joints, ${both}; expected one.`,
        joint.line,
      );
    }
    above.set(joint.child, joint);
  }
  const roots = [...links.keys()].filter((link) => !above.has(link));
  if (links.size === 0) return refused('The file has no links; expected a robot with at least three.', undefined);
  if (roots.length === 0)
    return refused('The links go round in a circle; expected one that no joint carries.', undefined);
  if (roots.length > 1) {
    const [one, other] = roots.map((link) => `"${shownText(link)}"`);
    return refused(`The links ${one} and ${other} are not joined; expected one tree.`, links.get(roots[1]));
  }
  for (const link of links.keys()) {
    if (pathTo({ root: roots[0], above }, roots[0], link) !== null) continue;
    return refused(
      `The link "${shownText(link)}" goes round in a circle with others; expected one tree.`,
      links.get(link),
    );
  }
  return { tree: { root: roots[0], above }, issues: [] };
}

/**
 * The joints from a link to another that it carries, base first.
 * @param {UrdfTree} tree
 * @param {string} base
 * @param {string} tip
 * @returns {UrdfJoint[] | null} null if `base` does not carry `tip`
 */
export function pathTo({ above }, base, tip) {
  /** @type {UrdfJoint[]} */
  const path = [];
  for (let link = tip; link !== base;) {
    const joint = above.get(link);
    if (!joint || path.length > above.size) return null;
    path.push(joint);
    link = joint.parent;
  }
  return path.reverse();
}

/**
 * The links that may be the tip of an arm that begins at `base`.
 * @param {UrdfTree} tree
 * @param {UrdfRobot} robot
 * @param {string} base
 * @returns {TipChoice[]}
 */
export const tipsFrom = (tree, { links }, base) =>
  [...links.keys()].flatMap((link) => {
    const path = pathTo(tree, base, link);
    const moving = path?.filter(moves).length ?? 0;
    return moving >= MIN_JOINTS && moving <= MAX_JOINTS ? [{ link, moving }] : [];
  });

/**
 * The likeliest tip: the one that is called as tips are, or else the end of the longest chain without fingers. Of two that
 * are as good, the one with more that moves, then the one farther out, then the first of the file.
 * @param {UrdfTree} tree
 * @param {UrdfRobot} robot
 * @param {string} base
 * @returns {string | null} null if there is no chain of 2 to 6 moving joints
 */
export const likelyTip = (tree, robot, base) => rankedTips(tree, robot, base)[0]?.link ?? null;

/** @param {UrdfTree} tree @param {UrdfRobot} robot @param {string} base  the likeliest tip first */
const rankedTips = (tree, robot, base) =>
  tipsFrom(tree, robot, base)
    .map(({ link, moving }) => {
      const path = pathTo(tree, base, link) ?? [];
      const found = TIP_NAMES.findIndex((pattern) => pattern.test(link));
      const named = found === -1 ? TIP_NAMES.length : found;
      const isArm = path.every((joint) => !moves(joint) || isArmJoint(joint));
      return { link, moving, isArm, isNamed: found !== -1, rank: [isArm ? 0 : 1, named, -moving, -path.length] };
    })
    .sort((a, b) => a.rank.map((value, i) => value - b.rank[i]).find((difference) => difference !== 0) ?? 0);

/**
 * The likeliest tip is one of several that are about as likely: at the end of another branch, with as many joints that move,
 * and no better name.
 * @param {UrdfTree} tree
 * @param {UrdfRobot} robot
 * @param {string} base
 */
export function leavesChoice(tree, robot, base) {
  const [best, ...others] = rankedTips(tree, robot, base);
  if (!best) return false;
  const isRival = (/** @type {typeof best} */ other) =>
    other.isArm && other.moving === best.moving && (other.isNamed || !best.isNamed);
  const isOnOneLine = (/** @type {string} */ link) =>
    pathTo(tree, link, best.link) !== null || pathTo(tree, best.link, link) !== null;
  // flange and tool0 of one arm name one and the same end of it
  const lastMoved = (/** @type {string} */ link) => pathTo(tree, base, link)?.findLast(moves);
  const isSameEnd = (/** @type {string} */ link) => best.isNamed && lastMoved(link) === lastMoved(best.link);
  return !best.isArm || others.filter(isRival).some(({ link }) => !isOnOneLine(link) && !isSameEnd(link));
}

/**
 * The end of an arm that goes on beyond its likeliest tip because it has too many joints: a part of it is no arm of its own.
 * @param {UrdfTree} tree
 * @param {UrdfRobot} robot
 * @param {string} base
 * @param {string} tip
 * @returns {TipChoice | null}
 */
export function endBeyond(tree, { links }, base, tip) {
  if (TIP_NAMES.some((pattern) => pattern.test(tip))) return null;
  const ends = [...links.keys()].flatMap((link) => {
    const more = pathTo(tree, tip, link)?.filter(moves) ?? [];
    const all = pathTo(tree, base, link)?.filter(moves) ?? [];
    return more.length > 0 && more.every(isArmJoint) ? [{ link, moving: all.length }] : [];
  });
  return ends.sort((a, b) => b.moving - a.moving)[0] ?? null;
}

/**
 * What is in the way of taking these joints for an arm.
 * @param {readonly UrdfJoint[]} path
 * @returns {Issue[]}
 */
export function pathIssues(path) {
  const issues = path.flatMap(({ name, type, mimics, limit, line }) => {
    const joint = `The joint "${shownText(name)}"`;
    if (type === 'floating' || type === 'planar') {
      const message = `${joint} of this chain is ${type}, which moves in several directions at once; expected joints that turn or slide.`;
      return [fileIssue('joint-type', message, { line })];
    }
    if (limit && type !== 'continuous' && limit.lower > limit.upper) {
      const message = `${joint} has the limits ${limit.lower} and ${limit.upper}; expected the lower one first.`;
      return [fileIssue('limits-crossed', message, { line })];
    }
    if (type === 'fixed' || mimics === null) return [];
    const message = `${joint} of this chain follows "${shownText(mimics)}" (mimic); expected joints that move on their own.`;
    return [fileIssue('mimic', message, { line })];
  });
  const moving = path.filter(moves).length;
  if (moving >= MIN_JOINTS && moving <= MAX_JOINTS) return issues;
  const message = `The chain has ${moving} joint${moving === 1 ? '' : 's'} that move; expected ${MIN_JOINTS} to ${MAX_JOINTS}.`;
  return [...issues, fileIssue('joint-count', message)];
}
