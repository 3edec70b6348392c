/**
 * What can be asked about a workspace, as plain data that can be posted to another thread, and the work itself as generators:
 * each step is some milliseconds and says how far it is, often with a picture so far.
 *
 * @import { Chain, ChainDescription } from '../kinematics/chain.js'
 * @import { FirstSection } from './firstSection.js'
 * @import { PointAnswer, LineAnswer } from './points.js'
 * @import { Section, SectionOptions } from './section.js'
 * @import { Summary } from './summary.js'
 * @import { VolumeOptions } from './volume.js'
 * @import { Voxels } from './voxels.js'
 * @import { VoxelSurface } from './voxelSurface.js'
 *
 * @typedef {object} CloudOptions
 * @property {boolean} [withLimits]
 * @property {number} [seed]
 * @property {number} [count]  of postures (1e6)
 *
 * @typedef {{ kind: 'cloud', options?: CloudOptions }
 *   | { kind: 'section', options?: SectionOptions }
 *   | { kind: 'volume', options?: VolumeOptions }
 *   | { kind: 'points', places: readonly ArrayLike<number>[], options?: { withLimits?: boolean, seed?: number } }
 *   | { kind: 'line', from: ArrayLike<number>, to: ArrayLike<number>, options?: { withLimits?: boolean, seed?: number } }} WorkspaceJob
 *
 * @typedef {object} Word   how far it is
 * @property {string} stage
 * @property {number} share  of this stage, 0 … 1
 * @property {Float32Array} [places]  of sampled postures, x, y and z each: the next part of a cloud
 * @property {Voxels} [voxels]        so far
 * @property {VoxelSurface} [surface] of these
 * @property {Summary | null} [summary]
 * @property {FirstSection} [first]   a first picture of a section
 *
 * @typedef {{ kind: 'cloud' }
 *   | { kind: 'section', section: Section | null }
 *   | { kind: 'volume', voxels: Voxels, surface: VoxelSurface, summary: Summary | null }
 *   | { kind: 'points', answers: PointAnswer[] }
 *   | { kind: 'line', answer: LineAnswer }} WorkspaceAnswer
 */
import { createChain } from '../kinematics/chain.js';
import { whyNotMapped } from './placement.js';
import { firstSections } from './firstSection.js';
import { createPointFinder } from './points.js';
import { createSampler } from './sampler.js';
import { mapSection } from './section.js';
import { saying } from './steps.js';
import { summarising } from './summary.js';
import { mapVolume } from './volume.js';
import { surfacing } from './voxelSurface.js';

const CLOUD = 1e6;
const CLOUD_SLICE = 5e4;

/** Points between two words. */
const POINTS = 10;

/** @typedef {ReturnType<typeof whyNotMapped>} NotMapped */

/**
 * @param {ChainDescription} description
 * @param {WorkspaceJob} job
 * @returns {Generator<Word, WorkspaceAnswer | { kind: 'not-mapped', why: NonNullable<NotMapped> }>}
 */
export function* workspaceJob(description, job) {
  const chain = createChain(description);
  const why = whyNotMapped(chain);
  if (why) return { kind: 'not-mapped', why };
  switch (job.kind) {
    case 'cloud':
      return yield* cloud(chain, job.options ?? {});
    case 'section': {
      for (const first of firstSections(chain, job.options)) yield { stage: 'first', share: 0, first };
      return { kind: 'section', section: yield* mapSection(chain, job.options) };
    }
    case 'volume': {
      const voxels = yield* withPictures(mapVolume(chain, job.options));
      return { kind: 'volume', ...(yield* pictureOf(voxels, { stage: 'middles', share: 1 })) };
    }
    case 'points': {
      const finder = createPointFinder(chain, job.options);
      const answers = [];
      for (const place of job.places) {
        answers.push(finder.ask(place));
        if (answers.length % POINTS === 0) yield { stage: 'points', share: answers.length / job.places.length };
      }
      return { kind: 'points', answers };
    }
    case 'line':
      return { kind: 'line', answer: createPointFinder(chain, job.options).askLine(job.from, job.to) };
  }
}

/**
 * Cubes with what whoever shows them would have to look for.
 * @param {Voxels} voxels
 * @param {Word} word  that is said meanwhile
 */
function* pictureOf(voxels, word) {
  const surface = yield* saying(word, surfacing(voxels));
  return { voxels, surface, summary: yield* saying(word, summarising(voxels)) };
}

/**
 * Cubes that are told of on the way come with the same.
 * @param {ReturnType<typeof mapVolume>} work
 * @returns {Generator<Word, Voxels>}
 */
function* withPictures(work) {
  let step = work.next();
  for (; !step.done; step = work.next()) {
    const { voxels, ...word } = step.value;
    yield voxels ? { ...word, ...(yield* pictureOf(voxels, word)) } : word;
  }
  return step.value;
}

/**
 * @param {Chain} chain
 * @param {CloudOptions} options
 * @returns {Generator<Word, { kind: 'cloud' }>}
 */
function* cloud(chain, { withLimits, seed, count = CLOUD }) {
  const sampler = createSampler(chain, { withLimits, seed });
  for (let done = 0; done < count; done += CLOUD_SLICE) {
    const places = new Float32Array(3 * Math.min(CLOUD_SLICE, count - done));
    sampler.fill(done, places);
    yield { stage: 'cloud', share: Math.min(1, (done + CLOUD_SLICE) / count), places };
  }
  return { kind: 'cloud' };
}

/**
 * The memory that can be handed over with a message instead of copied: all that its typed arrays own.
 * @param {unknown} message
 * @param {Set<ArrayBuffer>} [found]
 * @returns {Set<ArrayBuffer>}
 */
export function transferable(message, found = new Set()) {
  if (ArrayBuffer.isView(message)) {
    if (message.buffer instanceof ArrayBuffer && message.byteLength === message.buffer.byteLength)
      found.add(message.buffer);
  } else if (message !== null && typeof message === 'object') {
    for (const part of Object.values(message)) transferable(part, found);
  }
  return found;
}
