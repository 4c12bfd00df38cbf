/** A command of the keyboard in; what it does to the clock of the pair out. */
import type { KeyCommand } from '../player/keys';
import type { PairState } from './pair-state';

const tenthS = 0.1;

export function pairKeys(state: PairState): (command: KeyCommand) => void {
  const { clock } = state;
  const keypose = (direction: 1 | -1): void =>
    clock.keypose(0, state.clips.peek()[0]?.keyposes ?? new Int32Array(), direction);
  const commands: Readonly<Partial<Record<KeyCommand, () => void>>> = {
    play: () => clock.toggle(),
    'frame-back': () => clock.step(-1),
    'frame-on': () => clock.step(1),
    'tenth-back': () => clock.skip(-tenthS),
    'tenth-on': () => clock.skip(tenthS),
    'next-keypose': () => keypose(1),
    'previous-keypose': () => keypose(-1),
    'first-frame': () => clock.toEnd(-1),
    'last-frame': () => clock.toEnd(1),
    slower: () => clock.stepSpeed(-1),
    faster: () => clock.stepSpeed(1),
    loop: () => clock.toggleLoop(),
    'loop-start': () => clock.loopEnd('a'),
    'loop-end': () => clock.loopEnd('b'),
    'loop-clear': () => clock.setLoop(null),
    'zoom-in': () => state.rows.zoom('in'),
    'zoom-out': () => state.rows.zoom('out'),
    'zoom-all': () => state.rows.zoom('all'),
  };
  return (command) => commands[command]?.();
}
