/**
 * Remember the last result; compute again only when an argument is a different object or value.
 * @template {readonly unknown[]} Args
 * @template Value
 * @param {(...args: Args) => Value} compute
 * @returns {(...args: Args) => Value}
 */
export function memo(compute) {
  /** @type {Args | undefined} */
  let lastArgs;
  /** @type {Value} */
  let lastValue;
  return (...args) => {
    if (!lastArgs || args.some((arg, i) => !Object.is(arg, lastArgs?.[i]))) {
      lastValue = compute(...args);
      lastArgs = args;
    }
    return lastValue;
  };
}
