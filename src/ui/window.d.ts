// What the page puts on `window` (docs/api.md).
import type { createScripting } from './scripting.js';

declare global {
  interface Window {
    denavit: ReturnType<typeof createScripting>;
  }
}
