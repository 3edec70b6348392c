/**
 * What runs for each built-in. Each gets its arguments as values, and those that it sets as references.
 *
 * @import { Builtin } from './machine.js'
 */
import { CONTROLLER } from './builtinsController.js';
import { FILES } from './builtinsFiles.js';
import { MATHEMATICS } from './builtinsMath.js';
import { TASKS } from './tasks.js';
import { VARIABLES_BY_NAME } from './variablesByName.js';

/** @type {Readonly<Record<string, Builtin>>} */
export const RUN = { ...MATHEMATICS, ...CONTROLLER, ...FILES, ...TASKS, ...VARIABLES_BY_NAME };
