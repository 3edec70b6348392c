/** Listings for tests: a whole file around the lines and positions that matter. */

/**
 * @param {readonly string[]} lines       instructions, without numbers; more lines of one after "\n"
 * @param {readonly string[]} [positions]
 * @param {{ name?: string, group?: string, lineEnd?: string }} [more]
 */
export function listing(lines, positions = [], { name = 'DEMO', group = '1,*,*,*,*', lineEnd = '\n' } = {}) {
  const numbered = lines.map((line, i) => `${String(i + 1).padStart(4)}:${line.replaceAll('\n', '\n    :')} ;`);
  return [
    `/PROG  ${name}`,
    '/ATTR',
    'OWNER\t\t= MNEDITOR;',
    'COMMENT\t\t= "for a test";',
    `LINE_COUNT\t= ${lines.length};`,
    'TCD:  STACK_SIZE\t= 0,',
    '      TASK_PRIORITY\t= 50;',
    `DEFAULT_GROUP\t= ${group};`,
    '/APPL',
    '',
    '/MN',
    ...numbered,
    '/POS',
    ...positions,
    '/END',
    '',
  ]
    .join('\n')
    .replaceAll('\n', lineEnd);
}

/** @param {number} number @param {readonly number[]} xyzwpr @param {{ uf?: number | 'F', ut?: number | 'F', config?: string }} [more] */
export function cartesian(number, [x, y, z, w, p, r], { uf = 0, ut = 1, config = 'N U T, 0, 0, 0' } = {}) {
  return `P[${number}]{
   GP1:
	UF : ${uf}, UT : ${ut},		CONFIG : '${config}',
	X =   ${x}  mm,	Y =   ${y}  mm,	Z =   ${z}  mm,
	W =   ${w} deg,	P =   ${p} deg,	R =   ${r} deg
};`;
}

/** @param {number} number @param {readonly number[]} joints @param {{ uf?: number | 'F', ut?: number | 'F' }} [more] */
export function joints(number, joints, { uf = 0, ut = 1 } = {}) {
  return `P[${number}:"by joints"]{
   GP1:
	UF : ${uf}, UT : ${ut},
	${joints.map((value, i) => `J${i + 1}= ${value} deg`).join(',	')}
};`;
}
