/** Work that is done in steps, so that whoever waits for it can show how far it is, or stop. */

/**
 * All of it at once.
 * @template Found
 * @param {Generator<unknown, Found>} work
 * @returns {Found}
 */
export function atOnce(work) {
  let step = work.next();
  while (!step.done) step = work.next();
  return step.value;
}

/**
 * Work that says nothing, with a word at each of its steps.
 * @template Found, Word
 * @param {Word} word
 * @param {Generator<unknown, Found>} work
 * @returns {Generator<Word, Found>}
 */
export function* saying(word, work) {
  let step = work.next();
  for (; !step.done; step = work.next()) yield word;
  return step.value;
}
