/**
 * Controller code in order: lines of KAREL and KRL set in by the blocks that they are in, lines of TP numbered. Only what stands
 * before the first and behind the last character of a line changes: no remark is lost, and the code is the same.
 *
 * @import { ProgramDoc } from '../document.js'
 */

const STEP = '  ';

/** @param {Pick<ProgramDoc, 'language' | 'text'>} program @returns {string} */
export function formatted({ language, text }) {
  if (language === 'fanuc-tp') return numbered(text);
  const words = language === 'karel' ? KAREL : KRL;
  let depth = 0;
  /** Whether the line before goes on in this one. */
  let isOpen = false;
  /** Whether it stands in what a macro stands for, or tells the preprocessor something. */
  let isMacro = false;
  return text
    .split('\n')
    .map((line) => {
      isMacro = isMacro || words.asItIs.test(line);
      const code = words.bare(line);
      const { before, behind } = words.steps(code.trim());
      depth = words.outermost.test(code) ? 0 : Math.max(0, depth + before);
      const isAsItIs = isMacro;
      isMacro = isMacro && words.asItIs.test(line) && /\\\s*$/.test(line);
      const inside = line.trim();
      const set = inside === '' ? '' : STEP.repeat(depth + Number(isOpen)) + inside;
      isOpen = words.goesOn.test(code);
      depth = Math.max(0, depth + behind);
      return isAsItIs ? line : set;
    })
    .join('\n');
}

/**
 * Where a line is ended while it is typed: how far in it stands by then, and the next one. Only where the line before is in order:
 * whoever sets lines in another way goes on so.
 * @param {ProgramDoc['language']} language
 * @param {string} before  the text up to there
 * @param {string} rest    of the line, which the next one takes
 * @returns {{ own: string, next: string } | null}  blanks
 */
export function whenLineEnds(language, before, rest) {
  if (language === 'fanuc-tp') return null;
  const lines = before.split('\n');
  const own = lines[lines.length - 1];
  const inOrder = formatted({ language, text: `${before}\n${rest.trimStart() || '.'}` }).split('\n');
  const last = lines.findLastIndex((line, i) => i < lines.length - 1 && line.trim() !== '');
  const isInOrder = last < 0 || lines[last].trimEnd() === inOrder[last];
  if (!isInOrder || own.trim() === '') return null;
  const [ownBlanks, next] = inOrder.slice(-2).map((line) => line.slice(0, line.length - line.trimStart().length));
  return { own: ownBlanks, next };
}

/**
 * @typedef {object} Blocks
 * @property {(line: string) => string} bare      without texts and remarks
 * @property {(code: string) => { before: number, behind: number }} steps  how much farther in the line, and what follows it, are
 * @property {RegExp} outermost
 * @property {RegExp} asItIs
 * @property {RegExp} goesOn
 */

/** @param {RegExp} opens @param {RegExp} closes @param {RegExp} turns  closes one and opens one @returns {Blocks['steps']} */
const stepsBy = (opens, closes, turns) => (code) => {
  const [opened, closed] = [opens, closes].map((words) => (code.match(words) ?? []).length);
  // A line that begins with the end of a block is as far in as the block's beginning; a block in one line changes nothing.
  if (turns.test(code)) return { before: -1, behind: 1 + opened - closed };
  const first = closed > opened ? closed - opened : 0;
  return { before: -first, behind: first + opened - closed };
};

/** @type {Blocks} */
const KAREL = {
  bare: (line) => line.replace(/'(?:[^']|'')*'?|--.*/g, (found) => (found.startsWith('--') ? '' : "''")),
  steps: karelSteps,
  outermost: /^\s*(PROGRAM|ROUTINE|CONST|TYPE|VAR|BEGIN|END(?=\s+\w|\s*$))\b/i,
  asItIs: /^%/,
  goesOn: /(&|,|\bAND|\bOR|[-+*/=<>])\s*$/i,
};

const KAREL_BLOCKS = stepsBy(
  /\b(?:IF\b(?=.*\bTHEN\b)|SELECT|FOR\b(?=.*\bDO\b)|WHILE\b(?=.*\bDO\b)|REPEAT|USING\b(?=.*\bDO\b)|CONDITION\s*\[[^\]]*\]\s*:|STRUCTURE\b|MOVE\b(?=.*(?:,\s*$|\bWHEN\b)))/gi,
  /\b(?:ENDIF|ENDSELECT|ENDFOR|ENDWHILE|UNTIL|ENDUSING|ENDCONDITION|ENDSTRUCTURE|ENDMOVE)\b/gi,
  /^(?:ELSE|CASE|WHEN)\b/i,
);

/** Sections are one step out of what they hold. @param {string} code @returns {{ before: number, behind: number }} */
function karelSteps(code) {
  if (/^(CONST|TYPE|VAR|BEGIN)\b/i.test(code)) return { before: 0, behind: 1 };
  return KAREL_BLOCKS(code);
}

/** @type {Blocks} */
const KRL = {
  bare: (line) => line.replace(/"[^"]*"?|;.*/g, ''),
  steps: stepsBy(
    /\b(?:DEF|DEFDAT|DEFFCT|IF\b(?=.*\bTHEN\b)|SWITCH|FOR\b(?=.*\bTO\b)|WHILE|REPEAT|LOOP)\b/gi,
    /\b(?:END|ENDDAT|ENDFCT|ENDIF|ENDSWITCH|ENDFOR|ENDWHILE|UNTIL|ENDLOOP)\b/gi,
    /^(?:ELSE|CASE|DEFAULT)\b/i,
  ),
  outermost: /^\s*(&|DEF|DEFDAT|DEFFCT|END|ENDDAT|ENDFCT)\b/i,
  asItIs: /^&/,
  goesOn: /(?!)/,
};

/** The lines of /MN counted anew, those without a number too; and how many they are. @param {string} text */
function numbered(text) {
  let section = '';
  let count = 0;
  const lines = text.split('\n').map((line) => {
    const head = /^\s*\/([A-Z]+)\b/.exec(line);
    if (head) [, section] = head;
    const isMore = /^[ \t]*:/.test(line);
    if (head || section !== 'MN' || isMore || line.trim() === '') return line;
    count++;
    const [, content] = /** @type {RegExpExecArray} */ (/^[ \t]*(?:\d+:)?(.*)$/.exec(line));
    const isNumbered = /^[ \t]*\d+:/.test(line);
    const rest = isNumbered ? content : `${/^[JLCA]\s/.test(content) ? '' : '  '}${content}`;
    return `${String(count).padStart(4)}:${rest}`;
  });
  return lines.map((line) => line.replace(/^(LINE_COUNT\s*=\s*)\d+(?=\s*;)/, `$1${count}`)).join('\n');
}
