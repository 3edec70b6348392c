/**
 * Where code is run without a person, the inputs and flags that it names are taken to come: the first changes at each look, the
 * next at each second one and so on, so that those of one condition come together in every way.
 *
 * @import { State } from '../../karel/run/machine.js'
 */
import { PORTS } from '../../karel/tp/run/memory.js';

const INPUT = /\b(DIN?|RDI|RI|UIN?|OPIN|SI|WI|FLG|F)\s*\[\s*(\d+)/g;

/** So many that stand next to each other. */
const BITS = 4;

/** @param {readonly { text: string }[]} programs @returns {(state: Pick<State, 'ports'>) => void} */
export function comingInputs(programs) {
  const inputs = new Map(
    programs.flatMap(({ text }) =>
      [...text.matchAll(INPUT)].map(([, bank, index]) => [`${bank} ${index}`, [PORTS[bank] ?? bank, Number(index)]]),
    ),
  );
  let looks = 0;
  return ({ ports }) => {
    looks++;
    for (const [i, [port, index]] of [...inputs.values()].entries())
      (ports[port] ??= {})[index] = ((looks >> (i % BITS)) & 1) === 1;
  };
}
