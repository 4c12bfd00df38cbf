/** A film's shape, how many stages and clips it shows in; where stages and captions are in its pictures out. Pure. */
import type { FilmShape } from './film-shape';

export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface FilmSheet {
  /** Pixels of one CSS pixel. */
  readonly ratio: number;
  /** In pixels. */
  readonly panes: readonly Box[];
  /** One for each clip, in CSS pixels. */
  readonly captions: readonly Box[];
  /** Where the captions begin, in CSS pixels. */
  readonly barY: number;
}

/** Height of the smallest film, for which letters have the sizes of the page. */
const CSS_HEIGHT = 720;
/** Between two stages, in CSS pixels. */
const GAP = 2;
const CAPTION_HEIGHT = 60;
const MOST_IN_ROW = 4;

export function filmSheet({ width, height }: FilmShape, panes: number, clips: number): FilmSheet {
  const ratio = height / CSS_HEIGHT;
  const columns = Math.min(clips, MOST_IN_ROW);
  const rows = Math.ceil(clips / MOST_IN_ROW);
  const barY = CSS_HEIGHT - rows * CAPTION_HEIGHT;
  const captionWidth = width / ratio / columns;
  return {
    ratio,
    barY,
    panes: Array.from({ length: panes }, (_, pane) => paneBox(pane, panes, width, ratio, barY)),
    captions: Array.from({ length: clips }, (_, clip) => ({
      x: (clip % MOST_IN_ROW) * captionWidth,
      y: barY + Math.floor(clip / MOST_IN_ROW) * CAPTION_HEIGHT,
      width: captionWidth,
      height: CAPTION_HEIGHT,
    })),
  };
}

/** All of one width, the last at the right edge. */
function paneBox(pane: number, panes: number, all: number, ratio: number, barY: number): Box {
  const width = Math.floor((all - (panes - 1) * GAP * ratio) / panes);
  const x = panes > 1 ? Math.round((pane * (all - width)) / (panes - 1)) : 0;
  return { x, y: 0, width, height: Math.round(barY * ratio) };
}
