/** Paths and ticks in; the drawn rows out: speeds, the ribbon between them, who is ahead. */
import { nothing, svg, type TemplateResult } from 'lit-html';
import type { Axis } from '../timeline/axis';
import { clockTime, divisionOf, rulerTicks } from '../timeline/ruler-layout';
import { AHEAD_MIDDLE, type AheadOutline } from './ahead';
import { rows, ROWS_HEIGHT, type RowPlace } from './rows-layout';
import type { SpeedOutline } from './speed-outline';

export interface GraphClip {
  readonly axis: Axis;
  readonly frameTimeS: number;
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
  /** "2 s" of "2". */
  readonly withUnit: (seconds: string) => string;
}

const TICK = 3;
const MAJOR_TICK = 6;

const speedRow = ({ speed }: GraphClip, who: 'a' | 'b') =>
  speed &&
  svg`<path class="pair-speed-area ${who}" d=${speed.area} />
    <path class="pair-speed-line ${who}" d=${speed.line} />`;

function ticks(
  { axis, frameTimeS }: GraphClip,
  withUnit: PairGraphProps['withUnit'],
  edge: { readonly y: number; readonly inward: 1 | -1 },
): TemplateResult {
  const division = divisionOf(axis, frameTimeS);
  const all = rulerTicks(axis, frameTimeS, division);
  const path = all.map(({ x, size }) => {
    const length = edge.inward * (size === 'minor' ? TICK : MAJOR_TICK);
    return `M${x.toFixed(1)} ${edge.y}v${length}`;
  });
  const labelled = all.filter(({ size, timeS }) => size === 'major' && timeS > 0);
  const y = edge.y + (edge.inward > 0 ? 11 : -3);
  return svg`<path class="pair-ticks" d=${path.join('')} />
    ${labelled.map(
      ({ x, timeS }) =>
        svg`<text class="pair-time-label" x=${x + 4} y=${y}>${withUnit(clockTime(timeS, division.digits))}</text>`,
    )}`;
}

function aheadRow({ ahead, aheadText: [a, b], width }: PairGraphProps) {
  if (!ahead) return nothing;
  const { top, height } = rows.ahead;
  return svg`<path class="pair-ahead a" d=${ahead.a} />
    <path class="pair-ahead b" d=${ahead.b} />
    <path class="pair-even" d="M0 ${AHEAD_MIDDLE}H${width}" />
    <text class="pair-time-label end" x=${width - 4} y=${top + 13}>${a}</text>
    <text class="pair-time-label end" x=${width - 4} y=${top + height - 5}>${b}</text>`;
}

const rule = ({ top }: RowPlace, width: number) =>
  svg`<path class="pair-rule" d="M0 ${top - 0.5}H${width}" />`;

export function pairGraph(props: PairGraphProps): TemplateResult {
  const { width, a, b, lines, keyposeLines, withUnit } = props;
  const { ribbon } = rows;
  return svg`<svg class="pair-graph" width=${width} height=${ROWS_HEIGHT} aria-hidden="true">
    <rect class="pair-ribbon" x="0" y=${ribbon.top} width=${width} height=${ribbon.height} />
    ${speedRow(a, 'a')}${speedRow(b, 'b')}
    ${ticks(a, withUnit, { y: ribbon.top, inward: 1 })}
    ${ticks(b, withUnit, { y: ribbon.top + ribbon.height, inward: -1 })}
    <path class="pair-lines" d=${lines} />
    <path class="pair-keypose-lines" d=${keyposeLines} />
    ${rule(rows.ahead, width)}${rule(rows.parts, width)}
    ${aheadRow(props)}
  </svg>`;
}
