/**
 * A row of steps dragged by its number to another place; a line shows where it would go. Keys do the same in programTable.js.
 * @param {HTMLElement} body  of the table
 * @param {(index: number, to: number) => void} move
 */
export function watchStepDrag(body, move) {
  /** @type {{ row: HTMLElement, to: number } | null} */
  let drag = null;

  const rows = () => /** @type {HTMLElement[]} */ ([...body.children]);

  function unmark() {
    for (const row of rows()) row.classList.remove('is-dragged', 'goes-above', 'goes-below');
  }

  body.addEventListener('pointerdown', (event) => {
    const grip = event.target instanceof Element ? event.target.closest('[data-grip]') : null;
    const row = grip?.closest('tr');
    if (!(grip instanceof HTMLElement) || !row || event.button !== 0) return;
    drag = { row, to: rows().indexOf(row) };
    grip.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  body.addEventListener('pointermove', ({ clientY }) => {
    if (!drag) return;
    const all = rows();
    const from = all.indexOf(drag.row);
    const over = all.findIndex((row) => clientY < row.getBoundingClientRect().bottom);
    drag.to = over === -1 ? all.length - 1 : over;
    unmark();
    if (drag.to === from) return;
    drag.row.classList.add('is-dragged');
    all[drag.to].classList.add(drag.to > from ? 'goes-below' : 'goes-above');
  });
  body.addEventListener('pointerup', () => {
    if (!drag) return;
    const from = rows().indexOf(drag.row);
    const { to } = drag;
    drag = null;
    unmark();
    if (from >= 0 && to !== from) move(from, to);
  });
  body.addEventListener('pointercancel', () => {
    drag = null;
    unmark();
  });
}
