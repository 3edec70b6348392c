/** What code does beside its program between its moves: outputs, inputs, waits and calls, each digit and word of them; and accelerations. */
import { expect, test } from 'vitest';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { madeOf, WRITERS } from './codePrograms.js';

/** @import { Doc, StepDoc } from '../../../src/model/document.js' */

const base = newDocument(LIBRARY.fanuc_m10ia);
const move = (/** @type {number} */ q1) => ({
  ...{ kind: 'joint', target: { kind: 'posture', values: base.posture.with(0, q1) } },
  ...{ speed: 20, speedUnit: '%', acceleration: 50, ending: { kind: 'fine' } },
});
const STEPS = [
  ...[{ kind: 'set-output', output: 4, value: 'on' }, move(10)],
  ...[
    { kind: 'wait', seconds: 0.52 },
    { kind: 'wait-input', input: 7, value: 'on' },
  ],
  ...[{ kind: 'wait-input', input: 7, value: 'off' }, { kind: 'set-output', output: 24, value: 'off' }, move(20)],
  ...[
    { kind: 'set-output', output: 4, value: 'on' },
    { kind: 'call', program: 'grip2' },
  ],
].map((step, i) => ({ id: `s${i}`, ...step }));
/** @type {Doc} */
const doc = { ...base, motionPrograms: [{ id: 'm', name: 'Grip', steps: /** @type {StepDoc[]} */ (STEPS) }] };

/** Lines that are no moves, in any of the languages, and a digit or a word of them that is another. */
const CHANGES = [
  [/(?<![A-Z])(DO|DOUT|\$OUT)\[4\]/, '$1[5]'],
  [/(?<![A-Z])(DO|DOUT|\$OUT)\[24\]/, '$1[34]'],
  [/\b((?:DO|DOUT)\[24\] ?= ?)OFF/, '$1ON'],
  [/\$OUT\[24\]=FALSE/, '$OUT[24]=TRUE'],
  [/(?<![A-Z])(DI|DIN|\$IN)\[7\]/, '$1[8]'],
  [/\b((?:DI|DIN)\[7\] ?= ?)ON/, '$1OFF'],
  [/\$IN\[7\]==TRUE/, '$IN[7]==FALSE'],
  [/0\.52/, '0.62'],
  [/DELAY 520/, 'DELAY 550'],
  [/ACC50/, 'ACC60'],
  [/ACC_PTP,50/, 'ACC_PTP,60'],
  [/(CALL |CALL_PROG\('|\n)grip2/i, '$1grip3'],
];

test.each(WRITERS.map(([write, brand], i) => /** @type {const} */ ([['tp', 'pair', 'move', 'krl'][i], write, brand])))(
  '%s: as written nothing is against it; every other port, state, time or name is found on its line',
  (_, write, brand) => {
    const tried = madeOf(doc, brand);
    if (!tried) throw new Error('Expected a program.');
    const { files } = write(tried.made.program);
    expect(verifyCode(doc, tried.made, files).matches).toBe(true);
    let changed = 0;
    for (const [from, to] of /** @type {[RegExp, string][]} */ (CHANGES)) {
      const at = files.findIndex(({ text }) => from.test(text));
      if (at < 0) continue;
      changed++;
      const others = files.with(at, { ...files[at], text: files[at].text.replace(from, to) });
      const line = files[at].text.slice(0, from.exec(files[at].text)?.index).split('\n').length;
      const { matches, findings } = verifyCode(doc, tried.made, others);
      const found = findings.filter(({ code }) => code === 'differs');
      expect([String(from), matches, found.length > 0]).toEqual([String(from), false, true]);
      expect(Math.abs(found[0].line - line)).toBeLessThanOrEqual(1);
    }
    expect(changed).toBeGreaterThanOrEqual(7);
    // one that is left out, and one that is set to what it is
    const isOutput = /^.*(DO|DOUT|\$OUT)\[24\].*\r?\n/m;
    const without = files.map((file) => ({ ...file, text: file.text.replace(isOutput, '') }));
    expect(verifyCode(doc, tried.made, without).matches).toBe(false);
    const twice = files.map((file) => ({ ...file, text: file.text.replace(isOutput, (one) => one + one) }));
    expect(verifyCode(doc, tried.made, twice).matches).toBe(true);
  },
);
