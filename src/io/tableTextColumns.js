/**
 * What the columns of a pasted table are, and what its cells say: which parameter, in which unit, and where the variable of
 * the joint is in it (q₁, θ₁*, d₃*), which tells a joint that turns from one that slides.
 *
 * @import { DhField, Units } from '../model/document.js'
 * @typedef {DhField | 'offset' | 'none'} ColumnRole  offset: what is added to the joint value, apart from the table's own
 * @typedef {'symbol' | 'two-variables' | 'minus'} CellFault
 *
 * @typedef {object} PastedCell
 * @property {string} raw    as it was pasted
 * @property {string} text   of the number in it, an expression; empty where there is none
 * @property {CellFault | null} fault
 *
 * @typedef {{ readonly type: 'revolute' | 'prismatic' | null, readonly cells: Partial<Record<DhField, PastedCell>> }} PastedRow
 *
 * @typedef {object} ColumnGuess
 * @property {readonly ColumnRole[]} roles
 * @property {boolean} hasHead   the first row names the columns
 * @property {boolean} isNamed   the roles come from names, not from the usual order
 * @property {boolean} isModified  the names are those of the modified convention: a and α of i − 1
 * @property {{ length?: PastedUnits['length'], angle?: Units['angle'] }} units  that the names tell
 * @property {Partial<Record<DhField, Partial<PastedUnits>>>} others  those of columns whose name tells another unit than that
 *
 * @typedef {{ length: Units['length'] | 'in', angle: Units['angle'] }} PastedUnits  a table may be in inches
 */
const ROLE_NAMES = /** @type {const} */ ([
  ['theta', /^(θ|ϑ|theta|th|joint angle|angle)$/],
  ['d', /^(d|link offset|offset d|d offset)$/],
  ['a', /^(a|r|link length|length)$/],
  ['alpha', /^(α|⍺|alpha|link twist|twist|twist angle|link twist angle)$/],
  ['offset', /^(offset|joint offset|q offset|θ offset|theta offset)$/],
  [
    'none',
    /^(i|j|n|k|#|no\.?|joint|link|joint i|link i|frame|row|type|kind|sigma|σ|q[-−⁻+⁺]?|min|max|lower|upper|q ?min|q ?max|limits?|)$/,
  ],
]);

/** @type {Record<'standard' | 'modified', readonly DhField[]>} as their books write them */
export const USUAL_ORDER = { standard: ['theta', 'd', 'a', 'alpha'], modified: ['alpha', 'a', 'd', 'theta'] };

/** The unit that the later ones tell is that of the others. */
const DH_ORDER = /** @type {const} */ (['theta', 'd', 'a', 'alpha']);

const UNIT = /[([/,]?\s*(?:\bin\s+)?(?:\b(?:mm|cm|m|in|inch|inches|deg|degrees?|rad|radians?)\b\.?|°)\s*[)\]]?\s*$/i;
/** Beside words, as in “link length aᵢ”. */
const SYMBOL = /^(θ|ϑ|theta|d|a|α|⍺|alpha)$/;
const INDEX = /[_\s]*[([]?\s*(i\s*[-−]\s*1|i|j|n|k|ᵢ|ⱼ|ᵢ₋₁|ⱼ₋₁)\s*[)\]]?$/;

/** @param {string} cell @returns {{ role: ColumnRole | null, isBefore: boolean, unit: string | null }} */
function headOf(cell) {
  const unit = UNIT.exec(cell)?.[0].toLowerCase() ?? null;
  const named = (unit ? cell.replace(UNIT, '') : cell).trim();
  const isBefore = /i\s*[-−]\s*1|ᵢ₋₁|ⱼ₋₁|j\s*[-−]\s*1/.test(named);
  const name = named.toLowerCase();
  const bare = name.replace(INDEX, '').trim();
  const found =
    ROLE_NAMES.find(([, pattern]) => pattern.test(name)) ??
    ROLE_NAMES.find(([, pattern]) => bare !== '' && pattern.test(bare)) ??
    ROLE_NAMES.find(([, pattern]) => pattern.test(symbolIn(name)));
  return { role: found?.[0] ?? null, isBefore, unit };
}

/** The one symbol among the words of a name. @param {string} name */
function symbolIn(name) {
  const symbols = name.split(/[\s,;:()]+/).flatMap((word) => word.replace(INDEX, '').match(SYMBOL)?.[0] ?? []);
  return symbols.length === 1 ? symbols[0] : '?';
}

/** @param {string} unit as in a name @returns {Partial<PastedUnits>} */
function unitCalled(unit) {
  if (/deg|°/.test(unit)) return { angle: 'deg' };
  if (/rad/.test(unit)) return { angle: 'rad' };
  return { length: /mm/.test(unit) ? 'mm' : /cm/.test(unit) ? 'cm' : /\bin\b(?!\s+m)|inch/.test(unit) ? 'in' : 'm' };
}

/**
 * @param {readonly (readonly string[])[]} rows  at least one
 * @param {'standard' | 'modified'} convention  of the document
 * @returns {ColumnGuess}
 */
export function guessColumns(rows, convention) {
  const heads = rows[0].map(headOf);
  const named = heads.filter(({ role }) => role !== null && role !== 'none');
  const hasNumbers = rows[0].some((cell) => /^[-+−]?\d/.test(cell));
  if (named.length >= 2 && !hasNumbers) {
    const roles = once(heads.map(({ role }) => role ?? 'none'));
    const told = DH_ORDER.flatMap((field) => {
      const unit = heads[roles.indexOf(field)]?.unit;
      return unit ? [/** @type {const} */ ([field, unitCalled(unit)])] : [];
    });
    /** @type {ColumnGuess['units']} */
    const units = Object.assign({}, ...told.map(([, unit]) => unit));
    const others = Object.fromEntries(
      told.filter(
        ([, { length, angle }]) => (length ?? units.length) !== units.length || (angle ?? units.angle) !== units.angle,
      ),
    );
    const isModified = heads.some(({ role, isBefore }) => isBefore && (role === 'a' || role === 'alpha'));
    return { roles, hasHead: true, isNamed: true, isModified, units, others };
  }
  const start = rows[0].length > 4 && isNumbering(rows.map((row) => row[0])) ? 1 : 0;
  const { standard, modified } = USUAL_ORDER;
  const names = convention === 'standard' ? [standard, modified] : [modified, standard];
  const orders = names.map((name) => [...Array(start).fill('none'), ...name]);
  const suits = (/** @type {string[]} */ order) => rows.some((row) => TURN.test(row[order.indexOf('theta')] ?? ''));
  const order = suits(orders[0]) || !suits(orders[1]) ? orders[0] : orders[1];
  const roles = rows[0].map((_, column) => /** @type {ColumnRole} */ (order[column] ?? 'none'));
  return { roles, hasHead: false, isNamed: false, isModified: false, units: {}, others: {} };
}

/** A second column of the same name is not used. @param {ColumnRole[]} roles */
const once = (roles) => roles.map((role, i) => (roles.indexOf(role) === i ? role : 'none'));

/** @param {readonly string[]} cells */
const isNumbering = (cells) =>
  cells.every((cell, i) => cell.replace(/\D/g, '') === String(i + Number(cells[0].replace(/\D/g, '') || 1)));

const SUBSCRIPT = '_?\\(?[\\di₀-₉]*\\)?';
const TURN = new RegExp(`(θ|ϑ|theta|q)${SUBSCRIPT}\\s*\\*?(\\(t\\))?`, 'i');
const SLIDE = new RegExp(`(d|q)${SUBSCRIPT}\\s*\\*?(\\(t\\))?(?![a-z])`, 'i');
const ALONE = /^(\*|var\.?|variable)$/i;
const NUMBER_WORDS = /\b(pi|sqrt|sin|cos|tan|asin|acos|atan|abs|mm|cm|m|in|deg|rad)\b|\d(e)[-+]?\d/gi;

/**
 * @param {readonly string[]} row  without the head
 * @param {readonly ColumnRole[]} roles
 * @returns {PastedRow}
 */
export function readPastedRow(row, roles) {
  const raw = (/** @type {ColumnRole} */ role) => row[roles.indexOf(role)];
  const [theta, d, offset] = [raw('theta'), raw('d'), raw('offset')];
  const turns = theta !== undefined && (ALONE.test(theta) || TURN.test(theta));
  const isStarred = d !== undefined && (ALONE.test(d) || /\*\s*$|^q|\(t\)/i.test(d.replace(/\d\s*\*\s*\d/g, '')));
  const slides =
    d !== undefined && (isStarred || (!turns && theta !== undefined && SLIDE.test(d.replace(/deg/gi, ''))));
  /** @type {PastedRow['cells']} */
  const cells = {};
  if (theta !== undefined) cells.theta = variableCell(theta, turns ? TURN : null);
  if (d !== undefined) cells.d = variableCell(d, slides ? SLIDE : null);
  for (const field of /** @type {const} */ (['a', 'alpha'])) {
    const cell = raw(field);
    if (cell !== undefined) cells[field] = variableCell(cell, null);
  }
  if (turns && slides && cells.d) cells.d = { ...cells.d, fault: 'two-variables' };
  const type = slides ? 'prismatic' : turns ? 'revolute' : null;
  const moved = slides ? 'd' : 'theta';
  if (offset !== undefined && offset !== '' && offset !== '-') {
    const cell = cells[moved];
    const isEmpty = !cell || cell.text === '' || cell.text === '0';
    cells[moved] = {
      ...{ raw: [cell?.raw, offset].filter(Boolean).join(' + '), fault: cell?.fault ?? null },
      text: isEmpty ? offset : `${cell.text} + ${offset}`,
    };
  }
  return { type, cells };
}

/** @param {string} raw @param {RegExp | null} variable  that it has in it @returns {PastedCell} */
function variableCell(raw, variable) {
  if (variable && ALONE.test(raw)) return { raw, text: '0', fault: null };
  const rest = variable ? raw.replace(variable, '').trim() : raw.trim();
  if (variable && /[-−]\s*$/.test(rest)) return { raw, text: '', fault: 'minus' };
  const text = variable ? rest.replace(/^\+\s*|\s*\+$|(?<=^[-−])\s+/g, '').trim() || '0' : rest;
  if (/^[-−–—]$/.test(text)) return { raw, text: '', fault: null };
  const strange = /\p{L}/u.test(text.replace(NUMBER_WORDS, '').replace(/π/g, ''));
  return { raw, text, fault: strange ? 'symbol' : null };
}
