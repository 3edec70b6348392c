import { expect, test } from 'vitest';
import { SCHEMA, readQueryParameters } from '../../../src/io/queryParameters.js';
import { LIBRARY_IDS } from '../../../src/model/shelf.js';
import { nearestNames } from '../../../src/ui/nearestNames.js';
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

test('of a robot that is not there, what may have been meant is named, and not the whole library', () => {
  expect(said('?robot=pumma560')).toEqual(['?robot=pumma560 is not understood. Did you mean puma560? Using puma560.']);
  expect(said('?robot=UR-5')).toEqual(['?robot=UR-5 is not understood. Did you mean ur5? Using puma560.']);
  expect(said('?robot=planar')[0]).toMatch(/Did you mean planar\w+ or planar\w+\?/);
  expect(said('?robot=r2d2')).toEqual(['?robot=r2d2 is not understood. Using puma560.']);
  expect(said('?robot=')).toEqual(['?robot= is not understood. Using puma560.']);
});

test('a name is near to itself however it is written, and after one slip of the hand', () => {
  for (const id of LIBRARY_IDS) {
    expect(nearestNames(id.toUpperCase().replaceAll('_', ' '), LIBRARY_IDS)[0]).toBe(id);
  }
  // of arms whose ids are like no other
  for (const id of ['puma560', 'stanford', 'spherical_wrist', 'fanuc_m10ia', 'mitsubishi_rv2aj']) {
    for (let i = 0; i < id.length; i++) {
      const [before, after] = [id.slice(0, i), id.slice(i + 1)];
      expect(nearestNames(`${before}${after}`, LIBRARY_IDS)).toContain(id);
      expect(nearestNames(`${before}${id[i]}${id[i]}${after}`, LIBRARY_IDS)).toContain(id);
      expect(nearestNames(`${before}${after[0] ?? ''}${id[i]}${after.slice(1)}`, LIBRARY_IDS)).toContain(id);
    }
  }
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
