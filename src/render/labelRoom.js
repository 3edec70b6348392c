/**
 * Room for labels: those that may give way go a little farther out, or to the side, until they lie on nothing that was
 * placed before them. Pixels; no elements here.
 *
 * @typedef {object} Placed
 * @property {number} x       of the point that the label is about
 * @property {number} y       down
 * @property {number} width
 * @property {number} height
 * @property {number} east    the direction in which it keeps away from the point, a unit vector or nothing
 * @property {number} south
 * @property {number} gap     from the point to the label's edge
 * @property {boolean} yields
 *
 * @typedef {{ left: number, top: number, width: number, height: number }} Box
 */

const AIR = 1; // between two labels
const FARTHER = [0, 11, 22, 33];
const ASIDE = [0, 0.6, -0.6, 1.2, -1.2, 2, -2]; // radians

/**
 * The boxes in the order of the labels. What does not yield stands where it wants to; the others take the first place that is
 * free, or else the one with the least on it.
 * @param {readonly Placed[]} labels
 * @returns {Box[]}
 */
export function roomFor(labels) {
  /** @type {Box[]} */
  const taken = [];
  const boxes = labels.map((label) => {
    const box = boxAt(label, 0, 0);
    if (!label.yields) taken.push(box);
    return box;
  });
  labels.forEach((label, i) => {
    if (!label.yields) return;
    let least = Infinity;
    for (const farther of FARTHER) {
      for (const turn of ASIDE) {
        const box = boxAt(label, farther, turn);
        const covered = taken.reduce((sum, other) => sum + overlap(box, other), 0);
        if (covered < least) [least, boxes[i]] = [covered, box];
        if (least === 0) break;
      }
      if (least === 0) break;
    }
    taken.push(boxes[i]);
  });
  return boxes;
}

/** @param {Placed} label @param {number} farther @param {number} turn @returns {Box} */
function boxAt({ x, y, width, height, east, south, gap }, farther, turn) {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const [dx, dy] = east || south ? [east * cos - south * sin, east * sin + south * cos] : [sin, -cos];
  const away = gap + farther;
  const isFree = east || south || farther || turn;
  const [px, py] = isFree ? [dx, dy] : [0, 0];
  return {
    left: x + away * px + (width * (px - 1)) / 2,
    top: y + away * py + (height * (py - 1)) / 2,
    width,
    height,
  };
}

/** The area that two boxes share, with some air about them. @param {Box} a @param {Box} b */
export function overlap(a, b) {
  const wide = Math.min(a.left + a.width, b.left + b.width) - Math.max(a.left, b.left) + AIR;
  const high = Math.min(a.top + a.height, b.top + b.height) - Math.max(a.top, b.top) + AIR;
  return wide > 0 && high > 0 ? wide * high : 0;
}

/** Brought inside the picture, as far as it goes. @param {Box} box @param {number} width @param {number} height @returns {Box} */
export function inside(box, width, height) {
  const margin = 6;
  const least = (/** @type {number} */ at, /** @type {number} */ size, /** @type {number} */ room) =>
    Math.max(margin, Math.min(room - size - margin, at));
  return { ...box, left: least(box.left, box.width, width), top: least(box.top, box.height, height) };
}

/**
 * The end of a line, or where the line leaves the picture.
 * @param {number} x0  where it begins, inside
 * @param {number} y0
 * @param {number} x
 * @param {number} y
 * @param {number} width
 * @param {number} height
 * @returns {[number, number]}
 */
export function withinPicture(x0, y0, x, y, width, height) {
  const share = (/** @type {number} */ from, /** @type {number} */ to, /** @type {number} */ room) => {
    const most = to > room ? (room - from) / (to - from) : to < 0 ? from / (from - to) : 1;
    return Math.min(1, Math.max(0, most));
  };
  const all = Math.min(share(x0, x, width), share(y0, y, height));
  return [x0 + all * (x - x0), y0 + all * (y - y0)];
}
