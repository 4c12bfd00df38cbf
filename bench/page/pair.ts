/** Clips go in; the JavaScript of a frame of the page Pair that shows them all, and what it draws, come out. */
import '../../web/src/styles/index.css';
import type { Context } from '../../web/src/app/context';
import { mountPair } from '../../web/src/pair/mount-pair';
import { createContext } from '../../web/src/shell/create-context';
import { fileNamed } from './files';
import { drawNothing, watchFrames } from './watch-frames';

export interface PairFrames {
  readonly clips: number;
  /** Of the whole page: stage, rows, times. */
  readonly frameMs: number[];
  /** The most of a frame. */
  readonly drawCalls: number;
}

/** Frames played before the clock counts, and with it. */
const WARM_UP = 60;
const FRAMES = 300;

const frame = (): Promise<unknown> =>
  new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));

async function until(holds: () => boolean): Promise<void> {
  while (!holds()) await new Promise((resolve) => setTimeout(resolve, 20));
}

async function load({ store, actions, compareActions }: Context, names: readonly string[]) {
  actions.take(names.map((name) => ({ file: fileNamed(name), folder: '' })));
  const clips = () => store.present.peek();
  await until(
    () => clips().length === names.length && clips().every(({ status }) => status === 'ready'),
  );
  const [a, ...others] = clips().map(({ id }) => id);
  actions.openClip(a);
  for (const id of others) compareActions.addToPair(id);
}

function mount(context: Context): HTMLElement {
  const place = document.createElement('main');
  place.className = 'pair';
  place.style.cssText = 'position: fixed; inset: 0; width: 1440px; height: 856px';
  document.body.append(place);
  context.store.compare.superposed.value = true;
  context.store.compare.page.value = 'pair';
  mountPair(place, context, { off: false, reducedMotion: true });
  return place;
}

/** All on one stage, warped, playing, with the keyposes of the first. */
export async function pairFrames(names: readonly string[]): Promise<PairFrames> {
  document.documentElement.dataset['theme'] = 'light';
  const draws = drawNothing();
  const spent = watchFrames();
  const context = createContext();
  await load(context, names);
  const place = mount(context);
  const letters = () => place.querySelectorAll('.stage-tag.letter:not([hidden])').length;
  await until(() => letters() === names.length && place.querySelector('.pair-ahead') !== null);
  const press = context.pageKeys.get('pair')!;
  press('loop');
  press('play');
  const frameMs: number[] = [];
  let drawCalls = 0;
  for (let count = 0; count < WARM_UP + FRAMES; count += 1) {
    spent();
    draws();
    await frame();
    if (count < WARM_UP) continue;
    frameMs.push(spent());
    drawCalls = Math.max(drawCalls, draws());
  }
  press('play');
  return { clips: names.length, frameMs, drawCalls };
}
