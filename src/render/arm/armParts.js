/**
 * An arm as parts, from its DH table: every length in the picture is one of the table's (armPlan.js has the rules). A part
 * is built once, in the frame that the kernel gives its link, and moves with that frame and nothing else. No Three.js and
 * no WebGL here.
 *
 * @import { JointPlan } from './armPlan.js'
 * @import { Body } from './bodies.js'
 * @import { LinkStyle } from './linkPieces.js'
 * @import { PartKind } from './joinery.js'
 * @import { Shape } from './solid.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {object} Part
 * @property {Shape} shape
 * @property {Pose} pose    where it is in the frame of its link
 * @property {number} link  0 is the base
 * @property {PartKind} kind
 *
 * @typedef {object} Rod     what reaches from one link to the next along a slide, however far that is; 1 m long as built
 * @property {Shape} shape
 * @property {Pose} pose     in the frame of its link
 * @property {number} link
 * @property {number} joint  the index of the joint whose value, added to `constant`, is its length
 * @property {number} constant
 *
 * @typedef {object} JointSeat  where a joint is, for marks about it
 * @property {Pose} T_link_zero  in the frame of the link before: z is the joint's axis, x is x of its link at q = 0
 * @property {number} aim        the angle from x about z at which the link leaves the joint
 * @property {number} at         where on the axis the joint sits
 * @property {number} radius     of the link that it moves
 * @property {number} low        a slide's d at its limits, or where it is drawn to if it has none
 * @property {number} high
 *
 * @typedef {object} ArmParts
 * @property {Part[]} parts
 * @property {Rod[]} rods
 * @property {JointSeat[]} joints
 * @property {number} size   of the whole arm in metres: what its proportions, and the camera's, go by
 * @property {number} below  how far the base reaches behind frame 0
 * @property {1 | -1} sense  whether the arm begins along z of frame 0 or against it
 */
import { compose, translation } from '../../kinematics/pose.js';
import { hasBeam, planArm, radiiOf } from './armPlan.js';
import { axisInLink, bodiesOf } from './bodies.js';
import { basePieces, toolPieces } from './endPieces.js';
import { linkPieces } from './linkPieces.js';
import { rodShape, squareTo } from './slides.js';

/**
 * @param {Chain} chain
 * @param {readonly LinkStyle[]} [styles]  one for each joint: how the link that it moves is drawn
 * @returns {ArmParts}
 */
export function armParts(chain, styles = []) {
  const { bodies, size } = bodiesOf(chain);
  const radii = radiiOf(size, chain.dof).map((radius, i) => (i && styles[i - 1]?.radius) || radius);
  const plan = planArm(bodies, radii);
  const parts = bodies.flatMap((body, i) => {
    const link = { body, next: bodies[i + 1], near: plan.joints[i - 1], far: plan.joints[i], radius: radii[i] };
    const own = i ? linkPieces(link, styles[i - 1]) : basePieces(link, plan.base);
    const pieces = i < chain.dof ? own : [...own, ...toolPieces(link, plan.flange, chain.tool)];
    return pieces.map(({ shape, pose, kind }) => ({ shape, pose: compose(body.T_link_body, pose), link: i, kind }));
  });
  const rods = plan.joints.flatMap((joint, i) => {
    const body = bodies[i + 1];
    if (!body.slides) return [];
    const start = joint.joinery === 'lift' ? -joint.sense * (plan.base.depth - plan.base.plate) : 0;
    const pose = compose(compose(axisInLink(bodies, i + 1), squareTo(body)), translation([0, 0, start]));
    return [{ shape: rodShape(joint), pose, link: i, joint: i, constant: body.d - start }];
  });
  const joints = plan.joints.map(({ at, radius }, i) => {
    const body = bodies[i + 1];
    const T_link_zero = compose(axisInLink(bodies, i + 1), squareTo(body));
    return { T_link_zero, aim: aimOf(body, radius, plan.joints[i + 1]), at, radius, low: body.low, high: body.high };
  });
  return { parts, rods, joints, size, below: plan.base.depth, sense: plan.joints[0].sense };
}

/**
 * Along the beam if the link has one, along the next tube if that stands across, else along x.
 * @param {Body} body
 * @param {number} radius
 * @param {JointPlan | undefined} next
 */
function aimOf(body, radius, next) {
  if (hasBeam(body, radius)) return body.a < 0 ? Math.PI : 0;
  const y = next?.joinery === 'axial' ? -Math.sin(body.alpha) * next.sense : 0; // of the next axis, whose x is ours
  return Math.abs(y) > 0.5 ? (Math.sign(y) * Math.PI) / 2 : 0;
}
