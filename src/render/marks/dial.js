/**
 * The face of a turning joint's gauge: an arc from limit to limit, filled from zero to the present value, and a needle. A
 * range of more than a turn winds outwards, so that no part of it hides another.
 *
 * @import { Face, FaceOptions } from './gaugeFace.js'
 */
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';
import { fatLines, movableLine, segmentsThrough, spanLine } from '../fatLines.js';

const TURN = 2 * Math.PI;
const STEPS = 96; // in a full turn
const PITCH = 0.15; // by how much of the radius a turn winds outwards
const MOST_TURNS = 3; // a wider range is as good as endless
const NEARLY_FULL = 0.9 * TURN;
const ORDER = 35;

/** @param {FaceOptions} options @returns {Face} */
export function dialFace({ joint, seat, size, skin }) {
  const isEndless = !(joint.upper - joint.lower <= MOST_TURNS * TURN);
  const [from, to] = isEndless ? [-Math.PI, Math.PI] : [joint.lower, joint.upper];
  const pitch = to - from > TURN + 1e-9 ? PITCH / TURN : 0;
  const radius = Math.max(0.13 * size, 2.6 * seat.radius);

  /** @param {number} q @param {number} share  of the radius there @returns {[number, number, number]} */
  const at = (q, share) => {
    const r = radius * share * (1 + pitch * (q - from));
    return [r * Math.cos(seat.aim + q), r * Math.sin(seat.aim + q), seat.at];
  };
  /** Far outside its limits a value is shown outside, but no farther. @param {number} q */
  const inSight = (q) => Math.max(from - TURN, Math.min(to + TURN, q));
  const steps = Math.max(2, Math.ceil((STEPS * (to - from)) / TURN));
  const arc = Array.from({ length: steps + 1 }, (_, i) => at(from + ((to - from) * i) / steps, 1));
  const range = band(steps, skin.accent, 0.16);
  range.spread(from, to, at);
  const fill = band(STEPS, skin.accent, 0.5);
  const needle = movableLine({ color: skin.ink, width: 2.5, order: ORDER + 2 });
  const stops = [joint.lower, joint.upper].filter((q) => Number.isFinite(q) && !isEndless);
  const ticks = stops.flatMap((q) => [...at(q, 0.72), ...at(q, 1.08)]);

  return {
    still: [
      range.mesh,
      fatLines(segmentsThrough(arc), { color: skin.accent, width: 1.5, order: ORDER + 1 }),
      ...(ticks.length ? [fatLines(ticks, { color: skin.accent, width: 2.5, order: ORDER + 1 })] : []),
    ],
    moving: [fill.mesh, needle],
    stops,
    turnTo(q) {
      const shown = inSight(q);
      fill.spread(0, shown, at);
      spanLine(needle, at(shown, 0.3), at(shown, 1.1));
    },
    beyond(limit, value) {
      const end = inSight(value);
      const strip = band(STEPS, skin.bad, 0.5);
      strip.spread(limit, end, at);
      return [
        strip.mesh,
        fatLines([...at(end, 0.72), ...at(end, 1.08)], { color: skin.bad, width: 2.5, order: ORDER + 2 }),
      ];
    },
    tip: (q) => at(inSight(q), 1.1),
    centre: () => [0, 0, seat.at],
    // the two stops of a full turn are in one place: their words stand to either side
    besideStop: (q) => (to - from > NEARLY_FULL ? q + (q === to ? -0.35 : 0.35) : q),
  };
}

/**
 * A strip of the dial, of as many steps as it will ever have; spreading it again writes over the same numbers.
 * @param {number} steps
 * @param {string} color
 * @param {number} opacity
 */
function band(steps, color, opacity) {
  const positions = new BufferAttribute(new Float32Array((steps + 1) * 6), 3);
  const geometry = new BufferGeometry().setAttribute('position', positions);
  geometry.setIndex(
    Array.from({ length: steps }, (_, i) => [2 * i, 2 * i + 1, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 2]).flat(),
  );
  const material = new MeshBasicMaterial({
    color,
    opacity,
    transparent: true,
    side: DoubleSide,
    depthTest: false,
    depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.renderOrder = ORDER;
  mesh.frustumCulled = false;
  return {
    mesh,
    /** @param {number} from @param {number} to @param {(q: number, share: number) => [number, number, number]} at */
    spread(from, to, at) {
      for (let i = 0; i <= steps; i++) {
        const q = from + ((to - from) * i) / steps;
        positions.setXYZ(2 * i, ...at(q, 0.8));
        positions.setXYZ(2 * i + 1, ...at(q, 1));
      }
      positions.needsUpdate = true;
    },
  };
}
