/**
 * The recorded postures as code for a controller: what of the document goes into it, and what a person should know before
 * running it. The text itself is made in `karel`. Pure, so that it can be remembered for a document.
 *
 * @import { Doc } from '../document.js'
 * @import { Issue } from '../issues.js'
 * @import { KarelFile, TpFile } from '../../karel/fanucPair.js'
 * @import { PairOptions } from '../../karel/fanucPlan.js'
 *
 * @typedef {Pick<PairOptions, 'version' | 'generatedAt'> & Partial<Omit<PairOptions, 'robotName' | 'points' | 'convention'>>}
 *   CodeOptions  the program is called after the robot unless it is given a name
 */
import { writeFanucPair } from '../../karel/fanucPair.js';
import { conventionLines } from './controllerConvention.js';
import { postureIssues, robotIssues } from './controllerIssues.js';
import { pendantValues } from './controllerValues.js';
import { isSliding } from '../document.js';

const FEWEST_POSTURES = 2;

/**
 * @param {Doc} doc
 * @param {CodeOptions} options
 * @returns {{ files: readonly (KarelFile | TpFile)[], issues: readonly Issue[] }} no files where an issue is an error
 */
export function controllerCode({ robot, postures }, options) {
  if (postures.length < FEWEST_POSTURES) {
    const came = postures.length === 0 ? 'none is recorded' : 'one is recorded';
    const message = `A motion needs at least ${FEWEST_POSTURES} recorded postures; ${came}.`;
    return { files: [], issues: [{ severity: 'error', code: 'few-postures', path: 'postures', message }] };
  }
  const slides = robot.joints.map(isSliding);
  const points = postures.map(({ id, q }) => ({ name: id, jointValues: pendantValues(robot, q), slides }));
  const issues = [
    ...robotIssues(robot),
    ...postures.flatMap(({ id, q }, i) => postureIssues(robot, { id, q, pendant: points[i].jointValues, index: i })),
  ];
  if (issues.some(({ severity }) => severity === 'error')) return { files: [], issues };

  const programName = options.programName ?? robot.name;
  const pair = writeFanucPair({
    ...options,
    ...{ programName, robotName: robot.name, points, convention: conventionLines(robot) },
  });
  const pairIssues = pair.issues
    .filter(({ code }) => code !== 'program-name-changed' || options.programName !== undefined)
    .map((issue) => (issue.path === 'points' ? { ...issue, path: 'postures' } : issue));
  return { files: pair.files, issues: [...issues, ...pairIssues] };
}
