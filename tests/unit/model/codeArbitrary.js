/** Chance for the commands about controller code: sensible and senseless ones. */
import fc from 'fast-check';

/** @typedef {import('../../../src/model/code/codeCommands.js').CodeCommand} CodeCommand */

const anyName = fc.oneof(
  { weight: 6, arbitrary: fc.constantFrom('main', 'pick', 'MAIN', 'main_2') },
  { weight: 1, arbitrary: fc.oneof(fc.string(), fc.constantFrom('', '__proto__', '9x')) },
);
const anyText = fc.oneof(fc.constantFrom('', 'PROGRAM p\nBEGIN\nEND p\n', 'a\u0000b', '<&\'"'), fc.string());
const anyLanguage = fc.constantFrom('karel', 'fanuc-tp', 'krl', 'rapid');

/** @type {fc.Arbitrary<CodeCommand & { gesture?: string }>} */
export const anyCodeCommand = /** @type {fc.Arbitrary<CodeCommand>} */ (
  fc.oneof(
    fc.record({
      type: fc.constant('set-code'),
      programs: fc.array(fc.record({ id: anyName, language: anyLanguage, text: anyText }), { maxLength: 3 }),
    }),
    fc.record({ type: fc.constant('edit-code'), id: anyName, text: anyText, gesture: fc.constantFrom('a', 'b') }),
    fc.record({ type: fc.constant('rename-code'), id: anyName, to: anyName }),
    fc.record({ type: fc.constant('remove-code'), id: anyName }),
    fc.record({
      type: fc.constant('set-code-options'),
      text: fc.oneof(anyText, fc.constantFrom('userFrame=table', 'x'.repeat(10_001), 7)),
    }),
  )
);
