/** The open performer and its current keypose in; the ghosts and the trails around it on the stage out. */
import { computed, effect, signal, type ReadonlySignal } from '@preact/signals-core';
import type { Context } from '../app/context';
import type { Stage, StageGhost, StageTrails } from '../stage';
import { follow } from '../common/mount';
import { ghostMoments, trailFrames } from './moments';
import { PoseShelf } from './pose-shelf';
import type { TrailChoice } from './trail-choice';

type StageSignal = ReadonlySignal<Stage | null>;

/** Keyposes around the current one whose poses are fetched before they are needed. */
const ahead = 3;

const noGhosts: readonly StageGhost[] = [];

/** Calls `use` with a shelf of its own for every performer that is opened or analysed anew. */
function withShelf({ engine, store }: Context, use: (shelf: PoseShelf) => () => void): void {
  effect(() => {
    const id = store.openId.value;
    const performer = store.performer.value;
    if (!store.openPerformer.value || id === null) return;
    const shelf = new PoseShelf(engine, id, performer);
    const end = use(shelf);
    return () => {
      end();
      shelf.destroy();
    };
  });
}

export function showGhosts(stage: StageSignal, context: Context): void {
  const { store, language } = context;
  const ghosts = signal(noGhosts);
  withShelf(context, (shelf) => {
    ghosts.value = noGhosts;
    return follow(() => {
      const frames = store.keyposeFrames.value;
      const current = store.currentKeypose.value;
      const { format } = language.words.value;
      const moments = store.ghosts.value ? ghostMoments(frames, current) : [];
      const show = (): void => {
        const poses = shelf.read(moments.map(({ frame }) => frame));
        if (poses === null) return;
        ghosts.value = poses.map((pose, i) => ({ tag: format.integer(moments[i].number), pose }));
      };
      show();
      if (moments.length === 0 || current === null) return;
      const around = frames.subarray(Math.max(0, current - ahead), current + ahead + 1);
      shelf.fetch([...around], show);
    });
  });
  const passing = hoverGhost(context);
  follow(() => {
    const { format } = language.words.value;
    const current = store.currentKeypose.value;
    const open = store.openPerformer.value !== null;
    const tag = store.ghosts.value && current !== null ? format.integer(current + 1) : null;
    const shown = open ? [...ghosts.value, ...passing.value] : noGhosts;
    stage.value?.update({ ghosts: shown, currentTag: tag });
  });
}

/** The figure at the moment under the pointer, wherever on the page that is. */
function hoverGhost(context: Context): ReadonlySignal<readonly StageGhost[]> {
  const { store } = context;
  const passing = signal(noGhosts);
  withShelf(context, (shelf) => {
    passing.value = noGhosts;
    return follow(() => {
      const frame = store.hoverFrame.value;
      const isElsewhere = frame !== null && frame !== store.playback.value.frame;
      if (!isElsewhere) {
        passing.value = noGhosts;
        return;
      }
      const show = (): void => {
        const pose = shelf.read([frame])?.[0];
        if (pose && store.hoverFrame.peek() === frame) passing.value = [{ tag: '', pose }];
      };
      show();
      shelf.fetch([frame], show);
    });
  });
  return passing;
}

export function showTrails(stage: StageSignal, context: Context, choice: TrailChoice): void {
  const { store } = context;
  const frames = computed(() => {
    const result = store.openClip.value?.result;
    const performer = store.openPerformer.value;
    if (!result || !performer || !store.trails.value) return new Int32Array();
    return trailFrames(store.keyposeFrames.value, store.currentKeypose.value, {
      firstFrame: performer.leadingRestFrames,
      lastFrame: result.frames - 1,
      frameTimeS: result.frameTimeS,
    });
  });
  const poses = fetchTrailPoses(context, frames, () => choice.joints.value.length > 0);
  follow(() => {
    const joints = Int32Array.from(choice.joints.value);
    // The old ones stay until the new ones come.
    const due = joints.length > 0 && frames.value.length > 1;
    stage.value?.update({ trails: due && poses.value ? { joints, ...poses.value } : null });
  });
}

type TrailPoses = Omit<StageTrails, 'joints'>;

function fetchTrailPoses(
  { engine, store }: Context,
  frames: ReadonlySignal<Int32Array>,
  isWanted: () => boolean,
): ReadonlySignal<TrailPoses | null> {
  const poses = signal<TrailPoses | null>(null);
  effect(() => {
    void [store.openId.value, store.performer.value];
    poses.value = null;
  });
  effect(() => {
    const id = store.openId.value;
    const performer = store.performer.value;
    const wanted = frames.value;
    if (id === null || wanted.length < 2 || !isWanted()) return;
    const abort = new AbortController();
    engine.poses(id, performer, wanted, { signal: abort.signal }).then(
      (values) => {
        if (!abort.signal.aborted) poses.value = { frames: wanted, poses: values };
      },
      // The stage goes on without trails.
      () => undefined,
    );
    return () => abort.abort();
  });
  return poses;
}
