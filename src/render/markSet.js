/**
 * Marks that stand where they are told, whatever the arm does: built anew when the arm, what is wanted or the colours are
 * others.
 *
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { Skin } from './skins.js'
 */

/**
 * @template Wanted
 * @param {MarkTools} tools
 * @param {Wanted} nothing
 * @param {(arm: ArmNow, wanted: Wanted, skin: Skin) => () => void} draw  the answer takes it away again
 * @returns {MarkSet & { want: (wanted: Wanted) => void }}
 */
export function standingMarks({ skin }, nothing, draw) {
  /** @type {ArmNow | null} */
  let arm = null;
  let wanted = nothing;
  /** @type {(() => void) | null} */
  let remove = null;

  function clear() {
    remove?.();
    remove = null;
  }
  function build() {
    clear();
    if (arm) remove = draw(arm, wanted, skin);
  }
  return {
    show(next) {
      arm = next;
      build();
    },
    follow() {},
    clear,
    build,
    setSkin(next) {
      skin = next;
      build();
    },
    want(next) {
      wanted = next;
      build();
    },
  };
}
