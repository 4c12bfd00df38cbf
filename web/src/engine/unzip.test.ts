import { type Zippable, strToU8, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import type { UnpackedEntry } from './protocol';
import type { Failure } from './types';
import { type UnzipLimits, unzipMotions } from './unzip';

async function unpacked(archive: Uint8Array<ArrayBuffer>, limits?: UnzipLimits) {
  const entries: UnpackedEntry[] = [];
  const failures: [string, Failure['kind']][] = [];
  const progress: number[] = [];
  await unzipMotions(
    new Blob([archive]),
    {
      entry: (entry) => Promise.resolve(void entries.push(entry)),
      entryFailure: (name, failure) => Promise.resolve(void failures.push([name, failure.kind])),
      progress: (done) => progress.push(done),
      turn: () => Promise.resolve(),
    },
    limits,
  );
  const texts = await Promise.all(entries.map(({ blob }) => blob.text()));
  return { entries, texts, failures, progress };
}

const zip = (files: Zippable) => zipSync(files);
const motion = strToU8('HIERARCHY\n'.repeat(50_000));

/** Where the directory's entry and the local header of the only file begin. */
function headersOf(archive: Uint8Array): { local: number; directory: number } {
  const end = archive.length - 22;
  return { local: 0, directory: new DataView(archive.buffer).getUint32(end + 16, true) };
}

describe('unzip', () => {
  it('hands out the motions of all folders, stored and deflated', async () => {
    const archive = zip({
      'a.bvh': motion,
      'dances/B.BVH': [motion, { level: 0 }],
      'dances/readme.txt': strToU8('no'),
      'empty.bvh': new Uint8Array(0),
      '__MACOSX/._a.bvh': strToU8('shadow'),
    });
    const { entries, texts, failures, progress } = await unpacked(archive);
    expect(entries.map(({ folder, name }) => [folder, name])).toEqual([
      ['', 'a.bvh'],
      ['dances', 'B.BVH'],
      ['', 'empty.bvh'],
    ]);
    const text = new TextDecoder().decode(motion);
    expect(texts).toEqual([text, text, '']);
    expect(failures).toEqual([]);
    expect(progress.at(-1)).toBe(1);
  });

  it('reads names in UTF-8, with and without the flag, and in Shift_JIS', async () => {
    const archive = zip({ '踊り.bvh': motion });
    expect((await unpacked(archive)).entries[0]?.name).toBe('踊り.bvh');
    const { local, directory } = headersOf(archive);
    archive[local + 7] = 0;
    archive[directory + 9] = 0;
    expect((await unpacked(archive)).entries[0]?.name).toBe('踊り.bvh');
    const japanese = zip({ 'xxxx.bvh': motion });
    const at = headersOf(japanese).directory + 46;
    japanese.set([0x97, 0x78, 0x82, 0xe8], at);
    expect((await unpacked(japanese)).entries[0]?.name).toBe('踊り.bvh');
  });

  it('reports encrypted and unknown entries, and goes on', async () => {
    const encrypted = zip({ 'a.bvh': motion });
    encrypted[headersOf(encrypted).directory + 8] = 1;
    expect((await unpacked(encrypted)).failures).toEqual([['a.bvh', 'archive-entry-encrypted']]);
    const unknown = zip({ 'a.bvh': motion });
    unknown[headersOf(unknown).directory + 10] = 12;
    expect((await unpacked(unknown)).failures).toEqual([['a.bvh', 'archive-entry-method']]);
  });

  it('stops a bomb, whatever the directory says of its size', async () => {
    const archive = zip({ 'a.bvh': new Uint8Array(10_000_000), 'b.bvh': motion });
    const limits = { entryBytes: 1_000_000, archiveBytes: 2_000_000 };
    const honest = await unpacked(archive, limits);
    expect(honest.failures).toEqual([['a.bvh', 'archive-too-large']]);
    expect(honest.entries.map(({ name }) => name)).toEqual(['b.bvh']);
    new DataView(archive.buffer).setUint32(headersOf(archive).directory + 24, 10, true);
    expect((await unpacked(archive, limits)).failures).toEqual([['a.bvh', 'archive-too-large']]);
    const total = { entryBytes: 1_000_000, archiveBytes: 600_000 };
    const two = zip({ 'a.bvh': motion, 'b.bvh': motion });
    expect((await unpacked(two, total)).failures).toEqual([['b.bvh', 'archive-too-large']]);
  });

  it('says what is no archive, damaged, or without motions', async () => {
    const failing = (bytes: Uint8Array<ArrayBuffer>) =>
      unpacked(bytes).then(
        ({ failures }) => failures[0]?.[1],
        (error: { kind?: string }) => error.kind,
      );
    expect(await failing(new Uint8Array(0))).toBe('not-an-archive');
    expect(await failing(strToU8('HIERARCHY'))).toBe('not-an-archive');
    expect(await failing(zip({ 'a.txt': motion }))).toBe('archive-without-motions');
    const cut = zip({ 'a.bvh': motion });
    cut.fill(0xff, 40, 200);
    expect(await failing(cut)).toBe('archive-damaged');
    const moved = zip({ 'a.bvh': motion });
    new DataView(moved.buffer).setUint32(moved.length - 6, 0xfffffff0, true);
    expect(await failing(moved)).toBe('archive-damaged');
  });
});
