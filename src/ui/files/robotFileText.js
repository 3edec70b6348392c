/** What robot files begin with, whatever becomes of them: enough to tell them from a table or a name. */
const BEGINS = /^\s*<(\?xml|!--|robot|sdf|rlkin|rl|mujoco)\b/i;

/** @param {string} text */
export const looksLikeRobotFile = (text) => BEGINS.test(text) || /^\s*<[\w:.-]*robotModel\b/.test(text);
