/**
 * A worker for a job.
 *
 * @import { JobName } from '../../workers/worker.js'
 */

/** @param {JobName} name @returns {Worker} */
export const startJob = (name) =>
  new Worker(new URL('../../workers/worker.js', import.meta.url), { type: 'module', name });
