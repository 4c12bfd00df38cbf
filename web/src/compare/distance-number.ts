/** A distance in squared body heights in; how it is written out: near ones keep two figures that say something. */
import { powerOfTen, type Format } from '../app/format';

/** Digits after the point, at least and at most; what would still be 0 is rounding. */
const LEAST_DIGITS = 4;
const MOST_DIGITS = 9;
/** Below this power of ten the zeros are counted for the reader: they would not fit under a figure. */
const LEAST_TENS = -5;

export function distanceNumber({ decimal }: Pick<Format, 'decimal'>, distance: number): string {
  const tens = Math.floor(Math.log10(Math.abs(distance)));
  if (!(tens >= 1 - MOST_DIGITS)) return '0';
  if (tens >= LEAST_TENS) return decimal(distance, Math.max(LEAST_DIGITS, 1 - tens));
  const [figures, power] = distance.toExponential(1).split('e');
  return `${decimal(Number(figures), 1)}×${powerOfTen(Number(power))}`;
}
