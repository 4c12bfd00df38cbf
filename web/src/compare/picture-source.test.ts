import { expect, test } from 'vitest';
import type { MatrixPicture, MatrixRegion } from '../engine/comparison-types';
import { PictureSource } from './picture-source';
import { testScene } from './test-scene';

const turn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

function comparer() {
  const asked: MatrixRegion[] = [];
  return {
    asked,
    picture: (region: MatrixRegion): Promise<MatrixPicture> => {
      asked.push(region);
      const [rows, columns] = [region.rowCount, region.columnCount];
      return Promise.resolve({ rows, columns, values: new Float32Array(rows * columns) });
    },
  };
}

test('a scene shows with its picture; another cut needs no other picture', async () => {
  const engine = comparer();
  const source = new PictureSource(engine);
  const scene = testScene();
  source.follow(scene);
  expect(source.scene.value).toBeNull();
  await turn();
  expect(source.scene.value).toBe(scene);
  const cut = { clusters: 1, clusterOfItem: new Int32Array(scene.count), height: 9 };
  source.follow({ ...scene, cut });
  expect(source.scene.value?.cut).toBe(cut);
  expect(engine.asked).toHaveLength(1);
});

test('another order keeps the old scene until its picture is there', async () => {
  const source = new PictureSource(comparer());
  const scene = testScene();
  source.follow(scene);
  await turn();
  const turned = { ...scene, order: scene.order.slice().reverse() };
  source.follow(turned);
  expect(source.scene.value).toBe(scene);
  await turn();
  expect(source.scene.value).toBe(turned);
});

test('without a picture the rest of the scene shows all the same', async () => {
  const source = new PictureSource({ picture: () => Promise.reject(new Error('no worker')) });
  const scene = testScene();
  source.follow(scene);
  await turn();
  expect(source.scene.value).toBe(scene);
  expect(source.overview.value).toBeNull();
});
