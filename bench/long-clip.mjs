// A long motion: the bytes of a clip and a number of frames go in; a file with that many frames comes out.
import { closeSync, openSync, writeSync } from 'node:fs';

const CHUNK_BYTES = 8 * 2 ** 20;

/** The clip's head with another number of frames, and its rows. */
function parted(text, frames) {
  const end = text.indexOf('\n', text.indexOf('Frame Time')) + 1;
  const head = text.slice(0, end).replace(/Frames:\s*\d+/, `Frames: ${frames}`);
  const rows = text
    .slice(end)
    .split('\n')
    .filter((row) => row.trim() !== '');
  return { head, rows };
}

/** Writes the clip played forwards and backwards in turn, so that nothing jumps, until it is long enough. */
export function writeLongClip(path, text, frames) {
  const { head, rows } = parted(text, frames);
  const there = rows.slice(0, -1);
  const back = rows.slice(1).reverse();
  const cycle = [...there, ...back];
  const file = openSync(path, 'w');
  let chunk = head;
  for (let frame = 0; frame < frames; frame += 1) {
    chunk += `${cycle[frame % cycle.length]}\n`;
    if (chunk.length < CHUNK_BYTES && frame + 1 < frames) continue;
    writeSync(file, chunk);
    chunk = '';
  }
  closeSync(file);
}
