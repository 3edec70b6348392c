/**
 * Long jobs on text as generators that stop now and then, so that whoever has a page to keep quick can go on later.
 *
 * @template Result
 * @param {Generator<null, Result>} job
 * @returns {Result} of all of it, at once
 */
export function finished(job) {
  for (;;) {
    const turn = job.next();
    if (turn.done) return turn.value;
  }
}

/** A list in pieces. @template T @param {readonly T[]} all @param {(piece: readonly T[]) => void} act @returns {Generator<null, void>} */
export function* inPieces(all, act) {
  for (let i = 0; i < all.length; i += PIECE) {
    act(all.slice(i, i + PIECE));
    yield null;
  }
}

/** Statements, or lines. */
export const PIECE = 100;
