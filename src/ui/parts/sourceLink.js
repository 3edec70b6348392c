/**
 * The address that a text about a source names: a web address, or a DOI, which doi.org leads on.
 */

/** What ends a sentence is not part of an address. */
const END_OF_SENTENCE = /[.,;:!?)\]}"'’”]+$/;

/**
 * @example
 * addressIn('Corke, ICRA 1994, doi:10.1109/ROBOT.1994.351360; limits chosen') // → 'https://doi.org/10.1109/ROBOT.1994.351360'
 * addressIn('see https://example.org/arm.') // → 'https://example.org/arm'
 * addressIn('a data sheet') // → null
 * @param {string} text  of unknown origin
 * @returns {string | null} of the web, never of another kind
 */
export function addressIn(text) {
  const web = /\bhttps?:\/\/[^\s<>"]+/i.exec(text)?.[0];
  const doi = /\b10\.\d{4,9}\/[^\s<>"]+/.exec(text)?.[0];
  const found = web ?? (doi && `https://doi.org/${doi}`);
  const address = found?.replace(END_OF_SENTENCE, '');
  return address && URL.canParse(address) ? address : null;
}
