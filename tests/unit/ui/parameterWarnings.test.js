import { expect, test } from 'vitest';
import { SCHEMA, readQueryParameters } from '../../../src/io/queryParameters.js';
import { refusedInWords, startFaultInWords } from '../../../src/ui/parameterWarnings.js';

/** @param {string} search */
const said = (search) => refusedInWords(readQueryParameters(search, SCHEMA).refused);

test('a warning names the parameter, what came, what was expected and what is used', () => {
  expect(said('?theme=pink')).toEqual(['?theme=pink is not understood. Expected auto, light or dark.']);
  expect(said('?quality=no')).toEqual(['?quality=no is not understood. Expected high or low. Using high.']);
  expect(said('?q=a')).toEqual([
    '?q=a is not understood. Expected a number for each joint, with commas between, as in 0,45,-90.',
  ]);
  expect(said('?panels=cat')[0]).toMatch(/^\?panels=cat is not understood\. Expected some of robot, program, /);
  expect(said('?units=ell')[0]).toContain('a unit of length (mm, cm or m), one of angle (deg or rad), or both');
});

test('a long address makes short warnings, one for all that does not exist', () => {
  const many = Array.from({ length: 500 }, (_, i) => `x${i}=1`).join('&');
  expect(said(`?${many}`)).toEqual(['There are no parameters ?x0, ?x1, ?x2, ?x3 and 496 more.']);
  expect(said(`?q=${'9'.repeat(5000)}`)[0].length).toBeLessThan(200);
  expect(said(`?${'n'.repeat(5000)}=1`)[0].length).toBeLessThan(120);
});

test('what the robot cannot do is said with numbers', () => {
  expect(startFaultInWords({ code: 'count', given: 1, joints: 6 }, 'UR5')).toBe(
    '?q was left out: it has 1 value, and UR5 has 6 joints.',
  );
  expect(startFaultInWords({ code: 'outside', joints: [0, 2] }, 'UR5')).toContain('J1, J3 outside its limits');
});
