/**
 * What an arm is asked for: moves, one after another, and the limits of its joints.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 * @import { LawName } from './restLaw.js'
 *
 * @typedef {LawName | 'timeOptimal'} PlanLaw   timeOptimal: the joints alone decide how quickly the way gets faster and slower
 *
 * @typedef {'cubicSpline' | 'parabolicBlends'} ViaLaw   through the targets, or past them, as textbooks have it (viaRun.js)
 *
 * @typedef {{ kind: 'fine' } | { kind: 'share', share: number } | { kind: 'distance', distance: number }} Ending
 *   share: 1 for the largest zone, which reaches to about the middle of the quicker of both moves. distance: m, within which
 *   the tool is of the corner all through the zone's way
 *
 * @typedef {object} JointMoveBase
 * @property {'joint'} kind
 * @property {Float64Array} posture
 * @property {number} speed          share of the joints' rates, above 0 and at most 1
 * @property {number} acceleration   share of their accelerations
 * @property {Ending} ending
 * @property {Chain} [chain]         with another tool: where the joints go is the same with any, what the tool does is not
 *
 * @typedef {JointMoveBase & { law?: PlanLaw }} JointMove
 * @typedef {JointMoveBase & { law: ViaLaw }} ViaMove   goes on into the next one by the same law unless its ending is fine, whatever the zone
 *
 * @typedef {object} ToolMoveBase
 * @property {Pose} T_base_tcp     seen from the chain's root
 * @property {number} speed        m/s
 * @property {number} turnSpeed    rad/s
 * @property {number} acceleration  m/s²; of a turn in the same proportion to its speed
 * @property {PlanLaw} [law]
 * @property {Ending} ending
 * @property {Chain} [chain]       with another tool
 *
 * @typedef {ToolMoveBase & { kind: 'linear' }} LinearMove
 * @typedef {ToolMoveBase & { kind: 'circular', via: Pose }} CircularMove
 * @typedef {{ kind: 'wait', seconds: number }} Wait
 * @typedef {JointMove | LinearMove | CircularMove} WayMove
 * @typedef {WayMove | ViaMove | Wait} Move
 *
 * @typedef {object} JointLimits   one a joint, above 0
 * @property {Float64Array} rates
 * @property {Float64Array} accelerations
 * @property {Float64Array} [jerks]   of joint moves by the S-curve
 */
export {};
