/**
 * The words and characters that KAREL text is made of: what may be a name, what may stand in a string or a comment.
 * Caller's mistakes are RangeErrors, so that no text comes out that a translator would read differently.
 */

/** Reserved words: FANUC KAREL Reference Manual, appendix "Reserved words". The functions among them can be called. */
const RESERVED = new Set(
  `ABORT ABOUT AFTER ALONG ALSO AND ARRAY AT ATTACH AWAY AXIS BEFORE BEGIN BOOLEAN BY BYTE CAM_SETUP CANCEL CASE CLOSE
   CMOS COMMAND COMMON_ASSOC CONDITION CONFIG CONNECT CONST CONTINUE COORDINATED CR DELAY DISABLE DISCONNECT DIV DO
   DOWNTO DRAM ELSE ENABLE END ENDCONDITION ENDFOR ENDIF ENDMOVE ENDSELECT ENDSTRUCTURE ENDUSING ENDWHILE ERROR EVENT
   FILE FOR FROM GO GOTO GROUP GROUP_ASSOC HAND HOLD IF IN INDEPENDENT INTEGER JOINTPOS JOINTPOS1 JOINTPOS2 JOINTPOS3
   JOINTPOS4 JOINTPOS5 JOINTPOS6 JOINTPOS7 JOINTPOS8 JOINTPOS9 MOD MODEL MOVE NEAR NOABORT NODE NODEDATA NOMESSAGE
   NOPAUSE NOT NOWAIT OF OPEN OR PATH PATHHEADER PAUSE POSITION POWERUP PROGRAM PULSE PURGE READ REAL RELATIVE RELAX
   RELEASE REPEAT RESTORE RESUME RETURN ROUTINE SELECT SEMAPHORE SHADOW SHORT SIGNAL STOP STRING STRUCTURE THEN TIME
   TIMER TO TPENABLE TYPE UNHOLD UNPAUSE UNTIL USING VAR VECTOR VIA VIS_PROCESS WAIT WHEN WHILE WITH WRITE XYZWPR
   XYZWPREXT`.split(/\s+/),
);

/** Built-in functions, ports, constants and devices with names short enough for a program's: legal, but confusing. */
const PREDEFINED = new Set(
  `ABS ACOS AIN AOUT APPROACH ASIN ATAN2 BYNAME CHR CONT_TASK COS CURJPOS CURPOS CURR_PROG DIN DOUT EVAL EXP FALSE FLG
   FRAME GET_REG GET_TIME GET_VAR GIN GOUT INDEX IN_RANGE INPUT INV KCL LAI LAO LDI LDO LN MAXINT MININT MIRROR MRK
   NORMAL OFF ON OPIN OPOUT ORD ORIENT OUTPUT PATH_LEN POS POST_ERR RDI RDO ROUND SET_VAR SIN SQRT STR_LEN SUB_STR TAN
   TPDISPLAY TPERROR TPFUNC TPIN TPOUT TPPROMPT TPSTATUS TRUE TRUNC UIN UNINIT UNPOS UOUT WDI WDO`.split(/\s+/),
);

/** A letter, then letters, digits or underscores. */
const IDENTIFIER = /^[A-Za-z][A-Za-z0-9_]*$/;

/** Types whose names are reserved words. */
const TYPE_WORD =
  /^(BOOLEAN|BYTE|PATH|CONFIG|FILE|INTEGER|JOINTPOS[1-9]?|MODEL|POSITION|REAL|SHORT|VECTOR|VIS_PROCESS|XYZWPR|XYZWPREXT|CAM_SETUP|COMMON_ASSOC|GROUP_ASSOC)$/;

/** What ends a line or is no character at all. A tab is neither. */
const UNPRINTABLE = /[\p{Cs}\u2028\u2029]|[^\P{Cc}\t]/u;

export const MAX_STRING_LENGTH = 254;

/** Whether a word already means something in the language. @param {string} word */
export const isTakenWord = (word) => RESERVED.has(word.toUpperCase()) || PREDEFINED.has(word.toUpperCase());

/** @param {string} word  in any case */
export const isReserved = (word) => RESERVED.has(word.toUpperCase());

/** A built-in function, port, constant or device. @param {string} word  in any case */
export const isBuiltin = (word) => PREDEFINED.has(word.toUpperCase());

/** @param {string} text  whether it is a type of the language */
export const isTypeWord = (text) => TYPE_WORD.test(text.toUpperCase());

/** @param {string} text  @returns {string} the text itself, if it can name something */
export function identifier(text) {
  if (IDENTIFIER.test(text) && !RESERVED.has(text.toUpperCase())) return text;
  throw new RangeError(
    `Expected a KAREL identifier (a letter, then letters, digits or _, no reserved word), got ${JSON.stringify(text)}.`,
  );
}

/** A word of the language that is also a name: the condition ERROR. */
export const NAMES_ALL_THE_SAME = new Set(['ERROR']);

/** @param {string} text  @returns {string} the text itself, if a value can be called so */
export const referenceName = (text) => (NAMES_ALL_THE_SAME.has(text.toUpperCase()) ? text : identifier(text));

/** @param {string} text  @returns {string} the text itself, if it can name a type */
export const typeName = (text) => (TYPE_WORD.test(text.toUpperCase()) ? text : identifier(text));

/** A word of a directive: any word, reserved or not. @param {string} text */
export function word(text) {
  if (IDENTIFIER.test(text)) return text;
  throw new RangeError(`Expected a word (a letter, then letters, digits or _), got ${JSON.stringify(text)}.`);
}

/** @param {string} text @returns {string} the text itself, if it stays on one line */
export function oneLine(text) {
  if (!UNPRINTABLE.test(text)) return text;
  throw new RangeError(`Expected text without line ends and control characters, got ${JSON.stringify(text)}.`);
}

/** A string literal: the quote is doubled. @param {string} text */
export function quoted(text) {
  if (text.length > MAX_STRING_LENGTH) {
    throw new RangeError(`Expected a string of at most ${MAX_STRING_LENGTH} characters, got ${text.length}.`);
  }
  return `'${oneLine(text).replaceAll("'", "''")}'`;
}

/** A path of a file, with \ or / and a device; what would begin a comment or a string is none. @param {string} text */
export const isIncludePath = (text) => /^(?!.*--)[^\s'"%;,&]+$/.test(text);

/** @param {string} text @returns {string} the text itself, if it can be the path of a file */
export function includePath(text) {
  if (isIncludePath(text)) return text;
  throw new RangeError(`Expected the path of a file, got ${JSON.stringify(text)}.`);
}
