/**
 * The workspace in the scene: the volume, as a solid or as points, and the section.
 *
 * @import { State } from './robotView.js'
 * @import { Stage } from './stage.js'
 */
import { together } from '../model/views.js';
import { createReachMarks } from './marks/reachMarks.js';
import { createReachProbes } from './marks/reachProbes.js';

/**
 * @param {Pick<State, 'addView' | 'clock'>} state
 * @param {Stage} stage
 */
export function createWorkspaceView({ addView, clock }, stage) {
  const marks = stage.addMarks((tools) => createReachMarks({ ...tools, clock, onChange: () => stage.touch() }));
  addView(
    together(({ session }) => [session.maps.volume, session.workspace]),
    ([map, view]) => {
      const isShown = map !== null && view !== null && view.hasVolume && view.open.includes('volume');
      marks.wantVolume(isShown ? { map, view } : null);
    },
  );
  addView(
    together(({ session }) => [session.maps.section, session.workspace]),
    ([map, view]) => {
      const isShown = map !== null && view !== null && view.hasSection && view.open.includes('section');
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
