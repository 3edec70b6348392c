/**
 * Which of some names may have been meant by one that is none of them.
 */

const MOST_NAMES = 2;

/** How a name is said, whatever stands between its letters. @param {string} name */
const bare = (name) => name.toLowerCase().replace(/[^a-z0-9]/g, '');

/**
 * Letters that have to be put in, left out, changed or swapped with the next to make one text of the other.
 * @param {string} a
 * @param {string} b
 */
function editsBetween(a, b) {
  /** @type {number[][]} of the first i letters of `a` and j of `b` */
  const edits = Array.from({ length: a.length + 1 }, (_, i) => [i]);
  for (let j = 0; j <= b.length; j++) edits[0][j] = j;
  for (let i = 1; i <= a.length; i++) {
    for (let j = 1; j <= b.length; j++) {
      const changed = edits[i - 1][j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      const isSwap = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      const swapped = isSwap ? edits[i - 2][j - 2] + 1 : Infinity;
      edits[i][j] = Math.min(edits[i - 1][j] + 1, edits[i][j - 1] + 1, changed, swapped);
    }
  }
  return edits[a.length][b.length];
}

/**
 * The nearest first, one or two of them; none where nothing is near.
 * @param {string} text
 * @param {readonly string[]} names
 * @returns {string[]}
 */
export function nearestNames(text, names) {
  const wanted = bare(text).slice(0, 40);
  if (wanted === '') return [];
  return names
    .map((name) => {
      const said = bare(name);
      const isPart = wanted.length > 1 && said.includes(wanted);
      return { name, edits: isPart ? Math.min(1, said.length - wanted.length) : editsBetween(wanted, said) };
    })
    .filter(({ edits }) => edits <= Math.max(1, Math.floor(wanted.length / 3)))
    .sort((a, b) => a.edits - b.edits)
    .filter(({ edits }, _, [first]) => edits === 0 || first.edits > 0) // beside what was meant, nothing is near
    .slice(0, MOST_NAMES)
    .map(({ name }) => name);
}
