/**
 * How much chance the property tests take. `npm test` repeats one seed; `npm run test:deep` runs more cases on a fresh
 * seed, which it prints, so that a failure can be repeated with DENAVIT_SEED.
 */
const deep = Boolean(process.env.DENAVIT_DEEP);

export const SEED = Number(process.env.DENAVIT_SEED ?? 560);

/** @param {number} count how many cases `npm test` runs */
export const runs = (count) => (deep ? count * 20 : count);
