/** Elements of a drawing, from data; text stays text, as in dom.js. */

/**
 * @param {string} tag
 * @param {Record<string, string | number | null>} attributes  null: absent
 * @param {...(SVGElement | string)} children
 */
export function svg(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}
