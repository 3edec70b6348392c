/**
 * What the robot is called, and who says so: editable where it stands, with a link to the source where it has an address.
 *
 * @import { Page } from '../page.js'
 */
import { together } from '../../model/views.js';
import { captioned, textInput } from '../parts/captioned.js';
import '../css/robotDetails.css';
import { fill, h, spoken } from '../parts/dom.js';
import { createReasons } from '../parts/reasons.js';
import { addressIn } from '../parts/sourceLink.js';
import { editText } from '../parts/textEditor.js';
import { DETAILS } from '../words/robotDetails.js';

const FIELDS = /** @type {const} */ (['name', 'source', 'author', 'manufacturer', 'licence', 'description']);
/** Those that may take more than a line. */
const LONG = ['source', 'description'];

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createRobotInfo(page, host) {
  const { store, addView } = page;
  const link = h('p', { class: 'sm' });

  const fields = FIELDS.map((field) => {
    const reasons = createReasons(`about-${field}-reason`); // the last field is far from the first
    const input = LONG.includes(field)
      ? h('textarea', { rows: field === 'source' ? 3 : 2, spellcheck: 'false', 'aria-label': DETAILS.info[field] })
      : textInput({ 'aria-label': DETAILS.info[field] });
    const text = () => {
      const { name, info } = store.state.doc.robot;
      return field === 'name' ? name : (info[field] ?? '');
    };
    const editor = editText(page, input, {
      text,
      read: (typed) => ({
        command:
          field === 'name' ? { type: 'rename-robot', name: typed } : { type: 'set-robot-info', field, text: typed },
      }),
      onReason: (reason) => reasons.set(input, reason),
      onDone: () => DETAILS.set(DETAILS.info[field], text() || DETAILS.none),
    });
    return { field, editor, elements: [captioned(DETAILS.info[field], input, null, 'is-text'), reasons.element] };
  });
  fill(
    host,
    h(
      'div',
      { class: 'info-fields' },
      fields.flatMap(({ field, elements }) => (field === 'source' ? [...elements, link] : elements)),
    ),
  );

  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.robot.name, doc.robot.info, session.edition]),
    ([, info, now]) => {
      if (now !== edition) fields.forEach(({ editor }) => editor.forget());
      edition = now;
      fields.forEach(({ editor }) => editor.refresh());
      const address = addressIn(info.source ?? '');
      link.hidden = address === null;
      fill(
        link,
        address &&
          h(
            'a',
            { href: address, target: '_blank', rel: 'noopener noreferrer' },
            DETAILS.toSource,
            spoken(` ${DETAILS.newTab}`),
          ),
      );
    },
  );
}
