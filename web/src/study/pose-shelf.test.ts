import { expect, test } from 'vitest';
import { PoseShelf } from './pose-shelf';

interface Asked {
  readonly frames: readonly number[];
  readonly signal: AbortSignal | undefined;
  readonly answer: () => Promise<void>;
}

/** An engine of one joint, at x = its frame. */
function makeShelf() {
  const asked: Asked[] = [];
  const poses = (
    _clip: number,
    _performer: number,
    frames: Int32Array,
    work?: { readonly signal?: AbortSignal },
  ): Promise<Float32Array> =>
    new Promise((resolve) => {
      asked.push({
        frames: [...frames],
        signal: work?.signal,
        answer: async () => {
          resolve(Float32Array.from([...frames].flatMap((frame) => [frame, 0, 0])));
          await Promise.resolve();
        },
      });
    });
  return { asked, shelf: new PoseShelf({ poses }, 0, 0) };
}

test('poses come once and stay', async () => {
  const { asked, shelf } = makeShelf();
  let arrived = 0;
  shelf.fetch([3, 7], () => arrived++);
  expect(shelf.read([7])).toBeNull();
  await asked[0].answer();
  expect(arrived).toBe(1);
  expect(shelf.read([7, 3])?.map(([x]) => x)).toEqual([7, 3]);
  shelf.fetch([3, 7, 9], () => undefined);
  expect(asked[1].frames).toEqual([9]);
  shelf.fetch([3, 7], () => undefined);
  expect(asked).toHaveLength(2);
});

test('a newer wish ends an older one, which then asks for nothing', async () => {
  const { asked, shelf } = makeShelf();
  let arrived = 0;
  shelf.fetch([1], () => arrived++);
  shelf.fetch([2], () => arrived++);
  expect(asked[0].signal?.aborted).toBe(true);
  await asked[0].answer();
  await asked[1].answer();
  expect([arrived, shelf.read([1]), shelf.read([2])?.length]).toEqual([1, null, 1]);
});

test('of very many poses the oldest go', async () => {
  const { asked, shelf } = makeShelf();
  const frames = Array.from({ length: 300 }, (_, i) => i);
  shelf.fetch(frames, () => undefined);
  await asked[0].answer();
  expect(shelf.read([43])).toBeNull();
  expect(shelf.read([44, 299])).not.toBeNull();
});
