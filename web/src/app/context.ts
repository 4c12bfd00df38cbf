/** Everything that the wiring of the page hands around: the state and those who may change it. */
import type { Comparer } from '../engine/comparison-types';
import type { Engine } from '../engine/types';
import type { Playback } from '../player/playback';
import type { KeyCommand } from '../player/keys';
import type { Actions } from './actions';
import type { Page } from './compare-store';
import type { CompareActions } from './compare-actions';
import type { FullScreen } from './full-screen';
import type { History } from './history';
import type { LanguageState } from './language';
import type { Panels } from './panels';
import type { Preferences } from './preferences';
import type { Store } from './store';
import type { ThemeState } from './theme';

export interface Context {
  readonly engine: Engine;
  /** Pictures of the matrix and warpings; the rest of what it finds stands in the store. */
  readonly comparer: Comparer;
  readonly store: Store;
  readonly history: History;
  readonly playback: Playback;
  readonly actions: Actions;
  readonly compareActions: CompareActions;
  readonly language: LanguageState;
  readonly theme: ThemeState;
  readonly panels: Panels;
  readonly fullScreen: FullScreen;
  readonly preferences: Preferences;
  /** What the keys do on pages other than the study, which set it themselves. */
  readonly pageKeys: Map<Page, (command: KeyCommand) => void>;
  /** The browser's own dialogs. */
  readonly picker: { files(): void; folder(): void };
}
