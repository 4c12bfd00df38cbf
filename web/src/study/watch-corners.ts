/** The words over the stage in; how wide those in the lower corners are out, whenever that changes. */
import type { StageProps } from '../stage';

type Corners = StageProps['corners'];

export function watchCorners(overlay: HTMLElement, onChange: (corners: Corners) => void): void {
  const width = (name: string, edge: 'left' | 'right'): number => {
    const box = overlay.querySelector(name)?.getBoundingClientRect();
    const { left, right } = overlay.getBoundingClientRect();
    if (!box) return 0;
    return edge === 'left' ? box.right - left : right - box.left;
  };
  const tell = (): void =>
    onChange({ left: width('.stage-caption', 'left'), right: width('.stage-grid', 'right') });
  const sizes = new ResizeObserver(tell);
  // The words come and go with clips.
  const watch = (): void => {
    sizes.disconnect();
    for (const words of overlay.querySelectorAll('.stage-caption, .stage-grid'))
      sizes.observe(words);
    tell();
  };
  new MutationObserver(watch).observe(overlay, { childList: true });
  watch();
}
