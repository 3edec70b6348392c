/**
 * Any KAREL tree that the parser could have given, and text that is nearly KAREL.
 *
 * @import { Arbitrary, LetrecLooselyTypedTie } from 'fast-check'
 * @import { Call, Declaration, Designator, Expression, Program, Statement } from '../../../src/karel/tree.js'
 */
import fc from 'fast-check';
import { binary, call, integer, name, real, string, unary } from '../../../src/karel/tree.js';

const OPERATORS = /** @type {const} */ ([...':@#*/+-<>=', 'AND', 'DIV', 'MOD', 'OR', '<>', '<=', '>=', '>=<']);

export const anyName = fc.constantFrom('a', 'B2', 'flag', 'joint_val', 'x', 'DOUT', 'SIN', 'i');
const anyText = fc.string({ unit: 'grapheme-ascii', maxLength: 12 });
const anyReal = fc.oneof(
  fc.double({ min: 1.2e-38, max: 3.4e38, noNaN: true }),
  fc.integer({ min: 0, max: 10 ** 9 }).map((thousandths) => thousandths / 1000),
);
const port = fc
  .tuple(fc.constantFrom('DIN', 'dout', 'FLG', 'GIN'), fc.nat(99))
  .map(([word, n]) => index(name(word), [integer(n)]));

/** @param {unknown} target @param {Expression[]} indices @returns {Designator} */
const index = (target, indices) => ({ kind: 'index', target: /** @type {Designator} */ (target), indices });

/** The variables of every second place in parentheses. @param {Call} node @returns {Call} */
function withCopies(node) {
  const byValue = node.args.flatMap(({ kind }, i) => (i % 2 === 0 && /^(name|index|field)$/.test(kind) ? [i] : []));
  return byValue.length ? { ...node, byValue } : node;
}

/** Whatever the loose types of a recursive arbitrary are, the tree that comes out is one. @template T @param {Arbitrary<unknown>} arbitrary */
const as = (arbitrary) => /** @type {Arbitrary<T>} */ (arbitrary);

const { expression, designator } = fc.letrec((/** @type {LetrecLooselyTypedTie} */ tie) => ({
  expression: fc.oneof(
    { depthSize: 'small', withCrossShrink: true },
    fc.oneof(
      anyName.map(name),
      fc.nat(2 ** 31 - 1).map(integer),
      anyReal.map((value) => real(value)),
      anyText.map(string),
    ),
    fc
      .tuple(fc.constantFrom('NOT', '-', '+'), tie('expression'))
      .map(([op, one]) => unary(/** @type {'NOT'} */ (op), /** @type {Expression} */ (one))),
    fc
      .tuple(tie('expression'), fc.constantFrom(...OPERATORS), tie('expression'))
      .map(([left, op, right]) =>
        binary(/** @type {Expression} */ (left), /** @type {':'} */ (op), /** @type {Expression} */ (right)),
      ),
    fc
      .tuple(anyName, fc.array(tie('expression'), { minLength: 1, maxLength: 3 }))
      .map(([callee, args]) => withCopies(call(callee, /** @type {Expression[]} */ (args)))),
    tie('designator'),
  ),
  designator: fc.oneof(
    { depthSize: 'small', withCrossShrink: true },
    anyName.map(name),
    anyName.map((word) => ({ kind: 'system', name: word })),
    fc
      .tuple(tie('designator'), fc.array(tie('expression'), { minLength: 1, maxLength: 3 }))
      .map(([target, list]) => index(target, /** @type {Expression[]} */ (list))),
    fc
      .tuple(tie('designator'), fc.constantFrom('x', 'config_data', 'node', 'group'))
      .map(([target, field]) => ({ kind: 'field', target, name: field })),
  ),
}));

export const anyExpression = as(/** @type {Arbitrary<Expression>} */ (expression));
const one = /** @type {Arbitrary<Expression>} */ (expression);
const target = /** @type {Arbitrary<Designator>} */ (designator);

const term = fc.oneof(
  one,
  fc.tuple(port, fc.boolean()).map(([at, rising]) => ({ kind: 'edge', port: at, rising })),
  fc
    .tuple(fc.constantFrom('ERROR', 'EVENT'), fc.oneof(one, fc.constant('*')))
    .map(([word, argument]) => ({ kind: 'occurrence', name: word, argument })),
  fc.constantFrom('ABORT', 'PAUSE', 'CONTINUE').map((word) => ({ kind: 'occurrence', name: word })),
);
const conditions = fc
  .tuple(fc.constantFrom('AND', 'OR'), fc.array(term, { minLength: 1, maxLength: 3 }))
  .map(([operator, terms]) => ({ ...(terms.length > 1 && { operator }), terms }));
const settings = fc.array(
  fc.record({
    variable: fc.constantFrom('SPEED', 'MOTYPE').map((word) => ({ kind: 'system', name: word })),
    value: one,
  }),
  { minLength: 1, maxLength: 2 },
);
const item = fc.oneof(
  one,
  fc.constant({ kind: 'new-line' }),
  fc.record({ kind: fc.constant('format'), value: one, formats: fc.array(one, { minLength: 1, maxLength: 2 }) }),
);

/** @param {string} kind @param {Record<string, Arbitrary<unknown>>} parts @param {Record<string, Arbitrary<unknown>>} [maybe] */
const node = (kind, parts, maybe = {}) =>
  fc
    .tuple(fc.record(parts), fc.record(maybe, { requiredKeys: [] }))
    .map(([needed, optional]) => /** @type {unknown} */ ({ kind, ...needed, ...optional }));

const isTrue = fc.constant(true);
const comment = node('comment', { text: anyText.map((text) => text.trim()) });

const { statement } = fc.letrec((/** @type {LetrecLooselyTypedTie} */ tie) => {
  const body = fc.array(tie('statement'), { maxLength: 3 });
  const clauses = fc.array(fc.record({ conditions, actions: body }), { minLength: 1, maxLength: 2 });
  return {
    statement: fc.oneof(
      { depthSize: 'small', withCrossShrink: true },
      fc.oneof(
        comment,
        node('assign', { target, value: one }),
        fc
          .tuple(fc.constantFrom('f', 'POST_ERR'), fc.array(one, { maxLength: 3 }))
          .map(([callee, args]) => withCopies(call(callee, args))),
        node('label', { name: anyName }),
        node('goto', { label: anyName }),
        node('return', {}, { value: one }),
        node('abort', {}, { task: one }),
        node('pause', {}),
        node('delay', { milliseconds: one }),
        node('wait', { conditions }),
        node('pulse', { port, milliseconds: one }, { nowait: isTrue }),
        node('open-file', { file: target, usage: one, path: one }),
        node('close-file', { file: target }),
        node('cancel-file', { file: target }),
        node('write', { items: fc.array(item, { minLength: 1, maxLength: 3 }) }, { file: anyName }),
        node('read', { items: fc.array(item, { minLength: 1, maxLength: 3 }) }, { file: anyName }),
      ),
      fc.oneof(
        node('handler-control', { action: fc.constantFrom('ENABLE', 'DISABLE', 'PURGE'), number: one }),
        node('signal', { what: fc.constantFrom('EVENT', 'SEMAPHORE'), number: one }),
        node('timer', { action: fc.constantFrom('CONNECT', 'DISCONNECT'), variable: target }),
        node(
          'motion-control',
          { action: fc.constantFrom('CANCEL', 'STOP', 'RESUME', 'HOLD', 'UNHOLD', 'ATTACH', 'RELEASE') },
          { groups: fc.array(one, { minLength: 1, maxLength: 2 }) },
        ),
        node('action', {
          action: fc.constantFrom('NOABORT', 'NOPAUSE', 'NOMESSAGE', 'UNPAUSE', 'CONTINUE', 'RESTORE'),
        }),
        node('hand', { action: fc.constantFrom('OPEN', 'CLOSE', 'RELAX'), number: one }),
        node('directive', {
          name: fc.constant('INCLUDE'),
          path: fc.constantFrom('klevkeys', 'ud1:\\inc\\a.kl', '../b'),
        }),
      ),
      node('if', { condition: one, then: body }, { else: body }),
      node(
        'select',
        {
          value: one,
          cases: fc.array(fc.record({ values: fc.array(one, { minLength: 1, maxLength: 2 }), body }), { maxLength: 2 }),
        },
        { else: body },
      ),
      node('for', { variable: target, from: one, to: one, body }, { down: isTrue }),
      node('while', { condition: one, body }),
      node('repeat', { body, until: one }),
      node('using', { variables: fc.array(target, { minLength: 1, maxLength: 2 }), body }),
      node('condition', { number: one, clauses }, { settings }),
      fc
        .tuple(
          fc.oneof(
            fc.record({ to: fc.constant('TO'), position: one }),
            fc.record({ to: fc.constant('TO'), position: one, via: one }),
            fc.record({ to: fc.constant('NEAR'), position: one, by: one }),
            fc.record({ to: fc.constantFrom('AWAY', 'RELATIVE'), by: one }),
            fc.record({ to: fc.constant('ABOUT'), vector: one, by: one }),
            fc.record({ to: fc.constant('AXIS'), axis: one, by: one }),
            fc.record({
              to: fc.constant('ALONG'),
              path: fc.oneof(target, node('range', { target: anyName.map(name), from: one, to: one })),
            }),
          ),
          fc.record(
            { settings, nowait: isTrue, when: clauses, until: fc.array(conditions, { minLength: 1, maxLength: 2 }) },
            { requiredKeys: [] },
          ),
        )
        .map(([where, optional]) => ({ kind: 'move', target: where, ...optional })),
    ),
  };
});

export const anyStatement = /** @type {Arbitrary<Statement>} */ (statement);

const size = fc.oneof(fc.integer({ min: 1, max: 99 }), anyName.map(name));
const plainType = fc.oneof(
  fc.constantFrom('INTEGER', 'REAL', 'JOINTPOS6', 'my_type', 'PATH').map((word) => ({ kind: 'type', name: word })),
  fc.record({ kind: fc.constant('string-type'), length: size }),
  fc.constant({ kind: 'string-type' }),
);
const type = fc.oneof(
  plainType,
  fc.constant({ kind: 'path-type', node: 'my_type' }),
  fc.record({
    kind: fc.constant('array-type'),
    sizes: fc.array(fc.oneof(size, fc.constant('*')), { maxLength: 3 }),
    of: plainType,
  }),
);
const names = fc.uniqueArray(anyName, { minLength: 1, maxLength: 3 });
const declared = fc
  .tuple(
    fc.record({ names, type }),
    fc.record(
      { storage: fc.constantFrom('CMOS', 'SHADOW', 'DRAM'), from: anyName, group: fc.nat(8) },
      { requiredKeys: [] },
    ),
  )
  .map(([needed, optional]) => ({ ...needed, ...optional }));
const include = node('directive', { name: fc.constant('INCLUDE'), path: fc.constant('more') });

/** Entries; an include never ends a section, since it would then belong to what follows. @param {Arbitrary<unknown>} entry */
const entries = (entry) =>
  fc
    .tuple(fc.array(fc.oneof({ weight: 4, arbitrary: entry }, comment, include), { maxLength: 3 }), entry)
    .map(([list, last]) => [...list, last]);

const definition = fc.oneof(
  node('structure', { fields: fc.array(fc.oneof(declared, comment), { maxLength: 3 }) }),
  node('path-type', {}, { node: fc.constant('my_type'), header: fc.constant('other') }),
);
const anyPosition = fc.constantFrom('POSITION', 'XYZWPR', 'JOINTPOS6').map((name) => ({ kind: 'type', name }));
const section = fc.oneof(
  node('constants', { entries: entries(fc.record({ name: anyName, value: one })) }),
  node('variables', { entries: entries(declared) }),
  comment,
  node('directive', { name: fc.constantFrom('NOLOCKGROUP', 'CMOSVARS') }),
  node('directive', { name: fc.constant('LOCKGROUP'), value: fc.constant({ kind: 'integers', values: [1, 2] }) }),
  node('directive', { name: fc.constant('COMMENT'), value: anyText.map(string) }),
);
const parameters = fc.array(fc.record({ names, type }), { maxLength: 2 });
const declaration = fc.oneof(
  { weight: 4, arbitrary: section },
  node('types', {
    entries: entries(
      fc
        .tuple(fc.record({ name: anyName, definition }), fc.record({ from: anyName }, { requiredKeys: [] }))
        .map(([needed, optional]) => ({ ...needed, ...optional })),
    ),
  }),
  node('types', {
    entries: entries(fc.record({ name: anyName, definition: anyPosition, group: fc.integer({ min: 1, max: 8 }) })),
  }),
  node(
    'routine',
    { name: anyName, parameters, body: fc.array(anyStatement, { maxLength: 2 }) },
    { returns: type, declarations: fc.array(section, { minLength: 1, maxLength: 2 }) },
  ),
  node('routine', { name: anyName, parameters, from: anyName }, { returns: type }),
);
const declarations = /** @type {Arbitrary<Declaration[]>} */ (fc.array(declaration, { maxLength: 4 }));
const routine = node('routine', { name: anyName, parameters, body: fc.array(anyStatement, { maxLength: 2 }) });

export const anyProgram = /** @type {Arbitrary<Program>} */ (
  node(
    'program',
    {
      comments: fc.array(comment, { maxLength: 2 }),
      name: anyName,
      declarations,
      body: fc.array(anyStatement, { maxLength: 5 }),
    },
    { after: fc.array(routine, { minLength: 1, maxLength: 2 }) },
  )
);

/** The same tree without what only a text has: places. @template T @param {T} tree @returns {T} */
export function withoutSpans(tree) {
  if (Array.isArray(tree)) return /** @type {T} */ (tree.map(withoutSpans));
  if (typeof tree !== 'object' || tree === null) return tree;
  const kept = Object.entries(tree).filter(([key]) => key !== 'span' && key !== 'nameSpans');
  return /** @type {T} */ (Object.fromEntries(kept.map(([key, value]) => [key, withoutSpans(value)])));
}

const WORDS =
  `PROGRAM BEGIN END VAR CONST TYPE ROUTINE FROM STRUCTURE ENDSTRUCTURE PATH ARRAY OF STRING INTEGER IF THEN ELSE
  ENDIF FOR TO DOWNTO DO ENDFOR WHILE ENDWHILE REPEAT UNTIL SELECT CASE ENDSELECT CONDITION WHEN ENDCONDITION MOVE WITH
  ENDMOVE USING ENDUSING WAIT WRITE READ CR OPEN FILE GOTO RETURN ABORT ERROR DIN a b x NOT AND OR DIV`.split(/\s+/);
const SIGNS = [
  '(',
  ')',
  '[',
  ']',
  ':',
  '::',
  ';',
  ',',
  '.',
  '..',
  '=',
  '<>',
  '>=<',
  '+',
  '-',
  '*',
  '/',
  '@',
  '#',
  '&',
  '$x',
  '%INCLUDE f',
  '%define a b',
  "'s'",
  "'",
  '1',
  '2.5',
  '-- c\n',
  '\n',
  '\n',
  'é',
  '\0',
];

/** Anything that looks like KAREL word by word. */
export const anyTokens = fc
  .array(fc.oneof(fc.constantFrom(...WORDS), fc.constantFrom(...SIGNS)), { maxLength: 60 })
  .map((tokens) => tokens.join(' '));
