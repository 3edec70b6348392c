/**
 * How a document is looked at, as text: what is open, which frames are drawn, from where. It goes with a link, and with work
 * that is kept for another visit.
 *
 * @import { Session } from '../model/session.js'
 *
 * @typedef {readonly number[]} CameraNumbers  azimuth and elevation in degrees, distance in metres, what is looked at in metres
 *   (x, y, z), and how many times as wide as high the picture is
 */
import { writeWorkspaceLook } from './workspaceLook.js';

/** What is not written: a page begins so. */
const FIRST = { tab: 'robot', panel: 'jog', frames: 'ends', projection: 'perspective' };
const DIGITS = 6;

/**
 * @param {{ panels?: Session | null, view?: Session | null, camera?: CameraNumbers | null }} of  `panels`: what is open;
 *   `view`: frames, projection and what is asked of the workspace; `camera`: where it is seen from
 * @returns {string} as in an address; empty where all is as a page begins
 */
export function writeLook({ panels, view, camera }) {
  /** @param {Session | null | undefined} session @param {(keyof typeof FIRST)[]} names */
  const fields = (session, ...names) =>
    names.flatMap((name) => (session && session[name] !== FIRST[name] ? [`${name}=${session[name]}`] : []));
  const numbers = camera?.map((number) => String(Number(number.toPrecision(DIGITS))));
  return [
    ...fields(panels, 'tab', 'panel'),
    ...fields(view, 'frames', 'projection'),
    ...(view?.workspace ? writeWorkspaceLook(view.workspace) : []),
    ...(numbers ? [`camera=${numbers.join()}`] : []),
  ].join('&');
}
