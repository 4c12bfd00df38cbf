/** What a person wrote and the other parameters in; the number, or why it cannot be, out. */
import type { MessageKey } from '../app/i18n/catalogue';
import type { MethodSettings } from '../engine/types';

/** The parameters that are numbers. */
export type NumberKey = Exclude<keyof MethodSettings, 'selection'>;

export interface Refusal {
  readonly key: MessageKey;
  readonly values: readonly number[];
}

// As the core's options have it, which has the last word.
const leastHz = 0.01;
const mostHz = 100_000;
const mostScales = 1000;

/** A decimal comma is a point; a number with both signs, or with none of its digits, is none. */
export function parseNumber(text: string): number {
  const plain = text.trim().replace(/^([^.,]*),([^.,]*)$/, '$1.$2');
  return /\d/.test(plain) && /^[+-]?\d*\.?\d*(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
}

/** How many time scales there are from the finest down to the last that is not below the coarsest. */
export function scaleCount({ scaleMaxHz, scaleMinHz, scaleRatio }: MethodSettings): number {
  return Math.floor(Math.log(scaleMinHz / scaleMaxHz) / Math.log(scaleRatio)) + 1;
}

const isFrequency = (hz: number): boolean => hz >= leastHz && hz <= mostHz;

/** Why the value of `key` cannot be, told from that parameter's side; null if it can. */
export function refusalOf(settings: MethodSettings, key: NumberKey): Refusal | null {
  const { scaleMaxHz, scaleMinHz, scaleRatio } = settings;
  if (key !== 'scaleRatio' && !isFrequency(settings[key]))
    return { key: 'wrong.frequency', values: [] };
  if (key === 'scaleRatio' && !(scaleRatio > 0 && scaleRatio < 1))
    return { key: 'wrong.ratio', values: [] };
  if (key === 'lowPassHz') return null;
  if (scaleMinHz > scaleMaxHz)
    return key === 'scaleMinHz'
      ? { key: 'wrong.above-finest', values: [scaleMaxHz] }
      : { key: 'wrong.below-coarsest', values: [scaleMinHz] };
  const count = scaleCount(settings);
  return count > mostScales ? { key: 'wrong.scales', values: [count, mostScales] } : null;
}

/** The next value of a field by an arrow key, without what binary fractions add. */
export function stepped(value: number, step: number): number {
  const decimals = Math.max(0, Math.ceil(-Math.log10(Math.abs(step)) - 1e-9));
  const exact = Math.max(decimals, (String(value).split('.')[1] ?? '').length);
  return Number((value + step).toFixed(Math.min(exact, 12)));
}
