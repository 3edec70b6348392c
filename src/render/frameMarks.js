/**
 * Frames 1 … n as small triads with numbered letters, each where the convention of the table puts it. Frames that share
 * their origin differ in length, so that every arrow has a tip of its own.
 *
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 */
import { createTriad } from './triad.js';

const ARROW = 0.075; // in sizes of the arm
const LONGER = 0.26; // what an arrow is longer by than the one under it
const SAME_PLACE = 0.3; // in arrows
const ORDER = 20;

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { choose: (numbers: readonly number[]) => void }}  `numbers` of the frames to show, from 1
 */
export function createFrameMarks({ scene, skin, labels }) {
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {readonly number[]} */
  let chosen = [];
  /** @type {{ number: number, triad: ReturnType<typeof createTriad> }[]} */
  let shown = [];

  function clear() {
    for (const { triad } of shown) triad.dispose();
    shown = [];
  }

  function build() {
    clear();
    if (!arm) return;
    const { dof } = arm.chain;
    for (const number of chosen.filter((one) => one >= 1 && one <= dof)) {
      const style = { width: 2, letters: 'small', letterCase: /** @type {const} */ ('lower'), gap: 3 };
      const triad = createTriad({ skin, labels, ...style, subscript: String(number), order: ORDER + 2 * (number % 3) });
      scene.add(triad.group);
      shown.push({ number, triad });
    }
    follow();
  }

  function follow() {
    if (!arm) return;
    const { frames, parts } = arm;
    const length = ARROW * parts.size;
    /** @param {number} i @param {number} k */
    const distance = (i, k) => Math.hypot(...[12, 13, 14].map((at) => frames[16 * i + at] - frames[16 * k + at]));
    shown.forEach(({ number, triad }, i) => {
      const below = shown.slice(i + 1).filter((other) => distance(number, other.number) < SAME_PLACE * length).length;
      triad.show(frames.subarray(16 * number, 16 * number + 16), length * (1 + LONGER * below));
    });
  }

  return {
    show(next) {
      arm = next;
      build();
    },
    follow,
    clear,
    build,
    setSkin(next) {
      skin = next;
      for (const { triad } of shown) triad.setSkin(next);
    },
    choose(numbers) {
      chosen = numbers;
      build();
    },
  };
}
