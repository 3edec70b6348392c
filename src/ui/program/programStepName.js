/**
 * What a step is called beside its number, where there is little room.
 * @import { Doc, StepDoc } from '../../model/document.js'
 */
import { stepText } from './stepText.js';

/** What somebody called it; else its own name, unless that is nothing but numbers. @param {Doc} doc @param {StepDoc | undefined} step */
export function nameOfStep(doc, step) {
  if (!step) return '';
  if ('comment' in step && step.comment) return step.comment;
  const text = stepText(doc, step);
  return /[a-z]/i.test(text) ? text : '';
}
