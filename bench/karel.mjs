/**
 * A million KAREL statements, interpreted: a loop over whole numbers and one over reals and an array.
 *
 * @import { BenchRow } from './run.mjs'
 */
import { performance } from 'node:perf_hooks';
import { parseKarel } from '../src/karel/parser.js';
import { runKarel } from '../src/karel/interpreter.js';
import { median } from './measure.mjs';

const PROGRAM = `PROGRAM million
VAR
  i, k, total : INTEGER
  x : REAL
  a : ARRAY[10] OF REAL
ROUTINE twice(n : INTEGER) : INTEGER
BEGIN
  RETURN(n * 2)
END twice
BEGIN
  total = 0
  x = 0
  FOR k = 1 TO 10 DO
    a[k] = k
  ENDFOR
  FOR i = 1 TO 100000 DO
    total = total + i MOD 7
    IF total > 1000000 THEN
      total = 0
    ENDIF
    k = i MOD 10 + 1
    x = x * 0.5 + 1
    a[k] = x
    total = total + twice(k)
    k = k + 1
  ENDFOR
END million`;

/** Of the loop: FOR, five assignments, IF, a call and its RETURN. */
const STATEMENTS = 100_000 * 10;

/** @returns {BenchRow[]} */
export function bench() {
  const { tree } = parseKarel(PROGRAM);
  const times = Array.from({ length: 7 }, () => {
    const start = performance.now();
    const run = runKarel(tree, { steps: 100_000_000 });
    let next = run.next();
    while (!next.done) next = run.next();
    if (next.value.status !== 'ended')
      throw new Error(`The program did not end: ${next.value.status}, ${next.value.alarm?.reason}`);
    return (performance.now() - start) / 1000;
  });
  return [
    {
      name: `KAREL: ${STATEMENTS.toLocaleString('en')} statements`,
      unit: 's',
      median: median(times),
      target: { of: 'median', atMost: 1 },
    },
  ];
}
