/** What was typed for a number lives and dies with it. */
import { expect, test } from 'vitest';
import { readRobotXml } from '../../../src/io/robotXml.js';
import { writeRobotXml } from '../../../src/io/robotXmlWriter.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';

/** @typedef {import('../../../src/model/session.js').AppState} AppState */

const start = () => startState(newDocument(LIBRARY.puma560));
const set = (/** @type {number} */ value, /** @type {string} */ text, /** @type {string} */ gesture) =>
  /** @type {const} */ ({ type: 'set-joint-field', joint: 3, field: 'alpha', value, text, gesture });
const plainly = (/** @type {number} */ value) =>
  /** @type {const} */ ({ type: 'set-joint-field', joint: 3, field: 'alpha', value });
const textOf = (/** @type {AppState} */ state) => state.doc.robot.joints[3].text;

test('a text is kept with its number, undone and redone with it, and erased by a plain number', () => {
  const first = start();
  const typed = reduce(first, set(90, 'pi/2 rad', 'a'));
  expect(textOf(typed)).toEqual({ alpha: 'pi/2 rad' });
  const other = reduce(typed, { type: 'set-joint-field', joint: 3, field: 'd', value: 304.8, text: '12 in' });
  expect(textOf(other)).toEqual({ alpha: 'pi/2 rad', d: '12 in' });
  expect(textOf(reduce(other, plainly(90)))).toEqual({ d: '12 in' });
  expect(reduce(typed, plainly(90)).doc).toEqual(first.doc);
  const undone = reduce(other, { type: 'undo' });
  expect(textOf(undone)).toEqual({ alpha: 'pi/2 rad' });
  expect(textOf(reduce(undone, { type: 'redo' }))).toEqual({ alpha: 'pi/2 rad', d: '12 in' });
});

test('the same number and text again is no change; another text for the same number is one', () => {
  const typed = reduce(start(), set(90, '180/2', 'a'));
  expect(reduce(typed, set(90, '180/2', 'b')).doc).toBe(typed.doc);
  expect(textOf(reduce(typed, set(90, '45*2', 'b')))).toEqual({ alpha: '45*2' });
  expect(start().doc).not.toBe(reduce(start(), plainly(-90)).doc);
});

test('a text survives being saved and opened', () => {
  const { doc } = reduce(start(), set(90, '  √(8100) <"&π/2', 'a'));
  expect(readRobotXml(writeRobotXml(doc)).doc).toEqual(doc);
});

test.each([
  ['', 'got ""'],
  ['a\nb', 'a line'],
  ['\ud800', 'a line'],
  ['x'.repeat(201), 'got a longer one'],
])('the text %j is refused', (text, reason) => {
  expect(refusal(start().doc, set(90, text, 'a'))?.message).toContain(reason);
});

test('a text for a limit is refused', () => {
  const command = /** @type {const} */ ({ type: 'set-joint-field', joint: 0, field: 'lower', value: -90, text: '-90' });
  expect(refusal(start().doc, command)?.message).toBe('No text is kept for a lower limit; got "-90".');
});
