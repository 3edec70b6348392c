/** A value that the types rule out and a caller may still hand over. @template T @param {unknown} value @returns {T} */
export const wrong = (value) => /** @type {T} */ (value);
