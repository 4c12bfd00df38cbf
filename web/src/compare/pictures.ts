/** What is compared in; matrix, tree or map as a file, SVG or PNG, out. */
import type { Context } from '../app/context';
import { failureOf } from '../app/failure';
import { saveBlob } from '../common/save-file';
import { comparePalette } from './compare-palette';
import { svgOfMap } from './map-picture';
import { topPx } from './matrix-geometry';
import { pictureGeometry, svgOfMatrix, type PictureParts } from './matrix-picture';
import { longestNamePx } from './name-width';
import { sceneOf } from './scene';
import { svgSheet } from './svg-text';
import { cutTag, nameTags, treeTags } from './tree-picture';

export type PictureKind = 'matrix' | 'tree' | 'map';
export type PictureFormat = 'svg' | 'png';

const mostPixels = 1600;
const pngScale = 2;

/** null: nothing has been compared. */
function partsOf({ store, language }: Context): PictureParts | null {
  const { comparison, cut, order } = store.compare;
  if (!comparison.peek()) return null;
  const scene = sceneOf({
    comparison: comparison.peek()!,
    cut: cut.peek(),
    kind: order.peek(),
    clips: store.clips.peek(),
    qualifiers: store.qualifiers.peek(),
    labels: store.labels.peek(),
    labelNames: store.labelNames.peek(),
  });
  const longest = longestNamePx(scene.names, 'sans-serif');
  const palette = comparePalette(document.documentElement);
  return { scene, palette, words: language.words.peek(), longestNamePx: longest };
}

export function svgOfTree(parts: PictureParts): string {
  const { palette, words } = parts;
  const scene = parts.scene;
  const geometry = pictureGeometry(parts);
  const content =
    treeTags(scene, geometry, palette) +
    cutTag(scene, geometry, palette) +
    nameTags(scene, geometry, palette);
  const [width, height] = [geometry.left + 8, topPx + geometry.side + 12];
  return svgSheet({ width, height, ground: palette.panel, title: words.t('tree.label') }, content);
}

async function svgOf(context: Context, kind: PictureKind): Promise<string | null> {
  const parts = partsOf(context);
  if (!parts) return null;
  const { scene } = parts;
  if (kind === 'map') {
    const { clips } = scene.comparison;
    return svgOfMap(parts, (item) => context.store.clips.peek()[clips[item]]?.thumbnail ?? null);
  }
  // The tree has an order of its own, whatever that of the matrix.
  if (kind === 'tree') return svgOfTree({ ...parts, scene: inTreeOrder(context, parts) });
  const all = { firstRow: 0, rowCount: scene.count, firstColumn: 0, columnCount: scene.count };
  const region = { order: scene.order, ...all, most: mostPixels };
  return svgOfMatrix(parts, { region, picture: await context.comparer.picture(region) });
}

function inTreeOrder({ store }: Context, { scene }: PictureParts) {
  return sceneOf({
    comparison: scene.comparison,
    cut: scene.cut,
    kind: 'tree',
    clips: store.clips.peek(),
    qualifiers: store.qualifiers.peek(),
    labels: store.labels.peek(),
    labelNames: store.labelNames.peek(),
  });
}

/** Draws SVG text at twice its size. */
async function pngOf(svg: string): Promise<Blob> {
  const url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = image.naturalWidth * pngScale;
    canvas.height = image.naturalHeight * pngScale;
    canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) =>
      canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture')))),
    );
  } finally {
    URL.revokeObjectURL(url);
  }
}

/** Saves it in the downloads and tells so; nothing where nothing has been compared. */
export async function saveComparePicture(
  context: Context,
  kind: PictureKind,
  format: PictureFormat,
): Promise<void> {
  const { t, failure } = context.language.words.peek();
  const fileName = `${kind}.${format}`;
  try {
    const svg = await svgOf(context, kind);
    if (svg === null) return;
    const blob = format === 'svg' ? new Blob([svg], { type: 'image/svg+xml' }) : await pngOf(svg);
    saveBlob(fileName, blob);
    context.store.toast.value = { kind: 'done', text: t('toast.saved', fileName) };
  } catch (error) {
    const text = t('toast.error', fileName, failure(failureOf(error)));
    context.store.toast.value = { kind: 'error', text };
  }
}
