/**
 * A motion through recorded points as FANUC controllers since R-30iA want it: a KAREL program that fills position
 * registers, and a TP program that moves through them and that KAREL calls. KAREL itself must not move the arm there.
 *
 * Every target is a set of joint values: no inverse kinematics of the controller comes in between, and no arm
 * configuration is needed. Pure: the same arguments give the same text.
 *
 * @import { Program } from './tree.js'
 * @import { TpProgram } from './tpTree.js'
 * @import { PairOptions, PairPlan } from './fanucPlan.js'
 *
 * @typedef {{ name: string, language: 'karel', text: string, tree: Program }} KarelFile
 * @typedef {{ name: string, language: 'fanuc-tp', text: string, tree: TpProgram }} TpFile
 * @typedef {{ severity: 'error' | 'warning', code: string, path: string, message: string }} PairIssue
 */
import { fillerProgram } from './fanucFiller.js';
import { moverProgram } from './fanucMover.js';
import { planPair } from './fanucPlan.js';
import { printKarel } from './printer.js';
import { printTp } from './tpPrinter.js';

/** Position registers that a controller has unless it was set up for more (HandlingTool operator's manual, section 19). */
const USUAL_REGISTERS = 100;

/** Arms with so many axes are known to take joint values as they are written here. */
const KNOWN_AXES = 6;

/**
 * @param {PairOptions} options
 * @returns {{ files: [KarelFile, TpFile], issues: PairIssue[] }}
 */
export function writeFanucPair(options) {
  const plan = planPair(options);
  const filler = fillerProgram(plan);
  const mover = moverProgram(plan);
  return {
    files: [
      { name: `${plan.names.karel}.kl`, language: 'karel', text: printKarel(filler), tree: filler },
      { name: `${plan.names.tp.toLowerCase()}.ls`, language: 'fanuc-tp', text: printTp(mover), tree: mover },
    ],
    issues: issuesOf(options.programName, plan),
  };
}

/** @param {string} wanted @param {PairPlan} plan */
function issuesOf(wanted, { names, moves, slides }) {
  /** @type {PairIssue[]} */
  const issues = [];
  const warn = (/** @type {string} */ code, /** @type {string} */ path, /** @type {string} */ message) =>
    issues.push({ severity: 'warning', code, path, message });

  if (wanted.toLowerCase() !== names.karel) {
    const rule = 'at most 8 letters, digits and _, a letter first, no word of the language';
    warn('program-name-changed', 'programName', `The program "${wanted}" is called "${names.karel}": ${rule}.`);
  }
  const last = moves[moves.length - 1].register;
  if (last > USUAL_REGISTERS) {
    const usual = `a controller has ${USUAL_REGISTERS} position registers unless it was set up for more`;
    warn('many-registers', 'points', `The points take registers up to PR[${last}]; ${usual}.`);
  }
  if (slides.length !== KNOWN_AXES) {
    const known = `joint values are known to arrive this way for ${KNOWN_AXES} axes only`;
    const effect = 'if the controller refuses them, the KAREL program stops before moving';
    warn('axis-count', 'points', `This arm has ${slides.length} axes, and ${known}; ${effect}.`);
  }
  return issues;
}
