/**
 * The buttons that run the code that is open, and what they have come to.
 *
 * @import { RunControl } from './runControl.js'
 * @import { IconName } from '../parts/icons.js'
 */
import $ from 'jquery/slim';
import intoIcon from 'bootstrap-icons/icons/box-arrow-in-down.svg?raw';
import outIcon from 'bootstrap-icons/icons/box-arrow-up.svg?raw';
import overIcon from 'bootstrap-icons/icons/arrow-return-right.svg?raw';
import stopIcon from 'bootstrap-icons/icons/stop-fill.svg?raw';
import formatIcon from 'bootstrap-icons/icons/text-indent-left.svg?raw';
import { fill, h } from '../parts/dom.js';
import { icon, iconOf } from '../parts/icons.js';
import { CODE } from '../words/code.js';

/**
 * @param {RunControl} control
 * @param {(action: string) => void} onPress  run, pause, back, into, over, out, stop, format
 */
export function createCodeControls(control, onPress) {
  const status = h('span', { class: 'code-status' });
  const element = h('div', { class: 'code-controls', role: 'toolbar', 'aria-label': CODE.controls });
  let drawn = '';

  /** @param {string} action @param {string} label @param {SVGElement} drawing @param {boolean} [isOff] @param {string} [look] */
  const button = (action, label, drawing, isOff = false, look = 'btn-icon') =>
    h(
      'button',
      {
        ...{ type: 'button', class: `btn ${look}`, 'data-run': action, 'aria-label': label, title: label },
        'aria-disabled': isOff ? 'true' : null,
      },
      drawing,
    );

  function buttons() {
    const mode = control.mode();
    const isOff = mode === 'running' || mode === 'asks';
    return [
      mode === 'running'
        ? button('pause', CODE.pause, icon('pause'), false, 'btn-primary btn-icon')
        : button('run', CODE.run, icon('play'), mode === 'asks', 'btn-primary btn-icon'),
      button('back', CODE.back, icon('skipBack'), !control.canGoBack()),
      button('into', CODE.into, iconOf(intoIcon), isOff),
      button('over', CODE.over, iconOf(overIcon), isOff),
      button('out', CODE.out, iconOf(outIcon), isOff || mode !== 'paused'),
      button('stop', CODE.stop, iconOf(stopIcon), mode === 'idle'),
      status,
      button('format', CODE.format, iconOf(formatIcon)),
    ];
  }

  $(element).on('click', '[data-run]', ({ currentTarget }) => {
    if (currentTarget.getAttribute('aria-disabled') !== 'true') onPress(currentTarget.dataset.run ?? '');
  });

  return {
    element,
    draw() {
      const key = `${control.mode()} ${control.canGoBack()}`;
      if (key !== drawn) {
        const { activeElement } = document;
        const had =
          activeElement instanceof HTMLElement && element.contains(activeElement) ? activeElement.dataset.run : null;
        fill(element, buttons());
        const isRunning = control.mode() === 'running';
        const wanted = had === 'run' && isRunning ? 'pause' : had === 'pause' && !isRunning ? 'run' : had;
        const again = had && element.querySelector(`[data-run=${wanted}]`);
        if (again instanceof HTMLElement) again.focus();
        drawn = key;
      }
      if (status.textContent !== control.status()) status.textContent = control.status();
    },
  };
}
