// A Chromium for the browser tests. Out: the path of one: CHROMIUM_PATH, else the one that Playwright
// downloaded, else the system's; or, where there is none, one is installed.
import { accessSync, constants, existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { chromium } from '@playwright/test';
import { output, run } from './process.mjs';

const names = ['chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome'];

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

function systemChromium() {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  const onPath = names.flatMap((name) => folders.map((folder) => join(folder, name)));
  const installed = [
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    join(
      process.env.PROGRAMFILES ?? 'C:\\Program Files',
      'Google\\Chrome\\Application\\chrome.exe',
    ),
  ];
  return [...onPath, ...installed].find(isProgram);
}

/** The path of a Chromium, or undefined. */
export function findChromium() {
  if (process.env.CHROMIUM_PATH) return process.env.CHROMIUM_PATH;
  const downloaded = chromium.executablePath();
  return existsSync(downloaded) ? downloaded : systemChromium();
}

function installWithApt() {
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  run('apt-get', ['update', '-qq'], { env });
  const options = ['install', '-qq', '-y', '--no-install-recommends'];
  run('apt-get', [...options, 'chromium'], { env, stdio: ['ignore', 'ignore', 'inherit'] });
}

/** Installs a Chromium where there is none; throws, saying what to do, where that fails. */
export function ensureChromium(say) {
  if (findChromium()) return;
  say('installing Chromium');
  try {
    if (process.getuid?.() === 0 && output('apt-get', ['--version'])) installWithApt();
    else run(process.execPath, ['node_modules/@playwright/test/cli.js', 'install', 'chromium']);
  } catch (error) {
    throw new Error(
      `${error.message}\nThe browser tests need Chromium: install Chromium or Chrome, ` +
        'or set CHROMIUM_PATH to the program, then run this again.',
    );
  }
  if (!findChromium())
    throw new Error('Chromium was installed but is not found: set CHROMIUM_PATH.');
}

const asRoot = process.getuid?.() === 0 ? ['--no-sandbox'] : [];

/** Chromium's arguments: WebGL 2 in software, and no sandbox for root, who cannot have one. */
export const chromiumArguments = [
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  ...asRoot,
];

/** For pages without WebGL: nothing is rasterised by way of it. */
export const flatArguments = ['--disable-gpu', ...asRoot];
