/**
 * Each import rule still bites, and lets pass what it should: a small source tree is planted beside the real
 * configuration and cruised once.
 */
import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const CRUISER = join(ROOT, 'node_modules/dependency-cruiser/bin/dependency-cruise.mjs');

/** What the planted files import. */
const THERE = {
  'src/kinematics/pose.js': 'export const pose = 1;',
  'src/kinematics/chain.js': 'export const chain = 1;',
  'src/karel/printer.js': 'export const print = 1;',
  'src/model/document.js': '/** @typedef {{ a: number }} Doc */\nexport const doc = 1;',
  'src/io/file.js': 'export const file = 1;',
  'src/workers/job.js': 'export const job = 1;',
  'src/render/stage.js': '/** @typedef {{ a: number }} Stage */\nexport const stage = 1;',
  'src/ui/panel.js': '/** @typedef {{ a: number }} Panel */\nexport const panel = 1;',
  'src/ui/look.css': 'body { margin: 0; }',
  'src/model/c2.js': "import { a } from './c1.js'; export const b = a;",
  'src/model/c4.js': "/** @import { A } from './c3.js' */\n/** @typedef {{ a: A }} B */\nexport const b = 1;",
  'scripts/helper.mjs': 'export const helper = 1;',
};

/** @type {[what: string, file: string, text: string, rule: string][]} */
const REFUSED = [
  [
    'ui in model',
    'src/model/a1.js',
    "import { panel } from '../ui/panel.js'; export const a = panel;",
    'model-folders',
  ],
  [
    'ui in render',
    'src/render/a2.js',
    "import { panel } from '../ui/panel.js'; export const a = panel;",
    'render-folders',
  ],
  ['render in ui', 'src/ui/a3.js', "import { stage } from '../render/stage.js'; export const a = stage;", 'ui-folders'],
  ['ui in io', 'src/io/a4.js', "import { panel } from '../ui/panel.js'; export const a = panel;", 'io-folders'],
  [
    'ui in workers',
    'src/workers/a5.js',
    "import { panel } from '../ui/panel.js'; export const a = panel;",
    'workers-folders',
  ],
  [
    'model in kinematics',
    'src/kinematics/a6.js',
    "import { doc } from '../model/document.js'; export const a = doc;",
    'kinematics-folders',
  ],
  [
    'model in motion',
    'src/motion/a6.js',
    "import { doc } from '../model/document.js'; export const a = doc;",
    'motion-folders',
  ],
  [
    'motion in workspace',
    'src/workspace/a6.js',
    "import { a } from '../motion/a6.js'; export const b = a;",
    'workspace-folders',
  ],
  [
    'model in karel',
    'src/karel/a7.js',
    "import { doc } from '../model/document.js'; export const a = doc;",
    'karel-folders',
  ],
  ['io in model', 'src/model/a8.js', "import { file } from '../io/file.js'; export const a = file;", 'model-folders'],
  [
    'a chain in karel',
    'src/karel/a9.js',
    "import { chain } from '../kinematics/chain.js'; export const a = chain;",
    'karel-poses-only',
  ],
  ['ui in model, when needed', 'src/model/a10.js', "export const a = () => import('../ui/panel.js');", 'model-folders'],
  ['ui in model, passed on', 'src/model/a11.js', "export { panel } from '../ui/panel.js';", 'model-folders'],
  [
    'a type of ui in model',
    'src/model/a12.js',
    "/** @import { Panel } from '../ui/panel.js' */\n/** @type {Panel | null} */\nexport const a = null;",
    'model-folders',
  ],
  [
    'a type of ui in the header of a model file',
    'src/model/a13.js',
    "/**\n * What it is for.\n *\n * @import { Panel } from '../ui/panel.js'\n */\nimport { doc } from './document.js';\n\n/** @type {Panel | number} */\nexport const a = doc;",
    'model-folders',
  ],
  [
    'a type of render in ui, by bracket',
    'src/ui/a14.js',
    "/** @type {import('../render/stage.js').Stage | null} */\nexport const a = null;",
    'ui-folders',
  ],

  ['three in ui', 'src/ui/b1.js', "import { Object3D } from 'three'; export const a = Object3D;", 'ui-packages'],
  [
    'a type of three in ui',
    'src/ui/b2.js',
    "/** @import { Object3D } from 'three' */\n/** @type {Object3D | null} */\nexport const a = null;",
    'ui-packages',
  ],
  [
    'an addon of three in ui',
    'src/ui/b3.js',
    "export const a = () => import('three/addons/controls/OrbitControls.js');",
    'ui-packages',
  ],
  ['jquery in render', 'src/render/b4.js', "import $ from 'jquery'; export const a = $;", 'render-packages'],
  [
    'the XML parser in model',
    'src/model/b5.js',
    "import { parseXml } from '@rgrove/parse-xml'; export const a = parseXml;",
    'model-packages',
  ],
  [
    'Node in io',
    'src/io/b6.js',
    "import { readFileSync } from 'node:fs'; export const a = readFileSync;",
    'io-packages',
  ],
  ['Node in kinematics', 'src/kinematics/b7.js', "import os from 'os'; export const a = os;", 'kinematics-packages'],
  [
    'a script in model',
    'src/model/b8.js',
    "import { helper } from '../../scripts/helper.mjs'; export const a = helper;",
    'model-packages',
  ],
  [
    'a development package',
    'src/main.js',
    "import fc from 'fast-check'; import { a } from './root.js'; export const m = [fc, a];",
    'no-dev-dependencies',
  ],

  ['a cycle', 'src/model/c1.js', "import { b } from './c2.js'; export const a = b;", 'no-cycles'],
  [
    'a cycle of types',
    'src/model/c3.js',
    "/** @import { B } from './c4.js' */\n/** @typedef {{ b: B }} A */\nexport const a = 1;",
    'no-cycles',
  ],
  ['a missing file', 'src/model/c5.js', "import { a } from './nowhere.js'; export const b = a;", 'no-unresolvable'],
  ['a file nobody uses', 'src/model/c6.js', 'export const a = 1;', 'no-orphans'],
  [
    'a second root',
    'src/root.js',
    "import { doc } from './model/document.js'; export const a = doc;",
    'outside-the-table',
  ],
  [
    'a folder outside the table',
    'src/tools/c7.js',
    "import { doc } from '../model/document.js'; export const a = doc;",
    'outside-the-table',
  ],
  ['main in ui', 'src/ui/c8.js', "import { m } from '../main.js'; export const a = m;", 'nothing-imports-main'],
];

/** @type {[what: string, file: string, text: string][]} */
const ALLOWED = [
  ['karel takes poses', 'src/karel/d1.js', "import { pose } from '../kinematics/pose.js'; export const a = pose;"],
  [
    'model takes kinematics and karel',
    'src/model/d2.js',
    "import { chain } from '../kinematics/chain.js'; import { print } from '../karel/printer.js'; export const a = [chain, print];",
  ],
  [
    'workers take workspaces and motion',
    'src/workers/d2.js',
    "import { a } from '../workspace/a6.js'; import { pose } from '../kinematics/pose.js'; export const b = [a, pose];",
  ],
  [
    'io parses XML into documents',
    'src/io/d3.js',
    "import { parseXml } from '@rgrove/parse-xml'; import { deflateSync } from 'fflate'; import { doc } from '../model/document.js'; export const a = [parseXml, deflateSync, doc];",
  ],
  [
    'render draws with three',
    'src/render/d4.js',
    "import { Object3D } from 'three'; import { OrbitControls } from 'three/addons/controls/OrbitControls.js'; import { doc } from '../model/document.js'; export const a = [Object3D, OrbitControls, doc];",
  ],
  [
    'ui builds on bootstrap and jquery',
    'src/ui/d5.js',
    "import './look.css'; import $ from 'jquery'; import { Modal } from 'bootstrap'; import Tab from 'bootstrap/js/dist/tab.js'; import arrow from 'bootstrap-icons/icons/arrow-left.svg?raw'; import { job } from '../workers/job.js'; export const a = [$, Modal, Tab, arrow, job];",
  ],
  [
    'ui takes types of its packages',
    'src/ui/d6.js',
    "/** @import { Modal } from 'bootstrap' */\n/** @type {Modal | null} */\nexport const a = null;",
  ],
  [
    'a worker is asked for by address',
    'src/ui/d7.js',
    "import Job from '../workers/job.js?worker'; export const a = Job;",
  ],
];

/** @type {string} */
let tree;
/** @type {Map<string, string[]>} */
let broken;

beforeAll(() => {
  mkdirSync(join(ROOT, '.cache'), { recursive: true });
  tree = mkdtempSync(join(ROOT, '.cache', 'import-rules-'));
  for (const name of ['.dependency-cruiser.cjs', 'package.json', 'tsconfig.json'])
    cpSync(join(ROOT, name), join(tree, name));
  const planted = [...REFUSED, ...ALLOWED].map(([, file, text]) => [file, text]);
  for (const [file, text] of [...Object.entries(THERE), ...planted]) {
    mkdirSync(dirname(join(tree, file)), { recursive: true });
    writeFileSync(join(tree, file), text);
  }
  const report = join(tree, 'report.json');
  try {
    execFileSync(
      process.execPath,
      [CRUISER, 'src', '--config', '.dependency-cruiser.cjs', '-T', 'json', '-f', report],
      {
        cwd: tree,
        stdio: 'pipe',
      },
    );
  } catch {
    // Its exit status counts the violations; the report has them.
  }
  /** @type {{ summary: { violations: { from: string, rule: { name: string } }[] } }} */
  const { summary } = JSON.parse(readFileSync(report, 'utf8'));
  broken = new Map();
  for (const { from, rule } of summary.violations) broken.set(from, [...(broken.get(from) ?? []), rule.name]);
});

afterAll(() => rmSync(tree, { recursive: true, force: true }));

describe('the import rule refuses', () => {
  test.each(REFUSED)('%s', (_what, file, _text, rule) => {
    expect(broken.get(file) ?? []).toContain(rule);
  });
  test('a second root that main imports', () => {
    expect(broken.get('src/main.js')).toContain('outside-the-table-imported');
  });
});

describe('the import rule allows', () => {
  test.each(ALLOWED)('%s', (_what, file) => {
    expect(broken.get(file) ?? []).toEqual([]);
  });
});
