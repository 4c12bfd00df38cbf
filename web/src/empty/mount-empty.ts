/** The empty page; its pictures come from the generator and the engine, after the page has been painted. */
import { signal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { mount } from '../common/mount';
import { emptyPage } from './empty-page';
import { drawSample, sampleMotions, type SamplePicture } from './sample-picture';

/** Until the drop zone has been measured. */
const usualWidth = 1080;

export function mountEmpty(
  place: HTMLElement,
  { engine, actions, picker, language, store }: Context,
): void {
  const pictures = signal<readonly SamplePicture[]>([]);
  const width = signal(usualWidth);
  mount(place, () =>
    emptyPage({
      words: language.words.value,
      pictures: pictures.value,
      width: width.value,
      onFiles: () => picker.files(),
      onFolder: () => picker.folder(),
      onSample: (id) => actions.openSample(id),
    }),
  );
  new ResizeObserver(() => {
    // Zero while the study is shown.
    const measured = place.querySelector('.drop-zone')?.clientWidth ?? 0;
    if (measured > 0) width.value = measured;
  }).observe(place);

  const draw = async (): Promise<void> => {
    for (const motion of sampleMotions) {
      // The person's own files go first.
      if (store.clips.peek().length > 0) return;
      const picture = await drawSample(engine, motion);
      if (picture) pictures.value = [...pictures.peek(), picture];
    }
  };
  // Without its pictures the page does all it can do; opening a sample tells what is wrong.
  requestAnimationFrame(() => setTimeout(() => void draw().catch(() => undefined)));
}
