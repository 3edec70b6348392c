/**
 * Ports of the controller, and what happens by itself: names that conditions know.
 *
 * @import { Expression } from './tree.js'
 */

/** What happens by itself and can be waited for; those with true take a number in brackets. */
export const OCCURRENCES = /** @type {Readonly<Record<string, boolean>>} */ ({
  ...{ ERROR: true, EVENT: true, SEMAPHORE: true, ABORT: true },
  ...{ PAUSE: true, CONTINUE: true, POWERUP: false, TIME: true },
});

/** Names that stand for the controller's ports; the first group is BOOLEAN, the second INTEGER. */
export const BOOLEAN_PORTS = new Set(
  'DIN DOUT RDI RDO OPIN OPOUT TPIN TPOUT UIN UOUT WDI WDO WDOUT WDIN LDI LDO FLG MRK'.split(' '),
);
export const INTEGER_PORTS = new Set('GIN GOUT AIN AOUT LAI LAO'.split(' '));

/** @param {Expression} node */
export const isPort = (node) =>
  node.kind === 'index' &&
  node.target.kind === 'name' &&
  (BOOLEAN_PORTS.has(node.target.name.toUpperCase()) || INTEGER_PORTS.has(node.target.name.toUpperCase()));
