/** Robot files for tests: the fixtures, and short ones made on the spot. */
import { readdirSync, readFileSync } from 'node:fs';

const folder = (/** @type {string} */ name) => new URL(`../../fixtures/xml/${name}/`, import.meta.url);

/** @type {{ name: string, text: string }[]} twelve real arms */
export const SAMPLES = readdirSync(folder('samples')).map((name) => ({
  name,
  text: readFileSync(new URL(name, folder('samples')), 'utf8'),
}));

/** @typedef {'reject' | 'accept' | 'accept_warn' | 'any'} Outcome */

/** @type {{ file: string, family: string, case: string, expect: Outcome }[]} */
const manifest = JSON.parse(readFileSync(new URL('manifest.json', folder('bad')), 'utf8'));

export const BAD_FILES = manifest.map((entry) => ({
  ...entry,
  bytes: new Uint8Array(readFileSync(new URL(entry.file, folder('bad')))),
}));

const ROOT = 'xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="m" angleUnit="deg" convention="standard"';
const DH = '<dh theta="0" d="0.5" a="1" alpha="90"/>';

/**
 * A robot of two joints, one thing of it replaced or added. The start tag is on line 1, joint_1 on line 3, its <dh> on
 * line 4, joint_2 on line 7.
 * @param {object} [parts]
 * @param {string} [parts.root]     attributes of the root
 * @param {string} [parts.before]   elements before the chain, on line 1
 * @param {string} [parts.joint]    attributes of joint_1
 * @param {string} [parts.dh]       its <dh> element
 * @param {string} [parts.inJoint]  more elements of it, on line 5
 * @param {string} [parts.more]     more joints, on line 10
 * @param {string} [parts.after]    elements after the chain, on line 12
 */
export const robotFile = ({
  root = ROOT,
  before = '',
  joint = 'id="joint_1" type="revolute"',
  dh = DH,
  inJoint = '',
  more = '',
  after = '',
} = {}) =>
  [
    `<robotModel ${root}>${before}`,
    '  <chain>',
    `    <joint ${joint}>`,
    `      ${dh}`,
    `      ${inJoint}`,
    '    </joint>',
    '    <joint id="joint_2" type="revolute">',
    `      ${DH}`,
    '    </joint>',
    `    ${more}`,
    '  </chain>',
    `  ${after}`,
    '</robotModel>',
    '',
  ].join('\n');

/** @param {string} from @param {string} to the root's attributes with one thing changed */
export const rootWith = (from, to) => ROOT.replace(from, to);
