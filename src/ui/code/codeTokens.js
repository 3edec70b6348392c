/**
 * Which pieces of a line of controller code are words, numbers, texts, remarks: for its colours. It is no parser; what is wrong is
 * found by `karel`.
 *
 * @import { ProgramDoc } from '../../model/document.js'
 *
 * @typedef {object} Stream   a line, and how far it is read; CodeMirror's, or that of `piecesOf`
 * @property {string} string
 * @property {number} pos
 * @property {(pattern: RegExp) => RegExpMatchArray | boolean | null} match   from there on, and goes on behind it
 *
 * @typedef {'keyword' | 'typeName' | 'variableName' | 'variableName.standard' | 'meta' | 'number' | 'string' | 'comment' | 'lineNumber' | 'punctuation'} Token
 * @typedef {(stream: Stream) => Token | null} Reader   null: space
 */
import { isKnownRoutine } from '../../karel/check/builtins.js';
import { isBuiltin, isReserved, isTypeWord } from '../../karel/words.js';

const KRL_WORDS = new Set(
  `DEF DEFDAT DEFFCT END ENDDAT ENDFCT DECL INT REAL BOOL CHAR STRUC ENUM GLOBAL PUBLIC EXT CONST SIGNAL IF THEN ELSE ENDIF FOR TO
   STEP ENDFOR WHILE ENDWHILE REPEAT UNTIL LOOP ENDLOOP SWITCH CASE DEFAULT ENDSWITCH GOTO HALT EXIT RETURN WAIT SEC INTERRUPT WHEN DO
   TRIGGER DISTANCE DELAY CONTINUE AND OR NOT EXOR IMPORT IS RESUME BRAKE ON OFF`.split(/\s+/),
);
const KRL_MOVES = /^(PTP|LIN|CIRC|SPTP|SLIN|SCIRC|PTP_REL|LIN_REL|C_PTP|C_DIS|C_VEL|C_ORI|BAS|TOOL_DATA|BASE_DATA)$/i;
const KRL_TYPES = /^(INT|REAL|BOOL|CHAR|FRAME|POS|E6POS|AXIS|E6AXIS|FDAT|LDAT|PDAT)$/i;

const TP_WORDS =
  /^(IF|THEN|ELSE|ENDIF|SELECT|FOR|ENDFOR|TO|DOWNTO|JMP|LBL|CALL|RUN|END|WAIT|ABORT|PAUSE|SKIP|OFFSET|TOOL_OFFSET|CONDITION|UFRAME_NUM|UTOOL_NUM|UFRAME|UTOOL|TIMEOUT|AND|OR|DIV|MOD|MONITOR|MESSAGE|OVERRIDE|PAYLOAD|UALM|Offset|Tool_Offset|Skip|INC|Wjnt|FINE|CNT\d*|ACC\d*)$/;
const TP_DATA = /^(R|PR|DI|DO|RI|RO|GI|GO|AI|AO|UI|UO|SI|SO|WI|WO|F|M|SR|AR|P|VR|TIMER)$/;
const TP_VALUES = /^(ON|OFF|LPOS|JPOS|PULSE|START|STOP|RESET|mm|sec|deg|cm|min|inch)$/;

/** @param {string} word @returns {Token} */
function karelWord(word) {
  if (isTypeWord(word)) return 'typeName';
  if (isReserved(word)) return 'keyword';
  return isBuiltin(word) || isKnownRoutine(word) ? 'variableName.standard' : 'variableName';
}

/** @param {string} word @returns {Token} */
function tpWord(word) {
  if (TP_WORDS.test(word)) return 'keyword';
  if (/^[JLCA]$/.test(word)) return 'keyword';
  if (TP_VALUES.test(word)) return 'typeName';
  return TP_DATA.test(word) ? 'variableName.standard' : 'variableName';
}

/** @param {string} word @returns {Token} */
function krlWord(word) {
  if (KRL_TYPES.test(word)) return 'typeName';
  if (KRL_MOVES.test(word) || KRL_WORDS.has(word.toUpperCase())) return 'keyword';
  return word.startsWith('$') ? 'variableName.standard' : 'variableName';
}

/**
 * @param {readonly [RegExp, Token, boolean?][]} first  what comes before words and numbers; true: at the beginning of a line only
 * @param {(word: string) => Token} ofWord
 * @param {RegExp} word
 * @returns {Reader}
 */
const reader = (first, ofWord, word) => (stream) => {
  if (stream.match(/^\s+/)) return null;
  const isFirst = stream.string.slice(0, stream.pos).trim() === '';
  for (const [pattern, token, atFirst] of first) if ((!atFirst || isFirst) && stream.match(pattern)) return token;
  const found = stream.match(word);
  if (typeof found === 'object' && found) return ofWord(found[0]);
  if (stream.match(/^\d+(\.\d+)?([eE][+-]?\d+)?/)) return 'number';
  stream.pos++;
  return 'punctuation';
};

/** @type {Readonly<Record<ProgramDoc['language'], Reader>>} */
export const READERS = {
  karel: reader(
    [
      [/^--.*/, 'comment'],
      [/^'(?:[^']|'')*'?/, 'string'],
      [/^%\w+/, 'meta'],
    ],
    karelWord,
    /^[$]?[A-Za-z_]\w*/,
  ),
  'fanuc-tp': reader(
    [
      [/^\d+:(?!\s*$)/, 'lineNumber', true],
      [/^:/, 'lineNumber', true],
      [/^(!|--|\/\/).*/, 'comment'],
      [/^\/[A-Z]+\b.*/, 'meta', true],
      [/^(?:"[^"]*"?|'[^']*'?)/, 'string'],
    ],
    tpWord,
    /^[A-Za-z_]\w*/,
  ),
  krl: reader(
    [
      [/^;.*/, 'comment'],
      [/^&.*/, 'meta'],
      [/^"[^"]*"?/, 'string'],
      [/^'[^']*'?/, 'number'],
    ],
    krlWord,
    /^[$]?[A-Za-z_]\w*/,
  ),
};

/** A line in its pieces, in their order: together they are the line. @param {ProgramDoc['language']} language @param {string} line */
export function piecesOf(language, line) {
  const stream = {
    string: line,
    pos: 0,
    /** @param {RegExp} pattern */
    match(pattern) {
      const found = pattern.exec(line.slice(this.pos));
      if (found) this.pos += found[0].length;
      return found;
    },
  };
  /** @type {{ text: string, token: Token | null }[]} */
  const pieces = [];
  while (stream.pos < line.length) {
    const from = stream.pos;
    const token = READERS[language](stream);
    pieces.push({ text: line.slice(from, stream.pos), token });
  }
  return pieces;
}
