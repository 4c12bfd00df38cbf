/** The labels left of the rows: names, which fold the rows that can be folded, and figures. */
import type { FoldableRow } from '../app/store';
import { element } from '../common/element';
import { foldableRows, type RowLayout, type RowName } from './rows';
import type { TimelineText } from './timeline-text';

export interface GutterFigures {
  readonly speed: string;
  readonly intensity: string;
  readonly overview: string;
}

export class Gutter {
  readonly element = element('div', 'row-gutter');
  private readonly names: Record<RowName, HTMLElement>;
  private readonly figures = {
    ruler: element('span', 'row-figure'),
    speed: element('span', 'row-figure'),
    intensity: element('span', 'row-figure'),
    overview: element('span', 'row-figure'),
  };
  private readonly notes = {
    speed: element('span', 'row-note'),
    fine: element('span', 'row-note'),
    coarse: element('span', 'row-note'),
    intensity: element('span', 'row-note'),
  };

  constructor(onFold: (row: FoldableRow, folded: boolean) => void) {
    const name = (row: RowName): HTMLElement => {
      const foldable = foldableRows.find((other) => other === row);
      return foldable === undefined
        ? element('span', 'row-name')
        : foldButton((folded) => onFold(foldable, folded));
    };
    this.names = {
      pins: name('pins'),
      ruler: name('ruler'),
      speed: name('speed'),
      scales: name('scales'),
      intensity: name('intensity'),
      overview: name('overview'),
    };
    this.element.append(
      ...Object.values(this.names),
      ...Object.values(this.figures),
      ...Object.values(this.notes),
    );
  }

  update(rows: RowLayout, text: TimelineText, analysed: boolean): void {
    const { names, notes, figures } = this;
    const words = { ...text, ruler: text.time };
    for (const row of Object.keys(names) as RowName[]) {
      names[row].textContent = words[row];
      names[row].hidden = rows[row].height === 0 || (!analysed && row === 'speed');
      names[row].style.top = `${rows[row].top}px`;
      if (names[row] instanceof HTMLButtonElement)
        names[row].setAttribute('aria-expanded', String(!rows[row].folded));
    }
    for (const row of ['ruler', 'speed', 'intensity', 'overview'] as const)
      figures[row].style.top = `${rows[row].top}px`;
    figures.ruler.textContent = text.timeUnits;
    this.writeNote(notes.speed, text.speedUnit, rows, 'speed', analysed);
    this.writeNote(notes.fine, text.fine, rows, 'scales', analysed);
    this.writeNote(notes.coarse, text.coarse, rows, 'scales', analysed);
    this.writeNote(notes.intensity, text.cutNote, rows, 'intensity', analysed);
    notes.coarse.style.top = `${rows.scales.top + rows.scales.height - COARSE_UP}px`;
  }

  showFigures({ speed, intensity, overview }: GutterFigures): void {
    write(this.figures.speed, speed);
    write(this.figures.intensity, intensity);
    write(this.figures.overview, overview);
  }

  private writeNote(
    note: HTMLElement,
    words: string,
    rows: RowLayout,
    row: FoldableRow,
    analysed: boolean,
  ): void {
    note.textContent = words;
    note.hidden = rows[row].folded || !analysed;
    note.style.top = `${rows[row].top + NOTE_DOWN}px`;
  }
}

/** From a row's upper edge to its second line; from its lower edge to the word at its foot. */
const NOTE_DOWN = 21;
const COARSE_UP = 20;

function foldButton(onFold: (folded: boolean) => void): HTMLElement {
  const button = element('button', 'row-name fold') as HTMLButtonElement;
  button.type = 'button';
  button.addEventListener('click', () => onFold(button.getAttribute('aria-expanded') === 'true'));
  return button;
}

/** Writes only what is new: it is called with every frame. */
function write(node: HTMLElement, words: string): void {
  if (node.textContent !== words) node.textContent = words;
}
