/**
 * How a move of code stands, at a glance: its way, the room to limits, how near to a singular posture, how quick the joints.
 *
 * @import { CheckedMove, Verification } from './verifyCode.js'
 *
 * @typedef {'good' | 'warn' | 'bad' | 'unknown'} Level
 * @typedef {'way' | 'limit' | 'singularity' | 'rate'} Lane
 * @typedef {Record<Lane, Level>} MoveLevels
 */
import { NEAR_SINGULAR } from './verifyCode.js';

/** @type {readonly Lane[]} */
export const LANES = ['way', 'limit', 'singularity', 'rate'];

/** A joint that is so near to its limit is worth a look: radians, metres. */
const LITTLE_ROOM = 0.05;
const QUICK = 0.9;

/** @param {Verification} verification @param {CheckedMove} move @returns {MoveLevels} */
export function moveLevels({ findings }, move) {
  const { deviation, margins } = move;
  const found = findings.filter(({ file, line }) => file === move.file && line === move.line);
  const has = (/** @type {string[]} */ ...codes) => found.some(({ code }) => codes.includes(code));
  const { limit, singularity, rate } = margins;
  return {
    way: has('differs', 'impossible')
      ? 'bad'
      : has('lost-law', 'configuration-change')
        ? 'warn'
        : deviation
          ? 'good'
          : 'unknown',
    limit: !limit ? 'unknown' : limit.room < 0 ? 'bad' : limit.room < LITTLE_ROOM ? 'warn' : 'good',
    singularity: singularity < NEAR_SINGULAR ? 'bad' : singularity < 2 * NEAR_SINGULAR ? 'warn' : 'good',
    rate: !rate ? 'unknown' : rate.share > 1 ? 'bad' : rate.share > QUICK ? 'warn' : 'good',
  };
}
