// The rules of the TypeScript code that a program can check; CONTRIBUTING.md has the others.
import tseslint from 'typescript-eslint';

const typed = {
  files: ['web/src/**/*.ts', 'tests/**/*.ts', 'bench/**/*.ts', '*.config.ts'],
  extends: [tseslint.configs.recommendedTypeChecked],
  languageOptions: {
    parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname },
  },
  rules: {
    eqeqeq: ['error', 'always', { null: 'ignore' }],
    'no-console': 'error',
    'max-lines': ['error', { max: 350 }],
    '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
    '@typescript-eslint/no-floating-promises': 'error',
    '@typescript-eslint/consistent-type-imports': 'error',
    '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
  },
};

/** Names from files are text, never markup; and the page's policy allows no style in markup. */
const markup = ['innerHTML', 'outerHTML', 'insertAdjacentHTML', 'document.write'].map((name) => ({
  property: name.replace('document.', ''),
  message: 'Names from files are text, never markup: build nodes, set textContent.',
}));

const app = {
  files: ['web/src/**/*.ts'],
  ignores: ['**/*.test.ts'],
  rules: {
    'max-lines-per-function': ['error', { max: 40, skipBlankLines: true, skipComments: true }],
    'no-restricted-properties': ['error', ...markup],
  },
};

/** Modules that only some rooms may import; types may cross freely. */
function restricted(files, ignores, patterns) {
  return {
    files,
    ignores,
    rules: { '@typescript-eslint/no-restricted-imports': ['error', { patterns }] },
  };
}

const threeInStage = {
  group: ['three', 'three/*'],
  message: 'three.js is used in web/src/stage only.',
};
const wasmInEngine = {
  group: ['**/generated/*'],
  message: 'The WebAssembly module is used in web/src/engine only.',
};
const viewsShow = {
  group: ['**/engine/*'],
  allowTypeImports: true,
  message: 'A view shows what the store holds; it does not call the engine.',
};
const engineFirst = {
  regex: '^\\.\\./',
  message: 'The engine knows nothing of the app.',
};

const viewRooms = ['figure', 'strip', 'timeline', 'stage'].map((room) => `web/src/${room}/**`);

const oneWay = [
  restricted(
    ['web/src/**/*.ts'],
    ['web/src/stage/**', 'web/src/engine/**'],
    [threeInStage, wasmInEngine],
  ),
  restricted(['web/src/engine/**/*.ts'], [], [threeInStage, engineFirst]),
  restricted(viewRooms, ['web/src/stage/**'], [threeInStage, wasmInEngine, viewsShow]),
  restricted(['web/src/stage/**/*.ts'], [], [wasmInEngine, viewsShow]),
];

export default tseslint.config(
  {
    ignores: [
      'target/',
      'tools/',
      'dist/',
      'web/src/engine/generated/',
      'test-results/',
      'bench/results/',
    ],
  },
  typed,
  app,
  oneWay,
);
