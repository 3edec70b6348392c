/**
 * Who may import whom. This table is the architecture (docs/architecture.md); change both in one commit, with an ADR.
 * Type imports count: a folder that needs another's types depends on it.
 */
const MAY_IMPORT = {
  kinematics: { folders: [], packages: [] },
  karel: { folders: ['kinematics'], packages: [] },
  model: { folders: ['kinematics', 'karel'], packages: [] },
  io: { folders: ['model', 'karel', 'kinematics'], packages: ['@rgrove/parse-xml'] },
  workers: { folders: ['kinematics'], packages: [] },
  render: { folders: ['model', 'kinematics'], packages: ['three', '@types/three'] },
  ui: {
    folders: ['model', 'io', 'karel', 'workers', 'kinematics'],
    packages: ['jquery', '@types/jquery', 'bootstrap', '@types/bootstrap', '@popperjs/core', 'bootstrap-icons'],
  },
};

/** karel may import poses and orientations of kinematics, nothing else of it. */
const POSES_ONLY = '^src/kinematics/(pose|orientation)\\.js$';

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
    name: `${folder}-packages`,
    comment: `src/${folder} may import these packages: ${packages.join(', ') || 'none'}.`,
    severity: 'error',
    from: { path: `^src/${folder}/` },
    to: {
      dependencyTypesNot: ['local', 'type-only'],
      pathNot: ['^src/', ...packages.map((name) => `node_modules/${escape(name)}/`)],
    },
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
    { name: 'no-cycles', severity: 'error', from: {}, to: { circular: true } },
    { name: 'no-unresolvable', severity: 'error', from: {}, to: { couldNotResolve: true } },
    {
      name: 'no-dev-dependencies',
      severity: 'error',
      from: { path: '^src/' },
      to: { dependencyTypes: ['npm-dev'], pathNot: 'node_modules/@types/' },
    },
    {
      name: 'no-orphans',
      severity: 'error',
      from: { orphan: true, path: '^src/', pathNot: '^src/main\\.js$' },
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
