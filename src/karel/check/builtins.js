/**
 * The built-in routines and functions: one table for the checker, the interpreter and whoever offers names while typing.
 *
 * A line is a name, parameters, and behind > what a function gives. A parameter is `name:type`, with * before it where the
 * variable is set, ~ where the controller keeps something in it, and ? where it may be left out. Types: I integer, R real, N either, S string, B boolean, P any position,
 * J joint values, K a Cartesian position, V vector, C config, A array, L one of REAL, H path, F file, X anything.
 *
 * From the public record of the language; where the sources disagree, the entry says so. ATAN2 takes (x, y) here, by
 * evidence of programs that were run; a list of built-ins says (y, x).
 */

const TABLE = `
ABS x:N > =
ROUND x:R > I
TRUNC x:R > I
SQRT x:R > R
EXP x:R > R
LN x:R > R
SIN angle:R > R
COS angle:R > R
TAN angle:R > R
ASIN x:R > R
ACOS x:R > R
ATAN2 x:R y:R > R
POS x:R y:R z:R w:R p:R r:R config:C > XYZWPR
UNPOS position:P *x:R *y:R *z:R *w:R *p:R *r:R *config:C
INV position:P > POSITION
MIRROR position:P frame:P turns:B > POSITION
FRAME origin:P on_x:P on_xy:P ?second:P > POSITION
APPROACH position:P > V
ORIENT position:P > V
NORMAL position:P > V
CURPOS limits:I speeds:I ?group:I > XYZWPREXT
CURJPOS limits:I speeds:I ?group:I > JOINTPOS
CNV_JPOS_REL joints:J *values:L *status:I
CNV_REL_JPOS values:L *joints:J *status:I
CNV_CONF_STR config:C *text:S
CNV_STR_CONF text:S *config:C *status:I
IN_RANGE position:P ?group:I > B
J_IN_RANGE joints:J ?group:I > B
CHECK_EPOS position:P user_frame:P tool:P *status:I ?group:I
JOINT2POS joints:J user_frame:P tool:P reference:X *position:K *config:X *ext:L *status:I
POS2JOINT reference:P position:P user_frame:P tool:P config_ref:X config:X ext:L *joints:J *status:I
SET_PERCH joints:J tolerances:L *status:I
GET_REG number:I *is_real:B *integer:I *real:R *status:I
SET_INT_REG number:I value:I *status:I
SET_REAL_REG number:I value:R *status:I
GET_POS_REG number:I *status:I ?group:I > XYZWPREXT
SET_POS_REG number:I position:P *status:I ?group:I
SET_EPOS_REG number:I position:P *status:I ?group:I
GET_JPOS_REG number:I *status:I ?group:I > JOINTPOS
SET_JPOS_REG number:I joints:J *status:I ?group:I
CLR_POS_REG number:I group:I *status:I
POS_REG_TYPE number:I group:I *type:I *axes:I *status:I
GET_STR_REG number:I *text:S *status:I
SET_STR_REG number:I text:S *status:I
GET_REG_CMT number:I *text:S *status:I
SET_REG_CMT number:I text:S *status:I
GET_PREG_CMT number:I *text:S *status:I
SET_PREG_CMT number:I text:S *status:I
GET_SREG_CMT number:I *text:S *status:I
SET_SREG_CMT number:I text:S *status:I
GET_TPE_PRM number:I *type:I *integer:I *real:R *text:S *status:I
CALL_PROG name:S ~index:I
CALL_PROGLIN name:S line:I ~index:I pause:B
CURR_PROG > S
RUN_TASK name:S line:I pause:B motion:B mask:I *status:I
ABORT_TASK name:S force:B cancel:B *status:I
PAUSE_TASK name:S force:B stop:B *status:I
CONT_TASK name:S *status:I
GET_TSK_INFO *name:S *number:I attribute:I *integer:I *text:S *status:I
MOTION_CTL ?mask:I > B
LOCK_GROUP mask:I *status:I
UNLOCK_GROUP mask:I *status:I
CLEAR_SEMA number:I
POST_SEMA number:I
PEND_SEMA number:I timeout:I *timed_out:B
SEMA_COUNT number:I > I
CHR code:I > S
ORD text:S index:I > I
STR_LEN text:S > I
SUB_STR text:S start:I length:I > S
INDEX text:S find:S > I
CNV_INT_STR value:I length:I base:I *text:S
CNV_REAL_STR value:R length:I digits:I *text:S
CNV_STR_INT text:S *value:I
CNV_STR_REAL text:S *value:R
CNV_TIME_STR time:I *text:S
CNV_STR_TIME text:S *time:I
GET_VAR *entry:I program:S name:S *value:X *status:I
SET_VAR *entry:I program:S name:S value:X *status:I
UNINIT variable:X > B
ARRAY_LEN array:A > I
SET_FILE_ATR file:F attribute:I ?value:X
IO_STATUS file:F > I
CLR_IO_STAT file:F
BYTES_AHEAD file:F *count:I *status:I
BYTES_LEFT file:F > I
GET_FILE_POS file:F > I
SET_FILE_POS file:F position:I *status:I
DELETE_FILE path:S nowait:B *status:I
COPY_FILE from:S to:S overwrite:B nowait:B *status:I
RENAME_FILE from:S to:S nowait:B *status:I
MSG_CONNECT tag:S *status:I
MSG_DISCO tag:S *status:I
MSG_PING host:S *status:I
GET_PORT_VAL type:I number:I *value:I *status:I
SET_PORT_VAL type:I number:I value:I *status:I
GET_PORT_SIM type:I number:I *simulated:B *status:I
SET_PORT_SIM type:I number:I value:I *status:I
POST_ERR code:I text:S cause:I severity:I
ERR_DATA *number:I *code:I *text:S *cause:I *cause_text:S *time:I *severity:I *program:S
GET_TIME *time:I
GET_USEC_TIM > I
FORCE_SPMENU device:I menu:I screen:I
KCL command:S *status:I
KCL_NO_WAIT command:S *status:I
PATH_LEN path:H > I
APPEND_NODE path:H *status:I
INSERT_NODE path:H index:I *status:I
DELETE_NODE path:H index:I *status:I
COPY_PATH from:H first:I last:I to:H *status:I
NODE_SIZE path:H > I
`;

/** Known to exist; how they are called is not on record here, so that anything is taken. */
const WITHOUT_SIGNATURE = new Set(
  `ACT_SCREEN ADD_BYNAMEPC ADD_DICT ADD_INTPC ADD_REALPC ADD_STRINGPC ATT_WINDOW_D ATT_WINDOW_S AVL_POS_NUM APPEND_FILE
   APPEND_QUEUE CHECK_DICT CHECK_NAME CLEAR CLOSE_TPE CLR_PORT_SIM CNC_DYN_DISB CNC_DYN_DISE CNC_DYN_DISI CNC_DYN_DISP
   CNC_DYN_DISR CNC_DYN_DISS CNCL_STP_MTN COMPARE_FILE COPY_QUEUE COPY_TPE CREATE_TPE CREATE_VAR DEF_SCREEN DEF_WINDOW
   DELETE_QUEUE DEL_INST_TPE DET_WINDOW DISCTRL_ALPH DISCTRL_FORM DISCTRL_LIST DISCTRL_PLMN DISCTRL_SBMN DISCTRL_TBL
   DISMOUNT_DEV DOSFILE_INF FILE_LIST FORMAT_DEV GET_ATTR_PRG GET_JPOS_TPE GET_PORT_ASG GET_PORT_ATR GET_PORT_CMT
   GET_PORT_MOD GET_POS_FRM GET_POS_TPE GET_POS_TYP GET_PREG_CMT GET_QUEUE GET_TCP_INFO GET_USER_NAME INIT_QUEUE INIT_TBL
   INI_DYN_DISB INI_DYN_DISE INI_DYN_DISI INI_DYN_DISP INI_DYN_DISR INI_DYN_DISS INSERT_QUEUE IO_MOD_TYPE KCL_STATUS LOAD
   LOAD_STATUS MODIFY_QUEUE MOUNT_DEV MOVE_FILE OPEN_TPE POST_ERR_L POP_KEY_RD PRINT_FILE PROG_LIST
   PROG_BACKUP PROG_CLEAR PROG_RESTORE PUSH_KEY_RD PURGE_DEV QUEUE_TYPE READ_DICT READ_DICT_V READ_KB REMOVE_DICT RENAME_VAR
   RENAME_VARS RESET SAVE SAVE_DRAM SELECT_TPE SEND_DATAPC SEND_EVENTPC SET_ATTR_PRG SET_CURSOR SET_EPOS_TPE SET_JPOS_TPE
   SET_LANG SET_PORT_ASG SET_PORT_ATR SET_PORT_CMT SET_PORT_MOD SET_POS_TPE SET_TIME SET_TRNS_TPE SET_TSK_ATTR SET_TSK_NAME
   SET_TPE_PRM TRANSLATE UNPOS_EXT UPD_INT_REG V_CAM_CALIB VAR_INFO VAR_LIST VOL_SPACE WRITE_DICT WRITE_DICT_V XML_ADDTAG
   XML_GETDATA XML_REMTAG XML_SCAN XML_SETVAR CNV_JPOS_POS CNV_POS_JPOS CANCEL_RDKB HTTP_GET CURR_TASK VEC EVAL ISNAN RESET_UFRM
   GET_FILE_ATR IN_AUTO_MODE ROTATE TRNSPOSE`.split(/\s+/),
);

/**
 * @typedef {{ name: string, type: string, isSet: boolean, isKept: boolean, isOptional: boolean }} Parameter
 * @typedef {{ name: string, parameters: readonly Parameter[], gives: string | null }} Builtin
 */

/** By name in capitals. @type {ReadonlyMap<string, Builtin>} */
export const BUILTINS = new Map(
  TABLE.trim()
    .split('\n')
    .map((line) => {
      const [head, gives = null] = line.split(' > ');
      const [name, ...list] = head.trim().split(' ');
      const parameters = list.map((text) => {
        const [, mark, parameter, type] = /^([*?~]?)(\w+):(\w)$/.exec(text) ?? [];
        return { name: parameter, type, isSet: mark === '*', isKept: mark === '~', isOptional: mark === '?' };
      });
      return [name, { name, parameters, gives: gives?.trim() ?? (head.startsWith('CURR_PROG') ? 'S' : null) }];
    }),
);

/** @param {string} name */
export const isKnownRoutine = (name) =>
  BUILTINS.has(name.toUpperCase()) ||
  WITHOUT_SIGNATURE.has(name.toUpperCase()) ||
  /^(V|VT|VREG|DAQ|R|MIR|MH|IRV)_?[A-Z]+_\w+$/i.test(name);

/** As one would write it down: `CNV_INT_STR(value, length, base : INTEGER; VAR text : STRING)`. @param {Builtin} builtin */
export function signatureText({ name, parameters, gives }) {
  const list = parameters.map(
    (one) => `${one.isSet ? 'VAR ' : ''}${one.name} : ${WORDS[one.type]}${one.isOptional ? ' (optional)' : ''}`,
  );
  return `${name}${list.length ? `(${list.join('; ')})` : ''}${gives ? ` : ${WORDS[gives] ?? gives}` : ''}`;
}

/** @type {Readonly<Record<string, string>>} */
export const WORDS = {
  ...{
    I: 'INTEGER',
    R: 'REAL',
    N: 'INTEGER or REAL',
    S: 'STRING',
    B: 'BOOLEAN',
    P: 'a position',
    V: 'VECTOR',
    C: 'CONFIG',
  },
  ...{
    J: 'JOINTPOS',
    K: 'a Cartesian position',
    A: 'ARRAY',
    L: 'ARRAY OF REAL',
    H: 'PATH',
    F: 'FILE',
    X: 'anything',
    '=': 'the same',
  },
};
