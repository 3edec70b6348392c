/**
 * Date and time as KAREL packs them in 32 bits: years since 1980, month, day, hour, minute, pairs of seconds, from the highest bits down.
 */

const MONTHS = 'JANFEBMARAPRMAYJUNJULAUGSEPOCTNOVDEC';

/** @param {string} source  DD-MMM-YY HH:MM, with seconds or without @returns {number | undefined} */
export function packedTime(source) {
  const match = /^\s*(\d{1,2})-([A-Z]{3})-(\d{2}) +(\d{1,2}):(\d{2})(?::(\d{2}))?\s*$/i.exec(source);
  const month = match ? MONTHS.indexOf(match[2].toUpperCase()) / 3 + 1 : 0;
  if (!match || !Number.isInteger(month) || month < 1) return undefined;
  const [day, , year, hour, minute, second] = match.slice(1).map((part) => Number(part ?? 0));
  const years = year >= 80 ? year - 80 : year + 20;
  return packed(years, month, day, hour, minute, second);
}

/** @param {number} time */
export function timeText(time) {
  const two = (/** @type {number} */ value) => String(value).padStart(2, '0');
  const month = 3 * (((time >> 21) & 15) - 1);
  const [day, year, hour, minute] = [(time >> 16) & 31, (time >>> 25) + 80, (time >> 11) & 31, (time >> 5) & 63];
  return `${two(day)}-${MONTHS.slice(month, month + 3)}-${two(year % 100)} ${two(hour)}:${two(minute)}`;
}

/** The date on which the simulated clock begins, as a note of the run says: the 1st of January 2000. */
const [YEARS, JANUARY] = [20, 1];
const LAST_DAY = 31;
/** ms */
const SECOND = 10 ** 3;

/** What GET_TIME says. @param {number} time  of the program, ms @returns {number} */
export function packedClock(time) {
  const seconds = Math.trunc(time / SECOND);
  const [minutes, hours] = [Math.trunc(seconds / 60), Math.trunc(seconds / 3600)];
  const day = Math.min(LAST_DAY, 1 + Math.trunc(hours / 24));
  return packed(YEARS, JANUARY, day, hours % 24, minutes % 60, seconds % 60);
}

/** @param {number} years @param {number} month @param {number} day @param {number} hour @param {number} minute @param {number} second */
const packed = (years, month, day, hour, minute, second) =>
  (years << 25) | (month << 21) | (day << 16) | (hour << 11) | (minute << 5) | (second >> 1);
