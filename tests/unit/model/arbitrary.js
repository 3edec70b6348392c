/** Chance for the model's property tests: documents of the library, and any session of actions on them. */
import fc from 'fast-check';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { anyCodeCommand } from './codeArbitrary.js';
import { obstacleCommandOf } from './obstacleArbitrary.js';
import { anyMotionCommand } from './motionArbitrary.js';

/** @typedef {import('../../../src/model/session.js').Action} Action */
/** @typedef {import('../../../src/model/document.js').JointField} JointField */

export const anyDocument = fc.constantFrom(...Object.values(LIBRARY)).map(newDocument);

const anyNumber = fc.oneof(
  fc.double({ min: -1e4, max: 1e4, noNaN: true }),
  fc.constantFrom(0, -0, 90, 1e9, 2e9, NaN, Infinity, -Infinity),
);
const anyJoint = fc.integer({ min: -1, max: 6 });
const anyGesture = fc.option(fc.constantFrom('a', 'b'), { nil: undefined });
/** @type {JointField[]} */
const FIELDS = ['theta', 'd', 'a', 'alpha', 'lower', 'upper', 'home'];

/** One of these, and now and then another. @template {string} Word @param {...Word} words */
const anyWordOf = (...words) =>
  fc.oneof(
    { weight: 9, arbitrary: fc.constantFrom(...words) },
    { weight: 1, arbitrary: fc.constantFrom('', '__proto__', 'toString').map((word) => /** @type {Word} */ (word)) },
  );

const anyNumbers = (/** @type {number} */ n) => fc.array(anyNumber, { minLength: n - 1, maxLength: n });
const anyPose = fc.oneof(
  fc.record({ xyz: anyNumbers(3), rpy: anyNumbers(3) }),
  fc.record({ xyz: anyNumbers(3), quaternion: anyNumbers(4) }),
  fc.record({
    xyz: fc.constant([0, -0, 100]),
    quaternion: fc.constantFrom([0, 0, 0, 1], [0, 0, 0.6, 0.8], [1, 0, 0, 1]),
  }),
  fc.constant(/** @type {import('../../../src/model/document.js').PoseDoc} */ (/** @type {unknown} */ (null))),
);
const anyLink = fc.record(
  {
    kind: anyWordOf('auto', 'cylinder', 'box', 'none'),
    radius: anyNumber,
    width: anyNumber,
    height: anyNumber,
    color: fc.constantFrom('#ffcc00', '#FFF', 'red', ''),
  },
  { requiredKeys: ['kind'] },
);
const anyText = fc.oneof(fc.constantFrom('', 'arm', '__proto__'), fc.string({ maxLength: 300 }));

/** Commands about the robot beside its table. */
const anyRobotCommand = fc.oneof(
  fc.record({
    type: fc.constantFrom(/** @type {const} */ ('set-base'), /** @type {const} */ ('set-tool')),
    pose: anyPose,
    gesture: anyGesture,
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-link')),
    joint: anyJoint,
    link: anyLink,
    gesture: anyGesture,
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-joint-rate')),
    joint: anyJoint,
    rate: anyWordOf('velocity', 'acceleration', 'jerk', 'effort'),
    value: fc.option(anyNumber, { nil: undefined }),
    gesture: anyGesture,
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-controller')),
    joint: anyJoint,
    controller: fc.record(
      {
        sign: fc.constantFrom(...[1, -1, 0].map((sign) => /** @type {1} */ (sign))),
        offset: anyNumber,
        coupling: fc.oneof(fc.constantFrom(0, -1, 1), anyNumber),
        coupledTo: fc.constantFrom('j1', 'j2', 'j3', 'joint_1', 'none'),
      },
      { requiredKeys: ['sign', 'offset', 'coupling'] },
    ),
    gesture: anyGesture,
  }),
  fc.record({ type: fc.constant(/** @type {const} */ ('rename-robot')), name: anyText }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-robot-info')),
    field: anyWordOf('manufacturer', 'author', 'licence', 'source', 'description'),
    text: anyText,
  }),
);

const anyIndex = fc.integer({ min: -1, max: 3 });
const anyFrameName = fc.option(fc.constantFrom('user_1', 'table', 'tool_1', ''), { nil: undefined });
const anyConfiguration = fc.option(fc.constantFrom('N U T, 0, 0, 0', '', 'x'.repeat(201)), { nil: undefined });

/** Commands about the named targets. */
const anyTargetCommand = fc.oneof(
  fc.record({
    type: fc.constant(/** @type {const} */ ('add-target')),
    pose: anyPose,
    frame: anyFrameName,
    configuration: anyConfiguration,
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('rename-target')),
    index: anyIndex,
    id: fc.oneof(fc.constantFrom('aim_1', 'aim_2', 'pick', ''), fc.string()),
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('edit-target')),
    index: anyIndex,
    pose: anyPose,
    frame: anyFrameName,
    configuration: anyConfiguration,
    gesture: anyGesture,
  }),
  fc.record({ type: fc.constant(/** @type {const} */ ('move-target')), index: anyIndex, to: anyIndex }),
  fc.record({ type: fc.constant(/** @type {const} */ ('remove-target')), index: anyIndex }),
);

/** Commands about user frames and tools. */
const anyFrameCommand = fc.oneof(
  fc.record({ type: fc.constant(/** @type {const} */ ('add-frame')), kind: anyWordOf('user', 'tool'), pose: anyPose }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('rename-frame')),
    index: anyIndex,
    id: fc.oneof(fc.constantFrom('tool_1', 'user_1', 'table', ''), fc.string()),
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('number-frame')),
    index: anyIndex,
    number: fc.constantFrom(undefined, 0, 1, 2, 1.5, 2e9, NaN),
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('edit-frame')),
    index: anyIndex,
    pose: anyPose,
    gesture: anyGesture,
  }),
  fc.record({ type: fc.constant(/** @type {const} */ ('remove-frame')), index: anyIndex }),
  fc.record(
    {
      type: fc.constant(/** @type {const} */ ('choose-tool')),
      index: fc.option(anyIndex),
      posture: fc.array(anyNumber, { minLength: 2, maxLength: 6 }),
    },
    { requiredKeys: ['type', 'index'] },
  ),
  fc.record({ type: fc.constant(/** @type {const} */ ('choose-user')), index: fc.option(anyIndex) }),
);

/** Sensible and senseless ones. @type {import('fast-check').Arbitrary<Action>} */
export const anyAction = fc.oneof(
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-joint-field')),
    joint: anyJoint,
    field: fc.constantFrom(...FIELDS),
    value: anyNumber,
    text: fc.option(fc.oneof(fc.constantFrom('pi/2', '', 'a\nb', 'x'.repeat(201)), fc.string()), {
      nil: undefined,
    }),
    gesture: anyGesture,
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-joint-value')),
    joint: anyJoint,
    value: anyNumber,
    gesture: anyGesture,
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-posture')),
    posture: fc.array(anyNumber, { minLength: 1, maxLength: 6 }),
  }),
  fc.constant(/** @type {Action} */ ({ type: 'record-posture' })),
  fc.record(
    {
      type: fc.constant(/** @type {const} */ ('set-postures')),
      postures: fc.array(
        fc.record({
          id: fc.constantFrom('p1', 'p2', 'pick', 'current', ''),
          q: fc.oneof(anyNumbers(2), anyNumbers(6)),
        }),
        { maxLength: 3 },
      ),
      posture: anyNumbers(6),
    },
    { requiredKeys: ['type', 'postures'] },
  ),
  fc.record({
    type: fc.constant(/** @type {const} */ ('rename-posture')),
    index: fc.integer({ min: -1, max: 4 }),
    id: fc.oneof(fc.constantFrom('p1', 'p2', 'pick', 'current', ''), fc.string()),
  }),
  fc.record({ type: fc.constant(/** @type {const} */ ('remove-posture')), index: fc.integer({ min: -1, max: 4 }) }),
  anyDocument.map((doc) => /** @type {Action} */ ({ type: 'replace-document', doc })),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-table')),
    convention: anyWordOf('standard', 'modified'),
    rows: fc.array(
      fc.record({
        type: fc.option(anyWordOf('revolute', 'prismatic'), { nil: undefined }),
        numbers: fc.record({ theta: anyNumber, a: anyNumber, alpha: anyNumber }, { requiredKeys: [] }),
        texts: fc.record({ a: fc.constantFrom('12 in', 'pi', '') }, { requiredKeys: [] }),
      }),
      { maxLength: 7 },
    ),
  }),
  fc.record({ type: fc.constant(/** @type {const} */ ('add-joint')), after: anyJoint }),
  fc.record({
    type: fc.constantFrom(/** @type {const} */ ('remove-joint'), /** @type {const} */ ('duplicate-joint')),
    joint: anyJoint,
  }),
  fc.record({ type: fc.constant(/** @type {const} */ ('move-joint')), joint: anyJoint, to: anyJoint }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('set-joint-type')),
    joint: anyJoint,
    jointType: anyWordOf('revolute', 'prismatic', 'continuous'),
  }),
  fc.record({
    type: fc.constant(/** @type {const} */ ('convert-units')),
    units: fc.record({ length: anyWordOf('mm', 'cm', 'm'), angle: anyWordOf('deg', 'rad') }),
  }),
  fc.record({
    type: fc.constantFrom(/** @type {const} */ ('convert-convention'), /** @type {const} */ ('reinterpret-convention')),
    convention: anyWordOf('standard', 'modified'),
  }),
  anyRobotCommand,
  anyTargetCommand,
  anyFrameCommand,
  anyMotionCommand,
  obstacleCommandOf(anyPose),
  anyCodeCommand,
  fc.constantFrom(...['undo', 'redo', 'end-gesture', 'cancel-gesture'].map((type) => /** @type {Action} */ ({ type }))),
  fc.record({
    type: fc.constant(/** @type {const} */ ('show')),
    change: fc.record({ heldJoint: fc.constantFrom(null, 0, 1) }),
  }),
);
