/**
 * System variables: places by their text in capitals, without $, each index in brackets of its own. What they hold before a
 * program sets them: frames and tools that change nothing, of one group of axes; frame 0 and tool 1 are chosen, as a new
 * controller has it.
 *
 * @import { Value } from './values.js'
 */

const FRAMES = 9;
const TOOLS = 10;
const AXES = 9;
/** mm/s, of $SPEED for joint moves: a round number, as it differs from robot to robot. */
export const JOINT_SPEED_LIMIT = 2000;

const nothing = () => new Array(10).fill(0);

/** @returns {Record<string, Value>} */
export const firstSystem = () => ({
  ...{ 'GROUP[1].UFRAME': nothing(), 'GROUP[1].UTOOL': nothing(), 'MOR_GRP[1].NILPOS': nothing() },
  'MOR_GRP[1].CUR_NOM_ANG': new Array(AXES).fill(0),
  'PARAM_GROUP[1].SPEEDLIMJNT': JOINT_SPEED_LIMIT,
  ...{ 'MNUFRAMENUM[1]': 0, 'MNUTOOLNUM[1]': 1, 'SCR.NUM_GROUP': 1 },
  ...Object.fromEntries(Array.from({ length: FRAMES }, (_, i) => [`MNUFRAME[1][${i + 1}]`, nothing()])),
  ...Object.fromEntries(Array.from({ length: TOOLS }, (_, i) => [`MNUTOOL[1][${i + 1}]`, nothing()])),
});

/** Those of the first group have short names. @param {string} name in capitals */
export const systemKey = (name) => (name === 'UFRAME' || name === 'UTOOL' ? `GROUP[1].${name}` : name);

/** As GET_VAR has it: `$MNUFRAME[1,2]`. @param {string} text in capitals */
export const keyOfText = (text) =>
  systemKey(text.replace(/[$\s]/g, '').replace(/\[([^\]]*)\]/g, (_, list) => `[${list.split(',').join('][')}]`));

/** @param {string} key */
export const noValueOf = (key) => `$${key.replaceAll('][', ',')} has no value until a program sets it`;
