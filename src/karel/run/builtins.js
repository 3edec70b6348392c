/**
 * What runs for each built-in. Each gets its arguments as values, and those that it sets as references.
 *
 * @import { Builtin } from './machine.js'
 */
import { CONTROLLER } from './builtinsController.js';
import { MATHEMATICS } from './builtinsMath.js';

/** @type {Readonly<Record<string, Builtin>>} */
export const RUN = { ...MATHEMATICS, ...CONTROLLER };
