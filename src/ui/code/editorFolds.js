/**
 * What the editor folds.
 *
 * @import { Line, Text } from '@codemirror/state'
 */
import { foldService } from '@codemirror/language';

/** Blocks fold from the line that begins them to the line that ends them: of KAREL and KRL by how far they are set in, of TP by sections. */
const BEGINS =
  /^\s*(ROUTINE\b(?!.*\bFROM\b)|DEF|IF\b.*\bTHEN\s*$|FOR|WHILE|REPEAT|LOOP|SWITCH|SELECT|CONDITION|USING|\w+\s*=\s*STRUCTURE)/i;
const SECTION = /^\s*\/(PROG|ATTR|APPL|MN|POS|END)\b/;
export const folds = foldService.of(({ doc }, from) => {
  const line = doc.lineAt(from);
  if (SECTION.test(line.text)) return sectionOf(doc, line);
  if (!BEGINS.test(line.text)) return null;
  const indent = /^\s*/.exec(line.text)?.[0].length ?? 0;
  for (let number = line.number + 1; number <= doc.lines; number++) {
    const { text, to } = doc.line(number);
    if (!/^\s*(END|UNTIL)/i.test(text) || (/^\s*/.exec(text)?.[0].length ?? 0) > indent) continue;
    return { from: line.to, to };
  }
  return null;
});

/** @param {Text} doc @param {Line} line  that begins it */
function sectionOf(doc, line) {
  let last = line.number;
  while (last < doc.lines && !SECTION.test(doc.line(last + 1).text)) last++;
  return last > line.number ? { from: line.to, to: doc.line(last).to } : null;
}
