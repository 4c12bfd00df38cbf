/** The words and numbers that the timeline shows, in the reader's language. */
export interface TimelineText {
  readonly timeline: string;
  readonly pins: string;
  readonly time: string;
  readonly timeUnits: string;
  readonly speed: string;
  readonly speedUnit: string;
  readonly scales: string;
  readonly fine: string;
  readonly coarse: string;
  readonly intensity: string;
  readonly cutNote: string;
  readonly automatic: string;
  readonly overview: string;
  readonly playhead: string;
  readonly loopStart: string;
  readonly loopEnd: string;
  readonly loopTip: string;
  /** Seconds with a fixed number of digits, without the unit. */
  seconds(timeS: number, digits: number): string;
  /** "0.5 s" of "0.5". */
  withUnit(seconds: string): string;
  /** "0.2 Hz". */
  hertz(value: number): string;
  /** "8", without the unit. */
  short(value: number): string;
  /** A whole number in the language's digits. */
  count(value: number): string;
  /** A motion speed or an intensity as shown in the gutter. */
  figure(value: number): string;
  /** "Keypose 3 of 11, 2.82 seconds". */
  keypose(index: number, count: number, timeS: number): string;
  /** "Keyposes 3 to 5 of 11: zoom in". */
  keyposes(first: number, last: number, count: number): string;
  /** "2.817 seconds, frame 338". */
  moment(frame: number, timeS: number): string;
  /** What the rows show, for those who do not see them. */
  speedSummary(maximum: number): string;
  scalesSummary(finestHz: number, coarsestHz: number, keyposes: number, candidates: number): string;
  intensitySummary(candidates: number, keyposes: number, cut: number | null): string;
  /** "2.0 to 4.5 of 6.0 seconds". */
  shown(firstS: number, lastS: number, lengthS: number): string;
}
