/**
 * How a document is looked at, as text: what is open, which frames are drawn, from where. It goes with a link, and with work
 * that is kept for another visit.
 *
 * @import { Session } from '../model/session.js'
 *
 * @typedef {readonly number[]} CameraNumbers  azimuth and elevation in degrees, distance in metres, what is looked at in metres
 *   (x, y, z), and how many times as wide as high the picture is
 * @typedef {{ change: Partial<Session>, camera: CameraNumbers | null, refused: string[] }} Look  `refused`: names of what was not
 *   understood, and is left as it is
 */
import { SCHEMA } from './queryParameters.js';

/** What is not written: a page begins so. */
const FIRST = { tab: 'robot', panel: 'jog', frames: 'ends', projection: 'perspective' };
const CAMERA_NUMBERS = 7;
const DIGITS = 6;

/** @type {{ [K in 'tab' | 'panel' | 'frames' | 'projection']: readonly string[] }} */
const VALUES = {
  tab: ['robot', 'program', 'code', 'jacobian'],
  panel: ['robot', 'program', 'code', 'jacobian', 'jog', 'aim'],
  frames: SCHEMA.frames.values,
  projection: SCHEMA.projection.values,
};
const NAMES = /** @type {readonly (keyof typeof VALUES)[]} */ (Object.keys(VALUES));

/**
 * @param {{ panels?: Session | null, view?: Session | null, camera?: CameraNumbers | null }} of  `panels`: what is open;
 *   `view`: frames and projection; `camera`: where it is seen from
 * @returns {string} as in an address; empty where all is as a page begins
 */
export function writeLook({ panels, view, camera }) {
  const fields = NAMES.flatMap((name) => {
    const session = name === 'tab' || name === 'panel' ? panels : view;
    return session && session[name] !== FIRST[name] ? [`${name}=${session[name]}`] : [];
  });
  if (camera) fields.push(`camera=${camera.map((number) => String(Number(number.toPrecision(DIGITS)))).join(',')}`);
  return fields.join('&');
}

/** @param {string} text @returns {Look} */
export function readLook(text) {
  const given = new URLSearchParams(text);
  /** @type {Record<string, string>} */
  const change = {};
  /** @type {string[]} */
  const refused = [];
  for (const name of NAMES) {
    const value = given.get(name);
    if (value === null) continue;
    if (VALUES[name].includes(value)) change[name] = value;
    else refused.push(name);
  }
  const written = given.get('camera');
  const camera = written === null ? null : (SCHEMA.q.read(written) ?? null);
  const isCamera = camera?.length === CAMERA_NUMBERS && camera[2] > 0 && camera[6] > 0;
  if (written !== null && !isCamera) refused.push('camera');
  return { change, camera: isCamera ? camera : null, refused };
}
