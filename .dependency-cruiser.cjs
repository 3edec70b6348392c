/**
 * Who may import whom. This table is the architecture (docs/architecture.md); change both in one commit, with an ADR.
 * Type imports count: a folder that needs another's types depends on it. tests/unit/tooling/importRules.test.js plants a
 * violation of every rule here.
 */
const MAY_IMPORT = {
  kinematics: { folders: [], packages: [] },
  motion: { folders: ['kinematics'], packages: [] },
  workspace: { folders: ['kinematics'], packages: [] },
  karel: { folders: ['kinematics'], packages: [] },
  model: { folders: ['kinematics', 'motion', 'karel'], packages: [] },
  io: { folders: ['model', 'karel', 'kinematics'], packages: ['@rgrove/parse-xml', 'fflate'] },
  workers: { folders: ['kinematics', 'motion', 'workspace'], packages: [] },
  render: { folders: ['model', 'kinematics'], packages: ['three', '@types/three', 'earcut'] },
  ui: {
    folders: ['model', 'io', 'karel', 'workers'],
    packages: [
      'jquery',
      '@types/jquery',
      'bootstrap',
      '@types/bootstrap',
      '@popperjs/core',
      'bootstrap-icons',
      'mathjs',
      'uplot',
      '@codemirror',
      '@lezer/highlight',
    ],
  },
};

/** karel may import poses and orientations of kinematics, nothing else of it. */
const POSES_ONLY = '^src/kinematics/(pose|orientation)\\.js$';

const OUTSIDE_THE_TABLE = {
  path: '^src/.*\\.m?js$',
  pathNot: `^src/(main\\.js$|(${Object.keys(MAY_IMPORT).join('|')})/)`,
};

const escape = (text) => text.replace(/[/.@-]/g, '\\$&');

const folderRules = Object.entries(MAY_IMPORT).flatMap(([folder, { folders, packages }]) => [
  {
    name: `${folder}-folders`,
    comment: `src/${folder} may import from: ${[folder, ...folders].join(', ')}.`,
    severity: 'error',
    from: { path: `^src/${folder}/` },
    to: { path: '^src/', pathNot: `^src/(${[folder, ...folders].join('|')})/` },
  },
  {
    // Whatever is not under src: packages, Node's own modules, files of the repository.
    name: `${folder}-packages`,
    comment: `src/${folder} may import these packages: ${packages.join(', ') || 'none'}.`,
    severity: 'error',
    from: { path: `^src/${folder}/` },
    to: { couldNotResolve: false, pathNot: ['^src/', ...packages.map((name) => `(^|/)node_modules/${escape(name)}/`)] },
  },
]);

module.exports = {
  forbidden: [
    ...folderRules,
    {
      name: 'karel-poses-only',
      comment: 'src/karel may import only poses and orientations from src/kinematics.',
      severity: 'error',
      from: { path: '^src/karel/' },
      to: { path: '^src/kinematics/', pathNot: POSES_ONLY },
    },
    {
      name: 'outside-the-table',
      comment:
        'Every script of src but main.js is in a folder of the table, so that no other knows both ui and render.',
      severity: 'error',
      from: OUTSIDE_THE_TABLE,
      to: {},
    },
    { name: 'outside-the-table-imported', severity: 'error', from: {}, to: OUTSIDE_THE_TABLE },
    { name: 'nothing-imports-main', severity: 'error', from: {}, to: { path: '^src/main\\.js$' } },
    { name: 'no-cycles', severity: 'error', from: {}, to: { circular: true } },
    { name: 'no-unresolvable', severity: 'error', from: {}, to: { couldNotResolve: true } },
    {
      name: 'no-dev-dependencies',
      severity: 'error',
      from: { path: '^src/' },
      to: { dependencyTypes: ['npm-dev', 'npm-no-pkg', 'npm-unknown'], pathNot: 'node_modules/@types/' },
    },
    {
      name: 'no-orphans',
      severity: 'error',
      from: { orphan: true, path: '^src/', pathNot: '^src/(main\\.js|.*\\.d\\.ts)$' },
      to: {},
    },
  ],
  options: {
    doNotFollow: { path: 'node_modules' },
    tsPreCompilationDeps: true,
    detectJSDocImports: true,
    tsConfig: { fileName: 'tsconfig.json' },
    enhancedResolveOptions: { exportsFields: ['exports'], conditionNames: ['import', 'require', 'node', 'default'] },
  },
};
