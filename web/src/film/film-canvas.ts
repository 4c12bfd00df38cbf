/** Pictures of stages, their tags, captions in; the film's picture on a canvas out. */
import { tintOf } from '../figure/tints';
import type { FilmPalette } from './film-palette';
import { FilmPen } from './film-pen';
import type { FilmShape } from './film-shape';
import type { Box, FilmSheet } from './film-sheet';

/** What stands in the bar of a clip. */
export interface FilmCaption {
  readonly letter: string;
  /** Its place among the clips. */
  readonly place: number;
  readonly name: string;
  /** "Walk"; may be empty. */
  readonly label: string;
  readonly time: string;
  /** "Keypose 3 of 5". */
  readonly keypose: string;
  /** "left foot strikes"; may be empty. */
  readonly posture: string;
  /** "0.06 s past it"; may be empty. */
  readonly remark: string;
}

/** A number or a letter on a stage, its middle in CSS pixels. */
export interface FilmMark {
  readonly text: string;
  readonly kind: 'current' | 'ghost' | 'letter';
  readonly tint: number;
  readonly x: number;
  readonly y: number;
  readonly width: number;
}

const EDGE = 16;
const BADGE = 20;
const MARK_HEIGHT = 16;

export class FilmCanvas {
  readonly canvas = document.createElement('canvas');
  private readonly pen: FilmPen;

  constructor(
    shape: FilmShape,
    private readonly sheet: FilmSheet,
    palette: FilmPalette,
    language: string,
  ) {
    const { canvas } = this;
    canvas.width = shape.width;
    canvas.height = shape.height;
    // The same signs are written differently in Japanese and in Chinese.
    canvas.lang = language;
    const context = canvas.getContext('2d', { alpha: false });
    if (!context) throw new Error('no 2-D canvas');
    this.pen = new FilmPen(context, palette);
    context.fillStyle = palette.line2;
    context.fillRect(0, 0, shape.width, shape.height);
  }

  drawPane(index: number, picture: CanvasImageSource, marks: readonly FilmMark[]): void {
    const { context } = this.pen;
    const { ratio, panes } = this.sheet;
    const { x, y, width, height } = panes[index];
    context.resetTransform();
    context.drawImage(picture, x, y, width, height);
    context.setTransform(ratio, 0, 0, ratio, x, y);
    for (const mark of marks) this.drawMark(mark);
  }

  drawCaptions(captions: readonly FilmCaption[]): void {
    const { context, palette } = this.pen;
    const { ratio, barY } = this.sheet;
    const width = this.canvas.width / ratio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = palette.panel;
    context.fillRect(0, barY, width, this.canvas.height / ratio - barY);
    context.fillStyle = palette.line2;
    context.fillRect(0, barY, width, 1);
    captions.forEach((caption, i) => this.drawCaption(caption, this.sheet.captions[i]));
  }

  private drawMark({ text, kind, tint, x, y, width }: FilmMark): void {
    const { pen } = this;
    const { palette } = pen;
    const look = {
      current: { ground: palette.kp, colour: palette.onKp, weight: 600 },
      ghost: { ground: palette.raised, colour: palette.text2, weight: 400 },
      letter: { ground: palette.tints[tintOf(tint)], colour: palette.panel, weight: 700 },
    }[kind];
    const disc = (by: number, colour: string): void =>
      pen.box(
        x - width / 2 - by,
        y - MARK_HEIGHT / 2 - by,
        width + 2 * by,
        MARK_HEIGHT + 2 * by,
        MARK_HEIGHT / 2 + by,
        colour,
      );
    if (kind === 'ghost') disc(1, palette.line2);
    disc(0, look.ground);
    pen.centred({ text, size: 11, ...look }, x, y + 4);
  }

  private drawCaption(caption: FilmCaption, box: Box): void {
    const { pen } = this;
    const { palette } = pen;
    const { x, y, width } = box;
    const { letter, place, name, label, time, keypose, posture, remark } = caption;
    const left = x + EDGE;
    const most = width - 2 * EDGE;
    pen.box(left, y + 10, BADGE, BADGE, 5, palette.tints[tintOf(place)]);
    const badge = { text: letter, colour: palette.panel, weight: 700, size: 12 };
    pen.centred(badge, left + BADGE / 2, y + 24.5);
    const clock = { text: time, colour: palette.ink, weight: 600, size: 17 };
    const clockWidth = pen.width(clock);
    pen.line([clock], left + most - clockWidth, y + 26, clockWidth, 0);
    const names = [
      { text: name, colour: palette.ink, weight: 600, size: 16 },
      { text: label, colour: palette.text3, weight: 400, size: 14 },
    ];
    const indent = BADGE + 9;
    pen.line(names, left + indent, y + 26, most - indent - clockWidth - EDGE, 9);
    const state = [
      { text: keypose, colour: palette.kpText, weight: 600, size: 14 },
      { text: posture, colour: palette.text2, weight: 400, size: 14 },
      { text: remark, colour: palette.text3, weight: 400, size: 14 },
    ];
    pen.line(state, left, y + 49, most, 12);
  }
}
