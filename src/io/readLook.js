/**
 * What look.js wrote, or somebody else.
 *
 * @import { CameraNumbers } from './look.js'
 * @import { Session } from '../model/session.js'
 *
 * @typedef {{ change: Partial<Session>, camera: CameraNumbers | null, refused: string[] }} Look  `refused`: names of what was not
 *   understood, and is left as it is
 */
import { SCHEMA } from './queryParameters.js';
import { readWorkspaceLook } from './workspaceLook.js';

const CAMERA_NUMBERS = 7;
const VALUES = {
  tab: ['robot', 'program', 'code', 'workspace', 'jacobian'],
  panel: ['robot', 'program', 'code', 'workspace', 'jacobian', 'jog', 'aim'],
  frames: SCHEMA.frames.values,
  projection: SCHEMA.projection.values,
};

/** @param {string} text  as in an address @returns {Look} */
export function readLook(text) {
  const given = new URLSearchParams(text);
  const { view, refused } = readWorkspaceLook(given);
  /** @type {Partial<Session>} */
  const change = view ? { workspace: view } : {};
  for (const [name, values] of Object.entries(VALUES)) {
    const value = given.get(name);
    if (value === null) continue;
    if (values.some((one) => one === value)) Object.assign(change, { [name]: value });
    else refused.push(name);
  }
  const written = given.get('camera');
  const camera = written === null ? null : (SCHEMA.q.read(written) ?? null);
  const isCamera = camera?.length === CAMERA_NUMBERS && camera[2] > 0 && camera[6] > 0;
  if (written !== null && !isCamera) refused.push('camera');
  return { change, camera: isCamera ? camera : null, refused };
}
