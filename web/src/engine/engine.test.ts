/** The engine with workers of this thread and the real core. */
import { strToU8, zipSync } from 'fflate';
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { createEngine, workerCount } from './engine';
import type { Core } from './raw';
import { spawnAround, testCore } from './test-engine';
import type { ClipResult, ClipSource, ClipSurvey, Engine } from './types';

let core: Core;
let walk: Uint8Array<ArrayBuffer>;

beforeAll(async () => {
  core = await testCore();
  walk = core.sample('walk') ?? new Uint8Array();
});

function engineOf(extra: { motionBytes?: number; workers?: number } = {}): Engine {
  return createEngine({ spawn: spawnAround(core), workers: 2, ...extra });
}

function sourceOf(bytes: BlobPart, name = 'walk.bvh'): ClipSource {
  return { name, folder: '', blob: new Blob([bytes]) };
}

/** A core whose module traps at files that begin with the letter. */
function trappedBy(letter: string): Core {
  const newClip = () => {
    const clip = core.newClip();
    const push = clip.push.bind(clip);
    clip.push = (bytes) => {
      if (bytes[0] === letter.charCodeAt(0)) throw new WebAssembly.RuntimeError('unreachable');
      push(bytes);
    };
    return clip;
  };
  return { ...core, newClip };
}

/** A clip that stands still. */
const still = (frames: number, joints = 'Hips'): string =>
  `HIERARCHY\nROOT ${joints}\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: ${frames}\nFrame Time: 0.01\n${'0 0 0\n'.repeat(frames)}`;

const keyposeFrames = (result: ClipResult): number[] => {
  const found = result.performers[0]?.keyposes;
  return [...(found?.keyposes ?? [])].map((index) => found?.candidates[index] ?? -1);
};

describe('engine', () => {
  it('opens a clip, tells its progress, and gives every series', async () => {
    const engine = engineOf();
    const onProgress = vi.fn();
    const result = await engine.open(1, sourceOf(walk), {}, {}, { onProgress });
    const [performer] = result.performers;
    const found = performer?.keyposes;
    if (!performer || !found) throw new Error('no keyposes');
    expect(result.frameTimeS).toBeCloseTo(1 / 120, 5);
    expect(performer.body.kind).toBe('human');
    expect(performer.body.joints).toHaveLength(18);
    expect(performer.skeleton.labels).toHaveLength(performer.skeleton.parents.length);
    expect(performer.feature).toHaveLength(12);
    expect(found.speed).toHaveLength(result.frames - 1 - performer.leadingRestFrames);
    expect(found.trend).toHaveLength(found.speed.length);
    expect(found.maximumSpeed).toBe(Math.max(...found.speed));
    expect(found.intensities).toHaveLength(found.candidates.length);
    expect(found.traceOffsets).toHaveLength(found.candidates.length + 1);
    expect(found.traceOffsets.at(-1)).toBe(found.traceScales.length);
    expect(keyposeFrames(result).length).toBeGreaterThan(5);
    const shares = onProgress.mock.calls.map(([progress]) => (progress as { done: number }).done);
    expect(shares).toEqual([...shares].sort((a, b) => a - b));
    expect(onProgress.mock.calls[0]?.[0]).toEqual({ stage: 'waiting', done: 0 });
    engine.destroy();
  });

  it('gives poses of frames and of runs of frames', async () => {
    const engine = engineOf();
    const result = await engine.open(1, sourceOf(walk), {}, {});
    const width = (result.performers[0]?.skeleton.labels.length ?? 0) * 3;
    const run = await engine.poseRange(1, 0, 10, 4);
    const some = await engine.poses(1, 0, Int32Array.of(12, 10));
    expect(run).toHaveLength(4 * width);
    expect(some.subarray(0, width)).toEqual(run.subarray(2 * width, 3 * width));
    expect(some.subarray(width)).toEqual(run.subarray(0, width));
    engine.destroy();
  });

  it('says where a broken file is broken, and opens the others', async () => {
    const engine = engineOf();
    const broken = engine.open(1, sourceOf('HIERARCHY\nROOT a\n(\n', 'broken.bvh'), {}, {});
    const good = engine.open(2, sourceOf(walk), {}, {});
    await expect(broken).rejects.toMatchObject({
      name: 'EngineError',
      fileName: 'broken.bvh',
      failure: { kind: 'expected-brace', line: 3, column: 1 },
    });
    expect((await good).frames).toBeGreaterThan(100);
    await expect(engine.open(1, sourceOf('', 'empty.bvh'), {}, {})).rejects.toMatchObject({
      failure: { kind: 'empty' },
    });
    engine.destroy();
  });

  it('refuses settings that cannot be, with name and value', async () => {
    const engine = engineOf();
    const bad = engine.open(1, sourceOf(walk), {}, { scaleRatio: 2 });
    await expect(bad).rejects.toMatchObject({
      failure: { kind: 'setting', details: ['scale_ratio', '2', 'a number above 0 and below 1'] },
    });
    engine.destroy();
  });

  it('analyses again with other settings as a fresh clip would be', async () => {
    const engine = engineOf();
    const first = await engine.open(1, sourceOf(walk), {}, {});
    const decisions = { frameRateHz: 60, leadingRestFrames: 5 };
    const again = await engine.analyse(1, decisions, { selection: 'even-split' });
    const fresh = await engine.open(2, sourceOf(walk), decisions, { selection: 'even-split' });
    expect(again).toEqual(fresh);
    expect(again.frameTimeSource).toBe('user');
    expect(await engine.analyse(1, {}, {})).toEqual(first);
    engine.destroy();
  });

  it('cancels an older run when a newer one is asked for', async () => {
    const engine = engineOf();
    await engine.open(1, sourceOf(walk), {}, {});
    const older = engine.analyse(1, { frameRateHz: 30 }, {});
    const newer = engine.analyse(1, { frameRateHz: 60 }, {});
    await expect(older).rejects.toMatchObject({ name: 'AbortError' });
    expect((await newer).frameTimeS).toBe(1 / 60);
    engine.destroy();
  });

  it('cancels an opening, forgets the clip, and opens the id again', async () => {
    const engine = engineOf();
    const abort = new AbortController();
    const opening = engine.open(1, sourceOf(walk), {}, {}, { signal: abort.signal });
    setTimeout(() => abort.abort(), 5);
    await expect(opening).rejects.toMatchObject({ name: 'AbortError' });
    expect((await engine.open(1, sourceOf(walk), {}, {})).performers).toHaveLength(1);
    engine.destroy();
  });

  it('reads a motion again that was dropped for want of room', async () => {
    const engine = engineOf({ motionBytes: 1, workers: 1 });
    await engine.open(1, sourceOf(walk), {}, {});
    const before = await engine.poseRange(1, 0, 0, 3);
    const result = await engine.open(2, sourceOf(walk), {}, {});
    expect(await engine.poseRange(1, 0, 0, 3)).toEqual(before);
    await engine.poseRange(2, 0, 0, 1);
    expect(await engine.analyse(1, {}, {})).toEqual(result);
    engine.destroy();
  });

  it('names the file that kills its worker, and reads the others again', async () => {
    const engine = createEngine({ spawn: spawnAround(trappedBy('T')), workers: 1 });
    const result = await engine.open(1, sourceOf(walk), {}, {});
    const before = await engine.poseRange(1, 0, 0, 3);
    const deadly = engine.open(2, sourceOf('TRAP', 'deadly.bvh'), {}, {});
    const waiting = engine.open(3, sourceOf(walk), {}, {});
    await expect(deadly).rejects.toMatchObject({
      fileName: 'deadly.bvh',
      failure: { kind: 'worker-died', details: ['RuntimeError: unreachable'] },
    });
    expect((await waiting).frames).toBe(result.frames);
    expect(await engine.poseRange(1, 0, 0, 3)).toEqual(before);
    expect(await engine.exportText(1, 'keyposes-csv')).toContain('walk.bvh,0,1,');
    engine.destroy();
  });

  it('writes keyposes as JSON Lines and CSV with the hash of the file', async () => {
    const engine = engineOf();
    const result = await engine.open(1, sourceOf(walk, 'a "walk", 1.bvh'), {}, {});
    const line = await engine.exportText(1, 'keyposes-json');
    const report = JSON.parse(line) as {
      file: string;
      sha256: string;
      keyposes: { frame: number }[];
    };
    const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', walk));
    expect(report.sha256).toBe(Buffer.from(digest).toString('hex'));
    expect(report.file).toBe('a "walk", 1.bvh');
    expect(report.keyposes.map(({ frame }) => frame)).toEqual(keyposeFrames(result));
    const rows = (await engine.exportText(1, 'keyposes-csv')).trimEnd().split('\r\n');
    expect(rows[0]).toMatch(/^file,performer,number,frame,time_s,intensity,rank,/);
    expect(rows).toHaveLength(1 + report.keyposes.length);
    expect(rows[1]).toMatch(/^"a ""walk"", 1.bvh",0,1,\d+,/);
    engine.destroy();
  });

  it('refuses a clip that is not open', async () => {
    const engine = engineOf();
    await expect(engine.poseRange(7, 0, 0, 1)).rejects.toMatchObject({
      failure: { kind: 'not-open' },
    });
    await expect(engine.analyse(7, {}, {})).rejects.toMatchObject({ name: 'EngineError' });
    const [first, second] = [1, 1].map((id) => engine.open(id, sourceOf(walk), {}, {}));
    await expect(second).rejects.toThrow('clip 1 is open already');
    expect((await first)?.frames).toBeGreaterThan(100);
    engine.close(7);
    engine.destroy();
  });

  it('ends what is under way when a clip is closed', async () => {
    const engine = engineOf();
    const opening = engine.open(1, sourceOf(walk), {}, {});
    engine.close(1);
    await expect(opening).rejects.toMatchObject({ name: 'AbortError' });
    const other = await engine.open(1, sourceOf(walk), {}, {});
    expect(other.performers).toHaveLength(1);
    engine.destroy();
  });

  it('makes the samples', async () => {
    const engine = engineOf();
    const samples = await engine.samples();
    expect(samples.map(({ motion }) => motion)).toContain('walk');
    const source = await engine.sample('walk');
    expect(source.name).toBe('walk.bvh');
    expect(Buffer.compare(Buffer.from(await source.blob.arrayBuffer()), walk)).toBe(0);
    await expect(engine.sample('none')).rejects.toMatchObject({
      failure: { kind: 'no-such-sample', details: ['none'] },
    });
    engine.destroy();
  });
});

describe('number of workers', () => {
  it('is that of the cores, at most 8, unless the address says another', () => {
    expect(workerCount('', 4)).toBe(4);
    expect(workerCount('', 64)).toBe(8);
    expect(workerCount('', 0)).toBe(1);
    expect(workerCount('?workers=3', 64)).toBe(3);
    expect(workerCount('?workers=0', 2)).toBe(2);
    expect(workerCount('?workers=many', 2)).toBe(2);
    expect(workerCount('?workers=1000', 2)).toBe(8);
  });
});

describe('an archive', () => {
  it('has handed out every entry when it is done', async () => {
    const names = Array.from({ length: 20 }, (_, index) => `${index}.bvh`);
    const archive = zipSync(Object.fromEntries(names.map((name) => [name, strToU8(name)])));
    const given: string[] = [];
    await engineOf().unzip(new Blob([archive]), ({ name }) => given.push(name));
    expect(given).toEqual(names);
  });

  it('surveys many clips: features as those of the analysis, a reason where there is none', async () => {
    const engine = engineOf();
    const run = core.sample('run') ?? new Uint8Array();
    const sources = [sourceOf(walk), sourceOf('no motion'), sourceOf(still(5)), sourceOf(run)];
    const surveys: ClipSurvey[] = [];
    await engine.survey(
      sources.map((source, id) => ({ id, source })),
      (some) => surveys.push(...some),
    );
    surveys.sort((a, b) => a.id - b.id);
    const result = await engine.open(0, sourceOf(walk), {}, {});
    expect(surveys[0]).toMatchObject({ frames: result.frames, frameTimeS: result.frameTimeS });
    expect(surveys[0]?.feature).toEqual(result.performers[0]?.comparable);
    expect(surveys[0]?.feature?.recorded).toEqual(result.performers[0]?.feature);
    expect(surveys[1]).toMatchObject({ feature: null, failure: { kind: 'not-bvh' } });
    expect(surveys[2]?.incomparable?.kind).toBe('not-human-to-compare');
    expect(surveys[3]?.feature?.recorded).toHaveLength(12);
    engine.destroy();
  });

  it('finds the file whose worker dies among many, and surveys the others', async () => {
    const engine = createEngine({ spawn: spawnAround(trappedBy('X')), workers: 1 });
    const surveys: ClipSurvey[] = [];
    await engine.survey(
      [sourceOf(walk), sourceOf('XHIERARCHY'), sourceOf(walk)].map((source, id) => ({
        id,
        source,
      })),
      (some) => surveys.push(...some),
    );
    surveys.sort((a, b) => a.id - b.id);
    expect(surveys.map(({ failure }) => failure?.kind ?? null)).toEqual([
      null,
      'worker-died',
      null,
    ]);
    engine.destroy();
  });

  it('gives the postures of the analysed frames, also after the motion was dropped', async () => {
    const engine = engineOf({ motionBytes: 1, workers: 1 });
    const result = await engine.open(1, sourceOf(walk), { leadingRestFrames: 7 }, {});
    const before = await engine.postures(1, 0);
    await engine.open(2, sourceOf(walk), {}, {});
    const after = await engine.postures(1, 0);
    expect(before.firstFrame).toBe(7);
    expect(before.values).toHaveLength((result.frames - 7) * 48);
    expect(after.values).toEqual(before.values);
    expect(await engine.exportText(1, 'keyposes-json')).toContain('"keyposes"');
    engine.destroy();
  });
});
