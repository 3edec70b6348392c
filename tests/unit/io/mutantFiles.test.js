import fc from 'fast-check';
import { readFileSync, readdirSync } from 'node:fs';
import { expect, test } from 'vitest';
import { hasErrors } from '../../../src/io/fileIssues.js';
import { readRobotFile } from '../../../src/io/robotFile.js';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { LIBRARY } from '../../../src/model/library.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { validateDocument } from '../../../src/model/validate.js';
import { runs, SEED } from '../../helpers/property.js';
import { SAMPLES } from './files.js';
import { writeRlkin } from '../../../src/io/rlkin.js';
import { writeUrdf } from '../../../src/io/urdf.js';
import { mutantsOf } from './mutants.js';

/** @param {string} folder @param {string} ending */
function textsIn(folder, ending) {
  const where = new URL(`../../fixtures/${folder}/`, import.meta.url);
  const names = readdirSync(where).filter((name) => name.endsWith(ending));
  return names.map((name) => readFileSync(new URL(name, where), 'utf8'));
}

const library = Object.values(LIBRARY).map(newDocument);
const KINDS = [
  { kind: 'native', texts: SAMPLES.map(({ text }) => text) },
  { kind: 'URDF', texts: [...textsIn('urdf', '.urdf'), ...library.map(writeUrdf)] },
  { kind: 'rlkin', texts: [...textsIn('rlkin', '.xml'), ...library.map(writeRlkin)] },
];

/** What is wrong with an answer of the reader, or nothing. @param {ReturnType<typeof readRobotFile>} answer */
function fault({ doc, issues }) {
  if (hasErrors(issues) !== (doc === null)) return doc ? 'opened in spite of an error' : 'refused without an error';
  const strange = issues.find(({ message }) => !/^[^\p{Cc}\p{Cf}\p{Cs}]{20,500}\.$/u.test(message));
  if (strange) return `said: ${JSON.stringify(strange.message)}`;
  if (!doc) return null;
  if (validateDocument(doc).length > 0) return 'opened, and not sound';
  if (!tcpPose(compileRobot(doc.robot), compilePosture(doc.robot, doc.posture)).every(Number.isFinite))
    return 'opened, and not finite';
  const saved = writeRobotXml(doc);
  const again = readRobotXml(saved).doc;
  return again && writeRobotXml(again) === saved ? null : 'opened, and not saved as it is';
}

test.each(KINDS)(
  'spoilt $kind files are refused, or opened as sound and finite documents that can be saved',
  ({ texts }) => {
    let opened = 0;
    let refused = 0;
    fc.assert(
      fc.property(mutantsOf(texts), (text) => {
        const answer = readRobotFile(text);
        const found = fault(answer);
        if (found) throw new Error(found);
        if (answer.doc) opened++;
        else refused++;
      }),
      { seed: SEED, numRuns: runs(334) },
    );
    expect(opened).toBeGreaterThan(20);
    expect(refused).toBeGreaterThan(50);
  },
);
