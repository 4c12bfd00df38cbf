// What the command line says of a file, in the forms of docs/formats.md. In: a path, and decisions as options.
import { basename, dirname } from 'node:path';
import { runCommand } from '../../support/command';

/** The members that the page shows. */
export interface Report {
  readonly frames: number;
  readonly frame_time_s: number;
  readonly frame_rate_hz: number;
  readonly leading_rest_frames: number;
  readonly up: string;
  readonly ground_height: number;
  readonly unit: string | null;
  readonly body: {
    readonly kind: 'human' | 'other';
    readonly pelvis: string;
    readonly height: number;
    readonly joints: readonly { role: string; joint: string; source: string }[];
  };
  readonly notes: readonly { line: number | null; frame: number | null; message: string }[];
  readonly candidates: readonly { frame: number; intensity: number }[];
  readonly keyposes: readonly { frame: number; time_s: number; intensity: number }[];
  readonly clusters: number;
  readonly anova: { readonly f: number; readonly p: number } | null;
  readonly sureness: number | null;
}

function printed(path: string, ...options: string[]): string {
  return runCommand(['keyposes', ...options, basename(path)], dirname(path)) ?? '';
}

/** The file that the command line writes, byte for byte. */
export function exportOf(path: string, form: 'csv' | 'json', ...options: string[]): string {
  return printed(path, `--${form}`, ...options);
}

/** The first performer's report. */
export function reportOf(path: string, ...options: string[]): Report {
  return JSON.parse(exportOf(path, 'json', ...options).split('\n')[0] ?? '') as Report;
}

export const keyposeFramesOf = ({ keyposes }: Report): number[] =>
  keyposes.map(({ frame }) => frame);
