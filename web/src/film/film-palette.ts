/** The tokens of the theme in; the colours and the letters of captions and tags out. */
import { CLIP_TINTS } from '../figure/tints';

export interface FilmPalette {
  readonly ink: string;
  readonly text2: string;
  readonly text3: string;
  readonly panel: string;
  readonly raised: string;
  readonly line2: string;
  readonly kp: string;
  readonly kpText: string;
  readonly onKp: string;
  /** In the order of tints.ts. */
  readonly tints: readonly string[];
  /** As CSS has it. */
  readonly fontFamily: string;
}

export function filmPalette(element: Element): FilmPalette {
  const style = getComputedStyle(element);
  const token = (name: string): string => style.getPropertyValue(name).trim();
  return {
    ink: token('--t-1'),
    text2: token('--t-2'),
    text3: token('--t-3'),
    panel: token('--panel'),
    raised: token('--raised'),
    line2: token('--line2'),
    kp: token('--kp'),
    kpText: token('--kp-text'),
    onKp: token('--on-kp'),
    tints: CLIP_TINTS.map(token),
    fontFamily: token('--font-ui'),
  };
}
