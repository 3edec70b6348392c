/**
 * Where the tool has been since its trace was begun. What a hand, the clock or a program moves is one line on; what puts the arm
 * elsewhere at once (home, undo, a script) begins another stroke, for the tool has not been between.
 *
 * The trace takes so much memory and no more: points that lie closer than a thousandth of the reach are one, and when there
 * are too many after all, that distance is doubled.
 *
 * @import { Derived } from '../derived.js'
 * @import { Action, AppState } from '../session.js'
 * @import { Store } from '../store.js'
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {ReturnType<typeof createTrace>} Trace
 * @typedef {{ readonly trace: Trace | null }} Recorder
 */
import { tcpPose } from '../../kinematics/forward.js';

const SPACING = 0.001; // in reaches
const SAME_PLACE = 1e-9; // likewise
const MOST = 8192;
/** What one joint turns at once is the arc that it is, of so many radians a point, and no more than so far. */
const ARC = { step: 0.035, most: 4 * Math.PI };

/**
 * @param {Chain} chain
 * @param {Float64Array} q  where it begins
 * @param {number} [most]  points
 */
export function createTrace(chain, q, most = MOST) {
  const points = new Float32Array(3 * most);
  const starts = new Uint8Array(most);
  const size = Number.isFinite(chain.reach) && chain.reach > 0 ? chain.reach : chain.characteristicLength;
  let spacing = SPACING * size;
  let count = 0;
  let length = 0;
  let edition = 0;
  /** Where the tool is, to the last digit. */
  const here = new Float64Array(3);

  /** @param {number} i @param {number} k */
  const apart = (i, k) =>
    Math.hypot(
      points[3 * i] - points[3 * k],
      points[3 * i + 1] - points[3 * k + 1],
      points[3 * i + 2] - points[3 * k + 2],
    );

  /** @param {Float64Array} at  a pose */
  const farFrom = (at) => Math.hypot(at[12] - here[0], at[13] - here[1], at[14] - here[2]);

  /** @param {boolean} isStart */
  function push(isStart) {
    if (count === most) thin();
    starts[count] = Number(isStart);
    points.set(here, 3 * count++);
  }

  /** Fewer points: wider apart, and where it is the strokes that are too many, without the oldest. */
  function thin() {
    const enough = Math.floor(most * 0.75);
    while (count > enough && spacing < size) {
      spacing *= 2;
      let kept = 0;
      for (let i = 0; i < count; i++) {
        const isEnd = i === count - 1 || starts[i + 1] === 1;
        if (starts[i] || isEnd || apart(i, kept - 1) >= spacing) move(i, kept++);
      }
      count = kept;
    }
    const spare = count - enough;
    for (let i = spare; spare > 0 && i < count; i++) move(i, i - spare);
    if (spare > 0) count = enough;
    starts[0] = 1;
    edition++;
  }

  /** @param {number} from @param {number} to  not after it, or a point would be lost that is still wanted */
  function move(from, to) {
    points.copyWithin(3 * to, 3 * from, 3 * from + 3);
    starts[to] = starts[from];
  }

  /** @param {Float64Array} at  a pose */
  function begin(at) {
    if (count > 0 && farFrom(at) < SAME_PLACE * size) return; // in other units, or otherwise in the same place
    here.set(at.subarray(12, 15));
    const isAlone = count > 0 && starts[count - 1] === 1;
    if (isAlone) points.set(here, 3 * (count - 1));
    else push(true);
  }

  /** @param {Float64Array} at  a pose */
  function draw(at) {
    const far = farFrom(at);
    if (far === 0) return;
    length += far;
    here.set(at.subarray(12, 15));
    // the last point goes along with the tool until it is far enough from the one before
    if (starts[count - 1] || apart(count - 1, count - 2) >= spacing) push(false);
    else points.set(here, 3 * (count - 1));
  }

  begin(tcpPose(chain, q));

  return {
    /** x y z of each, in the world, m; those past `count` mean nothing. */
    points,
    most,
    get count() {
      return count;
    },
    /** Whether there is no line from the point before to this one. @param {number} i */
    isStart: (i) => starts[i] === 1,
    /** Of all that was drawn, m, whatever was thinned since. */
    get length() {
      return length;
    },
    get strokes() {
      let sum = 0;
      for (let i = 0; i < count; i++) sum += starts[i];
      return sum - Number(sum > 1 && starts[count - 1] === 1);
    },
    /** Counts how often points changed other than the last one, and those after it. */
    get edition() {
      return edition;
    },
    /**
     * @param {Float64Array} from
     * @param {Float64Array} to
     * @param {boolean} isMotion
     */
    go(from, to, isMotion) {
      const moved = [...to.keys()].filter((i) => to[i] !== from[i]);
      const [only] = moved;
      const isTurn = moved.length === 1 && chain.joints[only].type === 'revolute';
      const turn = isTurn ? Math.abs(to[only] - from[only]) : 0;
      if (!isMotion || turn > ARC.most) return begin(tcpPose(chain, to));
      const parts = Math.max(1, Math.ceil(turn / ARC.step));
      const between = Float64Array.from(from);
      for (let part = 1; part < parts; part++) {
        between[only] = from[only] + (part / parts) * (to[only] - from[only]);
        draw(tcpPose(chain, between));
      }
      draw(tcpPose(chain, to));
    },
  };
}

/** @param {Chain} one @param {Chain} other */
export function isSameShape(one, other) {
  if (one === other) return true;
  const [a, b] = [one, other].map(numbersOf);
  if (one.convention !== other.convention || a.length !== b.length) return false;
  return a.every((number, i) => number === b[i] || Math.abs(number - b[i]) <= 1e-12 * (1 + Math.abs(number)));
}

/** @param {Chain} chain */
const numbersOf = ({ joints, base, tool }) => [
  ...joints.flatMap(({ type, theta, d, a, alpha }) => [Number(type === 'revolute'), theta, d, a, alpha]),
  ...base,
  ...tool,
];

/** @type {WeakMap<object, Recorder>} */
const recorders = new WeakMap();

/**
 * The one who records what the session wants recorded, from when it is first asked for.
 * @param {{ store: Store<AppState, Action>, derived: Derived }} page
 * @returns {Recorder}
 */
export function traceOf(page) {
  const recorder = recorders.get(page.store) ?? recordTrace(page);
  recorders.set(page.store, recorder);
  return recorder;
}

/** @param {{ store: Store<AppState, Action>, derived: Derived }} page @returns {Recorder} */
function recordTrace({ store, derived }) {
  /** @type {{ trace: Trace, order: number, chain: Chain, q: Float64Array } | null} */
  let now = null;

  function look() {
    const { doc, session, gesture } = store.state;
    if (session.trace === null) {
      now = null;
      return;
    }
    const chain = derived.chain(doc);
    const q = derived.posture(doc);
    if (!now || now.order !== session.trace || !isSameShape(chain, now.chain)) {
      now = { trace: createTrace(chain, q), order: session.trace, chain, q };
      return;
    }
    if (q !== now.q) now.trace.go(now.q, q, gesture !== null || session.playback?.isPlaying === true);
    Object.assign(now, { chain, q });
  }
  look();
  store.subscribe(look);
  return {
    get trace() {
      return now?.trace ?? null;
    },
  };
}
