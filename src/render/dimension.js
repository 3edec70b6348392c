/**
 * The one number of the table that is being read or changed, drawn in the scene as a dimension: it belongs to a row and a
 * field, and may be drawn in part, while the row is built up.
 *
 * @import { Drafting } from './drafting.js'
 * @import { LabelText } from './labels.js'
 * @import { Dimension, Measured } from './measured.js'
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { Skin } from './skins.js'
 * @import { DhField } from '../model/document.js'
 *
 * @typedef {{ joint: number, field: DhField, share: number }} Wanted  `share`: 1 for all of it
 */
import { Vector3 } from 'three';
import { createAngleDimension } from './angleDimension.js';
import { createDrafting } from './drafting.js';
import { createLengthDimension } from './lengthDimension.js';
import { carried, rowSteps } from './rowSteps.js';

/**
 * @param {MarkTools & { text: (joint: number, field: DhField) => LabelText }} tools
 * @returns {MarkSet & { want: (next: Wanted | null) => void }}
 */
export function createDimensionMarks(tools) {
  let { skin } = tools;
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {Wanted | null} */
  let wanted = null;
  /** @type {{ drafting: Drafting, dimension: Dimension } | null} */
  let drawing = null;
  /** @type {Measured | null} */
  let measured = null;
  const middle = new Vector3();

  function clear() {
    drawing?.drafting.dispose();
    drawing = measured = null;
  }

  const stepNow = () => {
    if (!arm || !wanted || wanted.joint >= arm.chain.dof) return null;
    const { field } = wanted;
    const steps = rowSteps(arm.chain, arm.frames, arm.posture, wanted.joint);
    const step = steps.find((one) => one.field === field);
    return step ? { steps, step } : null;
  };

  function build() {
    clear();
    const now = stepNow();
    if (!arm || !now) return;
    const drafting = createDrafting({ ...tools, skin });
    const create = now.step.turns ? createAngleDimension : createLengthDimension;
    const { isVariable } = now.step;
    drawing = { drafting, dimension: create({ drafting, skin, size: arm.parts.size, isVariable }) };
    follow();
  }

  function follow() {
    const now = stepNow();
    if (!arm || !wanted || !drawing || !now) return;
    const { step, steps } = now;
    const shown = step.value * wanted.share;
    const after = carried(step.before, step, shown);
    const other = step.axis === 'z' ? 'x' : 'z';
    const names = [wanted.joint, wanted.joint + 1];
    const isWhole = wanted.share === 1;
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
    drawing.dimension.words.write(tools.text(wanted.joint, wanted.field));
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
    face(eye) {
      if (drawing && measured) drawing.dimension.face(eye, measured, middle);
    },
    want(next) {
      const isSame = drawing && next && wanted && next.joint === wanted.joint && next.field === wanted.field;
      wanted = next;
      if (isSame) follow();
      else build();
    },
  };
}

/** @param {ArrayLike<number>} T */
const pointOf = (T) => new Vector3(T[12], T[13], T[14]);

/** @param {ArrayLike<number>} T @param {'x' | 'z'} axis */
function wayOf(T, axis) {
  const at = axis === 'x' ? 0 : 8;
  return new Vector3(T[at], T[at + 1], T[at + 2]);
}
