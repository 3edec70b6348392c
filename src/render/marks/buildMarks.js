/**
 * The frame that goes from i−1 to i while a row of the table is built up.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 */
import { motionAt } from '../../model/robot/rowMotions.js';
import { createMarkSet } from './markSet.js';
import { carried, rowSteps } from './rowSteps.js';
import { createTriad } from './triad.js';

const ARROW = 0.1; // in sizes of the arm

/** @typedef {{ joint: number, at: number }} Wanted */

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (next: Wanted | null) => void }}
 */
export const createBuildMarks = ({ scene, labels, ...tools }) =>
  createMarkSet(tools, /** @type {Wanted | null} */ (null), ({ chain, frames, posture, parts }, wanted, skin) => {
    if (!wanted || wanted.joint >= chain.dof) return null;
    let { joint, at } = wanted;
    const triad = createTriad({ skin, labels, width: 4, letters: 'strong', letterCase: 'lower', gap: 4, order: 46 });
    scene.add(triad.group);
    return {
      remove: triad.dispose,
      follow() {
        const steps = rowSteps(chain, frames, posture, joint);
        const now = motionAt(chain.convention, at);
        const step = now && steps[now.index];
        const T = step ? carried(step.before, step, now.share * step.value) : steps[0].before;
        triad.show(T, ARROW * parts.size);
      },
      take(next) {
        if (next && next.joint < chain.dof) ({ joint, at } = next);
        return next !== null && next.joint < chain.dof;
      },
    };
  });
