/**
 * What a gauge needs of its face, be it a dial or a rail. Points are in the frame of the joint's seat.
 *
 * @import { Mesh } from 'three'
 * @import { JointSeat } from '../arm/armParts.js'
 * @import { Skin } from '../skins.js'
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {{ joint: Chain['joints'][number], seat: JointSeat, size: number, skin: Skin }} FaceOptions  `size` is the arm's
 *
 * @typedef {object} Face
 * @property {Mesh[]} still    drawn once
 * @property {Mesh[]} moving   moved by `turnTo`
 * @property {number[]} stops  the limits that it shows
 * @property {(q: number) => void} turnTo
 * @property {(from: number, to: number) => Mesh[]} beyond  from a limit to a value past it
 * @property {(q: number) => [number, number, number]} tip     of the pointer, or of a stop's mark
 * @property {(q: number) => [number, number, number]} centre  that words about `tip` keep away from
 * @property {(q: number) => number} besideStop  where, as a value, the words about a stop go
 */
export {};
