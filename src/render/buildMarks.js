/**
 * The frame that goes from i−1 to i while a row of the table is built up.
 *
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 */
import { motionAt } from '../model/rowMotions.js';
import { carried, rowSteps } from './rowSteps.js';
import { createTriad } from './triad.js';

const ARROW = 0.1; // in sizes of the arm

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (next: { joint: number, at: number } | null) => void }}
 */
export function createBuildMarks({ scene, skin, labels }) {
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {{ joint: number, at: number } | null} */
  let wanted = null;
  /** @type {ReturnType<typeof createTriad> | null} */
  let triad = null;

  function clear() {
    triad?.dispose();
    triad = null;
  }

  function follow() {
    if (!arm || !wanted || !triad) return;
    const steps = rowSteps(arm.chain, arm.frames, arm.posture, wanted.joint);
    const now = motionAt(arm.chain.convention, wanted.at);
    const step = now && steps[now.index];
    const T = step ? carried(step.before, step, now.share * step.value) : steps[0].before;
    triad.show(T, ARROW * arm.parts.size);
  }

  function build() {
    clear();
    if (!arm || !wanted || wanted.joint >= arm.chain.dof) return;
    triad = createTriad({ skin, labels, width: 4, letters: 'strong', letterCase: 'lower', gap: 4, order: 46 });
    scene.add(triad.group);
    follow();
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
      build();
    },
    want(next) {
      const isSame = triad && next;
      wanted = next;
      if (isSame) follow();
      else build();
    },
  };
}
