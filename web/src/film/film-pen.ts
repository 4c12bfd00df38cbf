/** A 2-D canvas and a palette in; texts in one line, fitted, out. */
import { fitText } from './fit-text';
import type { FilmPalette } from './film-palette';

export interface Run {
  readonly text: string;
  readonly colour: string;
  readonly weight: number;
  readonly size: number;
}

export class FilmPen {
  constructor(
    readonly context: CanvasRenderingContext2D,
    readonly palette: FilmPalette,
  ) {
    context.textBaseline = 'alphabetic';
  }

  width({ text, weight, size }: Run): number {
    this.setFont(weight, size);
    return this.context.measureText(text).width;
  }

  /** Writes the runs after each other as far as there is room; their width. */
  line(runs: readonly Run[], x: number, baseline: number, most: number, gap: number): number {
    const { context } = this;
    context.textAlign = 'left';
    let at = 0;
    for (const run of runs.filter(({ text }) => text !== '')) {
      this.setFont(run.weight, run.size);
      const text = fitText(run.text, most - at, (part) => context.measureText(part).width);
      context.fillStyle = run.colour;
      context.fillText(text, x + at, baseline);
      at += context.measureText(text).width + gap;
      if (text !== run.text) break;
    }
    return at;
  }

  /** Centred on a place. */
  centred({ text, colour, weight, size }: Run, x: number, baseline: number): void {
    this.setFont(weight, size);
    this.context.textAlign = 'center';
    this.context.fillStyle = colour;
    this.context.fillText(text, x, baseline);
  }

  box(x: number, y: number, width: number, height: number, radius: number, colour: string): void {
    const { context } = this;
    context.fillStyle = colour;
    context.beginPath();
    context.roundRect(x, y, width, height, radius);
    context.fill();
  }

  private setFont(weight: number, size: number): void {
    this.context.font = `${weight} ${size}px ${this.palette.fontFamily}`;
  }
}
