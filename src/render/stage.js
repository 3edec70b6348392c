/**
 * The 3-D view of an arm, in an element of the page.
 *
 *     const stage = createStage({ host, clock, quality: 'high', text, isCalm, onGridStep, onError });  // null without WebGL
 *     stage.showArm(chain, styles);   // builds; the same chain and styles again cost nothing
 *     stage.showPosture(q);           // only moves
 *     stage.look('top');              // or 'home', 'front' …; without a name: the whole arm, as it is seen now
 *     stage.goTo(stage.camera());     // numbers that can be kept; null before the first picture
 *
 * It draws at most once a frame, through the clock, and only after something changed: `draws` counts, and the canvas has the
 * number as `data-draws`. It knows no words: `text` is asked for each label when it is written, and `rewrite` asks again.
 * Colours are the page's CSS custom properties, read by `setTheme`. The host must be positioned; its background is the sky.
 *
 * @import { LinkStyle } from './arm/linkPieces.js'
 * @import { MarkText } from './marks/marks.js'
 * @import { Eye } from './eye.js'
 * @import { Rectangle } from './view.js'
 * @import { Viewpoint, ViewName } from './viewpoint.js'
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Clock } from '../model/clock.js'
 *
 * @typedef {MarkText & { view: string }} StageText
 *   `view` names the canvas; `jointValue(index)`, `jointLimit(index, 'lower' | 'upper')`, `missing(metres)` are labels
 *
 * @typedef {object} StageOptions
 * @property {HTMLElement} host
 * @property {Clock} clock
 * @property {'high' | 'low'} quality  low: no shadow, no smoothing, one pixel to a pixel of the page
 * @property {StageText} text
 * @property {() => Rectangle | null} [freePart]  what of the view nothing covers; all of it if null
 * @property {ViewName} [firstLook]  from where the arm is seen at first
 * @property {() => boolean} [isCalm]  whether the person wants no motion
 * @property {(view: Eye & Viewpoint) => void} [onDraw]  a picture was taken, from there
 * @property {(name: ViewName | null) => void} [onLook]  a key asked for that view
 * @property {(metres: number) => void} [onGridStep]  a square of the floor's grid is now this large
 * @property {(error: unknown) => void} [onError]     the view broke; it will not draw again
 *
 * @typedef {NonNullable<ReturnType<typeof createStage>>} Stage
 */
import { createFrameLoop } from '../model/clock.js';
import { cameraNumbers, fromCameraNumbers } from './cameraNumbers.js';
import { eyeOf } from './eye.js';
import { createLabels } from './labels.js';
import { createScene } from './scene.js';
import { currentSkin } from './skins.js';
import { createSurface } from './surface.js';
import { createView } from './view.js';

/** @param {StageOptions} options */
export function createStage({ host, clock, quality, text, isCalm = () => false, freePart = () => null, ...on }) {
  const { onGridStep = () => {}, onError = () => {}, onDraw = () => {}, onLook = (name) => look(name) } = on;
  const { firstLook = 'home' } = on;
  const isLow = quality === 'low';
  const surface = createSurface({ host, isLow, onResize, onLose, onRestore: () => redraw({ castsAnew: true }) });
  if (!surface) return null;
  surface.canvas.setAttribute('role', 'img');
  surface.canvas.setAttribute('aria-label', text.view);

  let castsAnew = true;
  let isBroken = false;
  /** The camera is being set for the picture that is drawn next: no other is due for that. */
  let isAiming = false;
  let isFitted = false;
  /** The arm is seen from where it is seen best. */
  let isAtHome = false;
  /** Where the view was before it went near something. @type {(Viewpoint & { free: Rectangle | null }) | null} */
  let left = null;
  /** The joint that it went near to. @type {number | null} */
  let near = null;
  /** Where the picture is to be taken from next. @type {readonly number[] | null} */
  let wanted = null;

  const labels = createLabels(host);
  const ask = createFrameLoop(clock, draw);
  const scene = createScene({ skin: currentSkin(), isLow, labels, text, onChange: redraw, onGridStep });
  const view = createView(surface.canvas, { clock, isCalm, onChange: invalidate, onLook: (name) => onLook(name) });
  surface.start();

  function invalidate() {
    if (!isAiming) ask();
  }

  /** @param {{ castsAnew: boolean }} change */
  function redraw(change) {
    castsAnew ||= change.castsAnew;
    invalidate();
  }

  function draw() {
    if (isBroken || !surface) return;
    try {
      isAiming = true;
      if (!isFitted) fit();
      if (wanted && isFitted) {
        view.standAt(fromCameraNumbers(wanted, surface.width / surface.height));
        left = wanted = null;
      }
      isAiming = false;
      const eye = eyeOf(view.camera, surface.width, surface.height);
      scene.face(eye);
      if (!surface.draw(scene.scene, view.camera, castsAnew)) return;
      castsAnew = false;
      labels.place(view.camera, surface.width, surface.height, view.free);
      onDraw({ ...eye, ...view.viewpoint() });
    } catch (error) {
      isBroken = true;
      onError(error);
    }
  }

  function onLose() {
    scene.release();
  }

  /** @param {number} width @param {number} height */
  function onResize(width, height) {
    const isDrawnAtOnce = surface !== null && surface.draws > 0;
    isAiming = isDrawnAtOnce;
    view.resize(width, height);
    if (view.isUntouched && !(left && goNear(near, false))) fit();
    isAiming = false;
    // Resizing empties the canvas: drawn a frame later it would flash, so a picture that was there is drawn at once.
    if (isDrawnAtOnce) draw();
    else invalidate();
  }

  /**
   * Get the whole arm into the picture.
   * @param {{ from?: ViewName | null, flies?: boolean }} [how]  `from`: as it is seen now if left out
   */
  function fit({ from = isFitted ? null : firstLook, flies = false } = {}) {
    const extent = scene.extent();
    if (!extent || !surface?.width || !surface.height) return;
    isFitted = true;
    left = null;
    isAtHome = from ? from === 'home' : isAtHome && view.isUntouched;
    view.fit(extent.corners, extent.size, { free: freePart(), from: from === 'home' ? extent.home : from, flies });
  }

  /** Another arm is seen as it is seen best, unless a person has chosen from where. */
  function fitOther() {
    fit(isAtHome && view.isUntouched ? { from: 'home' } : {});
  }

  /**
   * An arm that has grown or gone out of the picture, where nobody has chosen what is seen of it, is brought back; one that
   * became a speck, or is all around the eye, as when metres are read as millimetres, always.
   */
  function keepInPicture() {
    const extent = scene.extent();
    if (!isFitted || left || !extent || !surface?.width) return;
    if (view.isOutOfRange || (view.isUntouched && !view.hasAll(extent.corners))) fit({ flies: true });
  }

  /** @param {ViewName | null} [name] */
  function look(name = null) {
    fit({ from: name, flies: true });
  }

  /**
   * Go near what a row of the table says, and back to where the view was when there is none any more.
   * @param {number | null} joint
   */
  function closeIn(joint) {
    if (!surface?.width) return;
    near = joint;
    const before = left ?? { ...view.viewpoint(), free: view.free };
    if (goNear(joint, true)) {
      left = before;
      return;
    }
    if (left && view.isUntouched) view.returnTo(left);
    left = null;
  }

  /** @param {number | null} joint @param {boolean} flies @returns {boolean} whether there is anything to go near */
  function goNear(joint, flies) {
    const extent = joint === null ? null : scene.extentOfRow(joint);
    isAtHome &&= view.isUntouched;
    if (extent) view.fit(extent.corners, extent.size, { free: freePart(), from: null, flies, fill: 'part' });
    return extent !== null;
  }

  return {
    canvas: surface.canvas,
    get draws() {
      return surface.draws;
    },
    /**
     * @param {Chain} chain
     * @param {readonly LinkStyle[]} [styles]  one for each joint; 'auto' where left out. Compared by identity
     */
    showArm(chain, styles = NO_STYLES) {
      scene.showArm(chain, styles);
      const extent = scene.extent();
      if (extent) view.scaleTo(extent.size);
    },
    showPosture: scene.showPosture,
    highlightJoint: scene.highlightJoint,
    holdJoint: scene.holdJoint,
    showTarget: scene.showTarget,
    showEnds: scene.showEnds,
    showHandle: scene.showHandle,
    linkAt: scene.linkAt,
    addMarks: scene.addMarks,
    touch: scene.touch,
    rewrite: scene.rewrite,
    /** @param {'perspective' | 'parallel'} projection */
    project: (projection) => view.project(projection === 'parallel'),
    setTheme: () => scene.setSkin(currentSkin()),
    fit,
    fitOther,
    keepInPicture,
    look,
    closeIn,
    /** @param {{ isChosen?: boolean }} [only]  null while the page itself keeps the arm in the picture */
    camera: ({ isChosen = false } = {}) =>
      surface.draws === 0 || (isChosen && view.isUntouched)
        ? null
        : cameraNumbers(view.viewpoint(), surface.width / surface.height),
    /**
     * A PNG of what is seen now, at the pixels of the screen.
     * @param {{ background: boolean, floor: boolean, labels: boolean }} options
     */
    async picture(options) {
      const { pictureOf } = await import('./picture.js');
      scene.showFloor(options.floor);
      surface.draw(scene.scene, view.camera, castsAnew);
      const picture = pictureOf(surface.canvas, host, options); // reads the canvas at once
      scene.showFloor(true);
      redraw({ castsAnew: true });
      return picture;
    },
    /** @param {readonly number[]} numbers  as `camera` gives them */
    goTo(numbers) {
      wanted = numbers;
      invalidate();
    },
    /** How large the picture is, in pixels of the page. */
    get width() {
      return surface.width;
    },
    get height() {
      return surface.height;
    },
    dispose() {
      isBroken = true; // a frame that was asked for may still come
      scene.dispose();
      labels.dispose();
      view.dispose();
      surface.dispose();
    },
  };
}

/** @type {readonly LinkStyle[]} */
const NO_STYLES = [];
