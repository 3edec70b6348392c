/**
 * Times, on a machine that others use too: contestants take turns, so that a busy moment meets all alike, and medians
 * forget it. Times of different runs are not comparable; ratios within one are.
 */

/** @param {readonly number[]} values */
export const median = (values) => [...values].sort((x, y) => x - y)[Math.floor(values.length / 2)];

/** @param {readonly number[]} values @param {number} share */
export const quantile = (values, share) => [...values].sort((x, y) => x - y)[Math.floor(values.length * share)];

/** @param {readonly number[]} values */
export const geometricMean = (values) =>
  Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);

/** So long one block of calls should take, in ms: longer than the clock's grain, shorter than most interruptions. */
const BLOCK = 0.4;

/**
 * Nanoseconds of one call, for calls that are too short for the clock.
 * @template T
 * @template {string} Name
 * @param {readonly T[]} inputs
 * @param {Record<Name, (input: T) => void>} calls
 * @param {number} [blocks]
 * @returns {Record<Name, number>}
 */
export function timeCalls(inputs, calls, blocks = 150) {
  const names = /** @type {Name[]} */ (Object.keys(calls));
  const rounds = new Map();
  const times = new Map(names.map((name) => [name, /** @type {number[]} */ ([])]));
  const block = (/** @type {Name} */ name, /** @type {number} */ count) => {
    const call = calls[name];
    const start = performance.now();
    for (let round = 0; round < count; round++) for (const input of inputs) call(input);
    return performance.now() - start;
  };
  for (const name of names) {
    block(name, Math.ceil(2000 / inputs.length)); // to be compiled
    rounds.set(name, Math.max(1, Math.round((BLOCK * 20) / block(name, 20))));
  }
  for (let k = 0; k < blocks; k++) {
    for (const name of names) {
      const count = rounds.get(name);
      times.get(name)?.push((block(name, count) * 1e6) / (count * inputs.length));
    }
  }
  return /** @type {Record<Name, number>} */ (
    Object.fromEntries(names.map((name) => [name, median(times.get(name) ?? [])]))
  );
}

/**
 * Microseconds of each call, the median of some rounds; the first rounds, in which code is compiled, are not counted.
 * @template T
 * @template {string} Name
 * @param {readonly T[]} inputs
 * @param {Record<Name, { call: (input: T, index: number) => void, rounds?: number }>} contestants  rounds in each turn
 * @param {{ turns: number, warmUp?: number }} options
 * @returns {Record<Name, number[]>} for each input
 */
export function timeEach(inputs, contestants, { turns, warmUp = 2 }) {
  const names = /** @type {Name[]} */ (Object.keys(contestants));
  const times = new Map(names.map((name) => [name, inputs.map(() => /** @type {number[]} */ ([]))]));
  for (let turn = -warmUp; turn < turns; turn++) {
    for (const name of names) {
      const { call, rounds = 1 } = contestants[name];
      for (let round = 0; round < rounds; round++) {
        inputs.forEach((input, index) => {
          const start = performance.now();
          call(input, index);
          const time = performance.now() - start;
          if (turn >= 0) times.get(name)?.[index].push(time * 1e3);
        });
      }
    }
  }
  return /** @type {Record<Name, number[]>} */ (
    Object.fromEntries(names.map((name) => [name, (times.get(name) ?? []).map(median)]))
  );
}
