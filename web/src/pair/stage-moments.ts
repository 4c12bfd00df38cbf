/** A stage and the clip chosen on it in; its figures at the keyposes around and under the pointer, and its trails, out. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import { follow } from '../common/mount';
import type { Stage, StageGhost, StageTrails } from '../stage';
import { trailFrames, type NumberedFrame } from '../study/moments';
import { PoseShelf } from '../study/pose-shelf';
import type { PairClip } from './pair-clips';
import type { PairState } from './pair-state';

export interface ShownClip {
  readonly place: number;
  readonly clip: PairClip;
}

type Shown = ReadonlySignal<ShownClip | null>;
type StageSignal = ReadonlySignal<Stage | null>;

const noGhosts: readonly StageGhost[] = [];
/** Keyposes on either side that are shown; of one of many clips on a stage, for the time to draw them. */
const REACH = 2;
const REACH_AMONG_MANY = 1;
const MANY = 5;

/** Keyposes around the current one, which is the figure itself or next to it. */
export function keyposesAround(
  keyposes: Int32Array,
  current: number | null,
  together = 1,
): NumberedFrame[] {
  if (current === null) return [];
  const reach = together < MANY ? REACH : REACH_AMONG_MANY;
  return Array.from({ length: 2 * reach + 1 }, (_, i) => current - reach + i)
    .filter((index) => index !== current && index >= 0 && index < keyposes.length)
    .map((index) => ({ number: index + 1, frame: keyposes[index] }));
}

export function showKeyposes(
  stage: StageSignal,
  shown: Shown,
  context: Context,
  state: PairState,
): void {
  const { store, language, engine } = context;
  const current = computed(() => state.currentKeyposes.value[shown.value?.place ?? -1] ?? null);
  const together = computed(() => (store.compare.superposed.value ? state.clips.value.length : 1));
  const moments = computed(() =>
    store.ghosts.value && shown.value
      ? keyposesAround(shown.value.clip.keyposes, current.value, together.value)
      : [],
  );
  const ghosts = fetchedPoses(engine, shown, moments, ({ number }) =>
    language.words.peek().format.integer(number),
  );
  const under = computed(() => {
    const frame = hoveredFrame(state, shown.value);
    return frame === null ? [] : [{ number: 0, frame }];
  });
  const passing = fetchedPoses(engine, shown, under, () => '');
  follow(() => {
    const index = current.value;
    const tag = store.ghosts.value && index !== null ? String(index + 1) : null;
    stage.value?.update({ ghosts: [...ghosts.value, ...passing.value], currentTag: tag });
  });
}

/** The frame of a clip at the moment under the pointer, where that is another than the one shown. */
function hoveredFrame(state: PairState, shown: ShownClip | null): number | null {
  const hovered = state.hovered.value;
  if (!hovered || !shown) return null;
  const clip = state.clips.value[hovered.clip];
  const alignment = state.alignment.value;
  const at = alignment.pairTimeOf(hovered.clip, hovered.frame * (clip?.frameTimeS ?? 0));
  const timeS = alignment.timeOf(shown.place, at);
  const frame =
    hovered.clip === shown.place ? hovered.frame : Math.round(timeS / shown.clip.frameTimeS);
  return frame === state.moment.value.frames[shown.place] ? null : frame;
}

function fetchedPoses(
  engine: Context['engine'],
  shown: Shown,
  moments: ReadonlySignal<readonly NumberedFrame[]>,
  tagOf: (moment: NumberedFrame) => string,
): ReadonlySignal<readonly StageGhost[]> {
  const ghosts = signal(noGhosts);
  const clip = computed(() => shown.value?.clip ?? null);
  effect(() => {
    ghosts.value = noGhosts;
    const one = clip.value;
    if (!one) return;
    const shelf = new PoseShelf(engine, one.id, one.performerIndex);
    const end = follow(() => {
      const wanted = moments.value;
      const show = (): void => {
        const poses = shelf.read(wanted.map(({ frame }) => frame));
        if (poses && moments.peek() === wanted)
          ghosts.value = poses.map((pose, i) => ({ tag: tagOf(wanted[i]), pose }));
      };
      show();
      if (wanted.length > 0)
        shelf.fetch(
          wanted.map(({ frame }) => frame),
          show,
        );
    });
    return () => {
      end();
      shelf.destroy();
    };
  });
  return ghosts;
}

/** Those through which a clip's trails go around a keypose; null: it has no trails there. */
export function framesOfTrails(clip: PairClip, current: number | null): Int32Array | null {
  if (clip.performer.trailJoints.length === 0) return null;
  const frames = trailFrames(clip.keyposes, current, {
    firstFrame: clip.performer.leadingRestFrames,
    lastFrame: clip.frames - 1,
    frameTimeS: clip.frameTimeS,
  });
  return frames.length > 1 ? frames : null;
}

export function showTrails(
  stage: StageSignal,
  shown: Shown,
  context: Context,
  state: PairState,
): void {
  const trails = signal<StageTrails | null>(null);
  const wish = computed(() => {
    const { place, clip } = shown.value ?? { place: -1, clip: null };
    const due = context.store.trails.value && !context.store.compare.superposed.value;
    if (!clip || !due) return null;
    const frames = framesOfTrails(clip, state.currentKeyposes.value[place] ?? null);
    return frames && { clip, frames };
  });
  effect(() => {
    const wanted = wish.value;
    if (!wanted) {
      trails.value = null;
      return;
    }
    const abort = new AbortController();
    const { clip, frames } = wanted;
    context.engine.poses(clip.id, clip.performerIndex, frames, { signal: abort.signal }).then(
      (poses) => {
        const joints = clip.performer.trailJoints;
        if (!abort.signal.aborted) trails.value = { joints, frames, poses };
      },
      // The stage goes on without trails.
      () => undefined,
    );
    return () => abort.abort();
  });
  follow(() => stage.value?.update({ trails: trails.value }));
}
