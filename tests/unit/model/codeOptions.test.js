/** How code is to be written is kept with the model as a text: what counts of it, what it follows, and what is passed over. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { applyCommand } from '../../../src/model/commands.js';
import { formatOf, keptOptions, optionsFor, withOptions } from '../../../src/model/controller/codeOptions.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { refusal } from '../../../src/model/refusals.js';
import { runs, SEED } from '../../helpers/property.js';

/** @import { Doc } from '../../../src/model/document.js' */

const PUMA = newDocument(LIBRARY.puma560);
/** @param {Parameters<typeof withOptions>[1]} change @param {Doc} [doc] */
const choosing = (change, doc = PUMA) =>
  applyCommand(doc, { type: 'set-code-options', text: withOptions(doc, change) });
const POSTURES = /** @type {const} */ ({ kind: 'postures' });

test('the language is the one that was chosen, or that of the maker, or the usual one', () => {
  const of = (/** @type {string} */ name, info = {}) => formatOf(newDocument({ ...LIBRARY.puma560, name, info }), 'tp');
  expect(of('KUKA KR 5 arc')).toBe('krl');
  expect(of('FANUC M-10iA')).toBe('pair');
  expect(of('KR 5', { manufacturer: 'Kuka AG' })).toBe('krl');
  expect(of('Kukaburra')).toBe('tp');
  expect(formatOf(choosing({ format: 'pair' }, newDocument({ ...LIBRARY.puma560, name: 'KUKA' })), 'tp')).toBe('pair');
});

test('name and speed are of what they were chosen for, a register of the pair, a frame is one that is there', () => {
  const chosen = { programName: 'pick', speed: 12.5, firstRegister: 7, userFrame: 'table', toolNumber: 3 };
  const doc = choosing({ ...chosen, source: 'postures' });
  const numbers = { 'tool ': 3 };
  expect(optionsFor(doc, 'pair', POSTURES)).toEqual({ programName: 'pick', speed: 12.5, firstRegister: 7, numbers });
  expect(optionsFor(doc, 'krl', { kind: 'targets' })).toEqual({ numbers });
  expect(optionsFor(choosing({ userFrame: '0' }), 'tp', POSTURES)).toEqual({ userFrame: '' });
  const framed = applyCommand(doc, { type: 'add-frame', kind: 'user', pose: { xyz: [1, 0, 0] } });
  const named = applyCommand(framed, { type: 'rename-frame', index: 0, id: 'table' });
  expect(optionsFor(named, 'tp', POSTURES)).toMatchObject({ userFrame: 'table' });
  const renamed = applyCommand(named, { type: 'rename-frame', index: 0, id: 'bench' });
  expect(keptOptions(renamed)).toEqual({ ...keptOptions(doc), userFrame: 'bench' });
});

test('what is chosen is saved; what is chosen no longer leaves nothing behind', () => {
  const doc = choosing({ format: 'krl', programName: 'pick', source: 'program:m' });
  const saved = writeRobotXml(doc);
  expect(saved).toContain('<codeOptions>format=krl programName=pick source=program:m</codeOptions>');
  expect(readRobotXml(saved).doc).toStrictEqual(doc);
  expect(choosing({ format: 'krl' }, doc)).toBe(doc);
  expect(choosing({ format: undefined, programName: undefined, source: undefined }, doc)).toStrictEqual(PUMA);
});

test('of any text only what makes sense counts', () => {
  expect(
    keptOptions({
      codeOptions:
        'format=rapid speed=101 speed firstRegister=2001 toolNumber=0 programName=a;DOUT[1]=ON userFrame= source=m __proto__=1 constructor=2 =3',
    }),
  ).toEqual({});
  const words = fc.constantFrom(
    'speed',
    'format',
    'krl',
    'programName',
    'END',
    '=',
    ' ',
    '12.5',
    ';',
    '1e3',
    '__proto__',
  );
  fc.assert(
    fc.property(
      fc.oneof(
        fc.string(),
        fc.array(words).map((list) => list.join('')),
      ),
      (codeOptions) => {
        for (const value of Object.values(keptOptions({ codeOptions }))) expect(value).toMatch(/^[\w.:-]+$/);
        const {
          speed = 1,
          firstRegister = 1,
          programName = 'a',
        } = optionsFor({ ...PUMA, codeOptions }, 'pair', POSTURES);
        expect(speed >= 1 && speed <= 100 && Number.isInteger(firstRegister) && /^\w+$/.test(programName)).toBe(true);
      },
    ),
    { seed: SEED, numRuns: runs(200) },
  );
  expect(refusal(PUMA, { type: 'set-code-options', text: 'x'.repeat(10_001) })?.code).toBe('text-length');
});
