/** How curves of joints differ: by colour and by dash. */
const DASHES = [[], [], [8, 3], [7, 4], [2, 3], [9, 3, 2, 3]];

/** What draws the line of joint `i`: its token and its dashes. @param {number} i */
export const styleOf = (i) => ({ token: `--j${(i % 6) + 1}`, dash: DASHES[i % DASHES.length] });
