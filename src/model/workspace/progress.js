/**
 * How far work in several stages is, and how long it will take: each stage counts for its part of the whole, as it took the last
 * time. Told what the time is; never goes back.
 */

/** So long (s), or so little, and nobody can tell how long the rest takes. */
const TOO_EARLY = 0.4;
const TOO_LITTLE = 0.03;

/**
 * @param {Record<string, number>} parts  of each stage, in their order; any unit. It learns
 */
export function createProgress(parts) {
  const stages = Object.keys(parts);
  let begun = 0;
  let share = 0;
  /** When each stage was last spoken of, in seconds since the beginning. @type {Record<string, number>} */
  let ends = {};
  return {
    /** @param {number} now  s */
    begin(now) {
      [begun, share, ends] = [now, 0, {}];
    },
    /**
     * @param {string} stage
     * @param {number} done  of the stage, 0 … 1
     * @param {number} now   s
     * @returns {{ share: number, secondsLeft: number | null }}
     */
    at(stage, done, now) {
      const index = stages.indexOf(stage);
      const elapsed = now - begun;
      if (index >= 0) {
        ends[stage] = elapsed;
        const sum = (/** @type {string[]} */ names) => names.reduce((all, name) => all + parts[name], 0);
        const before = sum(stages.slice(0, index)) + parts[stage] * Math.min(1, Math.max(0, done));
        share = Math.max(share, before / (sum(stages) || 1));
      }
      const isKnown = elapsed > TOO_EARLY && share > TOO_LITTLE;
      return { share, secondsLeft: isKnown ? (elapsed * (1 - share)) / share : null };
    },
    /** All is done. @param {number} now  s */
    end(now) {
      let before = 0;
      for (const [i, stage] of stages.entries()) {
        const isLast = stages.slice(i + 1).every((later) => !(later in ends));
        const at = isLast && stage in ends ? now - begun : (ends[stage] ?? before);
        parts[stage] = Math.max(0, at - before);
        before = Math.max(before, at);
      }
    },
  };
}

/** @typedef {ReturnType<typeof createProgress>} ProgressOfStages */
