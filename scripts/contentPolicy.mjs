/**
 * The content security policy of the built page: whatever a file or a link brings along, nothing but the page's own
 * scripts runs, and nothing is fetched from or sent to anywhere else. A static host sets no headers, so it stands in a
 * meta element, first in the head, where it holds for all that follows. Such a policy cannot carry frame-ancestors:
 * who may embed the page is the host's to say.
 *
 * @import { Plugin } from 'vite'
 */

const POLICY = {
  'default-src': ["'self'"],
  'script-src': ["'self'"], // no 'unsafe-inline', no 'unsafe-eval'
  // Elements are placed by element.style, which needs no leave; an editor of code brings style elements of its own.
  'style-src': ["'self'", "'unsafe-inline'"],
  // Bootstrap's arrows and ticks are data: addresses; pictures that are saved are blob: addresses.
  'img-src': ["'self'", 'data:', 'blob:'],
  'object-src': ["'none'"],
  'base-uri': ["'none'"],
  'form-action': ["'none'"],
};

export const contentPolicy = () =>
  Object.entries(POLICY)
    .map(([directive, sources]) => [directive, ...sources].join(' '))
    .join('; ');

/** Puts the policy into the built page; the page of `npm start` needs inline scripts to renew itself. @returns {Plugin} */
export const contentPolicyPlugin = () => ({
  name: 'content-policy',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: () => [
      {
        tag: 'meta',
        attrs: { 'http-equiv': 'Content-Security-Policy', content: contentPolicy() },
        injectTo: 'head-prepend',
      },
    ],
  },
});
