/**
 * The one number of the table that is being read or changed, drawn in the scene as a dimension: it belongs to a row and a
 * field, and may be drawn in part, while the row is built up.
 *
 * @import { LabelText } from '../labels.js'
 * @import { Measured } from './measured.js'
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { DhField } from '../../model/document.js'
 *
 * @typedef {{ joint: number, field: DhField, share: number }} Wanted  `share`: 1 for all of it
 */
import { Vector3 } from 'three';
import { createAngleDimension } from './angleDimension.js';
import { createDrafting } from './drafting.js';
import { createLengthDimension } from './lengthDimension.js';
import { createMarkSet } from './markSet.js';
import { carried, rowSteps } from './rowSteps.js';

/**
 * @param {MarkTools & { text: (joint: number, field: DhField) => LabelText }} tools
 * @returns {MarkSet & { want: (next: Wanted | null) => void }}
 */
export const createDimensionMarks = (tools) =>
  createMarkSet(tools, /** @type {Wanted | null} */ (null), (arm, wanted, skin) => {
    if (!wanted || wanted.joint >= arm.chain.dof) return null;
    const { joint, field } = wanted;
    let { share } = wanted;
    const stepsNow = () => rowSteps(arm.chain, arm.frames, arm.posture, joint);
    const first = stepsNow().find((one) => one.field === field);
    if (!first) return null;
    const drafting = createDrafting({ ...tools, skin });
    const create = first.turns ? createAngleDimension : createLengthDimension;
    const dimension = create({ drafting, skin, size: arm.parts.size, isVariable: first.isVariable });
    const middle = new Vector3();
    /** @type {Measured | null} */
    let measured = null;

    return {
      remove: drafting.dispose,
      follow() {
        const steps = stepsNow();
        const step = steps.find((one) => one.field === field) ?? first;
        const shown = step.value * share;
        const after = carried(step.before, step, shown);
        const other = step.axis === 'z' ? 'x' : 'z';
        const names = [joint, joint + 1];
        const isWhole = share === 1;
        // where the new axis points is only said when it is there
        const last = isWhole ? steps[3].after : after;
        measured = {
          from: pointOf(step.before),
          to: pointOf(after),
          axis: {
            name: step.axis,
            number: String(names[step.number]),
            way: wayOf(step.before, step.axis),
            constant: step.constant,
          },
          across: [
            { name: other, number: String(names[0]), way: wayOf(steps[0].before, other) },
            { name: other, number: isWhole ? String(names[1]) : '', way: wayOf(step.turns ? after : last, other) },
          ],
          shown,
        };
        middle.set(0, 0, 0);
        const count = arm.frames.length / 16;
        for (let i = 0; i < count; i++) middle.add(pointOf(arm.frames.subarray(16 * i, 16 * i + 16)));
        middle.divideScalar(count);
        dimension.words.write(tools.text(joint, field));
      },
      face(eye) {
        if (measured) dimension.face(eye, measured, middle);
      },
      take(next) {
        const isSame = next?.joint === joint && next.field === field;
        if (isSame) ({ share } = next);
        return isSame;
      },
    };
  });

/** @param {ArrayLike<number>} T */
const pointOf = (T) => new Vector3(T[12], T[13], T[14]);

/** @param {ArrayLike<number>} T @param {'x' | 'z'} axis */
function wayOf(T, axis) {
  const at = axis === 'x' ? 0 : 8;
  return new Vector3(T[at], T[at + 1], T[at + 2]);
}
