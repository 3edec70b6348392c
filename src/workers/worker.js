/**
 * The one script of all workers: a worker's name says which job it does, and that job's code is fetched then. So jobs share in the
 * built page what they have in common.
 */

const JOBS = {
  checkPlan: () => import('./checkPlan.js'),
  findSingularity: () => import('./findSingularity.js'),
  mapWorkspace: () => import('./mapWorkspace.js'),
  planAround: () => import('./planAround.js'),
  planMotion: () => import('./planMotion.js'),
  solveAll: () => import('./solveAll.js'),
};

/** @typedef {keyof typeof JOBS} JobName */

/** What is asked before the job can hear. @type {MessageEvent[]} */
const early = [];
self.onmessage = (event) => void early.push(event);

JOBS[/** @type {JobName} */ (self.name)]().then(() => {
  for (const event of early) self.onmessage?.(event);
}, reportError);

export {};
