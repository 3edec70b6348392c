/**
 * Singular values of the Jacobian with the length that makes them comparable, manipulability, condition number, the motion that
 * is lost or hardest in words, and the ellipsoid in the scene.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { JacobianView } from '../../model/numbers/jacobianView.js'
 * @import { DexterityNumbers, WorstMotion } from '../../model/numbers/dexterityNumbers.js'
 */
import { dexterityNumbers, partOf } from '../../model/numbers/dexterityNumbers.js';
import { ellipsoidAt } from '../../model/numbers/ellipsoid.js';
import { fromKernel } from '../../model/units.js';
import { fill, h, symbol } from '../parts/dom.js';
import { fixed, poseNumber, unitSign, withUnit } from '../parts/format.js';
import { significant } from '../parts/scientific.js';
import { segments } from '../parts/segments.js';
import { JACOBIAN } from '../words/jacobian.js';

const { measures: WORDS, ellipsoid: ELLIPSOID } = JACOBIAN;

/** @param {readonly number[]} vector @returns {string} an axis by its name, or all three numbers */
export function directionInWords(vector) {
  const main = vector.findIndex((value) => Math.abs(value) > 1 - 1e-6);
  return main >= 0 ? 'xyz'[main] : `(${vector.map((value) => fixed(value, 2)).join(', ')})`;
}

/** @param {Page} page */
export function createMotionMeasures({ store, derived }) {
  /** @param {Partial<JacobianView>} change */
  const choose = (change) =>
    store.dispatch({ type: 'show', change: { jacobian: { ...store.state.session.jacobian, ...change } } });
  const part = segments(WORDS.part.label, ['full', 'linear', 'angular'], WORDS.part, (value) =>
    choose({ part: value }),
  );
  const scale = h('span', { class: 'soft' });
  const note = h('p', { class: 'sm soft' });
  const list = h('ol', { class: 'sigmas', 'aria-label': WORDS.list });
  const facts = h('dl', { class: 'measures' });
  const worst = h('p', { class: 'worst' });
  const joints = h('p', { class: 'sm soft' });
  const kind = segments(ELLIPSOID.label, ['off', 'velocity', 'force'], ELLIPSOID, (value) =>
    choose({ ellipsoid: value === 'off' ? null : value }),
  );
  const drawn = h('p', { class: 'sm soft' });

  /** @param {RobotDoc} robot @param {DexterityNumbers} found */
  function drawValues(robot, { part: rows, values, freedoms, rank, manipulability, conditionNumber }) {
    const length = rows === 'linear' ? unitSign(robot.units.length) : '';
    const most = Math.max(values[0] ?? 0, Number.MIN_VALUE);
    fill(
      list,
      values.slice(0, Math.max(freedoms, 1)).map((value, i) => {
        const bar = h('i', {});
        bar.style.width = `${(100 * value) / most}%`;
        return h(
          'li',
          {},
          symbol('σ', i + 1),
          h('span', { class: 'meter', 'aria-hidden': 'true' }, bar),
          h('output', {}, `${significant(i < rank ? value : 0)}${length && ` ${length}`}`),
        );
      }),
    );
    const power = length && freedoms > 1 ? `${length}${'⁰¹²³⁴⁵⁶'[freedoms]}` : length;
    const fact = (/** @type {string} */ name, /** @type {string} */ value, /** @type {string} */ title = '') => [
      h('dt', { title: title || null }, name),
      h('dd', {}, value),
    ];
    fill(
      facts,
      fact(
        WORDS.manipulability,
        `${significant(manipulability)}${power && ` ${power}`}`,
        WORDS.manipulabilityNote(freedoms),
      ),
      fact(WORDS.condition, significant(conditionNumber)),
      fact(WORDS.rank, WORDS.rankOf(rank, freedoms)),
    );
  }

  /** @param {RobotDoc} robot @param {WorstMotion | null} motion @param {string} axes */
  function drawWorst(robot, motion, axes) {
    if (!motion) {
      worst.textContent = WORDS.nothing;
      joints.textContent = '';
      return;
    }
    const along = motion.along && WORDS.along(directionInWords(motion.along));
    const about = motion.about && WORDS.about(directionInWords(motion.about));
    const motionText = along && about ? WORDS.mixed(along, about) : (along ?? about ?? '');
    const head = motion.isLost ? WORDS.lost : WORDS.worst;
    const others = motion.lostFreedoms > 1 ? WORDS.alsoLost(motion.lostFreedoms) : '';
    fill(worst, h('b', {}, `${head}: `), `${motionText}${WORDS.in(axes)}${others}.`);
    const rates = motion.joints
      .map(({ joint, share }) => `J${joint + 1}\u00a0${share < 0 ? '−' : '+'}${fixed(Math.abs(share), 2)}`)
      .join(', ');
    joints.textContent = (motion.isLost ? WORDS.still : WORDS.price)(rates);
  }

  return {
    element: h(
      'section',
      { class: 'sec' },
      h('header', {}, h('h2', {}, WORDS.title), h('span', { class: 'grow' }), part.element),
      h(
        'div',
        { class: 'body stack' },
        list,
        h('p', { class: 'sm' }, scale, ' ', note),
        facts,
        worst,
        joints,
        h('div', { class: 'row-flex wrap' }, h('span', {}, ELLIPSOID.label), kind.element),
        drawn,
      ),
    ),
    /** @param {Float64Array} q @param {JacobianView} view */
    draw(q, view) {
      const { doc } = store.state;
      const { robot } = doc;
      const chain = derived.chain(doc);
      const rows = partOf(chain, view.part);
      const found = dexterityNumbers(robot, chain, q, rows, view.frame, derived.user(doc));
      part.draw(rows);
      const { length } = robot.units;
      scale.textContent = WORDS.scale(withUnit(poseNumber(found.lengthScale, length), length));
      note.textContent = WORDS.scaleNote[rows];
      drawValues(robot, found);
      drawWorst(robot, found.worst, JACOBIAN.frame.seen[view.frame](doc.activeUser));
      kind.draw(view.ellipsoid ?? 'off');
      drawn.hidden = view.ellipsoid === null;
      if (view.ellipsoid) {
        const { halves, scale: metres, isCut } = ellipsoidAt(chain, q, view.ellipsoid);
        const scaleText = withUnit(significant(fromKernel('length', metres, robot.units)), length);
        const text = ELLIPSOID.inWords[view.ellipsoid](
          halves.map((half) => significant(half, 3)).join(', '),
          scaleText,
        );
        drawn.textContent = isCut ? `${text} ${ELLIPSOID.cut}` : text;
      }
    },
  };
}
