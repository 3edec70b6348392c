/**
 * What may be typed in controller code: its own names, what is built in, and the forms of instructions.
 *
 * @import { ProgramDoc } from '../document.js'
 *
 * @typedef {object} KnownName
 * @property {string} name    what is shown, and typed where nothing else is said
 * @property {'routine' | 'variable' | 'constant' | 'built-in' | 'instruction'} kind
 * @property {string} detail
 * @property {string} [typed]  with ${} around what is to be filled in
 */
import { analyse } from '../../karel/check/analysis.js';
import { BUILTINS, signatureText } from '../../karel/check/builtins.js';
import { typeText } from '../../karel/check/types.js';
import { parseKarel } from '../../karel/parser.js';

/** @type {readonly KnownName[]} */
const BUILT_IN = [...BUILTINS.values()].map((one) => ({
  name: one.name,
  kind: 'built-in',
  detail: signatureText(one).slice(one.name.length),
}));

/**
 * @param {readonly ProgramDoc[]} programs
 * @param {ProgramDoc} program  as it is being typed
 * @returns {readonly KnownName[]} what may be typed in it
 */
export function namesFor(programs, { language, text }) {
  if (language === 'karel') return namesOf(programs, text);
  return language === 'fanuc-tp' ? tpNames(programs, text) : KRL_NAMES;
}

/** What a KAREL program may name: its own, and what is built in. @param {readonly ProgramDoc[]} programs @param {string} text @returns {KnownName[]} */
function namesOf(programs, text) {
  const files = Object.fromEntries(programs.map(({ id, text: of }) => [id, of]));
  const { scope } = analyse(parseKarel(text, { files }).tree, files);
  const own = [...scope.globals.values()].map((symbol) => {
    const { name, kind } = symbol;
    if (kind !== 'routine') return { name, kind, detail: typeText(symbol.type) };
    const list = symbol.parameters.map((one) => `${one.name} : ${typeText(one.type)}`).join('; ');
    return { name, kind, detail: `(${list})` };
  });
  return [...own, ...BUILT_IN];
}

/** @param {string} name @param {string} detail @param {string} [typed] @returns {KnownName} */
const instruction = (name, detail, typed = name) => ({ name, kind: 'instruction', detail, typed });

/** HandlingTool's instructions, as listings have them. @type {readonly KnownName[]} */
const TP_INSTRUCTIONS = [
  instruction('J P[]', 'joint move', 'J P[${1}] ${100}% ${FINE}    ;'),
  instruction('L P[]', 'straight move', 'L P[${1}] ${500}mm/sec ${FINE}    ;'),
  instruction('C P[]', 'circular move, over two lines', 'C P[${1}]    \n    :  P[${2}] ${500}mm/sec ${FINE}    ;'),
  instruction('CNT', 'pass the point by: 0 to 100', 'CNT${100}'),
  instruction('FINE', 'stop at the point'),
  instruction('ACC', 'acceleration, %', 'ACC${100}'),
  instruction('Offset', 'moved by a position register', 'Offset,PR[${1}]'),
  instruction('Tool_Offset', 'likewise, seen from the tool', 'Tool_Offset,PR[${1}]'),
  instruction('Skip', 'where SKIP CONDITION was not met: goes on there', 'Skip,LBL[${1}]'),
  instruction('SKIP CONDITION', 'for moves with Skip', 'SKIP CONDITION ${DI[1]=ON} ;'),
  instruction('OFFSET CONDITION', 'for moves with Offset', 'OFFSET CONDITION PR[${1}] ;'),
  instruction('UFRAME_NUM', 'choose a user frame', 'UFRAME_NUM=${1} ;'),
  instruction('UTOOL_NUM', 'choose a tool', 'UTOOL_NUM=${1} ;'),
  instruction('R[]', 'register', 'R[${1}]=${0} ;'),
  instruction('PR[]', 'position register', 'PR[${1}]=${LPOS} ;'),
  instruction('DO[]', 'digital output', 'DO[${1}]=${ON} ;'),
  instruction('WAIT sec', 'a time', 'WAIT   ${1.00}(sec) ;'),
  instruction('WAIT DI', 'an input', 'WAIT DI[${1}]=${ON} ;'),
  instruction('WAIT TIMEOUT', 'an input, or a label when it does not come', 'WAIT DI[${1}]=${ON} TIMEOUT,LBL[${1}] ;'),
  instruction('IF JMP', 'a condition and a jump', 'IF R[${1}]=${0},JMP LBL[${1}] ;'),
  instruction('IF THEN', 'a block', 'IF (${R[1]=0}) THEN ;'),
  ...['ELSE', 'ENDIF', 'ENDFOR', 'END', 'PAUSE', 'ABORT'].map((word) => instruction(word, '', `${word} ;`)),
  instruction('SELECT', 'choices', 'SELECT R[${1}]=${1},JMP LBL[${1}] ;'),
  instruction('FOR', 'a loop', 'FOR R[${1}]=${1} TO ${10} ;'),
  instruction('LBL[]', 'a label', 'LBL[${1}] ;'),
  instruction('JMP', 'a jump', 'JMP LBL[${1}] ;'),
  instruction('TIMER', 'START, STOP, RESET', 'TIMER[${1}]=${START} ;'),
  instruction('OVERRIDE', 'speed of everything, %', 'OVERRIDE=${100}% ;'),
  instruction('MESSAGE', 'a text for the person', 'MESSAGE[${text}] ;'),
  instruction('PAYLOAD', 'choose a payload', 'PAYLOAD[${1}] ;'),
  instruction('UALM', 'a user alarm', 'UALM[${1}] ;'),
  instruction('CALL', 'run a program, then go on', 'CALL ${PROGRAM}    ;'),
];

/** Labels, positions and programs that are there come first. @param {readonly ProgramDoc[]} programs @param {string} text @returns {KnownName[]} */
function tpNames(programs, text) {
  const own = [...text.matchAll(/^\s*\d+:\s*(LBL\[\d+)(?::([^\]]*))?\]/gm)].map(([, label, comment = '']) =>
    instruction(`JMP ${label}]`, comment, `JMP ${label}] ;`),
  );
  const calls = programs
    .filter(({ language, text: of }) => language !== 'krl' && of !== text)
    .map(({ id, language, text: of }) => {
      const [, name = id] = (language === 'karel' ? /^\s*PROGRAM\s+(\w+)/im : /^\s*\/PROG\s+(\S+)/m).exec(of) ?? [];
      return instruction(`CALL ${name.toUpperCase()}`, 'a program of this model', `CALL ${name.toUpperCase()}    ;`);
    });
  return [...calls, ...own, ...TP_INSTRUCTIONS];
}

/** What the reader of KRL knows. @type {readonly KnownName[]} */
const KRL_NAMES = [
  instruction('PTP', 'joint move', 'PTP ${XP1}'),
  instruction('LIN', 'straight move', 'LIN ${XP1}'),
  instruction('CIRC', 'circular move', 'CIRC ${XP1},${XP2}'),
  instruction('WAIT SEC', 'a time', 'WAIT SEC ${1.0}'),
  instruction('WAIT FOR', 'an input', 'WAIT FOR $IN[${1}]==${TRUE}'),
  instruction('$OUT', 'an output', '$OUT[${1}]=${TRUE}'),
  instruction('$VEL.CP', 'm/s of the tool', '$VEL.CP=${0.25}'),
  instruction('BAS(#VEL_PTP)', '% of joint moves', 'BAS(#VEL_PTP,${100})'),
  instruction('BAS(#TOOL)', 'choose a tool', 'BAS(#TOOL,${1})'),
  instruction('BAS(#BASE)', 'choose a base', 'BAS(#BASE,${1})'),
];
