/**
 * Named targets: poses of the tool that a document keeps, in its units, seen from the world or from a user frame, with
 * which they then move. A target may say in which
 * configuration the arm stood when it was kept; whoever goes there again then takes the same one, if there is one.
 *
 * @import { Doc, PoseDoc, StepTarget, TargetDoc } from '../document.js'
 *
 * @typedef {{ type: 'add-target', pose: PoseDoc, frame?: string, configuration?: string }
 *   | { type: 'rename-target', index: number, id: string }
 *   | { type: 'edit-target', index: number, pose: PoseDoc, frame?: string, configuration?: string }
 *   | { type: 'move-target', index: number, to: number }
 *   | { type: 'remove-target', index: number }} TargetCommand
 */
import { withMoves, withTargets } from '../program/motionProgram.js';

/**
 * @param {Doc} doc
 * @param {TargetCommand} command  that `targetRefusal` has nothing against
 * @returns {Doc} the same object when nothing changed
 */
export function applyTargetCommand(doc, command) {
  const { targets } = doc;
  switch (command.type) {
    case 'add-target':
      return { ...doc, targets: [...targets, made(freeTargetId(doc), command)] };
    case 'rename-target': {
      const old = targets[command.index];
      if (old.id === command.id) return doc;
      const follow = (/** @type {StepTarget} */ target) =>
        target.kind === 'target' && target.id === old.id ? { ...target, id: command.id } : target;
      return {
        ...doc,
        targets: targets.with(command.index, { ...old, id: command.id }),
        motionPrograms: withMoves(doc.motionPrograms, (move) => withTargets(move, follow)),
      };
    }
    case 'edit-target': {
      const old = targets[command.index];
      const next = made(old.id, command);
      return isSame(old, next) ? doc : { ...doc, targets: targets.with(command.index, next) };
    }
    case 'move-target': {
      const { index, to } = command;
      if (index === to) return doc;
      return { ...doc, targets: targets.toSpliced(index, 1).toSpliced(to, 0, targets[index]) };
    }
    case 'remove-target':
      return { ...doc, targets: targets.toSpliced(command.index, 1) };
    default: {
      /** @type {never} */
      const unknown = command;
      throw new TypeError(`Unknown command: ${JSON.stringify(unknown)}`);
    }
  }
}

/**
 * What of a pose a target keeps, and nothing else that came with it.
 * @param {string} id
 * @param {{ pose: PoseDoc, frame?: string, configuration?: string }} given
 * @returns {TargetDoc}
 */
function made(id, { pose: { xyz, rpy, quaternion }, frame, configuration }) {
  return {
    id,
    ...(frame !== undefined && { frame }),
    xyz: [...xyz],
    ...(rpy && { rpy: [...rpy] }),
    ...(quaternion && { quaternion: [...quaternion] }),
    ...(configuration !== undefined && { configuration }),
  };
}

/** @param {TargetDoc} a @param {TargetDoc} b */
function isSame(a, b) {
  /** @param {readonly number[] | undefined} one @param {readonly number[] | undefined} other */
  const agree = (one, other) =>
    one === other || (one?.length === other?.length && one?.every((value, i) => Object.is(value, other?.[i])));
  return (
    a.frame === b.frame &&
    a.configuration === b.configuration &&
    agree(a.xyz, b.xyz) &&
    agree(a.rpy, b.rpy) &&
    agree(a.quaternion, b.quaternion)
  );
}

/** The first of aim_1, aim_2, … that no target has. @param {Doc} doc */
function freeTargetId({ targets }) {
  const taken = new Set(targets.map(({ id }) => id));
  let number = 1;
  while (taken.has(`aim_${number}`)) number++;
  return `aim_${number}`;
}
