/**
 * What the language predefines: constants and files. The numbers are those that programs and manuals agree on; where only
 * the name is on record, its value is a number of our own, good for being handed on and nothing else.
 *
 * @import { Type } from './types.js'
 */
import { BOOLEAN, INTEGER, REAL } from './types.js';

/** @type {[Type, Record<string, number | boolean>][]} */
const GROUPS = [
  [BOOLEAN, { TRUE: true, FALSE: false, ON: true, OFF: false }],
  [INTEGER, { MAXINT: 2147483647, MININT: -2147483648 }],
  [REAL, { DEG_2_RAD: Math.fround(0.017453292519943295), RAD_2_DEG: Math.fround(57.29577951308232) }],
  [INTEGER, { JOINT: 6, LINEAR: 7, CIRCULAR: 8, FINE: 1, COARSE: 2, NOSETTLE: 3, NODECEL: 4, VARDECEL: 5 }],
  [INTEGER, { RSWORLD: 1, AESWORLD: 2, WRISTJOINT: 3 }],
];

/** Attributes of files, tasks and programs, and how programs are opened, of which only the names are on record. */
const NAMES_ONLY =
  `ATR_EOL ATR_FIELD ATR_IA ATR_MODEM ATR_PASSALL ATR_PIPOVADV ATR_PIPWAIT ATR_READAHD ATR_REVERSE ATR_TIMEOUT
  ATR_UF ATR_XONOFF PASSALL TSK_STATUS TSK_LINENUM TSK_PROGNAME TSK_ROUTNAME TSK_STACK TSK_LOCKGRP TSK_NOABORT TSK_NOPAUSE
  TSK_PAUSESFT TSK_PRIORITY TSK_TIMESLICE TSK_TPMOTION TSK_PROGTYPE TSK_MCTL TSK_TRACE TSK_TRACELEN TSK_STEP TSK_PARENT
  TSK_NOBUSY TSK_HOLDCOND TSK_ABORTED TSK_HALTED PG_RUNNING PG_PAUSED PG_ABORTED PG_RUNACCEPT PG_NOTEXIST WINDOW SCREEN
  PG_ABORTING PG_PAUSING MM_SELECT BRIGHT_SCR KY_ENTER KY_PREV FULL_SOLN TP_PANEL SPI_TPUSER
  TPE_RDACC TPE_RWACC TPE_NOREJ TPE_RDREJ TPE_WRTREJ TPE_ALLREJ PT_MNE_UNDEF PT_MNE_JOB PT_MNE_PROC PT_MNE_MACRO PT_MNE_COND
  AT_PROG_TYPE AT_PROG_NAME AT_OWNER AT_COMMENT AT_PROG_SIZE AT_PROTECT AT_DEF_GROUP`.split(/\s+/);

/** By name in capitals. @type {ReadonlyMap<string, { type: Type, value: number | boolean }>} */
export const PREDEFINED = new Map([
  ...GROUPS.flatMap(([type, group]) =>
    Object.entries(group).map(([name, value]) => /** @type {const} */ ([name, { type, value }])),
  ),
  ...NAMES_ONLY.map(
    (name, i) =>
      /** @type {const} */ ([
        name,
        { type: INTEGER, value: name === 'TSK_STATUS' ? 1 : name === 'TSK_LINENUM' ? 6 : 100 + i },
      ]),
  ),
]);

export const PREDEFINED_FILES = new Set(
  'OUTPUT INPUT TPDISPLAY TPPROMPT TPSTATUS TPFUNC TPERROR CRTPROMPT CRTSTATUS CRTFUNC CRTERROR KB CRT VIS_MONITOR'.split(
    ' ',
  ),
);

/** Directives, with what they take; `any` where nobody says. */
export const DIRECTIVES = new Set(
  `ALPHABETIZE CMOSVARS CMOS2SHADOW COMMENT CRTDEVICE DEFGROUP DELAY ENVIRONMENT INCLUDE LOCKGROUP NOABORT NOBUSYLAMP
   NOLOCKGROUP NOPAUSE NOPAUSESHFT PRIORITY SHADOWVARS STACKSIZE TIMESLICE TPMOTION UNINITVARS INVISIBLE SYSTEM POWERFAIL
   FLASHROM NOSCANSVARS RWACCESS FASTCMOSVAR SHCMOSVARS UNINITIALIZE UPDATEVARS`.split(/\s+/),
);
