/**
 * The scene as a PNG at the pixels of the screen: sky or nothing behind it, and the labels, which are HTML over the canvas,
 * drawn where they stand. Fetched when a picture is first taken.
 */

/**
 * @param {HTMLCanvasElement} canvas  drawn in this very task: a frame later it is empty
 * @param {HTMLElement} host   whose background is the sky, and whose labels lie over the canvas
 * @param {{ background: boolean, labels: boolean }} options
 * @returns {Promise<Blob>}
 */
export function pictureOf(canvas, host, { background, labels }) {
  const picture = document.createElement('canvas');
  [picture.width, picture.height] = [canvas.width, canvas.height];
  const context = picture.getContext('2d');
  if (!context) throw new Error('The browser gives no room to put a picture together.');
  if (background) paintSky(context, picture);
  context.drawImage(canvas, 0, 0);
  if (labels) {
    const { left, top, width } = host.getBoundingClientRect();
    const scale = canvas.width / width;
    context.setTransform(scale, 0, 0, scale, -left * scale, -top * scale);
    for (const tag of host.querySelectorAll('.scene-labels .tag')) {
      if (tag instanceof HTMLElement && tag.style.display !== 'none') paintTag(context, tag);
    }
  }
  return new Promise((resolve, reject) =>
    picture.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('The picture could not be written.')))),
  );
}

/** As the page's stylesheet has it: from the sky above to the floor below. @param {CanvasRenderingContext2D} context @param {HTMLCanvasElement} size */
function paintSky(context, { width, height }) {
  const style = getComputedStyle(document.documentElement);
  const sky = context.createLinearGradient(0, 0, 0, height);
  sky.addColorStop(0, style.getPropertyValue('--sky').trim());
  sky.addColorStop(1, style.getPropertyValue('--floor').trim());
  context.fillStyle = sky;
  context.fillRect(0, 0, width, height);
}

/** @param {CanvasRenderingContext2D} context @param {HTMLElement} tag */
function paintTag(context, tag) {
  const box = tag.getBoundingClientRect();
  const { backgroundColor, borderTopWidth, borderTopColor, borderTopLeftRadius } = getComputedStyle(tag);
  const border = Number.parseFloat(borderTopWidth) || 0;
  const corner = Number.parseFloat(borderTopLeftRadius) || 0;
  const radius = borderTopLeftRadius.endsWith('%') ? box.height / 2 : Math.min(corner, box.height / 2);
  context.beginPath();
  context.roundRect(box.left, box.top, box.width, box.height, radius);
  context.fillStyle = backgroundColor;
  context.fill();
  if (border > 0) {
    context.lineWidth = border;
    context.strokeStyle = borderTopColor;
    context.stroke();
  }
  const words = document.createTreeWalker(tag, NodeFilter.SHOW_TEXT);
  for (let node = words.nextNode(); node; node = words.nextNode()) paintText(context, node);
}

/** @param {CanvasRenderingContext2D} context @param {Node} text */
function paintText(context, text) {
  if (!text.parentElement) return;
  const { font, color } = getComputedStyle(text.parentElement);
  const range = document.createRange();
  range.selectNodeContents(text);
  const { left, top, height } = range.getBoundingClientRect();
  context.font = font;
  context.fillStyle = color;
  context.textBaseline = 'alphabetic';
  const words = text.textContent ?? '';
  const { fontBoundingBoxAscent: up, fontBoundingBoxDescent: down } = context.measureText(words);
  context.fillText(words, left, top + (height - up - down) / 2 + up);
}
