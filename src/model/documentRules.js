/**
 * What the values of a document may be: the facts that validation, the robot file and its schema share.
 *
 * @import { AngleUnit, Convention, JointType, LengthUnit, LinkDoc, ProgramDoc, SpeedUnit, StepLaw } from './document.js'
 */

/** What a robot file can hold, and far beyond any arm in any unit. */
export const LARGEST_NUMBER = 1e9;

/** Ids are names in code, too (KAREL, URDF), hence the narrow alphabet. */
export const ID_PATTERN = /^[A-Za-z_][A-Za-z0-9_]{0,63}$/;
export const COLOUR_PATTERN = /^#[0-9A-Fa-f]{6}$/;

/** The posture of a file with this id is where the arm stands; no recorded posture may be called so. */
export const PRESENT_POSTURE_ID = 'current';

export const MAX_LABEL_LENGTH = 200;
export const MAX_DESCRIPTION_LENGTH = 10_000;
export const MAX_FRAMES = 100;
export const MAX_TARGETS = 200;
export const MAX_OBSTACLES = 100;
export const MAX_PROGRAMS = 20;
export const MAX_MOTION_PROGRAMS = 20;
/** Of all motion programs together: each step is an element of the file (io/fileLimits.js). */
export const MAX_STEPS = 1000;

/** How far the length of a quaternion may be from 1: typed digits are rounded, but six of them are usual. */
export const QUATERNION_TOLERANCE = 1e-6;

/** @type {readonly LengthUnit[]} */
export const LENGTH_UNITS = ['m', 'cm', 'mm'];
/** @type {readonly AngleUnit[]} */
export const ANGLE_UNITS = ['deg', 'rad'];
/** @type {readonly Convention[]} */
export const CONVENTIONS = ['standard', 'modified'];
/** @type {readonly JointType[]} */
export const JOINT_TYPES = ['revolute', 'prismatic', 'continuous'];
/** @type {readonly LinkDoc['kind'][]} */
export const LINK_KINDS = ['auto', 'cylinder', 'box', 'none'];
/** @type {readonly ProgramDoc['language'][]} */
export const PROGRAM_LANGUAGES = ['karel', 'fanuc-tp', 'krl'];

/** @type {readonly SpeedUnit[]} */
export const SPEED_UNITS = ['%', 'length/s', 'angle/s'];
/** Of any move. @type {readonly StepLaw[]} */
export const STEP_LAWS = ['trapezoid', 'doubleS', 'cubic', 'quintic', 'timeOptimal'];
/** Of joint moves: the last two go on through their targets, or past them. @type {readonly StepLaw[]} */
export const JOINT_LAWS = [...STEP_LAWS, 'cubicSpline', 'parabolicBlends'];

/** Characters as XML Schema counts them: an emoji is one. @param {string} text */
export const characterCount = (text) => Array.from(text).length;
