/** How the page looks now in; what a stage begins with, before a motion is on it, out. */
import type { Context } from '../app/context';
import type { StageProps } from '../stage';

type Settings = Pick<StageProps, 'off' | 'reducedMotion'>;

export function emptyStage({ store, theme }: Context, settings: Settings) {
  return {
    performers: [],
    chosen: 0,
    ghosts: [],
    currentTag: null,
    trails: null,
    theme: theme.theme.peek(),
    view: store.view.peek(),
    follow: store.follow.peek(),
    ...settings,
    corners: { left: 0, right: 0 },
    onViewChange: (view) => {
      store.view.value = view;
    },
  } satisfies Partial<StageProps>;
}
