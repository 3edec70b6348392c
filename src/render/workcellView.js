/**
 * What the scene shows of the workcell: obstacles, what touches, the nearest two bodies, and the arm as the check sees it.
 * While nothing moves it does nothing.
 *
 * @import { State } from './robotView.js'
 * @import { Stage } from './stage.js'
 * @import { Clearance, Closeness, Workcells } from '../model/workcell/workcell.js'
 */
import { together } from '../model/views.js';
import { shownObstacles } from '../model/workcell/workcell.js';
import { createCapsuleMarks } from './marks/capsuleMarks.js';
import { createClearanceMark } from './marks/clearanceMark.js';
import { createObstacleMarks } from './marks/obstacleMarks.js';

/**
 * @param {Pick<State, 'store' | 'addView'>} state
 * @param {Stage} stage
 * @param {object} given
 * @param {Workcells} given.cells
 * @param {(nearest: Clearance) => string} given.text   what stands beside the nearest two
 */
export function createWorkcellView({ store, addView }, stage, { cells, text }) {
  const obstacles = stage.addMarks(createObstacleMarks);
  const capsules = stage.addMarks(createCapsuleMarks);
  const nearest = stage.addMarks(createClearanceMark);
  /** @type {readonly unknown[]} */
  let cast = [];
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, doc.obstacles, session.workcell]),
    ([, , listed, { isOpen, chosen, hidden, hasCapsules }]) => {
      const { doc } = store.state;
      const isWanted = listed.length > 0 || isOpen;
      const close = isWanted ? cells.closeness(doc) : null;
      const touched = new Set(close?.touching.map(({ obstacle }) => obstacle));
      const links = new Set(close?.touching.flatMap(({ link, other }) => (other === null ? [link] : [link, other])));
      obstacles.want({
        obstacles: shownObstacles(doc).filter(({ id }) => !hidden.includes(id)),
        lookOf: (id) => (touched.has(id) ? 'touched' : id === chosen && isOpen ? 'chosen' : 'usual'),
        areNamed: isOpen,
      });
      capsules.want(
        isWanted || hasCapsules ? { capsules: cells.capsules(doc), isShown: hasCapsules, touching: links } : null,
      );
      const near = nearer(close);
      nearest.want(near && { points: near.points, text: text(near), isTouching: near.distance <= 0 });
      stage.touch(cast[0] !== listed || cast[1] !== hidden);
      cast = [listed, hidden];
    },
  );
  return { obstacleAt: obstacles.at };
}

/**
 * What the line is drawn of: obstacles, as somebody has put them there; links where those alone touch, or where there are no
 * obstacles.
 * @param {Closeness | null} close
 */
function nearer(close) {
  if (close?.itself && close.itself.distance <= 0 && (close.around?.distance ?? 1) > 0) return close.itself;
  return close?.around ?? close?.itself ?? null;
}

/** @typedef {ReturnType<typeof createWorkcellView>} WorkcellScene */
