import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { readRobotFile } from '../../../src/io/robotFile.js';
import { readRobotXml } from '../../../src/io/robotXml.js';
import { readUrdf } from '../../../src/io/urdf.js';
import { robotFile } from './files.js';

const urdf = (/** @type {string} */ name) =>
  readFileSync(new URL(`../../fixtures/urdf/${name}.urdf`, import.meta.url), 'utf8');

test('the root element tells which format it is', () => {
  expect(readRobotFile(robotFile())).toEqual(readRobotXml(robotFile()));
  const text = urdf('ur5');
  const { doc, issues, choices, snaps } = readUrdf(text);
  expect(readRobotFile(text)).toEqual({ doc, issues, chain: { choices, snaps, read: expect.any(Function) } });
  const styled = readRobotFile(text.replace(/<robot/, '<?xml-stylesheet href="a.css"?>$&'));
  expect(styled.chain?.read({ tipLink: 'wrist_3_link' }).issues.map(({ code }) => code)).toEqual(['not-read']);
  expect(readRobotFile('<sdf/>').issues[0].message).toContain('expected version 1.5 or later');
  expect(readRobotFile('<mujoco/>').issues[0].message).toContain('is in the format MJCF');
  expect(readRobotFile('').issues[0].code).toBe('empty');
});

test('axes that are nearly parallel are told, with what is the matter', () => {
  const { doc, issues } = readRobotFile(urdf('yguel_scara'));
  expect(doc).not.toBe(null);
  expect(issues.map(({ code, severity, message }) => [code, severity, message])).toContainEqual([
    'nearly-parallel',
    'warning',
    'The axes of joints 2 and 3 are 0.091° from parallel, so that the exact table has long links; parallel axes would move the tool by 0.00047 m at most.',
  ]);
});
