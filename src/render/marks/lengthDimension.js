/**
 * A length of the table, drawn as on a drawing: from axis to axis, a dimension line beside it with a dot where it begins and
 * an arrowhead where it ends, so that a negative length shows its direction; witness lines; and the axes by name.
 *
 * @import { Dimension, DimensionOptions } from './measured.js'
 */
import { besideAxis, within } from './drafting.js';

const OFFSET = /** @type {[number, number]} */ ([44, 104]); // of the dimension line, pixels
const BEYOND = /** @type {[number, number]} */ ([46, 104]); // of the axes
const HEAD = 13;

/** @param {DimensionOptions} options @returns {Dimension} */
export function createLengthDimension({ drafting, size, isVariable }) {
  const along = drafting.axis('z');
  const alongX = drafting.axis('x');
  const ends = { x: [drafting.axis('x'), drafting.axis('x')], z: [drafting.axis('z'), drafting.axis('z')] };
  const witnesses = [drafting.line(1.1, 0.75), drafting.line(1.1, 0.75)];
  const line = drafting.line(1.75);
  const tick = drafting.line(1.75);
  const head = drafting.arrowhead();
  const start = drafting.dot();
  const words = drafting.words();
  let side = 0;

  return {
    words,
    face(eye, { from, to, axis, across, shown }, middle) {
      const at = from.clone().lerp(to, 0.5);
      const perPixel = eye.perPixel(at);
      const out = besideAxis(eye, axis.way, at);
      // away from the rest of the arm; it changes sides only when that is clearly the wrong one
      const away = out.dot(at.clone().sub(middle)) / perPixel;
      if (side === 0 || away * side < -24) side = away < 0 ? -1 : 1;
      out.multiplyScalar(side);
      const length = from.distanceTo(to);
      const isZero = length < 1e-9;

      const beyond = within(0.11 * size, perPixel, BEYOND);
      const measured = axis.name === 'z' ? along : alongX;
      (axis.name === 'z' ? alongX : along).show(false);
      const [low, high] = shown > 0 || isZero ? [from, to] : [to, from];
      measured.show(true);
      measured.lay(
        low.clone().addScaledVector(axis.way, -0.6 * beyond),
        high.clone().addScaledVector(axis.way, beyond),
        perPixel,
        axis.number,
      );
      for (const name of /** @type {const} */ (['x', 'z'])) {
        ends[name].forEach((end, i) => {
          const isUsed = name === across[i].name && !(i === 1 && isZero && across[0].way.dot(across[1].way) > 0.9999);
          end.show(isUsed);
          const point = i === 0 ? from : to;
          const { way, number } = across[i];
          if (isUsed)
            end.lay(
              point.clone().addScaledVector(way, -0.6 * beyond),
              point.clone().addScaledVector(way, beyond),
              perPixel,
              number,
            );
        });
      }

      const offset = within(0.1 * size, perPixel, OFFSET);
      const [a, b] = [from, to].map((point) => point.clone().addScaledVector(out, offset));
      for (const { line: each } of [...witnesses, line]) each.visible = !isZero;
      head.mesh.visible = !isZero;
      start.lay(isZero ? from : a, (isZero ? 5 : 3) * perPixel);
      tick.line.visible = isVariable && !isZero && axis.constant !== 0 && Math.abs(axis.constant - shown) > 1e-9;
      if (!isZero) {
        const way = b.clone().sub(a).divideScalar(length);
        const point = Math.min(HEAD * perPixel, 0.6 * length);
        [
          [from, a],
          [to, b],
        ].forEach(([near, far], i) =>
          witnesses[i].lay(
            near.clone().addScaledVector(out, Math.min(3 * perPixel, offset)),
            far.clone().addScaledVector(out, 7 * perPixel),
          ),
        );
        line.lay(a, b.clone().addScaledVector(way, -0.8 * point));
        head.lay(b, way, point);
        if (tick.line.visible) {
          const stop = a.clone().addScaledVector(axis.way, axis.constant);
          tick.lay(stop.clone().addScaledVector(out, -6 * perPixel), stop.addScaledVector(out, 6 * perPixel));
        }
      }
      words.at.copy(isZero ? from : a.clone().lerp(b, 0.5));
      words.from = isZero ? from.clone().addScaledVector(out, -perPixel) : at;
    },
  };
}
