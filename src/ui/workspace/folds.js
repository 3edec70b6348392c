/**
 * The folds of the workspace panel, in their order. **This is where one is added**: an entry here, its words in a file of
 * `ui/words` that its module imports, its stylesheet imported by that module likewise. It is fetched when it is first opened;
 * which are open is `session.workspace.open`, so that a fold knows whether anybody looks (`isFoldOpen` of look.js).
 *
 * @import { Page } from '../page.js'
 *
 * @callback CreateFold
 * @param {Page} page
 * @param {HTMLElement} body
 * @param {(summary: string) => void} say  puts the most important into its head
 * @param {(draw: () => void) => void} afterPress  draws when nothing in the panel is pressed
 *
 * @typedef {object} WorkspaceFold
 * @property {string} id     of the fold; its head is the element `fold-reach-<id>`
 * @property {string} name
 * @property {(...given: Parameters<CreateFold>) => Promise<void>} create  what is in it
 */
import { WORKSPACE } from '../words/workspace.js';

/** @type {readonly WorkspaceFold[]} */
export const FOLDS = [
  {
    id: 'volume',
    name: WORKSPACE.name.volume,
    create: async (...given) => (await import('./volumePanel.js')).createVolumePanel(...given),
  },
  {
    id: 'section',
    name: WORKSPACE.name.section,
    create: async (...given) => (await import('./sectionPanel.js')).createSectionPanel(...given),
  },
  {
    id: 'points',
    name: WORKSPACE.name.points,
    create: async (...given) => (await import('./pointsPanel.js')).createPointsPanel(...given),
  },
  {
    id: 'teach',
    name: WORKSPACE.name.teach,
    create: async (...given) => (await import('./teachPanel.js')).createTeachPanel(...given),
  },
];
