// The faces of the README's pictures: Inter, and one with Japanese. Out: both are installed where that can be
// done, else a sentence; Node built-ins only.
import { output, run } from './process.mjs';

const packages = ['fonts-inter', 'fonts-noto-cjk'];

/** Installs the faces as root with apt where they are missing; elsewhere says that they are. */
export function ensureFonts(say) {
  if (output('fc-list', ['Inter']) && output('fc-list', [':lang=ja'])) return;
  if (process.getuid?.() !== 0 || !output('apt-get', ['--version'])) {
    say('Inter or a Japanese face is missing: the pictures will show others');
    return;
  }
  say('installing Inter and a Japanese face');
  run('apt-get', ['update', '-qq']);
  const options = ['install', '-qq', '-y', '--no-install-recommends'];
  run('apt-get', [...options, ...packages], { stdio: ['ignore', 'ignore', 'inherit'] });
}
