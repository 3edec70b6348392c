/**
 * What an empty panel says: how the first thing gets there, and the button that brings it.
 */
import { h } from './dom.js';

/** @param {string} title @param {string} detail @param {HTMLElement} action */
export const emptyState = (title, detail, action) =>
  h('div', { class: 'empty' }, h('h2', {}, title), h('p', {}, detail), action);
