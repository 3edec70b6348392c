/**
 * Reads written code line by line, by a grammar of its lines written down here: what it does not know it throws at. It answers
 * with the numbers and the words of moves.
 */

const NUMBER = String.raw`-?\d{1,5}\.\d{3}`;
const KAREL_COMMENT = /^ *--( [!-~]([ -~]*[!-~])?| {2,}[!-~]([ -~]*[!-~])?)?$/;
const CONFIG = `'[FN] [UD] [TB], -?\\d, -?\\d, -?\\d'`;
/** Of both forms of KAREL. */
const KAREL = [
  /^PROGRAM [a-z][a-z0-9_]{0,7}$/,
  /^%COMMENT = '[A-Za-z0-9 _.:()*@-]{1,16}'$/,
  /^%ENVIRONMENT REGOPE$/,
  /^%NOLOCKGROUP$/,
  /^%NOPAUSE = ERROR \+ COMMAND \+ TPENABLE$/,
  /^(VAR|BEGIN|ENDIF| *IF status <> 0 THEN| *ENDIF| *ABORT)$/,
  /^ {2}(joints : ARRAY\[[1-9]\] OF REAL|at_joints : JOINTPOS|via_joints : JOINTPOS|config_n : CONFIG|status : INTEGER)$/,
  /^ {2}(target_n : XYZWPR|via_n : XYZWPR|prog_idx : INTEGER)$/,
  /^ROUTINE ([a-z][a-z0-9_]{0,7}) FROM \1$/,
  /^ROUTINE check_it\(what : STRING\)$/,
  /^END [a-z][a-z0-9_]{0,7}$/,
  /^ {4}WRITE\(what, ' gave status ', status, CR\)$/,
  /^ {2}joints\[\d\] = NUMBER$/,
  /^ {2}CNV_REL_JPOS\(joints, (at|via)_joints, status\)$/,
  /^ {2}CNV_STR_CONF\(LETTERS, config_n, status\)$/,
  /^ {2}check_it\('(CNV_REL_JPOS|CNV_STR_CONF|SET_JPOS_REG|SET_POS_REG)'\)$/,
  /^ {2}IF NOT J_IN_RANGE\(at_joints\) THEN$/,
  /^ {4}WRITE\('Joint values are outside of the limits', CR\)$/,
  /^ {2}SET_JPOS_REG\(\d+, at_joints, status\)$/,
  /^ {2}SET_POS_REG\(\d+, POS\(NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, config_n\), status\)$/,
  /^ {2}(target|via)_n = POS\(NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, NUMBER, config_n\)$/,
  /^ {2}[a-z][a-z0-9_]{0,7}$/, // the call of the TP half
  /^ {2}\$MNU(FRAME|TOOL)NUM\[1\] = \d+$/,
  /^ {2}\$GROUP\[1\]\.\$U(FRAME|TOOL) = (\$MOR_GRP\[1\]\.\$NILPOS|\$MNU(FRAME|TOOL)\[1, \d+\])$/,
  /^ {2}WITH \$MOTYPE = (JOINT|LINEAR|CIRCULAR), \$TERMTYPE = (FINE|VARDECEL, \$DECELTOL = \d+|NODECEL), (\$SPEED = \$PARAM_GROUP\[1\]\.\$SPEEDLIMJNT \* \d\.\d{3}|\$(ROT)?SPEED = \d+\.\d) MOVE TO (target_n|at_joints)( VIA (via_n|via_joints))?$/,
  /^ {2}(DELAY \d+|DOUT\[\d+\] = (ON|OFF)|WAIT FOR DIN\[\d+\] = (ON|OFF)|CALL_PROG\('[A-Za-z0-9_]{1,36}', prog_idx\))$/,
].map((pattern) => new RegExp(pattern.source.replaceAll('NUMBER', NUMBER).replaceAll('LETTERS', CONFIG)));

const TP_HEAD = [
  /^\/PROG {2}[A-Z][A-Z0-9_]{0,7}$/,
  /^\/(ATTR|MN|POS|END)$/,
  /^(OWNER\t\t= MNEDITOR|PROG_SIZE\t= 0|FILE_NAME\t= |VERSION\t\t= 0|LINE_COUNT\t= \d+|MEMORY_SIZE\t= 0|PROTECT\t\t= READ_WRITE);$/,
  /^COMMENT\t\t= "[^";]{0,16}";$/,
  /^(CREATE\t\t|MODIFIED\t)= DATE \d\d-\d\d-\d\d {2}TIME \d\d:\d\d:\d\d;$/,
  /^TCD: {2}STACK_SIZE\t= 0,$/,
  /^ {6}(TASK_PRIORITY\t= 50|TIME_SLICE\t= 0|BUSY_LAMP_OFF\t= 0|ABORT_REQUEST\t= 0),$/,
  /^ {6}PAUSE_REQUEST\t= 0;$/,
  /^DEFAULT_GROUP\t= 1,\*,\*,\*,\*;$/,
  /^CONTROL_CODE\t= 00000000 00000000;$/,
];
const END = String.raw`(FINE|CNT\d{1,3}|CR\d+)( ACC\d{1,3})? {4};`;
const TP_LINES = [
  /^ {2}![^;]{1,32} ;$/,
  /^J P(R)?\[\d+\] \d{1,3}% END$/,
  /^L P(R)?\[\d+\] \d+(mm|deg)\/sec END$/,
  /^C P(R)?\[\d+\] *$/,
  /^ {2}(UFRAME_NUM|UTOOL_NUM)=\d+ ;$/,
  /^ {2}(WAIT +\d*\.\d\d\(sec\)|DO\[\d+\]=(ON|OFF)|WAIT DI\[\d+\]=(ON|OFF)|CALL [A-Z0-9_]{1,36})( {4})? ;$/,
].map((pattern) => new RegExp(pattern.source.replaceAll('END$', `${END}$`)));
const TP_ARC = new RegExp(String.raw`^ *(\d+)?: {2}P(R)?\[\d+\] \d+(mm|deg)/sec ${END}$`);
const TP_POSITION = [
  /^P\[\d+\]\{$/,
  /^ {3}GP1:$/,
  /^\tUF : \d+, UT : \d+,(\t\tCONFIG : CONFIG,)?$/,
  /^(\t(J\d|[XYZWPR] ?)= *-?\d*\.\d{3} +(mm|deg),?)+$/,
  /^\};$/,
].map((pattern) => new RegExp(pattern.source.replace('CONFIG :CONFIG', '').replace(': CONFIG', `: ${CONFIG}`)));

const KRL = [
  /^&(ACCESS RVP|REL 1)$/,
  /^DEF [A-Za-z_]\w{0,23} \( \)$/,
  /^DEFDAT [A-Za-z_]\w{0,23}$/,
  /^(END|ENDDAT)$/,
  /^;[ -~]*$/,
  /^GLOBAL INTERRUPT DECL 3 WHEN \$STOPMESS==TRUE DO IR_STOPM \( \)$/,
  /^INTERRUPT ON 3$/,
  /^BAS \(#(INITMOV|TOOL|BASE|VEL_PTP|ACC_PTP),\d+\)$/,
  /^\$(VEL\.CP|VEL\.ORI[12]|APO\.(CDIS|CPTP|CVEL))=\d+(\.\d+)?$/,
  /^(PTP|LIN) XP\d+( C_(PTP|DIS|VEL))*$/,
  /^CIRC XP\d+,XP\d+( C_(DIS|VEL))?$/,
  /^(WAIT SEC \d+(\.\d+)?|\$OUT\[\d+\]=(TRUE|FALSE)|WAIT FOR \$IN\[\d+\]==(TRUE|FALSE)|[A-Za-z_]\w{0,23} \( \))$/,
  /^DECL (AXIS|POS|FRAME) XP\d+=\{([A-Z]\d? (NUMBER|'B[01]+'),?)+\}$/,
].map((pattern) => new RegExp(pattern.source.replaceAll('NUMBER', NUMBER)));

/** Lines, the last of them ended, too; no other kind of line end. @param {string} text @param {string} end */
function linesOf(text, end) {
  if (!text.endsWith(end)) throw new Error('The last line has no end.');
  const lines = text.slice(0, -end.length).split(end);
  for (const line of lines) if (!/^[\t -~]*$/.test(line)) throw new Error(`Not plain: ${JSON.stringify(line)}`);
  return lines;
}

/** @param {string} line @param {readonly RegExp[]} patterns */
function expectKnown(line, patterns) {
  if (!patterns.some((pattern) => pattern.test(line))) throw new Error(`Not known: ${JSON.stringify(line)}`);
}

/** @param {{ name: string, language: string, text: string }} file @returns {string[]} its lines that are no comments */
export function readWritten({ name, language, text }) {
  if (language === 'karel') {
    const whole = linesOf(text, '\n').filter((line) => line !== '' && !KAREL_COMMENT.test(line));
    const lines = whole
      .join('\n')
      .replace(/ &\n +/g, ' ')
      .split('\n');
    for (const line of lines) expectKnown(line, KAREL);
    if (lines[0] !== `PROGRAM ${name.slice(0, -3)}`) throw new Error(`Called otherwise than its file: ${lines[0]}`);
    return lines;
  }
  const lines = linesOf(text, '\r\n');
  if (language === 'krl') {
    for (const line of lines) expectKnown(line, KRL);
    return lines.filter((line) => !line.startsWith(';'));
  }
  const [mn, pos] = [lines.indexOf('/MN'), lines.indexOf('/POS')];
  for (const line of [...lines.slice(0, mn + 1), '/POS', lines.at(-1) ?? '']) expectKnown(line, TP_HEAD);
  let count = 0;
  const own = lines.slice(mn + 1, pos).flatMap((line) => {
    if (TP_ARC.test(line)) return [line];
    const [, number, instruction] = /^ *(\d+):(.*)$/.exec(line) ?? [];
    if (Number(number) !== ++count) throw new Error(`Numbered wrongly: ${line}`);
    expectKnown(instruction, TP_LINES);
    return instruction.startsWith('  !') ? [] : [instruction];
  });
  for (const line of lines.slice(pos + 1, -1)) expectKnown(line, TP_POSITION);
  if (!lines.includes(`LINE_COUNT\t= ${count};`)) throw new Error(`Expected LINE_COUNT ${count}.`);
  return own;
}
