/**
 * `window.denavit`: the page for scripts, driving the same commands as the panels. Documented in docs/api.md.
 *
 * @import { Page } from './page.js'
 * @import { ManualClock } from '../model/clock.js'
 */
import { writeRobotXml } from '../io/robotXmlWriter.js';
import { writeUrdf } from '../io/urdf/urdfWriter.js';
import { aim } from '../model/aim/aim.js';
import { newDocument } from '../model/newDocument.js';
import { poseFromRows, rowsOf } from '../model/numbers/poseRows.js';
import { LIBRARY_IDS, loadRobot } from '../model/shelf.js';

const OVERTAKEN = 'Another document was opened in the meantime.';

/**
 * @param {Page} page
 * @param {object} given
 * @param {Promise<void>} given.ready  the page stands and its first frame is drawn
 * @param {ManualClock | null} given.clock  what moves the page's time, where nothing else does
 */
export function createScripting(page, { ready, clock }) {
  const { store, derived, opener } = page;
  return {
    ready,
    clock,

    /**
     * @param {string} robotIdOrXml  an id of the library, or the text of a robot file, ours or a URDF
     * @throws {RangeError} when it is neither; the document is then as it was
     */
    async load(robotIdOrXml) {
      const text = String(robotIdOrXml);
      if (LIBRARY_IDS.includes(text)) {
        const isWanted = opener.begin();
        const robot = await loadRobot(text);
        if (!isWanted()) throw new Error(OVERTAKEN);
        opener.open(newDocument(robot));
        return;
      }
      if (!text.trimStart().startsWith('<')) {
        throw new RangeError(`Expected one of ${LIBRARY_IDS.join(', ')} or a robot file, got "${text.slice(0, 80)}".`);
      }
      const isWanted = opener.begin();
      const { readRobotFile } = await import('../io/robotFile.js');
      const { doc, issues } = readRobotFile(text);
      if (!doc)
        throw new RangeError(
          issues
            .filter(({ severity }) => severity === 'error')
            .map(({ message }) => message)
            .join(' '),
        );
      if (!isWanted()) throw new Error(OVERTAKEN);
      opener.open(doc);
    },

    /** The robot as it is in the document. */
    model: () => store.state.doc.robot,

    /** The document as a robot file. */
    xml: () => writeRobotXml(store.state.doc),

    /** The robot as a URDF. */
    urdf: () => writeUrdf(store.state.doc),

    /**
     * The document as it stands now in one of the formats that it can be written in.
     * @param {string} format  an id of io/exportFormats.js
     */
    async file(format) {
      const { doc } = store.state;
      return (await formatCalled(format)).write(doc);
    },

    /**
     * What that format will not hold of it: one sentence each.
     * @param {string} format
     */
    async losses(format) {
      const { doc } = store.state;
      return (await formatCalled(format)).losses(doc).map(({ message }) => message);
    },

    /**
     * The address that opens the document as it is.
     * @param {{ view?: boolean, panels?: boolean }} [what]  goes with it: camera, frames and projection; what is open
     * @throws {RangeError} when the document is too large for a link
     */
    async link({ view = false, panels = false } = {}) {
      const { shareAddress } = await import('./files/shareAddress.js');
      const link = shareAddress(page, { view, panels });
      if (link === null) throw new RangeError('The document is too large for a link.');
      return link;
    },

    /** Joint values in document units. */
    joints: () => [...store.state.doc.posture],

    /** @param {ArrayLike<number>} values  in document units; not held inside the limits */
    setJoints(values) {
      const posture = values !== null && typeof values === 'object' ? Array.from(values) : values;
      store.dispatch({ type: 'set-posture', posture });
    },

    /** The pose of the TCP: 4 rows of 4 numbers, metres. */
    pose: () => rowsOf(derived.tcp(store.state.doc)),

    /**
     * What "Move there" does: the arm goes to the pose if it can.
     * @param {readonly (readonly number[])[]} pose  4 rows of 4 numbers, metres
     */
    solve(pose) {
      const { doc } = store.state;
      const { posture, isMet, result } = aim(doc, derived.chain(doc), poseFromRows(pose));
      if (isMet) store.dispatch({ type: 'set-posture', posture });
      return { ...result, q: [...posture], moved: isMet };
    },

    undo: () => store.dispatch({ type: 'undo' }),
    redo: () => store.dispatch({ type: 'redo' }),
  };
}

/** @param {string} id */
async function formatCalled(id) {
  const { EXPORT_FORMATS } = await import('../io/exportFormats.js');
  const format = EXPORT_FORMATS.find((each) => each.id === id);
  if (format) return format;
  const ids = EXPORT_FORMATS.map((each) => each.id).join(', ');
  throw new RangeError(`Expected one of ${ids}, got "${String(id).slice(0, 80)}".`);
}
