/**
 * Frames 1 … n as small triads with numbered letters, each where the convention of the table puts it. Frames that share
 * their origin differ in length, so that every arrow has a tip of its own.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 */
import { createMarkSet } from './markSet.js';
import { createTriad } from './triad.js';

const ARROW = 0.075; // in sizes of the arm
const LONGER = 0.26; // what an arrow is longer by than the one under it
const SAME_PLACE = 0.3; // in arrows
const ORDER = 20;

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (numbers: readonly number[]) => void }}  `numbers` of the frames to show, from 1
 */
export const createFrameMarks = ({ scene, labels, ...tools }) =>
  createMarkSet(tools, /** @type {readonly number[]} */ ([]), ({ chain, frames, parts }, wanted, skin) => {
    const style = { width: 2, letters: 'small', letterCase: /** @type {const} */ ('lower'), gap: 3 };
    const length = ARROW * parts.size;
    const shown = wanted
      .filter((number) => number >= 1 && number <= chain.dof)
      .map((number) => {
        const order = ORDER + 2 * (number % 3);
        const triad = createTriad({ skin, labels, ...style, subscript: String(number), order });
        scene.add(triad.group);
        return { number, triad };
      });
    /** @param {number} i @param {number} k */
    const distance = (i, k) => Math.hypot(...[12, 13, 14].map((at) => frames[16 * i + at] - frames[16 * k + at]));
    return {
      remove: () => shown.forEach(({ triad }) => triad.dispose()),
      follow: () =>
        shown.forEach(({ number, triad }, i) => {
          const isNear = (/** @type {number} */ other) => distance(number, other) < SAME_PLACE * length;
          const below = shown.slice(i + 1).filter((other) => isNear(other.number)).length;
          triad.show(frames.subarray(16 * number, 16 * number + 16), length * (1 + LONGER * below));
        }),
    };
  });
