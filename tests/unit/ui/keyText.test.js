import { expect, test } from 'vitest';
import { keyText } from '../../../src/ui/parts/keyText.js';

/** A field with “|” where the cursor stands, or around what is chosen. @param {string} shown @param {Parameters<typeof keyText>[0][]} keys */
function typed(shown, ...keys) {
  const [before, ...rest] = shown.split('|');
  const [chosen, after] = rest.length === 1 ? ['', rest[0]] : rest;
  let value = before + chosen + after;
  let [from, to] = [before.length, before.length + chosen.length];
  for (const key of keys) {
    const { text, start, end } = keyText(key, value, from, to);
    value = value.slice(0, start) + text + value.slice(end);
    from = to = start + text.length;
  }
  return value;
}

test('a unit and a division go behind the number that is chosen; a sign begins anew', () => {
  expect(typed('|431.8|', 'inch')).toBe('431.8 in');
  expect(typed('|90|', 'deg')).toBe('90°');
  expect(typed('|π|', 'divide')).toBe('π/');
  expect(typed('|431.8|', 'minus')).toBe('−');
  expect(typed('|431.8|', 'pi', 'divide')).toBe('π/');
  expect(typed('12|.5', 'mm')).toBe('12 mm.5'); // where the cursor stands
});

test('one key opens and closes brackets', () => {
  expect(typed('|', 'root', 'brackets', 'pi', 'brackets')).toBe('√(π)');
  expect(typed('2|', 'divide', 'brackets', 'brackets', 'pi', 'brackets', 'brackets')).toBe('2/((π))');
  expect(typed('|1 + 2|', 'brackets', 'divide', 'pi')).toBe('(1 + 2)/π');
  expect(typed('(1)|', 'brackets')).toBe('(1)(');
});
