/** Whether a file was started by name (`node scripts/size.mjs`) or is only imported. Symbolic links are seen through. */
import { realpathSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** @param {string} moduleUrl the file's own `import.meta.url` */
export function isMain(moduleUrl) {
  const started = process.argv[1];
  if (!started) return false;
  try {
    return realpathSync(started) === realpathSync(fileURLToPath(moduleUrl));
  } catch {
    return false; // started as `node scripts/size`, without its extension, or from standard input
  }
}
