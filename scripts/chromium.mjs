// A Chromium for the browser tests. Out: the path of one: CHROMIUM_PATH, else the one that Playwright
// downloaded, else the system's; or, where there is none, one is installed.
import { accessSync, constants, existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { chromium } from '@playwright/test';
import { output, run } from './process.mjs';

const names = ['chromium', 'chromium-browser', 'google-chrome-stable', 'google-chrome'];
const headlessShell = 'chromium-headless-shell';

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

function onPath(name) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return folders.map((folder) => join(folder, name));
}

function systemChromium() {
  const installed = [
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    join(
      process.env.PROGRAMFILES ?? 'C:\\Program Files',
      'Google\\Chrome\\Application\\chrome.exe',
    ),
  ];
  return [...names.flatMap(onPath), ...installed].find(isProgram);
}

/** The path of a Chromium, or undefined. */
export function findChromium() {
  if (process.env.CHROMIUM_PATH) return process.env.CHROMIUM_PATH;
  const downloaded = chromium.executablePath();
  return existsSync(downloaded) ? downloaded : systemChromium();
}

/** For tests of pages without WebGL, which never show a window: the same engine for two thirds of the time. */
export function findHeadlessShell() {
  return process.env.CHROMIUM_PATH || onPath(headlessShell).find(isProgram) || findChromium();
}

const isRoot = process.getuid?.() === 0;
const hasApt = () => isRoot && output('apt-get', ['--version']) !== null;
const lacks = (name) => !onPath(name).some(isProgram);

/** Debian has both programs, each in a package of its name. */
function installWithApt() {
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  run('apt-get', ['update', '-qq'], { env });
  for (const name of ['chromium', headlessShell].filter(lacks)) {
    const options = ['install', '-qq', '-y', '--no-install-recommends', name];
    run('apt-get', options, { env, stdio: ['ignore', 'ignore', 'inherit'] });
  }
}

function install() {
  if (hasApt()) installWithApt();
  else run(process.execPath, ['node_modules/@playwright/test/cli.js', 'install', 'chromium']);
}

/** Installs a Chromium where there is none; throws, saying what to do, where that fails. */
export function ensureChromium(say) {
  const tooSlow = process.env.CI && lacks(headlessShell) && hasApt();
  if (process.env.CHROMIUM_PATH || (findChromium() && !tooSlow)) return;
  say('installing Chromium');
  try {
    install();
  } catch (error) {
    // One of the two will do.
    if (findChromium()) return;
    throw new Error(
      `${error.message}\nThe browser tests need Chromium: install Chromium or Chrome, ` +
        'or set CHROMIUM_PATH to the program, then run this again.',
    );
  }
  if (!findChromium())
    throw new Error('Chromium was installed but is not found: set CHROMIUM_PATH.');
}

const asRoot = isRoot ? ['--no-sandbox'] : [];

/** Chromium's arguments: WebGL 2 in software, and no sandbox for root, who cannot have one. */
export const chromiumArguments = [
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  ...asRoot,
];

/** For pages without WebGL: nothing is rasterised by way of it. */
export const flatArguments = ['--disable-gpu', ...asRoot];
