/**
 * Copying, where the browser allows it; embedded pages often may not.
 * @param {string} text
 * @returns {Promise<boolean>} whether it was copied
 */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false; // said by the caller, in words
  }
}
