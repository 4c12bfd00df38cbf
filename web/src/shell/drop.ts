/** Files over the page in: a veil while they hover, what was given once they are let go. */
import { givenByDrop, type Given } from '../app/intake';

export interface DropEvents {
  readonly onHover: (over: boolean) => void;
  readonly onDrop: (given: Given[]) => void;
}

const holdsFiles = (event: DragEvent): boolean =>
  event.dataTransfer?.types.includes('Files') ?? false;

export function listenToDrops(target: Document, { onHover, onDrop }: DropEvents): void {
  // Every element under the pointer tells of an entry and an exit of its own.
  let depth = 0;
  const move = (step: number): void => {
    depth = Math.max(0, depth + step);
    onHover(depth > 0);
  };
  const on = (
    type: 'dragenter' | 'dragleave' | 'dragover' | 'drop',
    handle: (event: DragEvent) => void,
  ): void =>
    target.addEventListener(type, (event) => {
      if (!holdsFiles(event)) return;
      event.preventDefault();
      handle(event);
    });
  on('dragenter', () => move(1));
  on('dragleave', () => move(-1));
  on('dragover', (event) => {
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'copy';
  });
  on('drop', (event) => {
    move(-depth);
    if (event.dataTransfer) onDrop(givenByDrop(event.dataTransfer));
  });
}
