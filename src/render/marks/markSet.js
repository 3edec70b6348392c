/**
 * The frame of a set of marks: drawn anew when the arm, what is wanted or the colours are others. What was drawn may follow
 * the arm as it moves, or stand where it was put.
 *
 * @import { Eye } from '../eye.js'
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { Skin } from '../skins.js'
 */

/**
 * @template Wanted
 * @typedef {object} Drawn
 * @property {() => void} remove
 * @property {() => void} [follow]  after the arm has moved, and once when it has been drawn
 * @property {(eye: Eye) => void} [face]
 * @property {(wanted: Wanted) => boolean} [take]  whether that can be shown by following alone
 */

/**
 * @template Wanted
 * @param {Pick<MarkTools, 'skin'>} tools
 * @param {Wanted} nothing
 * @param {(arm: ArmNow, wanted: Wanted, skin: Skin) => Drawn<Wanted> | null} draw
 * @returns {MarkSet & { want: (wanted: Wanted) => void }}
 */
export function createMarkSet({ skin }, nothing, draw) {
  /** @type {ArmNow | null} */
  let arm = null;
  let wanted = nothing;
  /** @type {Drawn<Wanted> | null} */
  let drawn = null;

  function clear() {
    drawn?.remove();
    drawn = null;
  }
  const follow = () => drawn?.follow?.();
  function build() {
    clear();
    if (arm) drawn = draw(arm, wanted, skin);
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
    face: (eye) => drawn?.face?.(eye),
    want(next) {
      wanted = next;
      if (drawn?.take?.(next)) follow();
      else build();
    },
  };
}
