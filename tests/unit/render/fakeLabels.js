/**
 * Labels without a page.
 * @import { Label } from '../../../src/render/labels.js'
 */
import { Vector3 } from 'three';

export function fakeLabels() {
  /** @type {(Label & { className: string, text: string })[]} */
  const all = [];
  return {
    all,
    /** @param {string} className @returns {Label} */
    add(className) {
      const label = {
        className,
        text: '',
        at: new Vector3(),
        parent: null,
        from: null,
        gap: 0,
        aside: false,
        visible: true,
        yields: false,
        stays: false,
        write: (/** @type {Parameters<Label['write']>[0]} */ text) =>
          void (label.text = typeof text === 'string' ? text : text.flat().join('')),
        remove: () => void all.splice(all.indexOf(label), 1),
      };
      all.push(label);
      return label;
    },
    /** @param {string} className */
    texts: (className) => all.filter((label) => label.className === className && label.visible).map(({ text }) => text),
  };
}
