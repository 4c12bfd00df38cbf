// The rules of the TypeScript code that a program can check; CONTRIBUTING.md has the others.
import tseslint from 'typescript-eslint';

const typed = {
  files: ['web/src/**/*.ts', 'tests/**/*.ts', '*.config.ts'],
  extends: [tseslint.configs.recommendedTypeChecked],
  languageOptions: {
    parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname },
  },
  rules: {
    eqeqeq: 'error',
    'no-console': 'error',
    'max-lines': ['error', { max: 350 }],
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

const oneWay = {
  files: ['web/src/**/*.ts'],
  ignores: ['web/src/stage/**'],
  rules: {
    'no-restricted-imports': [
      'error',
      { paths: [{ name: 'three', message: 'three.js is used in web/src/stage only.' }] },
    ],
  },
};

export default tseslint.config(
  { ignores: ['target/', 'tools/', 'dist/', 'web/src/engine/generated/', 'test-results/'] },
  typed,
  app,
  oneWay,
);
