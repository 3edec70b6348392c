/**
 * The document: everything that is saved, shared and undone, as a person typed it, in the units the document declares.
 * Plain frozen data: no methods, nothing that can be derived. What the arm is (`robot`) and where it is (`posture`)
 * stay apart, so that jogging compiles nothing.
 *
 * @typedef {'mm' | 'cm' | 'm'} LengthUnit
 * @typedef {'deg' | 'rad'} AngleUnit
 * @typedef {{ readonly length: LengthUnit, readonly angle: AngleUnit }} Units
 * @typedef {'standard' | 'modified'} Convention
 * @typedef {'revolute' | 'prismatic' | 'continuous'} JointType
 *
 * @typedef {object} PoseDoc            a constant frame, seen from its parent
 * @property {readonly number[]} xyz    3 lengths
 * @property {readonly number[]} [rpy]  3 angles: R = Rz(rpy[2]) · Ry(rpy[1]) · Rx(rpy[0]), as URDF
 * @property {readonly number[]} [quaternion]  x y z w, instead of `rpy`; never both
 *
 * @typedef {object} LinkDoc   how the link that the joint moves is drawn
 * @property {'auto' | 'cylinder' | 'box' | 'none'} kind
 * @property {number} [radius]
 * @property {number} [width]
 * @property {number} [height]
 * @property {string} [color]  '#rrggbb'
 *
 * @typedef {object} ControllerDoc  pendant value = sign · q + offset + coupling · (pendant value of joint `coupledTo`)
 * @property {1 | -1} sign
 * @property {number} offset
 * @property {string} [coupledTo]   the id of another joint
 * @property {number} coupling
 *
 * @typedef {object} JointDoc
 * @property {string} id       unique in the robot: [A-Za-z_][A-Za-z0-9_]{0,63}
 * @property {string} [label]
 * @property {JointType} type
 * @property {number} theta    joint angle; the constant part if the joint turns
 * @property {number} d        link offset; the constant part if the joint slides
 * @property {number} a        link length
 * @property {number} alpha    link twist
 * @property {number} [lower]  joint value, absent where unlimited
 * @property {number} [upper]
 * @property {number} [home]
 * @property {number} [velocity]      joint rate limit, per second; likewise the next two
 * @property {number} [acceleration]
 * @property {number} [jerk]
 * @property {number} [effort]        N or N m
 * @property {Partial<Record<DhField, string>>} [text]  what was typed, where it was an expression
 * @property {LinkDoc} link
 * @property {ControllerDoc} controller
 *
 * @typedef {object} RobotInfo
 * @property {string} [manufacturer]
 * @property {string} [author]
 * @property {string} [licence]
 * @property {string} [source]
 * @property {string} [description]
 *
 * @typedef {object} RobotDoc
 * @property {string} name
 * @property {RobotInfo} info
 * @property {Units} units
 * @property {Convention} convention
 * @property {PoseDoc} base    frame 0 seen from the world
 * @property {PoseDoc} tool    the TCP seen from the flange
 * @property {readonly JointDoc[]} joints  2 to 6 of them
 *
 * @typedef {{ readonly id: string, readonly q: readonly number[] }} PostureDoc  a recorded posture
 * @typedef {PoseDoc & { readonly kind: 'user' | 'tool', readonly id: string, readonly number?: number }} FrameDoc  a user
 *   frame seen from the world, a tool seen from the flange; numbered as UFRAME and UTOOL, or BASE_DATA and TOOL_DATA
 * @typedef {PoseDoc & { readonly id: string, readonly frame?: string, readonly configuration?: string }} TargetDoc  a named pose
 *   of the tool, seen from the world, or from the user frame whose id it names
 * @typedef {PoseDoc & { readonly kind: 'box', readonly id: string, readonly width: number, readonly depth: number, readonly height: number }} BoxDoc
 * @typedef {PoseDoc & { readonly kind: 'sphere', readonly id: string, readonly radius: number }} SphereDoc
 * @typedef {PoseDoc & { readonly kind: 'cylinder', readonly id: string, readonly radius: number, readonly height: number }} CylinderDoc
 * @typedef {PoseDoc & { readonly kind: 'plane', readonly id: string }} PlaneDoc
 * @typedef {BoxDoc | SphereDoc | CylinderDoc | PlaneDoc} ObstacleDoc  what the arm is to keep clear of, seen from the world (obstacles.js)
 * @typedef {{ readonly id: string, readonly language: 'karel' | 'fanuc-tp' | 'krl', readonly text: string }} ProgramDoc
 *
 * Motion programs are lists of moves and of what is done between them, in no controller's language. A step keeps what a
 * controller's statement carries, so that code can be written from it.
 *
 * @typedef {{ readonly kind: 'posture', readonly values: readonly number[] }} PostureTarget
 * @typedef {{ readonly kind: 'target', readonly id: string }} NamedTarget   one of the document's targets
 * @typedef {PoseDoc & { readonly kind: 'pose', readonly configuration?: string }} PoseTarget  in the step's user frame, or the world
 * @typedef {PostureTarget | NamedTarget | PoseTarget} StepTarget
 *
 * @typedef {{ readonly kind: 'fine' } | { readonly kind: 'percent' | 'distance', readonly value: number }} Ending
 *   fine: it stops there; else the corner is rounded, by a share or from that far away on
 *
 * @typedef {'trapezoid' | 'doubleS' | 'cubic' | 'quintic' | 'timeOptimal' | 'cubicSpline' | 'parabolicBlends'} StepLaw   the last two
 *   of joint moves: through their targets, or past them, unless their ending is fine
 * @typedef {'%' | 'length/s' | 'angle/s'} SpeedUnit  of the joint rates; of the tool's way; of its turn
 *
 * @typedef {object} MoveDoc
 * @property {string} id           unique in its program
 * @property {'joint' | 'linear' | 'circular'} kind
 * @property {StepTarget} target
 * @property {StepTarget} [via]    of a circular move, and only of it
 * @property {number} speed        of a joint move in %, of the others per second
 * @property {SpeedUnit} speedUnit
 * @property {number} acceleration  %
 * @property {Ending} ending
 * @property {StepLaw} [law]
 * @property {string} [tool]       the id of a tool in the document; absent: the active one
 * @property {string} [frame]      the id of a user frame that its poses are given in; absent: the world
 * @property {string} [comment]
 * @property {boolean} [disabled]
 *
 * @typedef {{ readonly id: string, readonly comment?: string, readonly disabled?: boolean }} Anything
 * @typedef {Anything & { readonly kind: 'wait', readonly seconds: number }} WaitDoc
 * @typedef {Anything & { readonly kind: 'set-output', readonly output: number, readonly value: Signal }} OutputDoc
 * @typedef {Anything & { readonly kind: 'wait-input', readonly input: number, readonly value: Signal }} InputDoc
 * @typedef {Anything & { readonly kind: 'call', readonly program: string }} CallDoc  by id: one of these programs, or one that only the controller has
 * @typedef {Anything & { readonly kind: 'label', readonly label: string }} LabelDoc
 * @typedef {{ readonly id: string, readonly kind: 'comment', readonly text: string, readonly disabled?: boolean }} CommentDoc
 * @typedef {'on' | 'off'} Signal
 *
 * @typedef {Readonly<MoveDoc>} MoveStep
 * @typedef {MoveStep | WaitDoc | OutputDoc | InputDoc | CallDoc | LabelDoc | CommentDoc} StepDoc
 * @typedef {StepDoc['kind']} StepKind
 * @typedef {{ readonly id: string, readonly name: string, readonly steps: readonly StepDoc[] }} MotionProgramDoc
 *
 * @typedef {'pair' | 'tp' | 'karel-move' | 'krl'} CodeFormat
 *
 * @typedef {object} Doc
 * @property {RobotDoc} robot
 * @property {readonly number[]} posture              a joint value for each joint
 * @property {readonly PostureDoc[]} postures         recorded, in the order they are visited
 * @property {readonly FrameDoc[]} frames             user frames and tools, ids unique among all
 * @property {string} [activeTool]                    the id of the tool that `robot.tool` is; absent: of none in the list
 * @property {string} [activeUser]                    the id of a user frame; absent: the world
 * @property {readonly TargetDoc[]} targets           named, in the order of their list
 * @property {readonly ObstacleDoc[]} obstacles       in the order of their list, ids unique
 * @property {readonly MotionProgramDoc[]} motionPrograms  in the order of their list
 * @property {readonly ProgramDoc[]} programs         controller code
 * @property {string} [codeOptions]                   how code is written of the model, as far as it is chosen (codeOptions.js)
 * @property {readonly string[]} extensions           foreign XML elements of the file it came from, as text
 *
 * @typedef {'theta' | 'd' | 'a' | 'alpha'} DhField
 * @typedef {DhField | 'lower' | 'upper' | 'home'} JointField
 */

export const MIN_JOINTS = 2;
export const MAX_JOINTS = 6;
export const MAX_POSTURES = 999; // the file's limit of 1000 less the one that keeps where the arm stands

/** @type {readonly DhField[]} */
export const DH_FIELDS = ['theta', 'd', 'a', 'alpha'];

/** @param {{ readonly type: JointType }} joint */
export const isSliding = ({ type }) => type === 'prismatic';

/**
 * Whether a field of a joint is a length or an angle. Limits and home follow the joint: a slide's are lengths.
 * @param {JointDoc} joint
 * @param {JointField} field
 * @returns {'length' | 'angle'}
 */
export function quantityOf(joint, field) {
  if (field === 'a' || field === 'd') return 'length';
  if (field === 'theta' || field === 'alpha') return 'angle';
  return isSliding(joint) ? 'length' : 'angle';
}

/** @returns {PoseDoc} */
export const identityPose = () => ({ xyz: [0, 0, 0], rpy: [0, 0, 0] });

/**
 * What the joint value may not go past: a continuous joint has no limits, whatever its file says.
 * @param {JointDoc} joint
 */
export const limitsOf = ({ type, lower, upper }) =>
  type === 'continuous'
    ? { lower: -Infinity, upper: Infinity }
    : { lower: lower ?? -Infinity, upper: upper ?? Infinity };

/**
 * Where an arm stands before anyone moved it: home, or else zero brought inside the limits.
 * @param {RobotDoc} robot
 * @returns {number[]}
 */
export const homePosture = ({ joints }) =>
  joints.map((joint) => {
    const { lower, upper } = limitsOf(joint);
    return joint.home ?? Math.min(upper, Math.max(lower, 0));
  });
