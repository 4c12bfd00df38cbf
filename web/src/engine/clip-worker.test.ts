/** The worker's side alone: memory, files that cannot be read, cancelled steps. */
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { ClipWorker } from './clip-worker';
import type { ClipRef, Outcome } from './protocol';
import type { Core } from './raw';
import { testCore } from './test-engine';

let core: Core;
let walk: Uint8Array<ArrayBuffer>;

beforeAll(async () => {
  core = await testCore();
  walk = core.sample('walk') ?? new Uint8Array();
});

function refOf(id: number, blob: Blob = new Blob([walk])): ClipRef {
  return { id, name: 'walk.bvh', blob, decisions: {}, options: {}, readBefore: false };
}

/** A Blob of a file that is gone. */
function unreadable(): Blob {
  const blob = new Blob([walk]);
  const gone = () => Promise.reject(new DOMException('gone', 'NotReadableError'));
  vi.spyOn(blob, 'slice').mockReturnValue({ arrayBuffer: gone } as unknown as Blob);
  return blob;
}

const kindOf = <T>(outcome: Outcome<T>) =>
  outcome.status === 'failed' ? outcome.failure.kind : outcome.status;

describe('clip worker', () => {
  it('says whether a file was never readable or changed on disk', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const ref = refOf(1, unreadable());
    expect(kindOf(await worker.analyse(1, ref))).toBe('not-readable');
    const again = { ...ref, readBefore: true };
    expect(kindOf(await worker.poses(2, again, 0, Int32Array.of(0)))).toBe('changed-on-disk');
    expect(kindOf(await worker.unzip(3, unreadable()))).toBe('not-readable');
  });

  it('answers with poses of a dropped or unknown clip by reading it again', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const ref = refOf(1);
    const first = await worker.poseRange(1, ref, 0, 50, 2);
    worker.dropMotion(1);
    const slice = vi.spyOn(ref.blob, 'slice');
    expect(await worker.poseRange(2, ref, 0, 50, 2)).toEqual(first);
    expect(slice).toHaveBeenCalled();
    worker.close(1);
    expect(await worker.poseRange(3, ref, 0, 50, 2)).toEqual(first);
  });

  it('keeps the pose of the thumbnail when the motion is dropped', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const ref = refOf(1);
    const outcome = await worker.analyse(1, ref);
    const found = outcome.status === 'done' ? outcome.value.performers[0] : undefined;
    const frame = Int32Array.of(found?.thumbnailFrame ?? -1);
    const before = await worker.poseRange(2, ref, 0, frame[0] ?? 0, 1);
    worker.dropMotion(1);
    const slice = vi.spyOn(ref.blob, 'slice');
    const after = await worker.poses(3, ref, 0, frame);
    expect(slice).not.toHaveBeenCalled();
    expect(after).toMatchObject({ status: 'done', memory: { motionBytes: 0 } });
    if (before.status === 'done' && after.status === 'done') {
      expect(after.value).toEqual(before.value);
    }
  });

  it('reads a motion once for all who wait for it', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const ref = refOf(1);
    const slice = vi.spyOn(ref.blob, 'slice');
    await Promise.all([1, 2, 3].map((job) => worker.poseRange(job, ref, 0, 0, 1)));
    expect(slice).toHaveBeenCalledTimes(1);
  });

  it('ends a job at its next step, and works on', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const [cancelled, other] = [worker.analyse(1, refOf(1)), worker.analyse(2, refOf(2))];
    worker.cancel(1);
    expect((await cancelled).status).toBe('cancelled');
    expect((await other).status).toBe('done');
    expect((await worker.analyse(3, refOf(1))).status).toBe('done');
  });

  it('drops no motion under the hands of a job', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const running = worker.analyse(1, refOf(1));
    await new Promise((resolve) => setTimeout(resolve, 5));
    worker.dropMotion(1);
    expect(await running).toMatchObject({ status: 'done', memory: { motionBytes: 0 } });
  });

  it('cancels what is under way with a clip that is closed', async () => {
    const worker = new ClipWorker(Promise.resolve(core));
    const running = worker.analyse(1, refOf(1));
    await new Promise((resolve) => setTimeout(resolve, 5));
    worker.close(1);
    expect((await running).status).toBe('cancelled');
  });

  it('calls a fault of the module a trap', async () => {
    const broken: Core = {
      ...core,
      newClip: () => {
        throw new WebAssembly.RuntimeError('unreachable');
      },
    };
    const worker = new ClipWorker(Promise.resolve(broken));
    expect(await worker.analyse(1, refOf(1))).toEqual({
      status: 'trapped',
      message: 'RuntimeError: unreachable',
    });
  });

  it('says so when the core could not be loaded', async () => {
    const worker = new ClipWorker(Promise.reject(new Error('404')));
    expect(await worker.samples(1)).toMatchObject({
      failure: { kind: 'engine-unavailable', details: ['Error: 404'] },
    });
  });
});
