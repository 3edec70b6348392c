/**
 * The workspace in the scene: the volume, as a solid or as points, and the section.
 *
 * @import { State } from './robotView.js'
 * @import { Stage } from './stage.js'
 */
import { together } from '../model/views.js';
import { createReachPress } from './drag/reachPress.js';
import { createReachMarks } from './marks/reachMarks.js';
import { createReachProbes } from './marks/reachProbes.js';

/**
 * @param {Pick<State, 'store' | 'addView' | 'derived' | 'clock'>} state
 * @param {Stage} stage
 */
export function createWorkspaceView(state, stage) {
  const { addView, clock } = state;
  const marks = stage.addMarks((tools) => createReachMarks({ ...tools, clock, onChange: () => stage.touch() }));
  addView(
    together(({ session }) => [session.maps.volume, session.workspace]),
    ([map, view]) => {
      const isShown = map !== null && view !== null && view.hasVolume && view.open.includes('volume');
      marks.wantVolume(isShown ? { map, view } : null);
    },
  );
  addView(
    together(({ session }) => [session.maps.section, session.workspace, session.reachHand.pick === 'section']),
    ([map, view, isPicked]) => {
      // the numbers of the boundary's postures stand on it
      const isOpen = ['section', 'teach'].some((fold) => view?.open.includes(fold));
      const isWanted = isPicked || (isOpen && view?.hasSection === true);
      const isShown = map !== null && isWanted;
      marks.wantSection(isShown ? (map.section ?? map.first) : null);
    },
  );
  const probes = stage.addMarks((tools) => createReachProbes(tools));
  addView(
    together(({ session }) => [session.probes, session.workspace?.open]),
    ([shown, open]) => {
      probes.want([open?.includes('points') ? shown.points : null, open?.includes('teach') ? shown.teach : null]);
      stage.touch();
    },
  );
  createReachPress(state, stage);
  // What has come into the picture is seen whole, unless somebody has chosen what is seen.
  addView(
    ({ session: { maps, workspace } }) =>
      [
        workspace?.hasVolume && maps.volume && !maps.volume.isStale,
        workspace?.hasSection && maps.section && !maps.section.isStale,
      ]
        .map(Boolean)
        .join(),
    () => clock.onFrame(stage.keepInPicture),
  );
}
