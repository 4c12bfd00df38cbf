// `npm run pictures`: the README's pictures, from the built app and our own sample. Out: docs/pictures.
import { mkdirSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { preview } from 'vite';
import { findChromium } from './chromium.mjs';

const folder = 'docs/pictures';
const views = [
  { name: 'study-light', colorScheme: 'light' },
  { name: 'study-dark', colorScheme: 'dark' },
];

mkdirSync(folder, { recursive: true });
const server = await preview({ preview: { port: 0 } });
const browser = await chromium.launch({ executablePath: findChromium(), args: ['--no-sandbox'] });
