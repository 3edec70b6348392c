/**
 * Arbitrary sound documents: hostile texts, odd numbers, all types, optional things there or not.
 * @import { ControllerDoc, Doc, FrameDoc, JointDoc, LinkDoc, MotionProgramDoc, ObstacleDoc, PoseDoc, RobotInfo, StepDoc, StepTarget, TargetDoc } from '../../../src/model/document.js'
 */
import fc from 'fast-check';
import { JOINT_LAWS, STEP_LAWS } from '../../../src/model/documentRules.js';

/**
 * Plain objects, never without a prototype, as documents are; `requiredKeys` as in fc.record.
 * @template T
 * @template {keyof T} [K=keyof T]
 * @param {{ [Key in keyof T]: fc.Arbitrary<T[Key]> }} fields
 * @param {{ requiredKeys?: K[] }} [constraints]
 */
const record = (fields, constraints) => fc.record(fields, { ...constraints, noNullPrototype: true });

/** What XML 1.0 (fifth edition), production 2, calls a character. @param {string} character */
const isXmlCharacter = (character) => {
  const code = character.codePointAt(0) ?? 0;
  return (
    [0x9, 0xa, 0xd].includes(code) ||
    (code >= 0x20 && code <= 0xd7ff) ||
    (code >= 0xe000 && code <= 0xfffd) ||
    code >= 0x10000
  );
};

const HOSTILE = [
  '',
  ' ',
  ' leading and trailing ',
  'a\tb\nc\rd\r\ne',
  '<img src=x onerror=alert(1)>',
  '"><script>alert(1)</script>',
  '\' & " < > &amp; &#10; ]]> <!-- --> <![CDATA[ <?xml ?>',
  '__proto__',
  '\u202Eevil',
  '\uFEFF\u200B\u0085\u2028',
  '😀'.repeat(40),
];

/** @param {number} maxLength @returns {fc.Arbitrary<string>} */
export const text = (maxLength) =>
  fc.oneof(
    { weight: 1, arbitrary: fc.constantFrom(...HOSTILE) },
    {
      weight: 2,
      arbitrary: fc.string({ unit: 'binary', maxLength }).map((any) => Array.from(any).filter(isXmlCharacter).join('')),
    },
    { weight: 2, arbitrary: fc.string({ unit: fc.constantFrom(...'ab <>&"\'\n\t\r]-é😀'), maxLength }) },
  );

const id = fc.stringMatching(/^[A-Za-z_][A-Za-z0-9_]{0,63}$/);
const number = fc.oneof(
  fc.double({ min: -1e9, max: 1e9, noNaN: true }),
  fc.constantFrom(0, -0, 90, -90, 431.8, 0.1 + 0.2, 1e9, -1e9, 5e-324, 1e-7, 1 / 3),
);
const positive = fc.oneof(fc.double({ min: 5e-324, max: 1e9, noNaN: true }), fc.constantFrom(0.05, 1e9));

/** @param {fc.Arbitrary<number>} of @param {number} length */
const vector = (of, length) => fc.array(of, { minLength: length, maxLength: length });

const quaternion = vector(fc.double({ min: -1, max: 1, noNaN: true }), 4).map((values) => {
  const length = Math.hypot(...values);
  return length > 0.01 ? values.map((value) => value / length) : [0, 0, 0, 1];
});

/** @type {fc.Arbitrary<PoseDoc>} */
const pose = fc.oneof(
  fc.constant({ xyz: [0, 0, 0], rpy: [0, 0, 0] }),
  record({ xyz: vector(number, 3) }),
  record({ xyz: vector(number, 3), rpy: vector(number, 3) }),
  record({ xyz: vector(number, 3), quaternion }),
);

/** @type {fc.Arbitrary<LinkDoc>} */
const link = record(
  {
    kind: fc.constantFrom('auto', 'cylinder', 'box', 'none'),
    radius: positive,
    width: positive,
    height: positive,
    color: fc.stringMatching(/^#[0-9A-Fa-f]{6}$/),
  },
  { requiredKeys: ['kind'] },
);

const expressions = record({ theta: text(30), d: text(30), a: text(30), alpha: text(30) }, { requiredKeys: [] });

/** @param {string[]} ids @param {number} index @returns {fc.Arbitrary<ControllerDoc>} coupled backwards only: no circles */
const controller = (ids, index) =>
  fc.oneof(
    fc.constant({ sign: /** @type {const} */ (1), offset: 0, coupling: 0 }),
    record({
      sign: fc.constantFrom(/** @type {const} */ (1), /** @type {const} */ (-1)),
      offset: number,
      coupling: fc.constant(0),
    }),
    ...(index === 0
      ? []
      : [
          record({
            sign: fc.constantFrom(/** @type {const} */ (1), /** @type {const} */ (-1)),
            offset: number,
            coupledTo: fc.constantFrom(...ids.slice(0, index)),
            coupling: number,
          }),
        ]),
  );

/** @param {string[]} ids @param {number} index @returns {fc.Arbitrary<JointDoc>} */
const joint = (ids, index) =>
  record(
    {
      id: fc.constant(ids[index]),
      label: text(60),
      type: fc.constantFrom('revolute', 'prismatic', 'continuous'),
      theta: number,
      d: number,
      a: number,
      alpha: number,
      lower: number,
      upper: number,
      home: number,
      velocity: positive,
      acceleration: positive,
      jerk: positive,
      effort: positive,
      text: expressions,
      link,
      controller: controller(ids, index),
    },
    { requiredKeys: ['id', 'type', 'theta', 'd', 'a', 'alpha', 'link', 'controller'] },
  ).map(({ text: typed, lower, upper, ...rest }) => ({
    ...rest,
    ...(typed && Object.keys(typed).length > 0 && { text: typed }),
    ...(lower !== undefined && { lower: upper === undefined ? lower : Math.min(lower, upper) }),
    ...(upper !== undefined && { upper: lower === undefined ? upper : Math.max(lower, upper) }),
  }));

/** @type {fc.Arbitrary<RobotInfo>} */
const info = record(
  { manufacturer: text(60), author: text(60), licence: text(60), source: text(60), description: text(300) },
  { requiredKeys: [] },
);

/** @param {number} count of joints */
const postures = (count) =>
  fc.uniqueArray(record({ id: id.filter((word) => word !== 'current'), q: vector(number, count) }), {
    selector: (posture) => posture.id,
    maxLength: 4,
  });

/** @type {fc.Arbitrary<FrameDoc[]>} */
const frames = fc.uniqueArray(
  fc
    .tuple(
      pose,
      record(
        { kind: fc.constantFrom('user', 'tool'), id, number: fc.integer({ min: 1, max: 1e9 }) },
        { requiredKeys: ['kind', 'id'] },
      ),
    )
    .map(([where, rest]) => /** @type {FrameDoc} */ ({ ...where, ...rest })),
  { selector: (frame) => frame.id, maxLength: 4 },
);

/** @type {fc.Arbitrary<TargetDoc[]>} */
const targets = fc.uniqueArray(
  fc
    .tuple(pose, record({ id, frame: id, configuration: text(40) }, { requiredKeys: ['id'] }))
    .map(([where, rest]) => /** @type {TargetDoc} */ ({ ...where, ...rest })),
  { selector: (target) => target.id, maxLength: 4 },
);

/** @type {fc.Arbitrary<ObstacleDoc[]>} */
const obstacles = fc.uniqueArray(
  fc
    .tuple(
      pose,
      fc.oneof(
        record({ kind: fc.constant('box'), id, width: positive, depth: positive, height: positive }),
        record({ kind: fc.constant('sphere'), id, radius: positive }),
        record({ kind: fc.constant('cylinder'), id, radius: positive, height: positive }),
        record({ kind: fc.constant('plane'), id }),
      ),
    )
    .map(([where, rest]) => /** @type {ObstacleDoc} */ ({ ...where, ...rest })),
  { selector: (obstacle) => obstacle.id, maxLength: 5 },
);

const signal = fc.constantFrom(/** @type {const} */ ('on'), /** @type {const} */ ('off'));
const count = fc.integer({ min: 1, max: 1e9 });
const percent = fc.double({ min: 5e-324, max: 100, noNaN: true });
const aside = { id, comment: text(40), disabled: fc.boolean() };

/** @type {fc.Arbitrary<import('../../../src/model/document.js').Ending>} */
const ending = fc.oneof(
  fc.constant({ kind: /** @type {const} */ ('fine') }),
  record({ kind: fc.constant(/** @type {const} */ ('percent')), value: fc.double({ min: 0, max: 100, noNaN: true }) }),
  record({ kind: fc.constant(/** @type {const} */ ('distance')), value: fc.double({ min: 0, max: 1e9, noNaN: true }) }),
);

/** Programs for a document that has what their steps name. @param {Doc} doc @returns {fc.Arbitrary<MotionProgramDoc[]>} */
function motionPrograms(doc) {
  /** @type {fc.Arbitrary<StepTarget>[]} */
  const places = [
    record({ kind: fc.constant(/** @type {const} */ ('posture')), values: vector(number, doc.posture.length) }),
    fc.tuple(pose, fc.option(text(40), { nil: undefined })).map(([where, configuration]) => ({
      kind: /** @type {const} */ ('pose'),
      ...where,
      ...(configuration !== undefined && { configuration }),
    })),
  ];
  const target = fc.oneof(
    ...places,
    ...doc.targets.map((one) => fc.constant({ kind: /** @type {const} */ ('target'), id: one.id })),
  );
  const frameOf = (/** @type {'user' | 'tool'} */ kind) => {
    const ids = doc.frames.filter((frame) => frame.kind === kind).map((frame) => frame.id);
    return fc.constantFrom(undefined, ...ids);
  };
  const move = {
    ...aside,
    target,
    acceleration: percent,
    ending,
    law: fc.constantFrom(...STEP_LAWS),
    tool: frameOf('tool'),
    frame: frameOf('user'),
  };
  const rate = { speed: positive, speedUnit: fc.constantFrom(...['length/s', 'angle/s']) };
  const needed = ['id', 'kind', 'target', 'via', 'speed', 'speedUnit', 'acceleration', 'ending'];
  const kind = (/** @type {string} */ word) => ({ kind: fc.constant(word) });
  /** @param {Record<string, fc.Arbitrary<unknown>>} fields @param {string[]} requiredKeys */
  const some = (fields, requiredKeys) =>
    record(fields, { requiredKeys: requiredKeys.filter((name) => Object.hasOwn(fields, name)) });
  const step = fc.oneof(
    some(
      { ...kind('joint'), ...move, law: fc.constantFrom(...JOINT_LAWS), speed: percent, speedUnit: fc.constant('%') },
      needed,
    ),
    some({ ...kind('linear'), ...move, ...rate }, needed),
    some({ ...kind('circular'), ...move, ...rate, via: target }, needed),
    some({ ...kind('wait'), ...aside, seconds: positive }, ['id', 'kind', 'seconds']),
    some({ ...kind('set-output'), ...aside, output: count, value: signal }, ['id', 'kind', 'output', 'value']),
    some({ ...kind('wait-input'), ...aside, input: count, value: signal }, ['id', 'kind', 'input', 'value']),
    some({ ...kind('call'), ...aside, program: id }, ['id', 'kind', 'program']),
    some({ ...kind('label'), ...aside, label: text(40) }, ['id', 'kind', 'label']),
    some({ ...kind('comment'), id, disabled: fc.boolean(), text: text(40) }, ['id', 'kind', 'text']),
  );
  // put together from fields by name, which a type cannot follow; validateDocument is asked of all of it
  const said = step.map(
    (fields) =>
      /** @type {StepDoc} */ (Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== undefined))),
  );
  const steps = fc.uniqueArray(said, { selector: (one) => one.id, maxLength: 5 });
  return fc.uniqueArray(record({ id, name: text(60), steps }), { selector: (program) => program.id, maxLength: 2 });
}

const programs = fc.uniqueArray(
  record({ id, language: fc.constantFrom('karel', 'fanuc-tp', 'krl'), text: text(200) }),
  { selector: (program) => program.id, maxLength: 3 },
);

/** @param {string} value */
const escaped = (value) =>
  value.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('\r', '&#13;');
/** @param {string} value */
const escapedAttribute = (value) =>
  escaped(value).replaceAll('"', '&quot;').replaceAll('\t', '&#9;').replaceAll('\n', '&#10;');

const extensions = fc.array(
  fc.oneof(
    fc.constantFrom('<x:note xmlns:x="urn:example:x"/>', '<view xmlns="urn:example:view"><camera at="1 2 3"/></view>'),
    fc
      .tuple(text(20), text(40))
      .map(([value, content]) => [escapedAttribute(value), escaped(content)])
      .map(
        ([value, content]) =>
          `<x:a xmlns:x="urn:example:x" xmlns:y="urn:example:y" y:b="${value}"><x:c>${content}.</x:c><?go on?></x:a>`,
      ),
  ),
  { maxLength: 3 },
);

/** @type {fc.Arbitrary<Doc>} */
export const documents = fc.uniqueArray(id, { minLength: 2, maxLength: 6 }).chain((ids) =>
  record({
    robot: record({
      name: text(100),
      info,
      units: record({ length: fc.constantFrom('mm', 'cm', 'm'), angle: fc.constantFrom('deg', 'rad') }),
      convention: fc.constantFrom('standard', 'modified'),
      base: pose,
      tool: pose,
      joints: fc.tuple(...ids.map((_, index) => joint(ids, index))),
    }),
    posture: vector(number, ids.length),
    postures: postures(ids.length),
    frames,
    targets,
    obstacles,
    motionPrograms: fc.constant([]),
    programs,
    codeOptions: fc.oneof(text(60), fc.constant('format=krl source=program:m userFrame=0')),
    extensions,
  })
    .map(({ codeOptions, ...doc }) => ({ ...doc, ...(codeOptions !== '' && { codeOptions }) }))
    .chain(withActive)
    .chain((doc) => motionPrograms(doc).map((made) => ({ ...doc, motionPrograms: made }))),
);

/**
 * One of its user frames and tools active, or none; targets in frames that are there.
 * @param {Doc} doc
 * @returns {fc.Arbitrary<Doc>}
 */
function withActive(doc) {
  const users = doc.frames.filter(({ kind }) => kind === 'user').map((frame) => frame.id);
  const tools = doc.frames.filter(({ kind }) => kind === 'tool');
  const targetsThere = doc.targets.map(({ frame, ...target }, i) => ({
    ...target,
    ...(frame !== undefined && users.length > 0 && { frame: users[i % users.length] }),
  }));
  return fc
    .tuple(fc.constantFrom(undefined, ...users), fc.constantFrom(undefined, ...tools))
    .map(([activeUser, tool]) => {
      const { xyz, rpy, quaternion } = tool ?? doc.robot.tool;
      const pose = { xyz, ...(rpy && { rpy }), ...(quaternion && { quaternion }) };
      return {
        ...doc,
        robot: { ...doc.robot, tool: pose },
        targets: targetsThere,
        ...(tool && { activeTool: tool.id }),
        ...(activeUser !== undefined && { activeUser }),
      };
    });
}
