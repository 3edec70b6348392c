/**
 * The program is checked, and where it comes too near to something is marked on its timeline.
 *
 * @import { Page } from '../page.js'
 * @import { TimelineStrip } from '../program/timelineStrip.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import { checkNow } from '../../model/workcell/programCheck.js';
import { marginNow } from '../../model/workcell/workcellView.js';
import { createProgramChecker } from './programChecker.js';
import { touchSentence } from './touchText.js';

/** @param {Page} page @param {Pick<TimelineStrip, 'setTouches'>} strip @param {Workcells} cells */
export function createTimelineTouches(page, strip, cells) {
  createProgramChecker(page, cells);
  page.addView(checkNow, (check) => {
    const { doc, session } = page.store.state;
    const margin = marginNow(session.workcell, page.derived.chain(doc));
    strip.setTouches(
      (check?.touches ?? []).map((touch) => ({
        time: touch.time,
        title: touchSentence(touch, margin, doc.robot.units),
      })),
    );
  });
}
