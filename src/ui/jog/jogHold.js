/**
 * The hand on the pendant's buttons: pointer, touch, and keys alike hold one down, and everything that may have taken the hand
 * off lets it go. Keys 1 to 6 are the rows from anywhere in the panel, and from where no other thing has the focus.
 */

const HOLD_KEYS = ['Enter', ' '];
const ROW_CODE = /^(?:Digit|Numpad)([1-6])$/;

/**
 * @param {HTMLElement} keys  whose buttons have data-row and data-sign
 * @param {object} given
 * @param {() => boolean} given.isOpen
 * @param {() => boolean} given.isMoving
 * @param {(row: number, sign: 1 | -1, isByStep?: true) => void} given.press
 * @param {() => void} given.stop
 */
export function watchJogKeys(keys, { isOpen, isMoving, press, stop }) {
  /** What holds the button down: a pointer, or a key by its code. @type {{ button: HTMLElement | null, by: number | string } | null} */
  let hold = null;
  let wasPressed = false; // the click that follows is the end of a press, not one of its own

  /** @param {EventTarget | null} target */
  const buttonAt = (target) => {
    const button = target instanceof Element && target.closest('[data-row]');
    return button instanceof HTMLElement && keys.contains(button) ? button : null;
  };
  /** @param {HTMLElement} button @param {true} [isByStep] */
  const pressButton = ({ dataset }, isByStep) => press(Number(dataset.row), dataset.sign === '1' ? 1 : -1, isByStep);
  const buttonOf = (/** @type {number} */ row, /** @type {1 | -1} */ sign) =>
    /** @type {HTMLElement | null} */ (keys.querySelector(`[data-row="${row}"][data-sign="${sign}"]`));

  /** @param {HTMLElement} button @param {number | string} by */
  function begin(button, by) {
    end();
    hold = { button, by };
    button.classList.add('is-held');
    pressButton(button);
  }

  function end() {
    hold?.button?.classList.remove('is-held');
    hold = null;
    stop();
  }

  keys.addEventListener('pointerdown', (event) => {
    const button = buttonAt(event.target);
    if (!button || event.button !== 0 || !event.isPrimary) return;
    wasPressed = true;
    button.focus({ preventScroll: true }); // a step that was being typed is taken first
    button.setPointerCapture(event.pointerId);
    begin(button, event.pointerId);
  });
  for (const name of /** @type {const} */ (['pointerup', 'pointercancel', 'lostpointercapture'])) {
    keys.addEventListener(name, ({ pointerId }) => {
      if (hold?.by === pointerId) end();
    });
  }
  keys.addEventListener('contextmenu', (event) => {
    if (hold) event.preventDefault(); // a long touch holds the button
  });
  keys.addEventListener('click', (event) => {
    const button = buttonAt(event.target);
    // A click without a press comes from a screen reader or a voice, which cannot hold: it is one step.
    if (button && !wasPressed) {
      pressButton(button, true);
      stop();
    }
    wasPressed = false;
  });
  keys.addEventListener('focusout', () => {
    if (hold && hold.button?.matches(':focus') === false && typeof hold.by === 'string') end();
  });

  // Before anything else hears the key: what moves stops, whatever has the focus.
  document.addEventListener(
    'keydown',
    (event) => {
      if (!isMoving()) return;
      const isStop = event.key === 'Escape' || (event.key === ' ' && hold?.by !== event.code);
      if (!isStop) return;
      event.preventDefault();
      event.stopPropagation();
      end();
    },
    true,
  );
  document.addEventListener('keydown', (event) => {
    if (!isOpen() || event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector('.modal.show')) return;
    const button = HOLD_KEYS.includes(event.key) ? buttonAt(event.target) : buttonOfKey(event);
    if (!button) return;
    event.preventDefault();
    if (event.repeat || hold?.by === event.code) return;
    begin(button, event.code);
  });
  document.addEventListener('keyup', ({ code }) => {
    if (hold?.by === code) end();
  });
  addEventListener('blur', end);
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) end();
  });

  /** @param {KeyboardEvent} event */
  function buttonOfKey({ code, shiftKey, target }) {
    const row = ROW_CODE.exec(code)?.[1];
    if (row === undefined || !(target instanceof Element)) return null;
    const isHere =
      target === document.body || (keys.closest('.jog-panel')?.contains(target) && !target.matches('input'));
    return isHere ? buttonOf(Number(row) - 1, shiftKey ? -1 : 1) : null;
  }
}
