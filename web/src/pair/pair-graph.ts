/** Paths and ticks in; the drawn rows out: speeds, the ribbon between them, who is ahead. */
import { nothing, svg, type TemplateResult } from 'lit-html';
import type { Tick } from '../timeline/ruler-layout';
import { AHEAD_MIDDLE, type AheadOutline } from './ahead';
import type { RibbonLabel } from './ribbon-labels';
import { rows, ROWS_HEIGHT, type RowPlace } from './rows-layout';
import type { SpeedOutline } from './speed-outline';

export interface GraphClip {
  readonly ticks: readonly Tick[];
  /** null without an analysis. */
  readonly speed: SpeedOutline | null;
}

export interface PairGraphProps {
  readonly width: number;
  readonly a: GraphClip;
  readonly b: GraphClip;
  /** SVG path data of lines between matching moments. */
  readonly lines: string;
  readonly keyposeLines: string;
  readonly ahead: AheadOutline | null;
  /** "A +5 %" and "B". */
  readonly aheadText: readonly [string, string];
}

interface Edge {
  readonly y: number;
  readonly inward: 1 | -1;
}

const TICK = 3;
const MAJOR_TICK = 6;

const speedRow = ({ speed }: GraphClip, who: 'a' | 'b') =>
  speed &&
  svg`<path class="pair-speed-area ${who}" d=${speed.area} />
    <path class="pair-speed-line ${who}" d=${speed.line} />`;

/** Ticks on an edge of the ribbon, into it. */
function ticks({ ticks: all }: GraphClip, { y, inward }: Edge): TemplateResult {
  const path = all.map(
    ({ x, size }) => `M${x.toFixed(1)} ${y}v${inward * (size === 'minor' ? TICK : MAJOR_TICK)}`,
  );
  return svg`<path class="pair-ticks" d=${path.join('')} />`;
}

function aheadRow({ ahead, aheadText: [a, b], width }: PairGraphProps) {
  if (!ahead) return nothing;
  const { top, height } = rows.ahead;
  return svg`<path class="pair-ahead a" d=${ahead.a} />
    <path class="pair-ahead b" d=${ahead.b} />
    <path class="pair-even" d="M0 ${AHEAD_MIDDLE}H${width}" />
    <text class="pair-time-label end" x=${ahead.labelEnds[0]} y=${top + 13}>${a}</text>
    <text class="pair-time-label end" x=${ahead.labelEnds[1]} y=${top + height - 5}>${b}</text>`;
}

const rule = ({ top }: RowPlace, width: number) =>
  svg`<path class="pair-rule" d="M0 ${top - 0.5}H${width}" />`;

export function pairGraph(props: PairGraphProps): TemplateResult {
  const { width, a, b, lines, keyposeLines } = props;
  const { ribbon } = rows;
  return svg`<svg class="pair-graph" width=${width} height=${ROWS_HEIGHT} aria-hidden="true">
    <rect class="pair-ribbon" x="0" y=${ribbon.top} width=${width} height=${ribbon.height} />
    ${speedRow(a, 'a')}${speedRow(b, 'b')}
    ${ticks(a, { y: ribbon.top, inward: 1 })}
    ${ticks(b, { y: ribbon.top + ribbon.height, inward: -1 })}
    <path class="pair-lines" d=${lines} />
    <path class="pair-keypose-lines" d=${keyposeLines} />
    ${rule(rows.ahead, width)}${rule(rows.parts, width)}
    ${aheadRow(props)}
  </svg>`;
}

/** The times at the edges of the ribbon, over its lines. */
export function ribbonTimes(
  width: number,
  labels: readonly [readonly RibbonLabel[], readonly RibbonLabel[]],
): TemplateResult {
  const { top, height } = rows.ribbon;
  const y = [top + 11, top + height - 4];
  return svg`<svg class="pair-graph" width=${width} height=${ROWS_HEIGHT} aria-hidden="true">
    ${labels.map((all, clip) =>
      all.map(
        ({ x, text }) => svg`<text class="pair-time-label" x=${x} y=${y[clip]}>${text}</text>`,
      ),
    )}
  </svg>`;
}
