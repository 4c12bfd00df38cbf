/** The empty page; its pictures come from the generator and the engine, after the page has been painted. */
import { signal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { mount } from '../common/mount';
import type { SampleInfo } from '../engine/types';
import { emptyPage } from './empty-page';
import { drawSample, type SamplePicture } from './sample-picture';

interface Samples {
  readonly infos: readonly SampleInfo[];
  readonly pictures: readonly SamplePicture[];
}

export function mountEmpty(
  place: HTMLElement,
  { engine, actions, picker, language, store }: Context,
): void {
  const samples = signal<Samples>({ infos: [], pictures: [] });
  mount(place, () =>
    emptyPage({
      words: language.words.value,
      samples: samples.value.infos,
      pictures: samples.value.pictures,
      onFiles: () => picker.files(),
      onFolder: () => picker.folder(),
      onSample: (id) => actions.openSample(id),
    }),
  );

  const draw = async (): Promise<void> => {
    const infos = await engine.samples();
    samples.value = { infos, pictures: [] };
    for (const motion of ['slow-dance', 'walk'] as const) {
      const info = infos.find((known) => known.motion === motion);
      // The person's own files go first.
      if (!info || store.clips.peek().length > 0) return;
      const picture = await drawSample(engine, info);
      if (picture) samples.value = { infos, pictures: [...samples.peek().pictures, picture] };
    }
  };
  // Without its pictures the page does all it can do; opening a sample tells what is wrong.
  requestAnimationFrame(() => setTimeout(() => void draw().catch(() => undefined)));
}
