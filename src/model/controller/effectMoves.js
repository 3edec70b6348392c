/**
 * What one effect of running code is to the arm: one move, or those along a path. Code that is compared with a program has to say
 * what the program says, frames by their numbers and configurations; code of a person may leave open what the controller then
 * takes as it is.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from './codeMoves.js'
 * @import { ControllerFrames } from './frameNumbers.js'
 * @import { SystemValues } from '../code/codeFrames.js'
 * @import { Effect } from '../../karel/run/machine.js'
 */
import { codeFrames, OWN_FRAME } from '../code/codeFrames.js';
import { movesOf, withOwnFrames } from '../code/codeMoves.js';
import { codeMove } from './codeMoves.js';

/**
 * @param {Doc} doc
 * @param {ControllerFrames} frames
 * @param {Float64Array} from
 * @param {Effect} effect       of runMoves
 * @param {boolean} isStrict    compared with a program
 * @returns {{ moves: CodeMove[], missing: readonly string[] } | { message: string }}  missing: frames that the model does not have
 */
export function effectMoves(doc, frames, from, effect, isStrict) {
  const raw = /** @type {Effect | undefined} */ (effect.raw);
  const system = /** @type {SystemValues | undefined} */ (effect.system);
  const isPlain = (raw ?? effect).to === 'TO' || !raw;
  if (system && (!isStrict || !isPlain)) {
    const found = movesOf(doc, from, raw ?? effect, system);
    if ('message' in found) return found;
    return { ...found, moves: found.moves.map(({ move }) => (raw ? asSaid(move, effect) : move)) };
  }
  const { position } = effect;
  if (!Array.isArray(position) || position.slice(0, 6).some((value) => typeof value !== 'number'))
    return { message: 'a position that is moved to is uninitialised' };
  const done =
    raw && system
      ? codeMove(
          doc,
          codeFrames(doc, withOwnFrames(raw, system)),
          from,
          { ...effect, userFrame: OWN_FRAME, toolFrame: OWN_FRAME },
          isStrict,
        )
      : codeMove(doc, frames, from, effect, isStrict);
  if ('message' in done) return done;
  return { moves: [raw ? asSaid(done, effect) : done], missing: [] };
}

/** KAREL moves by what $UFRAME and $UTOOL hold; which number that is, other variables say. @param {CodeMove} move @param {Effect} effect @returns {CodeMove} */
const asSaid = (move, effect) => ({
  ...move,
  ...{ userFrame: Number(effect.userFrame), tool: Number(effect.toolFrame) },
  speed: /** @type {CodeMove['speed']} */ (effect.speed),
  ending: /** @type {CodeMove['ending']} */ (effect.termination),
  acceleration: null,
});
