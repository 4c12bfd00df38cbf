import { expect, test } from 'vitest';
import { createKeyposePoses } from './keypose-poses';

const owner = { id: 1, performer: 0, jointCount: 1 };

/** An engine whose answers come when they are let go: pose of frame n = (n, n, n). */
function slowEngine() {
  const asked: number[][] = [];
  const gates: (() => void)[] = [];
  const poses = async (_id: number, _performer: number, frames: Int32Array) => {
    asked.push([...frames]);
    await new Promise<void>((resolve) => gates.push(resolve));
    return Float32Array.from([...frames].flatMap((frame) => [frame, frame, frame]));
  };
  const letGo = async (): Promise<void> => {
    gates.shift()?.();
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { engine: { poses }, asked, letGo };
}

test('each pose is fetched once', async () => {
  const { engine, asked, letGo } = slowEngine();
  const poses = createKeyposePoses(engine);
  poses.want(owner, Int32Array.of(3, 5));
  await letGo();
  expect([...(poses.of(owner).get(5) ?? [])]).toEqual([5, 5, 5]);
  poses.want(owner, Int32Array.of(5, 3));
  poses.want(owner, Int32Array.of(3, 9));
  await letGo();
  expect(asked).toEqual([[3, 5], [9]]);
  expect([...poses.of(owner).keys()]).toEqual([3, 5, 9]);
});

test('while one request is under way only the latest wish waits', async () => {
  const { engine, asked, letGo } = slowEngine();
  const poses = createKeyposePoses(engine);
  poses.want(owner, Int32Array.of(1));
  poses.want(owner, Int32Array.of(2));
  poses.want(owner, Int32Array.of(3));
  await letGo();
  await letGo();
  expect(asked).toEqual([[1], [3]]);
});

test('another clip begins anew, and late poses of the one before are not taken', async () => {
  const { engine, letGo } = slowEngine();
  const poses = createKeyposePoses(engine);
  poses.want(owner, Int32Array.of(1));
  const other = { ...owner, id: 2 };
  expect(poses.of(other).size).toBe(0);
  poses.want(other, Int32Array.of(7));
  await letGo();
  expect(poses.of(other).size).toBe(0);
  await letGo();
  expect([...poses.of(other).keys()]).toEqual([7]);
  expect(poses.of(owner).size).toBe(0);
});
