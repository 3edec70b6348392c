/**
 * The folds of the workspace panel, in their order. **This is where one is added**: an entry here, its words in a file of
 * `ui/words` that its module imports, its stylesheet imported by that module likewise. It is fetched when it is first opened;
 * which are open is `session.workspace.open`, so that a fold knows whether anybody looks (`isFoldOpen` of look.js).
 *
 * @import { Page } from '../page.js'
 *
 * @typedef {object} WorkspaceFold
 * @property {string} id     of the fold; its head is the element `fold-reach-<id>`
 * @property {string} name
 * @property {(page: Page, body: HTMLElement, say: (summary: string) => void) => Promise<void>} create  what is in it; `say` puts
 *   the most important into its head
 */
import { WORKSPACE } from '../words/workspace.js';

/** @type {readonly WorkspaceFold[]} */
export const FOLDS = [
  {
    id: 'volume',
    name: WORKSPACE.name.volume,
    create: async (page, body, say) => (await import('./volumePanel.js')).createVolumePanel(page, body, say),
  },
  {
    id: 'section',
    name: WORKSPACE.name.section,
    create: async (page, body, say) => (await import('./sectionPanel.js')).createSectionPanel(page, body, say),
  },
  {
    id: 'points',
    name: WORKSPACE.name.points,
    create: async (page, body, say) => (await import('./pointsPanel.js')).createPointsPanel(page, body, say),
  },
  {
    id: 'teach',
    name: WORKSPACE.name.teach,
    create: async (page, body, say) => (await import('./teachPanel.js')).createTeachPanel(page, body, say),
  },
];
