/**
 * What is drawn on: a canvas that fills its host, follows its size, and comes back after the browser has taken the graphics
 * context away.
 *
 * @import { Camera, Scene } from 'three'
 */
import { WebGLRenderer } from 'three';

const SHARPEST = 2; // pixels of the screen for one of the page: beyond that it only costs

/**
 * @param {object} options
 * @param {HTMLElement} options.host
 * @param {boolean} options.isLow
 * @param {(width: number, height: number) => void} options.onResize
 * @param {() => void} options.onLose     the graphics memory is gone, and what is in it with it
 * @param {() => void} options.onRestore
 * @returns the surface; null if the browser has no WebGL for it
 */
export function createSurface({ host, isLow, onResize, onLose, onRestore }) {
  const canvas = document.createElement('canvas');
  // asked for here, since Three.js would write its disappointment to the console
  const context = canvas.getContext('webgl2', { alpha: true, antialias: !isLow, stencil: true, depth: true });
  if (!context) return null;
  const renderer = new WebGLRenderer({ canvas, context, alpha: true, antialias: !isLow, stencil: true });
  renderer.shadowMap.enabled = !isLow;
  renderer.shadowMap.autoUpdate = false;
  /** @type {WeakSet<object>} */
  const kept = new WeakSet();
  Object.assign(canvas.style, { display: 'block', width: '100%', height: '100%' });
  canvas.tabIndex = 0;
  canvas.dataset.draws = '0';
  host.prepend(canvas);
  let width = 0;
  let height = 0;
  let ratio = 0;
  let draws = 0;
  let isLost = false;

  const ratioNow = () => (isLow ? 1 : Math.min(SHARPEST, devicePixelRatio));

  function measure() {
    if (host.clientWidth === width && host.clientHeight === height && ratioNow() === ratio) return;
    [width, height] = [host.clientWidth, host.clientHeight];
    if (!width || !height) return;
    sharpen();
    onResize(width, height);
  }

  function sharpen() {
    ratio = ratioNow();
    renderer.setPixelRatio(ratio);
    renderer.setSize(width, height, false);
  }

  /** Marks come and go with every key; without this their shaders were compiled again each time, at several pictures' cost. */
  function keepPrograms() {
    for (const program of renderer.info.programs ?? []) {
      if (kept.has(program)) continue;
      kept.add(program);
      program.usedTimes++;
    }
  }

  const observer = new ResizeObserver(measure);
  observer.observe(host);

  // a window that is dragged to another screen, or zoomed
  /** @type {MediaQueryList | null} */
  let screen = null;
  function watchScreen() {
    screen?.removeEventListener('change', watchScreen);
    screen = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    screen.addEventListener('change', watchScreen);
    measure();
  }

  function onLost() {
    isLost = true;
    onLose();
  }
  function onRestored() {
    isLost = false;
    onRestore();
  }
  canvas.addEventListener('webglcontextlost', onLost);
  canvas.addEventListener('webglcontextrestored', onRestored);

  return {
    canvas,
    start: watchScreen,
    get width() {
      return width;
    },
    get height() {
      return height;
    },
    get draws() {
      return draws;
    },
    /** @param {Scene} scene @param {Camera} camera @param {boolean} castAnew  draw the shadow again, too */
    draw(scene, camera, castAnew) {
      if (isLost || !width || !height) return false;
      if (ratioNow() !== ratio) sharpen(); // not every change of the screen is told
      renderer.shadowMap.needsUpdate = castAnew && !isLow;
      renderer.render(scene, camera);
      keepPrograms();
      canvas.dataset.draws = String(++draws);
      return true;
    },
    dispose() {
      observer.disconnect();
      screen?.removeEventListener('change', watchScreen);
      canvas.removeEventListener('webglcontextlost', onLost);
      canvas.removeEventListener('webglcontextrestored', onRestored);
      renderer.dispose();
      renderer.forceContextLoss(); // a browser has few contexts and gives them up late
      canvas.remove();
    },
  };
}
