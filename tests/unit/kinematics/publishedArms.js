/**
 * The 22 arms of the fixtures, by name, with what is known of them: tests/fixtures/kinematics/README.md says from whom.
 * @import { ArmName, ForwardCases, InverseCases } from './oracle.js'
 */
import { readFileSync } from 'node:fs';
import { arm, forwardCases, inverseCases, oracleForward } from './oracle.js';

/** A fixture by its file name; the caller knows what is in it. @param {string} name @returns {unknown} */
export const fixture = (name) =>
  JSON.parse(readFileSync(new URL(`../../fixtures/kinematics/${name}`, import.meta.url), 'utf8'));

const table = /** @type {{ arms: Record<string, object> }} */ (fixture('arms.json')).arms;

export const ALL_ARMS = Object.keys(table);

/** The readers of oracle.js, for any of the names. @param {string} name */
const known = (name) => {
  if (!Object.hasOwn(table, name)) throw new RangeError(`Expected one of ${ALL_ARMS.join(', ')}, got ${name}.`);
  return /** @type {ArmName} */ (name);
};

/** @typedef {InverseCases & { postures: number[][], nearSingularPostures?: number[][] }} PublishedInverse */

/** @param {string} name @param {number} [scale] of every length */
export const publishedArm = (name, scale = 1) => arm(known(name), scale);
/** @param {string} name @returns {ForwardCases} */
export const publishedForward = (name) => forwardCases[known(name)];
/** @param {string} name @returns {PublishedInverse} */
export const publishedInverse = (name) => /** @type {PublishedInverse} */ (inverseCases[known(name)]);

/** Metres: how far from the base the published poses lie, at most. @param {string} name */
export const publishedReach = (name) =>
  Math.max(...publishedForward(name).tcp.map((line) => Math.hypot(line[3], line[7], line[11])));

/** @param {string} name */
export const withSixJoints = (name) => publishedArm(name).joints.length === 6;

/** @param {string} name @param {number[]} q */
export const poseOf = (name, q) => oracleForward(publishedArm(name), q).tcp;
