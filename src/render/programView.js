/**
 * What the scene shows of the motion program: the path of its tool, and the arm where the present move begins and ends.
 *
 * @import { Stage } from './stage.js'
 * @import { AppState } from '../model/session.js'
 * @import { AddView } from '../model/views.js'
 */
import { codePathShown } from '../model/code/codePathShown.js';
import { together } from '../model/views.js';
import { moveGhosts, toolPathShown, toolPathTime } from '../model/program/toolPathShown.js';
import { createGhostArms } from './marks/ghostArms.js';
import { createPathMark } from './marks/pathMark.js';

/**
 * @param {{ addView: AddView<AppState> }} state
 * @param {Stage} stage
 * @param {{ ghosts: (step: number) => readonly [begins: string, ends: string] }} text
 */
export function createProgramView({ addView }, stage, text) {
  const path = stage.addMarks(createPathMark);
  addView(
    // one path at a time: that of the code, while it is open
    together((state) => [codePathShown(state) ? null : toolPathShown(state), toolPathTime(state)]),
    ([shown, time]) => {
      path.want(shown && { path: shown, time });
      stage.touch();
    },
  );
  const ghosts = stage.addMarks(createGhostArms);
  addView(
    // two at most: one that somebody looks at elsewhere comes first
    (state) => (state.session.ghost ? null : moveGhosts(state)),
    (shown) => {
      ghosts.want(shown ? shown.ends.map((q, i) => ({ q, label: text.ghosts(shown.step + 1)[i] })) : []);
      stage.touch();
    },
  );
}
