/**
 * How controller languages are coloured: words, numbers, texts, remarks. It is no parser; what is wrong is found by `karel`.
 *
 * @import { StreamParser, StringStream } from '@codemirror/language'
 * @import { ProgramDoc } from '../../model/document.js'
 */
import { StreamLanguage } from '@codemirror/language';
import { tags } from '@lezer/highlight';
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

/** @param {string} word */
function karelWord(word) {
  if (isTypeWord(word)) return 'typeName';
  if (isReserved(word)) return 'keyword';
  return isBuiltin(word) || isKnownRoutine(word) ? 'variableName.standard' : 'variableName';
}

/** @param {string} word */
function tpWord(word) {
  if (TP_WORDS.test(word)) return 'keyword';
  if (/^[JLCA]$/.test(word)) return 'keyword';
  if (TP_VALUES.test(word)) return 'typeName';
  return TP_DATA.test(word) ? 'variableName.standard' : 'variableName';
}

/** @param {string} word */
function krlWord(word) {
  if (KRL_TYPES.test(word)) return 'typeName';
  if (KRL_MOVES.test(word) || KRL_WORDS.has(word.toUpperCase())) return 'keyword';
  return word.startsWith('$') ? 'variableName.standard' : 'variableName';
}

/**
 * @param {[RegExp, string, boolean?][]} first  what comes before words and numbers; true: at the beginning of a line only
 * @param {(word: string) => string} ofWord
 * @param {RegExp} word
 * @returns {StreamParser<null>}
 */
const simple = (first, ofWord, word) => ({
  /** @param {StringStream} stream */
  token(stream) {
    if (stream.eatSpace()) return null;
    const isFirst = stream.column() === stream.indentation();
    for (const [pattern, style, atFirst] of first) if ((!atFirst || isFirst) && stream.match(pattern)) return style;
    const found = /** @type {RegExpMatchArray | null} */ (stream.match(word));
    if (found) return ofWord(found[0]);
    if (stream.match(/^\d+(\.\d+)?([eE][+-]?\d+)?/)) return 'number';
    stream.next();
    return 'punctuation';
  },
});

const KAREL = StreamLanguage.define({
  ...simple(
    [
      [/^--.*/, 'comment'],
      [/^'(?:[^']|'')*'?/, 'string'],
      [/^%\w+/, 'meta'],
    ],
    karelWord,
    /^[$]?[A-Za-z_]\w*/,
  ),
  languageData: { commentTokens: { line: '--' }, closeBrackets: { brackets: ['(', '[', "'"] } },
});

const TP = StreamLanguage.define({
  ...simple(
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
  tokenTable: { lineNumber: tags.lineComment },
  languageData: { commentTokens: { line: '!' } },
});

const KRL = StreamLanguage.define({
  ...simple(
    [
      [/^;.*/, 'comment'],
      [/^&.*/, 'meta'],
      [/^"[^"]*"?/, 'string'],
      [/^'[^']*'?/, 'number'],
    ],
    krlWord,
    /^[$]?[A-Za-z_]\w*/,
  ),
  languageData: { commentTokens: { line: ';' } },
});

/** @type {Record<ProgramDoc['language'], StreamLanguage<unknown>>} */
export const LANGUAGES = { karel: KAREL, 'fanuc-tp': TP, krl: KRL };
