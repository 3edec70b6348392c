/**
 * The parts of Bootstrap's stylesheet that the page uses, picked from the whole when it is built: what has no class (the
 * reset), and what has only classes of the families below. Custom properties that nothing of it reads go as well. A test
 * compares the list with the classes that the sources name.
 *
 * @import { Plugin, Root } from 'postcss'
 */

/** Families: `btn` is .btn and .btn-primary, not .btn-close (see VARIANTS). */
const FAMILIES = ['btn', 'dropdown', 'modal', 'form-check', 'form-switch', 'form-control', 'form-range', 'form-select'];

const SINGLE = [
  'show',
  'fade',
  'collapse',
  'collapsing',
  'visually-hidden',
  'visually-hidden-focusable',
  'disabled',
  'active',
  'is-invalid',
];

/** Of the families, what the page draws by its own tokens, or not at all. */
const VARIANTS =
  /^(btn-(?!primary$|check$).*|dropdown-(menu-(dark|(sm|md|lg|xl|xxl)-.*)|toggle.*)|modal-fullscreen(?!-sm-down$).*|form-(check-inline|check-reverse|control-(color|plaintext|lg)|select-lg))$/;

/** Custom properties that Bootstrap's scripts ask for. */
const READ_BY_SCRIPTS = ['--bs-position'];

/** @param {string} name of a class of Bootstrap */
export const isKept = (name) =>
  SINGLE.includes(name) ||
  (FAMILIES.some((family) => name === family || name.startsWith(`${family}-`)) && !VARIANTS.test(name));

/** @param {string} selector */
export const classesIn = (selector) => [...selector.matchAll(/\.(-?[_a-zA-Z][\w-]*)/g)].map(([, name]) => name);

/** @returns {Plugin} */
export const bootstrapParts = () => ({
  postcssPlugin: 'bootstrap-parts',
  Once(root) {
    if (/[\\/]bootstrap[\\/]dist[\\/]css[\\/]/.test(root.source?.input.file ?? '')) keepParts(root);
  },
});

/** @param {Root} root */
function keepParts(root) {
  root.walkRules((rule) => {
    const kept = rule.selectors.filter((selector) => classesIn(selector.replace(/:not\([^)]*\)/g, '')).every(isKept));
    if (kept.length === 0) rule.remove();
    else if (kept.length < rule.selectors.length) rule.selectors = kept;
  });
  for (let isDone = false; !isDone;) {
    const read = new Set(READ_BY_SCRIPTS);
    root.walkDecls(({ value }) => [...value.matchAll(/var\((--[\w-]+)/g)].forEach(([, name]) => read.add(name)));
    isDone = true;
    root.walkDecls(/^--/, (declaration) => {
      if (read.has(declaration.prop)) return;
      declaration.remove();
      isDone = false;
    });
  }
  root.walkAtRules('keyframes', (rule) => void rule.remove());
  root.walkRules((rule) => void (rule.nodes.length === 0 && rule.remove()));
  root.walkAtRules('media', (rule) => void (rule.nodes?.length === 0 && rule.remove()));
}
