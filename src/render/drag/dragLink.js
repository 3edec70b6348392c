/**
 * A link in the hand: its joint follows the pointer, stops at its limits, and shows them; all of it is one undo step.
 *
 * @import { Vector } from './dragRays.js'
 * @import { State } from '../robotView.js'
 * @import { Sight } from '../sight.js'
 */
import { quantityOf } from '../../model/document.js';
import { handleStep } from '../../model/aim/handleAxes.js';
import { inside } from '../../model/jog/jogRange.js';
import { fromKernel } from '../../model/units.js';
import { beginJoint } from './dragJoint.js';
import { snap } from './dragRays.js';

/** No hand is finer than this, and numbers stay readable: as shares of a step that snaps. */
const FINEST = { metres: 1 / 100, radians: 1 / 50 };

/**
 * @param {Pick<State, 'store' | 'derived'>} state
 * @param {{ onStep: () => void }} on  the arm has moved
 */
export function createJointDrag({ store, derived }, { onStep }) {
  let count = 0;

  return {
    /**
     * @param {{ joint: number, point: Vector, sight: Sight, x: number, y: number }} begin
     * @returns what to do with it; null if the joint cannot be moved as it is seen
     */
    hold({ joint, point, sight, x, y }) {
      const { doc } = store.state;
      const { robot } = doc;
      const chain = derived.chain(doc);
      const wayAt = beginJoint({ chain, q: derived.posture(doc), joint, point, sight, x, y });
      if (!wayAt) return null;
      const gesture = `link-${++count}`;
      const row = robot.joints[joint];
      const quantity = quantityOf(row, 'home');
      const unit = quantity === 'length' ? /** @type {const} */ ('metres') : 'radians';
      const start = doc.posture[joint];
      const isOurs = () => store.state.doc.robot === robot;
      /** @param {number | null} heldJoint @param {boolean} [isStopped] */
      const show = (heldJoint, isStopped = false) => {
        const hindrance = isStopped ? { kind: /** @type {const} */ ('limit'), joint, metres: 0, radians: 0 } : null;
        const old = store.state.session.drag;
        const drag = heldJoint === null ? null : { T_world_goal: null, hindrance, isHeld: true };
        const isSame = old && drag && Boolean(old.hindrance) === isStopped;
        store.dispatch({ type: 'show', change: { heldJoint, drag: isSame ? old : drag } });
      };

      return {
        begin: () => show(joint),
        /** @param {Sight} now @param {number} px @param {number} py @param {boolean} snaps */
        move(now, px, py, snaps) {
          const way = isOurs() ? wayAt(now, px, py) : null;
          if (way === null) return;
          const step = fromKernel(quantity, handleStep(chain)[unit] * (snaps ? 1 : FINEST[unit]), robot.units);
          const wanted = Number(snap(start + fromKernel(quantity, way, robot.units), step).toPrecision(12));
          const value = store.state.session.numbers.keepsLimits ? inside(row, wanted) : wanted;
          store.dispatch({ type: 'set-joint-value', joint, value, gesture });
          show(joint, value !== wanted);
          onStep();
        },
        end() {
          if (store.state.gesture?.id === gesture) store.dispatch({ type: 'end-gesture' });
          show(null);
        },
        cancel() {
          if (store.state.gesture?.id === gesture) store.dispatch({ type: 'cancel-gesture' });
          show(null);
        },
      };
    },
  };
}
