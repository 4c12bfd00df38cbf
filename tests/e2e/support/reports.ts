// What the command line says of a file, in the forms of docs/formats.md. In: a path, and decisions as options.
import { basename, dirname } from 'node:path';
import { runCommand } from '../../support/command';

/** The members that the page shows. */
export interface Report {
  readonly parameters: { readonly scale_max_hz: number; readonly scale_min_hz: number };
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
  readonly candidates: readonly CandidateReport[];
  readonly keyposes: readonly KeyposeReport[];
  readonly clusters: number;
  readonly anova: AnovaReport | null;
  readonly sureness: number | null;
  readonly cut: number | null;
  readonly maximum_speed: number;
}

export interface AnovaReport {
  readonly f: number;
  readonly p: number;
  readonly df_between: number;
  readonly df_within: number;
}

export interface CandidateReport {
  readonly frame: number;
  readonly time_s: number;
  readonly intensity: number;
  readonly rank: number;
  readonly strongest_hz: number | null;
}

export interface KeyposeReport extends CandidateReport {
  readonly body_part_percents: Readonly<Record<string, number | null>> | null;
}

/** The ways of the candidates through the time scales. */
export interface TraceReport {
  readonly scales_hz: readonly number[];
  readonly traces: readonly { candidate: number; u: readonly number[] }[];
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

export function tracesOf(path: string): TraceReport {
  return JSON.parse(printed(path, '--json', '--traces').split('\n')[0] ?? '') as TraceReport;
}

export const keyposeFramesOf = ({ keyposes }: Report): number[] =>
  keyposes.map(({ frame }) => frame);
