/**
 * The button beside a MOVE that is deprecated: all of the program's become calls of TP programs, which come with them, in one step to
 * undo. Where they cannot, it says why.
 *
 * @import { Page } from '../page.js'
 * @import { ProgramDoc } from '../../model/document.js'
 */
import { withTpCalls } from '../../model/code/tpCalls.js';
import { attempt } from '../page.js';
import { h } from '../parts/dom.js';
import { CODE } from '../words/code.js';

/** @param {Page} page @param {{ version: string, today: () => string }} written @param {() => void} onWritten */
export function createTpCallButton(page, { version, today }, onWritten) {
  const reason = h('p', { id: 'tp-call-reason', class: 'tp-call-reason', hidden: true });
  const button = h(
    'button',
    { type: 'button', class: 'btn btn-outline', hidden: true, 'aria-describedby': reason.id },
    CODE.tpCall,
  );
  /** What it was last asked for. @type {{ key: string, made: ReturnType<typeof withTpCalls> } | null} */
  let last = null;

  /** @param {ProgramDoc} program  as it is in the editor */
  function made(program) {
    const { doc } = page.store.state;
    const programs = doc.programs.map((one) => (one.id === program.id ? program : one));
    const key = JSON.stringify([program.id, doc.robot.name, programs]);
    const generatedAt = today().replace(/\.\d+/, '');
    if (last?.key !== key)
      last = { key, made: withTpCalls({ ...doc, programs }, program.id, { version, generatedAt }) };
    return last.made;
  }

  button.addEventListener('click', () => {
    const { made: found } = last ?? {};
    if (!found) return;
    if ('reason' in found) return page.announce(CODE.noTpCall(found.reason));
    const against = attempt(page, { type: 'set-code', programs: found.programs });
    if (against) return page.announce(against);
    page.announce(CODE.tpCalls(found.movers.join(', ')));
    onWritten();
  });

  return {
    button,
    reason,
    /** @param {ProgramDoc | null} program  whose MOVE is spoken of */
    show(program) {
      const found = program && made(program);
      const against = found && 'reason' in found ? CODE.noTpCall(found.reason) : '';
      button.hidden = found === null;
      reason.hidden = against === '';
      if (reason.textContent !== against) reason.textContent = against;
      button.setAttribute('aria-disabled', String(against !== ''));
    },
  };
}
