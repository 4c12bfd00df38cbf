/**
 * Comparing many clips in the page: a number of them goes in; times until all is known of them and until the
 * matrix is drawn, and the JavaScript of the frames in which the pointer moves over matrix and map, come out.
 */
import '../../web/src/styles/index.css';
import type { Context } from '../../web/src/app/context';
import { newClip } from '../../web/src/app/clips';
import { usualSettings } from '../../web/src/app/compare-store';
import { mountCompare } from '../../web/src/compare/mount-compare';
import { createContext } from '../../web/src/shell/create-context';
import { heapedFeatures } from './heaps';
import { watchFrames } from './watch-frames';

export interface ManyClips {
  readonly clips: number;
  /** From the features to the comparison. */
  readonly comparedMs: number;
  /** From the comparison to the picture of the matrix, everything else of the page mounted. */
  readonly pictureMs: number;
  /** Of each frame. */
  readonly hoverMatrixMs: number[];
  readonly hoverMapMs: number[];
  readonly zoomMatrixMs: number[];
}

const FRAMES = 120;

const frame = (): Promise<unknown> =>
  new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));

/** Sends an event a frame along a diagonal of the element; what each frame took. */
async function frames(
  target: Element,
  spent: () => number,
  event: (place: MouseEventInit) => Event,
): Promise<number[]> {
  const { left, top, width, height } = target.getBoundingClientRect();
  const found: number[] = [];
  for (let count = 0; count < FRAMES; count += 1) {
    const [x, y] = [(count + 0.5) / FRAMES, ((7 * count + 0.5) % FRAMES) / FRAMES];
    const place = { clientX: left + x * width, clientY: top + y * height, bubbles: true };
    spent();
    const start = performance.now();
    target.dispatchEvent(event({ ...place, cancelable: true }));
    const sent_ms = performance.now() - start;
    await frame();
    found.push(sent_ms + spent());
  }
  return found;
}

async function compare({ store, comparer }: Context, count: number): Promise<number> {
  const features = heapedFeatures(count);
  store.clips.value = features.map(({ heap }, id) => {
    const source = { name: `clip-${id}.bvh`, folder: `heap-${heap}`, blob: new Blob() };
    return { ...newClip(id, source), status: 'ready' };
  });
  store.compare.labelRule.value = { kind: 'folder' };
  const start = performance.now();
  features.forEach(({ feature }, id) => comparer.setFeature(id, `clip-${id}.bvh`, feature));
  const comparison = await comparer.compare(usualSettings);
  const compared_ms = performance.now() - start;
  store.compare.cut.value = await comparer.cut(comparison.automaticClusters);
  store.compare.comparison.value = comparison;
  return compared_ms;
}

function pictureDrawn(): Promise<void> {
  const name = 'comparison-first-picture';
  return new Promise((resolve) => {
    const look = (): unknown =>
      performance.getEntriesByName(name).length > 0 ? resolve() : setTimeout(look, 1);
    look();
  });
}

export async function manyClips(count: number): Promise<ManyClips> {
  document.documentElement.dataset['theme'] = 'light';
  const context = createContext();
  const spent = watchFrames();
  const place = document.createElement('main');
  place.className = 'compare';
  place.style.cssText = 'position: fixed; inset: 0; width: 1184px; height: 860px';
  document.body.append(place);
  const comparedMs = await compare(context, count);
  const start = performance.now();
  mountCompare(place, context);
  await pictureDrawn();
  const pictureMs = performance.now() - start;
  // The first frames after it draw names, map and tabs.
  for (let rest = 0; rest < 30; rest += 1) await frame();
  const grid = place.querySelector('.matrix-grid')!;
  const map = place.querySelector('.map-input')!;
  const move = (at: MouseEventInit): Event => new PointerEvent('pointermove', at);
  const wheel = (at: MouseEventInit): Event => new WheelEvent('wheel', { ...at, deltaY: -30 });
  return {
    clips: count,
    comparedMs,
    pictureMs,
    hoverMatrixMs: await frames(grid, spent, move),
    hoverMapMs: await frames(map, spent, move),
    zoomMatrixMs: await frames(grid, spent, wheel),
  };
}
